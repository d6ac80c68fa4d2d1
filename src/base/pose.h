/* SPDX-License-Identifier: MIT */
/*
 * How a rectangle lies in space, be it a source, a surface or a measuring grid: its normal is the axis, its height h
 * runs along `up` made perpendicular to the axis, its width w along up x axis, so that seen from its front w runs to
 * the right and h upwards.
 */
#ifndef LX_BASE_POSE_H
#define LX_BASE_POSE_H

#include "wide.h"

struct lx_pose {
    lx_wide3 across, upward, axis; /* unit, at right angles: of the width, of the height, the normal */
};

/* Whether two vectors, of any lengths but 0, are parallel to 1e-12 of a radian: then they span no plane. */
bool lx_are_parallel(const double a[3], const double b[3]);

/* The `up` that is meant where none is given: (0, 1, 0), or (0, 0, 1) where the axis is parallel to that. */
void lx_usual_up(const double axis[3], double up[3]);

/* The pose of an axis and an `up` that are not parallel. */
struct lx_pose lx_pose_of(const double axis[3], const double up[3]);

/* The pose of an axis from one place to another, which need not be a float64 number. */
struct lx_pose lx_pose_towards(const double from[3], const double to[3], const double up[3]);

/* One of these directions as the nearest float64 numbers, with their rounding as the bound. */
lx_bounded3 lx_wide3_direction(lx_wide3 a);

#endif
