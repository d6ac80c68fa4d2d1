/* SPDX-License-Identifier: MIT */
/* Shading by a plan: the values of a run of pixels in one row, whatever surfaces they show. */
#ifndef LX_PICTURE_SHADER_H
#define LX_PICTURE_SHADER_H

#include <stdint.h>

#include "../base/rows.h"
#include "plan.h"

/* Scratch memory of one thread for one plan. */
struct lx_seen;
struct lx_shader_memory;
struct lx_shader_memory *lx_shader_memory_new(const struct lx_plan *plan);
void lx_shader_memory_free(struct lx_shader_memory *memory);

/* What it sees of a run of pixels, for whoever needs such room while no row is shaded. */
struct lx_seen *lx_shader_seen(struct lx_shader_memory *memory);
/* And what it samples highlights with; NULL where no light of the plan is sampled. */
struct lx_sampling_memory *lx_shader_sampling(struct lx_shader_memory *memory);

/*
 * The rows and columns of a tile of a picture that is so many columns wide; they begin at multiples of these.  For its
 * pixels together it is decided which points are clustered; where none are a tile is as wide as a block.
 */
enum { LX_TILE_ROWS = 4 };
unsigned lx_tile_columns(const struct lx_plan *plan, unsigned columns);

/*
 * Tells which tile the points are of that are shaded next: all (x[i], y[j]), x from left to right, no more than there
 * are in one.  Their values depend on the tile where points are clustered.
 */
void lx_shader_enter(const struct lx_plan *plan, struct lx_shader_memory *memory, const double *y_mm, size_t rows,
                     const double *x_mm, size_t count);

/* What is summed of a surface's light. */
struct lx_portion {
    const uint8_t *which; /* of its lights, and then its area lights, those that are not 0; NULL: all */
    bool lights, uniform, highlights;
};

/* From now on; NULL, as at first: all of it.  It stays the caller's. */
void lx_shader_choose(struct lx_shader_memory *memory, const struct lx_portion *portion);

/*
 * The values through the points (x[i], y[row]) of the tile, 0 off every surface, and the mask, 1 on a surface; values
 * has room for lx_padded(count).  `control` may be NULL; where it says stop, the call returns early with values
 * unfinished.  Returns how many pixels show a surface.
 */
size_t lx_shade_row(const struct lx_plan *plan, struct lx_shader_memory *memory, size_t row, struct lx_control *control,
                    bool is_caller, double *values, uint8_t *mask);

/* Shades a row, rounded to float32; values has room for all of the row and no more. */
size_t lx_shade_row_single(const struct lx_plan *plan, struct lx_shader_memory *memory, size_t row,
                           struct lx_control *control, bool is_caller, float *values, uint8_t *mask);

/* How far those last shaded may be off because of clusters, at most. */
double lx_shader_error(const struct lx_shader_memory *memory);

/* How far any of all those that it shaded may be off where there are mirrors; HUGE_VAL: no bound is known. */
double lx_shader_mirrored_error(const struct lx_shader_memory *memory);

#endif
