/* SPDX-License-Identifier: MIT */
/*
 * Kinds of surfaces.  A kind describes its authored parameters by a table and prepares its constants.
 * To add a kind: a file like sphere.c, and a line in registry.c.
 */
#ifndef LX_SURFACE_SURFACE_H
#define LX_SURFACE_SURFACE_H

#include "../base/bounded.h"
#include "../parameter/table.h"

/* A line of sight: origin + t direction, t > 0; the direction need not be of unit length. */
struct lx_ray {
    double origin_mm[3], direction[3];
};

/* Where a ray meets a surface: after t times its direction. */
struct lx_hit {
    bool exists;
    double t;
    lx_bounded3 place_mm, normal;
};

struct lx_sphere_parameters {
    uint64_t given;
    double center_mm[3];
    double radius_mm;
};

/* The shapes that the kernels know, with their constants. */
enum lx_shape_type { LX_SPHERE, LX_SHAPE_TYPES };

struct lx_shape {
    enum lx_shape_type type;
    double anchor_mm[3]; /* offsets on the surface are measured from here: a sphere's centre */
    double radius_mm;
};

struct lx_surface_kind {
    struct lx_variant variant; /* first, so that a variant of the list `surfaces` is its kind */
    /* The extent of the surface along the axes, in mm: lowest and highest x, y, z. */
    void (*extent)(const void *parameters, double low_mm[3], double high_mm[3]);
    /* The shape for the kernels. */
    struct lx_shape (*shape)(const void *parameters);
    /* The reference: the first point of the surface on the ray, seen from outside. */
    struct lx_hit (*hit)(const void *parameters, const struct lx_ray *ray);
    /* Whether the surface crosses the open way from a place to `towards` away from it, that is between the
     * parameters 0 and 1 of place + t towards; `endless`: from 0 on.  1 or 0, the error 1 where it is in doubt. */
    lx_bounded (*blocks)(const void *parameters, lx_bounded3 place_mm, lx_bounded3 towards, bool endless);
    /* Whether a place lies on the surface, to 1e-9 of its size. */
    bool (*holds)(const void *parameters, const double place_mm[3]);
};

/* NULL-terminated: the variants of the list `surfaces`. */
extern const struct lx_variant *const lx_surface_variants[];

#endif
