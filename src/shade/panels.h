/* SPDX-License-Identifier: MIT */
/*
 * Pictures panel by panel: squares of LX_PANEL_SIDE times as many pixels, and their quarters, over which polynomials
 * take the place of most lights (smooth.h).  The lights that are left are summed for each pixel, and squares with no
 * polynomial are shaded as any tile.
 */
#ifndef LX_SHADE_PANELS_H
#define LX_SHADE_PANELS_H

#include "shader.h"

/* Scratch memory of one thread for one plan, which has panels. */
struct lx_panels_memory;
struct lx_panels_memory *lx_panels_memory_new(const struct lx_plan *plan);
void lx_panels_memory_free(struct lx_panels_memory *memory);

/* A picture, and where its rows are put: the values and mask of its row `top` come first. */
struct lx_canvas {
    const double *x_mm, *y_mm; /* of all columns and rows */
    unsigned columns, rows, top;
    float *values;
    uint8_t *mask;
};

/*
 * Shades rows first to last - 1 of a row of panels, from a column on as many as a block holds, as shader.h tells;
 * `first` is a multiple of LX_PANEL_SIDE and the column one of LX_BLOCK.  shown[row - first] is to be how many of these
 * pixels show a surface.  Where the control says stop the call returns early with values unfinished.
 */
void lx_shade_panels(const struct lx_plan *plan, struct lx_panels_memory *memory, struct lx_shader_memory *shader,
                     struct lx_control *control, bool is_caller, const struct lx_canvas *canvas, unsigned first,
                     unsigned last, unsigned column, unsigned *shown);

#endif
