/* SPDX-License-Identifier: MIT */
/*
 * Slots: where an element of a list, or a key of a mapping with its value, stands in the text, with what belongs to
 * it: the comment behind it on its line, and comments right above it that begin at its column.
 */
#ifndef LX_SCENE_SLOT_H
#define LX_SCENE_SLOT_H

#include "layout.h"

struct lx_slot {
    size_t head;           /* where the first comment above it begins, if it is alone; else start */
    size_t start, end;     /* of itself; in block style with its dash and with the comment behind it */
    size_t tail, tail_end; /* in brackets: the comment behind it, with the blanks before; else empty */
    size_t comma;          /* in brackets: of the comma behind it */
    bool has_comma;
    bool alone; /* no other one stands on its lines: they can be taken out whole */
};

/* Finds the slot of a child; `before` is the child before it, 0: it is the first. */
struct lx_slot lx_find_slot(const struct lx_layout *layout, lx_node_id parent, lx_node_id before, lx_node_id id);

/* Whether the bytes are nothing but space and one comma. */
bool lx_is_separator(const struct lx_layout *layout, size_t start, size_t end);

/* The start of the line below that of a byte; the end of the text where there is none. */
size_t lx_line_below(const struct lx_layout *layout, size_t at);

#endif
