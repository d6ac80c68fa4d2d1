/* SPDX-License-Identifier: MIT */
/* The side of a cylinder: what its shape keeps, and how offsets from its centre lie to its axis. */
#ifndef LX_SURFACE_CYLINDER_H
#define LX_SURFACE_CYLINDER_H

#include "../base/vector.h"
#include "plane.h"

/* The shape keeps the radius and half the height, with room for rounding, as own[0] and own[1]. */
static inline double lx_cylinder_radius(const struct lx_shape *cylinder)
{
    return cylinder->own[0];
}

static inline double lx_cylinder_half(const struct lx_shape *cylinder)
{
    return cylinder->own[1];
}

/* The part of an offset from the centre that lies across the axis, and that along it. */
static inline void lx_cylinder_split(const struct lx_shape *cylinder, const double offset_mm[3], double aside[3],
                                     double *along)
{
    *along = lx_dot(offset_mm, cylinder->axis);
    for (int i = 0; i < 3; i++)
        aside[i] = offset_mm[i] - *along * cylinder->axis[i];
}

/* Members of the kind. */
extern const struct lx_surface_chart lx_cylinder_chart;
void lx_cylinder_outline(const struct lx_shape *cylinder, const struct lx_origin *eye, int i, int steps,
                         double place_mm[3], double inside_mm[3]);

#endif
