/* SPDX-License-Identifier: MIT */
/* The tables as a JSON Schema, for editors and other programs that check scenes before the library does. */
#ifndef LX_PARAMETER_SCHEMA_H
#define LX_PARAMETER_SCHEMA_H

#include "table.h"

/*
 * The schema (draft-07) of a mapping that `table` describes, as a text to be freed with free(); NULL when memory ran
 * out.  `beyond` is what holds between its parts that no schema can say, one sentence each.
 */
char *lx_schema(const struct lx_table *table, const char *title, const char *beyond);

#endif
