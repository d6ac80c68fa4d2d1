/* SPDX-License-Identifier: MIT */
/*
 * Extended emitters: Lambertian surfaces of uniform radiance.
 *
 * facets    a convex polygon that shines from its front, or the surface of a convex polyhedron that shines outwards
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

#include "round.h"
#include "area_light_facets.h"

/* The middle of an emitter that has a place, and the radius of the ball around it; of a point 0. */
static inline const double *lx_emitter_center(const struct lx_emitter *emitter)
{
    return emitter->facets           ? emitter->facets->center_mm
           : lx_is_extended(emitter) ? emitter->center_mm
                                     : emitter->position_mm;
}

static inline double lx_emitter_radius(const struct lx_emitter *emitter)
{
    if (!lx_is_extended(emitter))
        return 0;
    if (emitter->facets)
        return emitter->facets->radius_mm;
    const double half = lx_half_height(emitter);
    return lx_emitter_kind(emitter)->bulges ? emitter->radius_mm + half : hypot(emitter->radius_mm, half);
}

/* Where its light comes from: the unit vector to parallel light and to the sun, else its middle. */
static inline void lx_emitter_origin(const struct lx_emitter *emitter, double at[3])
{
    const double towards[3] = {emitter->towards.x.value, emitter->towards.y.value, emitter->towards.z.value};
    const double *from = lx_is_endless(emitter) || lx_is_dome(emitter) ? towards : lx_emitter_center(emitter);
    for (int i = 0; i < 3; i++)
        at[i] = from[i];
}

/* A place in the plane of a flat one and the normal of the side that shines; false: it is a body, or has no size. */
bool lx_emitter_plane(const struct lx_emitter *emitter, double place_mm[3], double normal[3]);

/* How far an extended one comes along a unit direction from a place, and from where on. */
static inline double lx_emitter_extent(const struct lx_emitter *emitter, const double place_mm[3],
                                       const double direction[3], double *nearest)
{
    return lx_emitter_kind(emitter)->extent(emitter, place_mm, direction, nearest);
}

/* Whether the place lies on the source, as far as its error tells: there is no L from every part of it. */
static inline bool lx_extended_touches(const struct lx_emitter *emitter, lx_bounded3 place_mm)
{
    return lx_emitter_kind(emitter)->touches(emitter, place_mm);
}

/* The area that shines. */
static inline lx_bounded lx_extended_area_mm2(const struct lx_emitter *emitter)
{
    return lx_emitter_kind(emitter)->area_mm2(emitter);
}

/* The irradiance by the law 1/r^2 of an element that the source does not touch; its normal is a unit vector. */
lx_bounded lx_extended_irradiance(const struct lx_emitter *emitter, lx_bounded3 place_mm, lx_bounded3 normal);

/* An isotropic point in its middle that has the intensity of its area. */
struct lx_emitter lx_extended_as_point(const struct lx_emitter *emitter);

/* Appends the point emitters that stand for the source when it is cut into parts (SPEC: `parts: N`).  0, or -1 when
 * memory ran out. */
int lx_extended_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);

/* r^2 a(r), r in metres: the law of an emitter relative to the inverse square. */
double lx_relative_law(const struct lx_emitter *emitter, double distance_mm);

#endif
