/* SPDX-License-Identifier: MIT */
/* Balls in the way of thick lines, and shapes in the way of light. */
#include "blocking.h"

#include <math.h>

#include "general.h"

struct lx_ball lx_shape_ball(const struct lx_shape *shape, const double low_mm[3], const double high_mm[3],
                             const double anchor_mm[3])
{
    struct lx_ball ball;
    for (int i = 0; i < 3; i++)
        ball.center[i] = shape->anchor_mm[i] - anchor_mm[i];
    ball.radius = hypot(hypot(high_mm[0] - low_mm[0], high_mm[1] - low_mm[1]), high_mm[2] - low_mm[2]) / 2;
    return ball;
}

struct lx_ball lx_ball_from(const struct lx_ball *ball, const double anchor_mm[3])
{
    const double *center = ball->center;
    return (struct lx_ball){.center = {center[0] - anchor_mm[0], center[1] - anchor_mm[1], center[2] - anchor_mm[2]},
                            .radius = ball->radius};
}

bool lx_may_block(const struct lx_ball *blocker, const struct lx_ball *from, const struct lx_ball *towards,
                  bool endless)
{
    double way[3], offset[3], along = 0, square = 0, gap = 0;
    for (int i = 0; i < 3; i++) {
        way[i] = towards->center[i] - (endless ? 0 : from->center[i]);
        offset[i] = blocker->center[i] - from->center[i];
        along += offset[i] * way[i];
        square += way[i] * way[i];
    }
    double t = square > 0 ? fmax(along / square, 0) : 0;
    if (!endless)
        t = fmin(t, 1);
    for (int i = 0; i < 3; i++)
        gap += (offset[i] - t * way[i]) * (offset[i] - t * way[i]);
    double thick = endless ? from->radius : fmax(from->radius, towards->radius);
    return !(sqrt(gap) > (blocker->radius + thick) * (1 + 1e-9));
}

/* Whether all ways between two balls, or from one in a direction, stay on one side of the plane of what is flat. */
static bool is_beside_plane(const struct lx_shape *flat, const struct lx_ball *middle, const struct lx_ball *from,
                            const struct lx_ball *towards, bool endless)
{
    double height = 0, further = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        const double way = from->center[i] - middle->center[i];
        const double other = towards->center[i] - (endless ? 0 : middle->center[i]);
        height += flat->axis[i] * way;
        further += flat->axis[i] * other;
        size += fabs(way) + fabs(other);
    }
    const double margin = from->radius + 1e-9 * size + 2 * flat->touch_mm + flat->behind_mm;
    const double far = endless ? further : fabs(further) > towards->radius + margin ? further : 0;
    return fabs(height) > margin && (height > 0 ? far > 0 : far < 0);
}

bool lx_shape_may_block(const struct lx_shape *shape, const double anchor_mm[3], const struct lx_ball *from,
                        const struct lx_ball *towards, bool endless)
{
    struct lx_ball ball = {.radius = shape->radius_mm + lx_shape_room(shape)};
    for (int i = 0; i < 3; i++)
        ball.center[i] = shape->anchor_mm[i] - anchor_mm[i];
    return lx_may_block(&ball, from, towards, endless) &&
           !(lx_shape_is_flat(shape) && is_beside_plane(shape, &ball, from, towards, endless));
}

bool lx_are_before_wall(const struct lx_shape *wall, const struct lx_shape *lit, const struct lx_origin *light)
{
    const double room = 2 * wall->touch_mm - wall->behind_mm,
                 back[3] = {-wall->axis[0], -wall->axis[1], -wall->axis[2]};
    double lowest[3], height = 0, end = 0;
    if (!(wall->behind_mm > 0) || !lit->kind->bounds)
        return false;
    const double around = lit->kind->bounds->support(lit, back, lowest);
    for (int i = 0; i < 3; i++) {
        height += wall->axis[i] * (lit->anchor_mm[i] + lowest[i] - wall->anchor_mm[i]);
        end += wall->axis[i] * (light->at[i] - (light->endless ? 0 : wall->anchor_mm[i]));
    }
    return height - around > room && end > (light->endless ? 0 : room);
}

void lx_block_one(const struct lx_kernels *kernels, const struct lx_shape *shape, bool is_own,
                  const double anchor_mm[3], const struct lx_light_double *light, const struct lx_block_double *block,
                  size_t count, float *open)
{
    struct lx_blocker blocker = {
        .shape = lx_shape_in_the_way(shape),
        .is_point = light->kind != LX_DISTANT,
        .light = {light->x, light->y, light->z},
    };
    for (int i = 0; i < 3; i++)
        blocker.shape.anchor_mm[i] -= anchor_mm[i];
    lx_block_shape(kernels, &blocker, is_own, block, count, open);
}
