/* SPDX-License-Identifier: MIT */
/* What spheres that are seen from outside (sphere.c) and from inside (inside.c) share. */
#ifndef LX_SURFACE_SPHERE_H
#define LX_SURFACE_SPHERE_H

#include "surface.h"

extern const struct lx_surface_kind lx_inside_kind;

void lx_sphere_extent(const void *parameters, double low_mm[3], double high_mm[3]);
double lx_sphere_farthest(const void *parameters, const double direction[3]);

/* Where a ray meets the sphere, with the normal outwards: the nearer, or the farther, of both places. */
struct lx_hit lx_sphere_meet(const struct lx_shape *sphere, const struct lx_ray *ray, bool farther);
/* The way between both ends, of which none is inside, comes into the sphere. */
lx_bounded lx_sphere_reached(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 towards, bool endless);
bool lx_sphere_holds(const struct lx_shape *sphere, const double place_mm[3]);
double lx_sphere_beside(const struct lx_shape *sphere, const double place_mm[3], const double way[3], bool endless);
double lx_sphere_shadow_edge(const struct lx_shape *sphere, const struct lx_origin *light, unsigned i,
                             const double place_mm[3]);

/* The middle direction of the part that faces an observer outside; returns the cosine of its rim. */
double lx_sphere_front(const struct lx_shape *sphere, const struct lx_origin *eye, double front[3]);
void lx_sphere_outline(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int steps, double place_mm[3],
                       double inside_mm[3]);

/* Directions and moves on the chart, whose coordinates are the direction from the centre. */
void lx_sphere_directions(const struct lx_shape *sphere, const double n[3], double first[3], double second[3]);
void lx_sphere_move(const struct lx_shape *sphere, const double at[3], const double first[3], const double second[3],
                    const double step_mm[2], double moved[3]);
void lx_sphere_rim(const struct lx_shape *sphere, const struct lx_origin *eye, int i, int count, double at[3]);

#endif
