/* SPDX-License-Identifier: MIT */
/*
 * What a surface is at complex places of the screen around a square of pixels: how far places, normals and view vectors
 * may be there from what they are in the middle (struct lx_vicinity in kernel.h; docs/MATHS.md, "Squares of a
 * picture").
 */
#ifndef LX_PICTURE_VICINITY_H
#define LX_PICTURE_VICINITY_H

#include <stdbool.h>

#include "../../kernel/kernel.h"

struct lx_plan;
struct lx_planned_surface;
struct lx_basis;

/* A square of pixels. */
struct lx_square {
    const struct lx_planned_surface *surface; /* that its middle shows */
    double x_mm, y_mm, half_mm[2];            /* its middle on the screen, and half its width and height there */
    unsigned side;                            /* in pixels: LX_PANEL_SIDE, half or a quarter of it */
};

/* The surface that a place on the screen shows; NULL: none. */
const struct lx_planned_surface *lx_surface_seen(const struct lx_plan *plan, double x_mm, double y_mm);

/* The vicinity of a square that shows its surface throughout, for polynomials of a kind (smooth.h).  False: it does
 * not, or not for certain, or there is none. */
bool lx_find_vicinity(const struct lx_plan *plan, const struct lx_square *square, const struct lx_basis *basis,
                      struct lx_vicinity *at);

#endif
