/* SPDX-License-Identifier: MIT */
/*
 * Cuts: the clusters and single points that together light a region of a surface, as few as the allowed error of the
 * light lets be.  The cluster whose error may be the largest is opened until the bounds of all together are within
 *
 *     light_error * max(the least value of the region, a thousandth of the picture's maximum).
 *
 * A cut depends on the plan and the region alone.
 */
#ifndef LX_PICTURE_CUT_H
#define LX_PICTURE_CUT_H

#include "../plan.h"

/* One of the clusters of a cut. */
struct lx_cut_item {
    double error, least; /* as in struct lx_share_bound */
    uint32_t tree, cluster;
};

struct lx_cut {
    const struct lx_planned_surface *surface; /* which it lights; NULL: none */
    struct lx_receiver_region region;
    struct lx_cut_item *items; /* taken whole, the one with the largest error first; from the end on: opened leaves */
    double *bounds;            /* for the choice of precision; below 0: float32 */
    size_t capacity, whole_count, opened_count;
    double error; /* of all of them together */
};

/* Room for any cut of a plan.  0, or -1 when memory ran out; release with lx_cut_clear(). */
int lx_cut_init(const struct lx_plan *plan, struct lx_cut *cut);
void lx_cut_clear(struct lx_cut *cut);

/* Cuts the plan's trees for a region of a surface; false: the work was stopped. */
bool lx_cut_make(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                 const struct lx_receiver_region *region, const struct lx_asking *asking, struct lx_cut *cut);

/* Adds the light of a cut to elements of its region; stops early where the work is to stop.  `open` is room. */
void lx_cut_shade(const struct lx_plan *plan, const struct lx_cut *cut, const struct lx_block_double *block,
                  const struct lx_block_single *copy, size_t count, const struct lx_asking *asking,
                  float open[LX_BLOCK], double *sum);

#endif
