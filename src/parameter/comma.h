/* SPDX-License-Identifier: MIT */
/*
 * Decimal commas within brackets and braces, where a comma ends an element: [2000,5, 0, 0] has four of them, and
 * {radius: 300,5} a key named 5.  Such a comma is told from others by what stands right before and behind it.
 */
#ifndef LX_PARAMETER_COMMA_H
#define LX_PARAMETER_COMMA_H

#include "document.h"

/* Whether a list has more numbers than are wanted because commas of some of them were read as those of the list. */
bool lx_has_decimal_commas(const struct lx_document *document, lx_node_id list, size_t wanted);

/* Whether the number of the node before a key, 0: there is none, goes on in that key, which no table has. */
bool lx_number_goes_on_in_key(const struct lx_document *document, lx_node_id before, lx_node_id key);

#endif
