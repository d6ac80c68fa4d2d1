/* SPDX-License-Identifier: MIT */
/*
 * Extended emitters: Lambertian shells of uniform radiance.
 *
 * facets    a convex polygon that shines from its front, or the shell of a convex polyhedron that shines outwards
 * disk      a flat disk that shines along its axis
 * ball      a sphere that shines outwards
 * cylinder  a right circular cylinder, both caps included, that shines outwards
 *
 * Each is convex, so what an element sees of it is bounded by one convex contour, which the element's horizon cuts
 * in two places at most.  With the law 1/r^2 the irradiance depends on that contour alone and has a closed form,
 *
 *     E = radiance/2 * closed integral of N.(r x dr)/|r|^2      (r from the element to the contour)
 *
 * (Lambert 1760; for edges Le/2 sum theta_i (N.g_i), Baum, Rushmeier, Winget 1989), here to 1e-12 relative
 * everywhere: the terms are summed as wide numbers, so they may cancel.  The other laws and the highlights are
 * integrals over the source (world/integral/cubature.h).
 */
#ifndef LX_LIGHT_EXTENDED_H
#define LX_LIGHT_EXTENDED_H

#include <math.h>

#include "../emitter.h"
#include "shell_facets.h"

/* The middle of an emitter that has a place, and the radius of the ball around it; of a point 0. */
static inline const double *lx_emitter_center(const struct lx_emitter *emitter)
{
    return emitter->type == LX_FACETS ? emitter->facets->center_mm
           : lx_is_extended(emitter)  ? emitter->center_mm
                                      : emitter->position_mm;
}

static inline double lx_emitter_radius(const struct lx_emitter *emitter)
{
    if (!lx_is_extended(emitter))
        return 0;
    if (emitter->type == LX_FACETS)
        return emitter->facets->radius_mm;
    return emitter->type == LX_CYLINDER ? hypot(emitter->radius_mm, emitter->height_mm / 2) : emitter->radius_mm;
}

/* Whether the place lies on the source, as far as its error tells: there is no L from every part of it. */
bool lx_extended_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm);

/* The area that shines. */
lx_bounded lx_extended_area_mm2(const struct lx_emitter *emitter);

/* The irradiance by the law 1/r^2 of an element that the source does not touch; its normal is a unit vector. */
lx_bounded lx_extended_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal);

/* Appends the point emitters that stand for the source when it is cut into parts (SPEC: `parts: N`): facets by
 * lx_facets_cut() of facets.h, the round ones by lx_round_cut() of round.h.  0, or -1 when memory ran out. */
int lx_extended_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);

#endif
