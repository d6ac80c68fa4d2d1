/* SPDX-License-Identifier: MIT */
/* The sides of surfaces, for elements whose normal need not be that of the surface they lie on. */
#include <math.h>

#include "../base/vector.h"
#include "beside.h"

/* In general light from the other side of the tangent plane has to come through the surface. */
static lx_bounded tangent_hides(const double own[3], double facing, lx_bounded3 towards)
{
    lx_bounded above = lx_dot3(lx_exact3(own), towards);
    above.error += 4 * LX_ROUNDING * sqrt(lx_square3(towards).value); /* of the normal */
    return lx_step(facing < 0 ? above : lx_negate(above), false);
}

/* The shape's own normal at a place, and the cosine of another one to it. */
static double facing_of(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal, double own[3])
{
    const lx_bounded *places[3] = {&place_mm.x, &place_mm.y, &place_mm.z};
    double offset[3];
    for (int i = 0; i < 3; i++)
        offset[i] = places[i]->value - shape->anchor_mm[i];
    shape->kind->normal(shape, offset, own);
    return lx_dot(own, (double[]){normal.x.value, normal.y.value, normal.z.value});
}

bool lx_shape_is_turned(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal)
{
    double own[3];
    return facing_of(shape, place_mm, normal, own) < 1 - LX_SAME_NORMAL;
}

lx_bounded lx_shape_hides(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal, lx_bounded3 towards,
                          bool endless)
{
    double own[3];
    const double facing = facing_of(shape, place_mm, normal, own);
    if (facing >= 1 - LX_SAME_NORMAL && !shape->kind->normal_seen)
        return lx_exact(0);
    if (shape->kind->hides)
        return shape->kind->hides(shape, place_mm, facing, towards, endless);
    return lx_is_other_front(shape, facing) ? lx_exact(0) : tangent_hides(own, facing, towards);
}

bool lx_shape_encloses(const struct lx_shape *shape, const double place_mm[3])
{
    return shape->kind->encloses && shape->kind->encloses(shape, place_mm);
}
