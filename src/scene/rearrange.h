/* SPDX-License-Identifier: MIT */
/*
 * Patches that put an element into a list, take an element or a key out, or move an element.  The splicer's text and
 * document are what it was before; where it does not know how to do it, it gives up.
 */
#ifndef LX_SCENE_REARRANGE_H
#define LX_SCENE_REARRANGE_H

#include "patch.h"

/* Puts words before the element `index`; `block`: an empty list may get lines of its own. `parent` holds the list. */
void lx_put_in(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, size_t index, const char *words,
               bool block);

/* Takes a child out of a list or a mapping, which stands in `parent` (0: it is the root). */
void lx_take_out(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, lx_node_id id);

/* Moves an element to where another one is; those between close up. */
void lx_move_to(struct lx_splicer *splicer, lx_node_id list, size_t from, size_t to);

#endif
