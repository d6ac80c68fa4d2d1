/* SPDX-License-Identifier: MIT */
/*
 * Direct light on tiles, sampled by the world of elements: on each window at the nodes of Gauss's rule, and again on
 * its quarters until these tell nothing new, no beam is so narrow that they might miss it, and what they may miss
 * between the outlines of surfaces and at folds does not count.
 */
#ifndef LX_REFLECT_DIRECT_H
#define LX_REFLECT_DIRECT_H

#include "../world/world.h"
#include "beam.h"
#include "crossing.h"
#include "doubt.h"
#include "fold.h"
#include "tile.h"

struct lx_sampling_direct {
    struct lx_world world;
    struct lx_lobe lobe;
    struct lx_beams beams;
    struct lx_outlines outlines;
    struct lx_folds folds;
    const struct lx_prepared *open; /* the scene without shadows */
    /* Differences below this, in mm^2 times irradiance, tell nothing; infinite: beams and outlines alone are looked
     * for. */
    double least_flux;
    double narrow_flux; /* nor does what may be missed between outlines on one window, */
    double fold_flux;   /* or at folds */
    int most_levels;    /* of quarters, below those that beams ask for */
    const struct lx_near *near; /* places at which the light is wanted: near to them it is sampled more finely */
    size_t near_count;
};

/* The flux on a cell that no surface stands in the way of, about. */
double lx_direct_open_flux(const struct lx_sampling_direct *sampling, const struct lx_asking *asking,
                           const struct lx_tile_cell *cell);
/* Sets the direct light of a tile and its error; 0, or -1 when memory ran out or the work is to stop. */
int lx_direct_sample(const struct lx_sampling_direct *sampling, const struct lx_matte_face *face,
                     const struct lx_asking *asking, struct lx_tile *tile);
void lx_direct_clear(struct lx_direct *direct);

#endif
