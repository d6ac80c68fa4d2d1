/* SPDX-License-Identifier: MIT */
/* What holds for every kind of surface that does not know better. */
#include <math.h>

#include "../base/vector.h"
#include "surface.h"

struct lx_shape lx_surface_shape(const struct lx_surface_kind *kind, const void *parameters)
{
    struct lx_shape shape = kind->shape(parameters);
    shape.kind = shape.kind ? shape.kind : kind;
    return shape;
}

double lx_surface_farthest(const struct lx_surface_kind *kind, const void *parameters, const double direction[3])
{
    if (kind->farthest)
        return kind->farthest(parameters, direction);
    double low[3], high[3], sum = 0;
    kind->extent(parameters, low, high);
    for (int i = 0; i < 3; i++)
        sum += direction[i] * (direction[i] > 0 ? high[i] : low[i]);
    return sum;
}

enum lx_standing lx_surface_standing(const struct lx_surface_kind *kind, const void *parameters, double observer_z_mm,
                                     bool perspective)
{
    if (kind->standing)
        return kind->standing(parameters, observer_z_mm, perspective);
    double low[3], high[3];
    kind->extent(parameters, low, high);
    return observer_z_mm > high[2] ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
}

bool lx_surface_is_dark(const struct lx_surface_kind *kind, const void *parameters, const double place_mm[3])
{
    return kind->is_dark && kind->is_dark(parameters, place_mm);
}

double lx_shape_distance(const struct lx_shape *shape, const double offset_mm[3], double direction[3])
{
    if (shape->kind->distance)
        return shape->kind->distance(shape, offset_mm, direction);
    for (int i = 0; i < 3; i++)
        direction[i] = offset_mm[i];
    return lx_normalize(direction) - shape->radius_mm;
}

bool lx_shape_is_walkable(const struct lx_shape *shape)
{
    return shape->kind->chart && shape->kind->beside;
}

bool lx_shape_has_limb(const struct lx_shape *shape)
{
    return shape->kind->chart && shape->kind->chart->is_near_limb;
}
