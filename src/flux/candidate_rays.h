/* SPDX-License-Identifier: MIT */
/*
 * Candidate rays: ways at whose ends there are narrow extrema, which samples some way apart may miss.  They run along
 * the axis of a beam and the peaks of a luminaire's table, straight down from a source to a plane, and on from behind
 * the middle of what takes light from a source, into the middle of its shadow.
 */
#ifndef LX_FLUX_CANDIDATE_RAYS_H
#define LX_FLUX_CANDIDATE_RAYS_H

#include "../world/prepared.h"

struct lx_candidate_ray {
    double from_mm[3], way[3]; /* of any length */
};

struct lx_candidate_rays {
    struct lx_candidate_ray *items;
    size_t count, capacity;
};

/*
 * Appends the rays of all emitters; where they, their peaks or the surfaces are many, the rays of every so many of
 * them, about `most` of each kind.  `downward`, a unit vector to a plane, adds those down to it, from the middle and
 * the nearest place of each emitter and from the middle of each surface.  0, or -1 when memory ran out;
 * clear them anyway.
 */
int lx_candidate_rays_make(const struct lx_prepared *prepared, const double downward[3], size_t most,
                           struct lx_candidate_rays *rays);
void lx_candidate_rays_clear(struct lx_candidate_rays *rays);

#endif
