/* SPDX-License-Identifier: MIT */
/* Carrying places and directions into a frame and back. */
#include "frame.h"

#include <string.h>

#include "pose.h"

struct lx_frame lx_frame_own(void)
{
    struct lx_frame frame = {.is_own = true};
    for (int i = 0; i < 3; i++) {
        const double axis[3] = {i == 0, i == 1, i == 2};
        frame.axes[i] = lx_wide3_of(axis);
        frame.rounded[i] = lx_exact3(axis);
    }
    return frame;
}

static bool is_along(lx_bounded3 axis, int i)
{
    return axis.x.value == (i == 0) && axis.y.value == (i == 1) && axis.z.value == (i == 2) && axis.x.error == 0 &&
           axis.y.error == 0 && axis.z.error == 0;
}

struct lx_frame lx_frame_towards(const double origin_mm[3], const double towards_mm[3], const double up[3])
{
    const struct lx_pose pose = lx_pose_towards(origin_mm, towards_mm, up);
    struct lx_frame frame = {.axes = {pose.across, pose.upward, pose.axis}};
    frame.is_own = true;
    for (int i = 0; i < 3; i++) {
        frame.origin_mm[i] = origin_mm[i];
        frame.rounded[i] = lx_wide3_direction(frame.axes[i]);
        frame.is_own = frame.is_own && origin_mm[i] == 0 && is_along(frame.rounded[i], i);
    }
    return frame.is_own ? lx_frame_own() : frame;
}

lx_wide3 lx_frame_turn_wide(const struct lx_frame *frame, lx_wide3 direction)
{
    if (frame->is_own)
        return direction;
    return (lx_wide3){lx_wide3_dot(frame->axes[0], direction), lx_wide3_dot(frame->axes[1], direction),
                      lx_wide3_dot(frame->axes[2], direction)};
}

lx_wide3 lx_frame_carry_wide(const struct lx_frame *frame, lx_wide3 place_mm)
{
    if (frame->is_own)
        return place_mm;
    return lx_frame_turn_wide(frame, lx_wide3_sub(place_mm, lx_wide3_of(frame->origin_mm)));
}

/* x, y and z along the axes. */
static lx_wide3 along_axes(const struct lx_frame *frame, const double components[3])
{
    lx_wide3 sum = lx_wide3_mul(frame->axes[0], lx_wide_of(components[0]));
    sum = lx_wide3_add(sum, lx_wide3_mul(frame->axes[1], lx_wide_of(components[1])));
    return lx_wide3_add(sum, lx_wide3_mul(frame->axes[2], lx_wide_of(components[2])));
}

void lx_frame_carry(const struct lx_frame *frame, const double place_mm[3], double carried_mm[3])
{
    if (frame->is_own)
        memmove(carried_mm, place_mm, 3 * sizeof *carried_mm);
    else
        lx_wide3_values(lx_frame_carry_wide(frame, lx_wide3_of(place_mm)), carried_mm);
}

void lx_frame_bring(const struct lx_frame *frame, const double carried_mm[3], double place_mm[3])
{
    if (frame->is_own)
        memmove(place_mm, carried_mm, 3 * sizeof *place_mm);
    else
        lx_wide3_values(lx_wide3_add(lx_wide3_of(frame->origin_mm), along_axes(frame, carried_mm)), place_mm);
}

void lx_frame_turn(const struct lx_frame *frame, const double direction[3], double turned[3])
{
    if (frame->is_own)
        memmove(turned, direction, 3 * sizeof *turned);
    else
        lx_wide3_values(lx_frame_turn_wide(frame, lx_wide3_of(direction)), turned);
}

void lx_frame_turn_back(const struct lx_frame *frame, const double turned[3], double direction[3])
{
    if (frame->is_own)
        memmove(direction, turned, 3 * sizeof *direction);
    else
        lx_wide3_values(along_axes(frame, turned), direction);
}

/* The error of a component is no more than those of the direction's, and what a wide number is rounded by. */
static lx_bounded component(lx_wide3 axis, lx_bounded3 along, const double direction[3], lx_bounded3 errors)
{
    const lx_wide sum = lx_wide3_dot(axis, lx_wide3_of(direction));
    const double inherited = (fabs(along.x.value) + along.x.error) * errors.x.error +
                             (fabs(along.y.value) + along.y.error) * errors.y.error +
                             (fabs(along.z.value) + along.z.error) * errors.z.error;
    const double value = lx_wide_value(sum), rest = fabs(lx_wide_value(lx_wide_sub(sum, lx_wide_of(value))));
    const double size = fabs(direction[0]) + fabs(direction[1]) + fabs(direction[2]);
    const bool is_exact = along.x.error == 0 && along.y.error == 0 && along.z.error == 0; /* one of the scene's axes */
    return (lx_bounded){value, (inherited + rest + (is_exact ? 0 : 0x1p-90 * size)) * LX_BOUND_SLACK};
}

lx_bounded3 lx_frame_turn_bounded(const struct lx_frame *frame, lx_bounded3 direction)
{
    if (frame->is_own)
        return direction;
    const double values[3] = {direction.x.value, direction.y.value, direction.z.value};
    return (lx_bounded3){component(frame->axes[0], frame->rounded[0], values, direction),
                         component(frame->axes[1], frame->rounded[1], values, direction),
                         component(frame->axes[2], frame->rounded[2], values, direction)};
}

double lx_distance(const double a[3], const double b[3])
{
    const lx_wide3 way = lx_wide3_sub(lx_wide3_of(a), lx_wide3_of(b));
    const double high[3] = {way.x.high, way.y.high, way.z.high};
    if (!(isfinite(high[0]) && isfinite(high[1]) && isfinite(high[2])))
        return HUGE_VAL;
    const double scale = lx_scale_for3(lx_exact3(high));
    const lx_wide3 near = {lx_wide_scale(way.x, scale), lx_wide_scale(way.y, scale), lx_wide_scale(way.z, scale)};
    return lx_wide_value(lx_wide3_length(near)) / scale;
}
