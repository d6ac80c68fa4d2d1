/* SPDX-License-Identifier: MIT */
/* The sides of spheres and plates, for elements whose normal need not be that of the surface they lie on. */
#include <math.h>

#include "beside.h"

/* An element whose normal is off by less than this (1 less the cosine, for about a milliradian) has the normal of the
 * surface that it lies on, as far as who typed it could tell. */
static const double SAME_NORMAL = 5e-7;

/* What is no farther from a surface than this share of its size lies on it, as `holds` has it. */
static const double ON_SURFACE = 1e-9;

/*
 * An element that looks outwards loses the light from below the tangent plane.  One that looks inwards, such as that of
 * a table where a ball touches it, has what is inside the sphere in front of it, and loses all light from outside.
 */
static lx_bounded sphere_hides(const struct lx_shape *sphere, lx_bounded3 place_mm, lx_bounded3 normal,
                               lx_bounded3 towards, bool endless)
{
    lx_bounded3 from = lx_sub3(place_mm, lx_exact3(sphere->anchor_mm));
    double cosine = lx_dot3(lx_unit3(from), normal).value;
    if (cosine >= 1 - SAME_NORMAL)
        return lx_exact(0);
    if (cosine >= 0)
        return lx_step(lx_negate(lx_dot3(from, towards)), false);
    if (endless)
        return lx_exact(1);
    return lx_step(lx_sub(lx_length3(lx_add3(from, towards)), lx_exact(sphere->radius_mm)), false);
}

/* An element of a plate is on the side that it looks to: light from the other side has to come through. */
static lx_bounded plate_hides(const struct lx_shape *plate, lx_bounded3 normal, lx_bounded3 towards)
{
    lx_bounded3 axis = {{plate->axis[0], plate->axis_error[0]},
                        {plate->axis[1], plate->axis_error[1]},
                        {plate->axis[2], plate->axis_error[2]}};
    double cosine = lx_dot3(axis, normal).value;
    if (fabs(cosine) >= 1 - SAME_NORMAL)
        return lx_exact(0);
    lx_bounded above = lx_dot3(axis, towards);
    return lx_step(cosine < 0 ? above : lx_negate(above), false);
}

lx_bounded lx_shape_hides(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal, lx_bounded3 towards,
                          bool endless)
{
    return shape->type == LX_SPHERE ? sphere_hides(shape, place_mm, normal, towards, endless)
                                    : plate_hides(shape, normal, towards);
}

bool lx_shape_encloses(const struct lx_shape *shape, const double place_mm[3])
{
    lx_bounded3 from = lx_sub3(lx_exact3(place_mm), lx_exact3(shape->anchor_mm));
    return shape->type == LX_SPHERE && lx_length3(from).value < (1 - ON_SURFACE) * shape->radius_mm;
}
