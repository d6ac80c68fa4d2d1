/* SPDX-License-Identifier: MIT */
/*
 * The dome: an emitter at no finite distance, which has a radiance by direction: the sky, the ground beyond all
 * surfaces, the disk of the sun.  It is made of patches of the sphere of directions.  To light an element, a patch is
 * put up around it as an extended emitter, farther away than all that may stand in its light: what lights and hides
 * these does so with the sky.
 *
 * Patches of a sky that is not uniform are triangles between the sun, the zenith and the horizon, so that its radiance
 * is smooth on each: at the sun it has a corner.
 */
#ifndef LX_LIGHT_SKY_DOME_H
#define LX_LIGHT_SKY_DOME_H

#include "../../base/frame.h"
#include "../emitter.h"
#include "../solid/area_light_facets.h"
#include "dome_keeping.h"
#include "luminance.h"

enum { LX_DOME_CORNERS = 3, LX_MOST_VIEW_CORNERS = 8, LX_MOST_DOME_PATCHES = 12, LX_MOST_DOME_VIEWS = 6 };

/* Around the origin, at about the distance 1. */
struct lx_dome_patch {
    struct lx_facets *facets; /* one triangle that shines inwards; NULL: a disk */
    lx_bounded3 towards;      /* the way to the disk's middle, and its radius */
    double radius;
    lx_bounded radiance;
    bool is_even; /* everywhere the radiance; else that times the luminance of the sky relative to the zenith */
};

struct lx_dome {
    struct lx_kept kept; /* several emitters may use it */
    struct lx_sky sky;
    double up[3];
    lx_bounded facing;         /* the irradiance of a plane across `up` or, of the sun, its direction */
    lx_bounded zenith, ground; /* of a sky, its radiance there, and that of the ground */
    struct lx_dome_patch patches[LX_MOST_DOME_PATCHES];
    size_t patch_count;
};

/* Whether it is a disk, and has a direction in which that is. */
static inline bool lx_is_sun(const struct lx_dome *dome)
{
    return dome->patch_count == 1 && !dome->patches[0].facets;
}

/* Whether one of them is a dome: there are no kernels for these. */
static inline bool lx_has_dome(const struct lx_emitters *emitters)
{
    bool found = false;
    for (size_t i = 0; i < lx_item_count(emitters) && emitters->extended > 0 && !found; i++)
        found = lx_is_dome(&emitters->items[i]);
    return found;
}

/* A patch as an emitter around a place, so far away: a power of two; it points into itself. */
struct lx_dome_view {
    struct lx_emitter emitter;
    struct lx_facets facets;
    struct lx_face face;
    lx_wide3 corners_mm[LX_MOST_VIEW_CORNERS];
    struct lx_edge edges[LX_MOST_VIEW_CORNERS];
    unsigned loop[LX_MOST_VIEW_CORNERS];
};
void lx_dome_see(const struct lx_dome *dome, size_t patch, const double place_mm[3], double away_mm,
                 struct lx_dome_view *view);

/* What is seen of a sky and its ground through a rectangle whose corners are so far from a place, in their order, as
 * convex polygons in a plane along it: the sky whole or, where the sun is in it and `is_cut`, as triangles that have it
 * in a corner.  The unit normal of the rectangle leads away from the place.  Returns how many views were set. */
size_t lx_dome_see_through(const struct lx_dome *dome, const lx_wide3 rim[4], lx_wide3 outwards,
                           const double place_mm[3], double away_mm, bool is_cut,
                           struct lx_dome_view views[LX_MOST_DOME_VIEWS]);

/* The sky with the radiance of its zenith, and the ground below with one of its own; NULL: memory ran out. */
struct lx_dome *lx_dome_of_sky(const struct lx_sky *sky, lx_bounded zenith, lx_bounded ground);
/* A disk in a direction, under half the angle `half_rad`, which gives so much to a plane that faces it. */
struct lx_dome *lx_dome_of_disk(lx_bounded3 towards, double half_rad, double irradiance);
#endif
