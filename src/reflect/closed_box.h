/* SPDX-License-Identifier: MIT */
/* Closed boxes as a solution has them (box.h): where they lie, and which plates of the scene are their sides. */
#ifndef LX_REFLECT_CLOSED_BOX_H
#define LX_REFLECT_CLOSED_BOX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct lx_closed_box {
    double center_mm[3], axes[3][3], half_mm[3];
    double touch_mm;  /* what is below rounding, by its size */
    size_t plates[6]; /* the prepared surfaces that are its sides, two for each axis; SIZE_MAX: one that is covered */
};

/* The box that a prepared surface is a side of. */
struct lx_box_side {
    uint32_t box;  /* 0: of none; else its number + 1 */
    uint32_t side; /* 2 axis + (1 beyond the middle) */
};

struct lx_closed_boxes {
    struct lx_closed_box *items;
    size_t count, capacity;
    struct lx_box_side *sides; /* of each prepared surface */
};

#endif
