/* SPDX-License-Identifier: MIT */
/* Shading by a plan: the values of a run of pixels in one row, whatever surfaces they show. */
#ifndef LX_SHADE_SHADER_H
#define LX_SHADE_SHADER_H

#include <stdint.h>

#include "../base/rows.h"
#include "plan.h"

/* Scratch memory of one thread for one plan. */
struct lx_shader_memory;
struct lx_shader_memory *lx_shader_memory_new(const struct lx_plan *plan);
void lx_shader_memory_free(struct lx_shader_memory *memory);

/*
 * The rows and columns of a tile of a picture that is so many columns wide; they begin at multiples of these.  For its
 * pixels together it is decided which points are clustered; where none are a tile is as wide as a block.
 */
enum { LX_TILE_ROWS = 4 };
unsigned lx_tile_columns(const struct lx_plan *plan, unsigned columns);

/*
 * Tells which tile the points are of that are shaded next: all (x[i], y[j]), no more than there are in one, and x with
 * room as below.  Their values depend on the tile where points are clustered.
 */
void lx_shader_enter(const struct lx_plan *plan, struct lx_shader_memory *memory, const double *y_mm, size_t rows,
                     const double *x_mm, size_t count);

/*
 * The values through the screen points (x[i], y), 0 off every surface, and the mask, 1 on a surface; count is at most
 * LX_BLOCK, and x and values have room for lx_padded(count).  `control` may be NULL; where it says stop, the call
 * returns early with values unfinished.  Returns how many pixels show a surface.
 */
size_t lx_shade_points(const struct lx_plan *plan, struct lx_shader_memory *memory, double y_mm, double *x_mm,
                       size_t count, struct lx_control *control, bool is_caller, double *values, uint8_t *mask);

/* How far those last shaded may be off because of clusters, at most. */
double lx_shader_error(const struct lx_shader_memory *memory);

#endif
