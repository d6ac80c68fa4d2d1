/* SPDX-License-Identifier: MIT */
/* What holds for every kind of surface that does not know better. */
#include <math.h>
#include <string.h>

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

bool lx_surface_has_sides(const struct lx_surface_kind *kind)
{
    return kind->sheets || kind->mesh || kind->part;
}

struct lx_shape lx_shape_carried(const struct lx_shape *shape, const struct lx_frame *frame)
{
    struct lx_shape carried = *shape;
    if (frame->is_own)
        return carried;
    struct {
        double *value, *error;
    } directions[] = {{carried.axis, carried.axis_error},
                      {carried.across, carried.across_error},
                      {carried.upward, carried.upward_error}};
    lx_frame_carry(frame, shape->anchor_mm, carried.anchor_mm);
    for (size_t i = 0; i < LX_COUNT(directions); i++) {
        double *value = directions[i].value, *error = directions[i].error;
        const lx_bounded3 turned = lx_frame_turn_bounded(
            frame, (lx_bounded3){{value[0], error[0]}, {value[1], error[1]}, {value[2], error[2]}});
        value[0] = turned.x.value, value[1] = turned.y.value, value[2] = turned.z.value;
        error[0] = turned.x.error, error[1] = turned.y.error, error[2] = turned.z.error;
    }
    memcpy(carried.normal, carried.axis, sizeof carried.normal);
    if (shape->kind->carry)
        shape->kind->carry(frame, &carried);
    return carried;
}

/* The farthest place in the direction of axis i, or against it, is rounded by no more than some units of its parts. */
void lx_surface_extent(const struct lx_surface_kind *kind, const void *parameters, const struct lx_frame *frame,
                       double low_mm[3], double high_mm[3])
{
    if (frame->is_own) {
        kind->extent(parameters, low_mm, high_mm);
        return;
    }
    for (int i = 0; i < 3; i++) {
        const lx_bounded3 *axis = &frame->rounded[i];
        const double ahead[3] = {axis->x.value, axis->y.value, axis->z.value};
        const double back[3] = {-ahead[0], -ahead[1], -ahead[2]}, start = lx_dot(ahead, frame->origin_mm);
        const double high = lx_surface_farthest(kind, parameters, ahead),
                     low = -lx_surface_farthest(kind, parameters, back);
        double size = fabs(high) + fabs(low);
        for (int k = 0; k < 3; k++)
            size += fabs(frame->origin_mm[k]);
        high_mm[i] = high - start + 64 * DBL_EPSILON * size;
        low_mm[i] = low - start - 64 * DBL_EPSILON * size;
    }
}

enum lx_standing lx_surface_standing(const struct lx_surface_kind *kind, const void *parameters,
                                     const struct lx_frame *frame, double observer_z_mm, bool perspective)
{
    double low[3], high[3];
    lx_surface_extent(kind, parameters, frame, low, high);
    struct lx_shape shape = lx_surface_shape(kind, parameters);
    if (!shape.kind->standing)
        return observer_z_mm > high[2] ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
    shape = lx_shape_carried(&shape, frame);
    return shape.kind->standing(&shape, high[2], observer_z_mm, perspective);
}

enum lx_standing lx_standing_within(const struct lx_shape *shape, double highest_mm, double observer_z_mm,
                                    bool perspective)
{
    (void)perspective;
    return observer_z_mm > 2 * shape->anchor_mm[2] - highest_mm ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
}

bool lx_surface_is_dark(const struct lx_surface_kind *kind, const void *parameters, const struct lx_frame *frame,
                        const double place_mm[3])
{
    double carried[3];
    struct lx_shape shape = lx_surface_shape(kind, parameters);
    if (!shape.kind->is_dark)
        return false;
    shape = lx_shape_carried(&shape, frame);
    lx_frame_carry(frame, place_mm, carried);
    return shape.kind->is_dark(&shape, carried);
}

bool lx_surface_surrounds(const struct lx_surface_kind *kind, const void *parameters, const double place_mm[3])
{
    return kind->surrounds && kind->surrounds(parameters, place_mm);
}

struct lx_shape lx_shape_in_the_way(const struct lx_shape *shape)
{
    struct lx_shape moved = *shape;
    moved.behind_mm = 0;
    for (int i = 0; i < 3 && shape->behind_mm > 0; i++)
        moved.anchor_mm[i] -= shape->behind_mm * shape->axis[i];
    for (int i = 0; i < 2 && shape->behind_mm > 0; i++)
        moved.half_mm[i] += 2 * shape->behind_mm;
    return moved;
}

double lx_shape_distance(const struct lx_shape *shape, const double offset_mm[3], double direction[3])
{
    if (shape->kind->distance)
        return shape->kind->distance(shape, offset_mm, direction);
    for (int i = 0; i < 3; i++)
        direction[i] = offset_mm[i];
    return lx_normalize(direction) - shape->radius_mm;
}

bool lx_shape_faces(const struct lx_shape *shape, const struct lx_origin *eye)
{
    return !shape->kind->faces || shape->kind->faces(shape, eye);
}

double lx_shape_beside_sight(const struct lx_shape *shape, const double place_mm[3], const struct lx_origin *eye)
{
    double way[3];
    if (shape->kind->beside_sight)
        return shape->kind->beside_sight(shape, place_mm, eye);
    const bool endless = lx_way_to(eye, place_mm, way);
    return shape->kind->beside(shape, place_mm, way, endless);
}

bool lx_shape_is_walkable(const struct lx_shape *shape)
{
    return shape->kind->chart && shape->kind->beside;
}

bool lx_shape_has_limb(const struct lx_shape *shape)
{
    return shape->kind->chart && shape->kind->chart->is_near_limb;
}
