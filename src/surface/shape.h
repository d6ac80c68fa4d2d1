/* SPDX-License-Identifier: MIT */
/* The shape of a surface: the constants that its kind's reference and kernels compute with. */
#ifndef LX_SURFACE_SHAPE_H
#define LX_SURFACE_SHAPE_H

struct lx_surface_kind;

/* The kernels that a shape has; a kind without kernels of its own goes the general way, by its float64 reference. */
enum lx_shape_type { LX_SPHERE, LX_PLATE, LX_SHAPE_TYPES, LX_GENERAL = LX_SHAPE_TYPES };

/* A table of kernels that are called name_sphere, and so on. */
#define LX_BY_SHAPE(name)                                                                                              \
    {                                                                                                                  \
        [LX_SPHERE] = name##_sphere, [LX_PLATE] = name##_plate                                                         \
    }

struct lx_shape {
    enum lx_shape_type type;
    const struct lx_surface_kind *kind;
    double anchor_mm[3]; /* offsets on the surface are measured from here: its centre */
    double radius_mm;    /* no point of it is farther away: a sphere's radius, half a plate's diagonal */
    /* of a kind that has an axis: */
    double normal[3];                     /* the axis without rounding, of a length near 1 */
    double axis[3], across[3], upward[3]; /* unit: the axis, and two directions at right angles to it */
    double axis_error[3], across_error[3], upward_error[3];
    double half_mm[2]; /* a plate's half width and half height, with room for rounding: edges belong to it */
    double touch_mm;   /* places that near to it lie on it: nothing is between them and it */
    double behind_mm;  /* of a room's walls: in the way of light it stands so much farther back, and also before
                        * its own back (surface.h) */
    double own[4];     /* what else a kind wants */
    const void *body;  /* what it has too much of for that, held by the parameters; NULL: nothing */
};

#endif
