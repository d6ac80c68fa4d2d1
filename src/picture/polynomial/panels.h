/* SPDX-License-Identifier: MIT */
/*
 * Pictures panel by panel: squares of LX_PANEL_SIDE times as many pixels, and their quarters, over which polynomials
 * take the place of most lights (smooth.h).  The lights that are left are summed for each pixel, and squares with no
 * polynomial are shaded as any tile.
 */
#ifndef LX_PICTURE_PANELS_H
#define LX_PICTURE_PANELS_H

#include "../shader.h"

/* Scratch memory of one thread for one plan, which has panels. */
struct lx_panels_memory;
struct lx_panels_memory *lx_panels_memory_new(const struct lx_plan *plan);
void lx_panels_memory_free(struct lx_panels_memory *memory);

/* A part of the plan's picture: where its columns are from `left` on and its rows from `top` on, and room for their
 * values and mask, a row of which begins `stride` numbers after the one before. */
struct lx_picture_part {
    unsigned left, top;
    const double *x_mm, *y_mm;
    float *values;
    uint8_t *mask;
    size_t stride;
};

/*
 * Shades some panels side by side, no more than a block is wide, from a row and column of the picture on, both
 * multiples of LX_PANEL_SIDE: what of them is in the picture, as shader.h tells.  shown[i] is to be how many of the
 * pixels in the i-th row show a surface.  Where the control says stop the call returns early with values unfinished.
 */
void lx_shade_panels(const struct lx_plan *plan, struct lx_panels_memory *memory, struct lx_shader_memory *shader,
                     struct lx_control *control, bool is_caller, const struct lx_picture_part *canvas, unsigned row,
                     unsigned column, unsigned panels, unsigned shown[LX_PANEL_SIDE]);

#endif
