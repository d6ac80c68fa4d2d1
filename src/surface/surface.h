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

/* How a rectangle lies: base/pose.h. */
struct lx_plate_parameters {
    uint64_t given;
    double center_mm[3];
    double size_mm[2];
    double axis[3], up[3];
};

/* The shapes that the kernels and references know, with their constants. */
enum lx_shape_type { LX_SPHERE, LX_PLATE, LX_SHAPE_TYPES };

struct lx_shape {
    enum lx_shape_type type;
    double anchor_mm[3]; /* offsets on the surface are measured from here: its centre */
    double radius_mm;    /* no point of it is farther away: a sphere's radius, half a plate's diagonal */
    /* of a plate: */
    double normal[3];                     /* its axis without rounding, of a length near 1 */
    double axis[3], across[3], upward[3]; /* unit: the normal, along its width, along its height */
    double axis_error[3], across_error[3], upward_error[3];
    double half_mm[2]; /* of width and height, with room for rounding: edges belong to it */
    double touch_mm;   /* places that near to its plane lie on it: nothing is between them and it */
};

/* How an observer stands to a surface. */
enum lx_standing {
    LX_STANDS_BEFORE,  /* where the surface can be seen */
    LX_STANDS_TOO_LOW, /* not above all of it */
    LX_STANDS_BEHIND,  /* behind its front, or in its plane */
    LX_TURNED_AWAY     /* its front is turned away from whoever looks along -z */
};

struct lx_surface_kind {
    struct lx_variant variant; /* first, so that a variant of the list `surfaces` is its kind */
    /* The extent of the surface along the axes, in mm: lowest and highest x, y, z. */
    void (*extent)(const void *parameters, double low_mm[3], double high_mm[3]);
    /* How far it reaches along a direction: the greatest place . direction over the surface. */
    double (*farthest)(const void *parameters, const double direction[3]);
    /* The shape: the constants that the kernels and the reference below compute with. */
    struct lx_shape (*shape)(const void *parameters);
    /* The reference: the first point of the surface on the ray, seen from outside. */
    struct lx_hit (*hit)(const struct lx_shape *shape, const struct lx_ray *ray);
    /* Whether the surface crosses the open way from a place to `towards` away from it, that is between the
     * parameters 0 and 1 of place + t towards; `endless`: from 0 on.  1 or 0, the error 1 where it is in doubt. */
    lx_bounded (*blocks)(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless);
    /* Whether a place lies on the surface, to 1e-9 of its size. */
    bool (*holds)(const struct lx_shape *shape, const double place_mm[3]);
    /* How an observer stands to it who is at (0, 0, z), or, not in perspective, looks along -z from all that height. */
    enum lx_standing (*standing)(const void *parameters, double observer_z_mm, bool perspective);
    /* Whether a source here lights nothing of it that is seen along -z: it is inside or behind. */
    bool (*is_dark)(const void *parameters, const double place_mm[3]);
};

/* NULL-terminated: the variants of the list `surfaces`. */
extern const struct lx_variant *const lx_surface_variants[];

#endif
