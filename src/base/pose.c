/* SPDX-License-Identifier: MIT */
/* The directions of a rectangle, as wide numbers: whoever stands right at its edge still finds it where it is. */
#include "pose.h"

/* A vector brought near the length 1 by a power of two: its products neither overflow nor vanish. */
static lx_wide3 scaled(const double v[3])
{
    double scale = lx_scale_for3(lx_exact3(v));
    return lx_wide3_of((double[]){v[0] * scale, v[1] * scale, v[2] * scale});
}

bool lx_are_parallel(const double a[3], const double b[3])
{
    lx_wide3 first = scaled(a), second = scaled(b);
    double sine = lx_wide_value(lx_wide3_length(lx_wide3_cross(first, second)));
    double size = lx_wide_value(lx_wide3_length(first)) * lx_wide_value(lx_wide3_length(second));
    return !(sine > 1e-12 * size);
}

void lx_usual_up(const double axis[3], double up[3])
{
    static const double y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
    const double *chosen = lx_are_parallel(axis, y) ? z : y;
    for (int i = 0; i < 3; i++)
        up[i] = chosen[i];
}

/* The factors of the first product are float64 numbers, so it loses nothing where they are nearly parallel. */
struct lx_pose lx_pose_of(const double axis[3], const double up[3])
{
    struct lx_pose pose;
    pose.axis = lx_wide3_unit(scaled(axis));
    pose.across = lx_wide3_unit(lx_wide3_cross(scaled(up), scaled(axis)));
    pose.upward = lx_wide3_cross(pose.axis, pose.across);
    return pose;
}

struct lx_pose lx_pose_towards(const double from[3], const double to[3], const double up[3])
{
    lx_wide3 way = lx_wide3_sub(lx_wide3_of(to), lx_wide3_of(from));
    double scale = lx_scale_for3((lx_bounded3){lx_exact(way.x.high), lx_exact(way.y.high), lx_exact(way.z.high)});
    way = (lx_wide3){lx_wide_scale(way.x, scale), lx_wide_scale(way.y, scale), lx_wide_scale(way.z, scale)};
    struct lx_pose pose;
    pose.axis = lx_wide3_unit(way);
    pose.across = lx_wide3_unit(lx_wide3_cross(scaled(up), way));
    pose.upward = lx_wide3_cross(pose.axis, pose.across);
    return pose;
}

/* Along the axes a direction is exact; else it has its rounding, and, with room, that of the wide number. */
static lx_bounded rounded(lx_wide a, bool exact)
{
    double value = lx_wide_value(a);
    double rest = lx_wide_value(lx_wide_sub(a, lx_wide_of(value)));
    return (lx_bounded){value, exact ? 0 : fabs(rest) * LX_BOUND_SLACK + 0x1p-90};
}

lx_bounded3 lx_wide3_direction(lx_wide3 a)
{
    double x = lx_wide_value(a.x), y = lx_wide_value(a.y), z = lx_wide_value(a.z);
    bool exact = (x == 0) + (y == 0) + (z == 0) == 2;
    return (lx_bounded3){rounded(a.x, exact), rounded(a.y, exact), rounded(a.z, exact)};
}
