/* SPDX-License-Identifier: MIT */
/* What a run of pixels shows: the nearest surface of each, and the elements of a surface gathered into one block. */
#ifndef LX_PICTURE_SEEN_H
#define LX_PICTURE_SEEN_H

#include <stdint.h>

#include "plan.h"

/* What the lines of sight of a run of pixels meet, and room for that. */
struct lx_sight_lines {
    double *depth, *px, *py, *pz;
};
struct lx_lines_room {
    _Alignas(64) double depth[LX_BLOCK];
    double px[LX_BLOCK], py[LX_BLOCK], pz[LX_BLOCK];
};

/* Aligned as its blocks are; stays where it is. */
struct lx_seen {
    struct lx_block_double block; /* the elements, and the same in float32 */
    struct lx_block_single copy;
    struct lx_columns columns;     /* in whose rows elements in float32 alone are looked for */
    struct lx_sight_lines nearest; /* its places are those of the block where there is one surface alone */
    struct lx_lines_room room_of_nearest, candidate;
    struct lx_found found; /* those of many surfaces that the run may show */
    bool is_found;
    bool shows_one;           /* every pixel of the run shows the only surface that there is; else: */
    uint32_t shown[LX_BLOCK]; /* surface of each pixel, from 1; 0: none */
    unsigned place[LX_BLOCK]; /* pixel of each element of the block */
};

/* The elements of a surface in a run of pixels. */
struct lx_seen_run {
    size_t count;
    unsigned first; /* of their pixels, where these are side by side; else LX_BLOCK */
};

/* Where the view vectors of a surface start, from its anchor; NULL where they are all the same. */
const double *lx_observer_from(const struct lx_plan *plan, const struct lx_planned_surface *surface, double from[3]);

/* Where the lines of sight that meet it start, from its anchor, or the direction that they come from. */
struct lx_origin lx_eye_from(const struct lx_plan *plan, const struct lx_planned_surface *surface);

/* The lines of sight of a row. */
struct lx_row_view lx_row_view_of(const struct lx_plan *plan, double y_mm);

/* Makes the tree over where surfaces may be seen; 0, or -1 when memory ran out. */
int lx_seen_plan(struct lx_plan *plan);

/* Those that may be seen between two places of the screen. */
bool lx_seen_within(const struct lx_plan *plan, const double low_mm[2], const double high_mm[2],
                    struct lx_found *found);

void lx_seen_init(const struct lx_plan *plan, struct lx_seen *seen);

/* Repeats the first of one coordinate's numbers up to lx_padded(count): what kernels read beyond elements are places of
 * the surface, too. */
void lx_seen_pad(double *numbers, size_t count);

/*
 * Where the plan does with it (alone): tells the columns, from left to right, and then of each row sets the
 * mask of its pixels, and the copy, but not the block, to the elements of the surface that it shows, as kernel.h tells.
 */
void lx_seen_enter(const struct lx_plan *plan, struct lx_seen *seen, const double *x_mm, size_t count);
struct lx_stretch lx_seen_in_single(const struct lx_plan *plan, struct lx_seen *seen, double y_mm, uint8_t *mask);

/* Finds the nearest surface of each pixel; returns the number of pixels that show one. */
size_t lx_seen_find(const struct lx_plan *plan, struct lx_seen *seen, double y_mm, const double *x_mm, size_t count);

/* Makes the block, and its copy, of the elements of surface s; the lanes beyond the last repeat the first. */
struct lx_seen_run lx_seen_gather(const struct lx_plan *plan, struct lx_seen *seen, size_t s, size_t count);

/* Puts the sums of the elements where their pixels are. */
void lx_seen_scatter(const struct lx_seen *seen, struct lx_seen_run gathered, const double *sums, double *values);

#endif
