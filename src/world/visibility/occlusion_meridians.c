/* SPDX-License-Identifier: MIT */
/* The longitudes at which obstacles begin, end, and have corners. */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "occlusion.h"

/* The longitudes of the planes through the pole that touch the circle around a centre: n.(C C^T - R^2 (1 - a a^T)).n
 * = 0 for their normals n, or of a ball without the axis. */
static size_t touch_circle(const double center[3], const double *axis, double radius,
                           const struct lx_sweep_frame *frame, double meridians[2][3])
{
    const double *x = frame->x, *y = frame->y, square = radius * radius;
    const double cx = lx_dot(center, x), cy = lx_dot(center, y), ax = axis ? lx_dot(axis, x) : 0,
                 ay = axis ? lx_dot(axis, y) : 0;
    const double a = cx * cx - square * (1 - ax) * (1 + ax), b = cx * cy + square * ax * ay,
                 c = cy * cy - square * (1 - ay) * (1 + ay), below = b * b - a * c;
    if (!(below > 0))
        return 0;
    /* a nx^2 + 2 b nx ny + c ny^2 = 0, of n = (-sin, cos) of the longitude */
    const double root = sqrt(below), larger = b > 0 ? -b - root : -b + root;
    const double normals[2][2] = {{larger, a}, {c, larger}};
    for (int i = 0; i < 2; i++) {
        const double sign = normals[i][1] < 0 ? -1 : 1;
        for (int k = 0; k < 3; k++)
            meridians[i][k] = sign * (normals[i][1] * x[k] - normals[i][0] * y[k]);
    }
    return 2;
}

size_t lx_obstacle_meridians(const struct lx_obstacle *obstacle, const struct lx_sweep_frame *frame,
                             double meridians[LX_MOST_MERIDIANS][3], bool *round)
{
    *round = obstacle->type != LX_OBSTACLE_POLYGON;
    switch (obstacle->type) {
    case LX_OBSTACLE_POLYGON:
        memcpy(meridians, obstacle->corners_mm, obstacle->corner_count * sizeof *meridians);
        return obstacle->corner_count;
    case LX_OBSTACLE_DISK:
        return touch_circle(obstacle->center_mm, obstacle->axis, obstacle->radius_mm, frame, meridians);
    case LX_OBSTACLE_BALL: return touch_circle(obstacle->center_mm, NULL, obstacle->radius_mm, frame, meridians);
    case LX_OBSTACLE_TUBE: {
        size_t count = 0;
        for (int sign = -1; sign <= 1; sign += 2) {
            double center[3];
            for (int k = 0; k < 3; k++)
                center[k] = obstacle->center_mm[k] + sign * obstacle->half_mm * obstacle->axis[k];
            count += touch_circle(center, obstacle->axis, obstacle->radius_mm, frame, meridians + count);
        }
        return count;
    }
    case LX_OBSTACLE_SPACE:
    case LX_OBSTACLE_SHAPE: break;
    }
    return 0;
}
