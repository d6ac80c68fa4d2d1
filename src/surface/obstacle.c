/* SPDX-License-Identifier: MIT */
/* Lists of obstacles, what may come into a shaft, and what holds for kinds that gather nothing by themselves. */
#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "beside.h"
#include "obstacle.h"

/* What rounding may do to places of some size. */
static const double ROOM = 1e-12;

int lx_obstacles_append(struct lx_obstacles *obstacles, const struct lx_obstacle *obstacle)
{
    if (lx_reserve(&obstacles->items, &obstacles->capacity, obstacles->count + 1, sizeof *obstacle))
        return -1;
    obstacles->items[obstacles->count++] = *obstacle;
    return 0;
}

int lx_obstacles_append_edge(struct lx_obstacles *obstacles, const struct lx_outline_edge *edge)
{
    if (lx_reserve(&obstacles->edges, &obstacles->edge_capacity, obstacles->edge_count + 1, sizeof *edge))
        return -1;
    obstacles->edges[obstacles->edge_count++] = *edge;
    return 0;
}

int lx_obstacles_append_sheet(struct lx_obstacles *obstacles, const struct lx_sheet *sheet)
{
    if (lx_reserve(&obstacles->sheets, &obstacles->sheet_capacity, obstacles->sheet_count + 1, sizeof *sheet))
        return -1;
    obstacles->sheets[obstacles->sheet_count++] = *sheet;
    return 0;
}

int lx_obstacles_append_layered(struct lx_obstacles *obstacles, const struct lx_shape *shape)
{
    if (lx_reserve(&obstacles->layered, &obstacles->layered_capacity, obstacles->layered_count + 1,
                   sizeof *obstacles->layered))
        return -1;
    obstacles->layered[obstacles->layered_count++] = shape;
    return 0;
}

void lx_obstacles_clear(struct lx_obstacles *obstacles)
{
    free(obstacles->items);
    free(obstacles->edges);
    free(obstacles->sheets);
    free(obstacles->layered);
    *obstacles = (struct lx_obstacles){.items = NULL};
}

static double size_of(const double place_mm[3])
{
    return fabs(place_mm[0]) + fabs(place_mm[1]) + fabs(place_mm[2]);
}

/*
 * The hull of two balls is that of all balls between them, at a + t w with the radius r + t k: a place at x along w
 * and y aside is as far from it as the least of sqrt((x - t w)^2 + y^2) - r - t k, which is convex in t.
 */
bool lx_shaft_meets_ball(const struct lx_shaft *shaft, const double center_mm[3], double radius_mm)
{
    double way[3], offset[3], t;
    const double growth = shaft->to_radius_mm - shaft->from_radius_mm;
    const double room =
        ROOM * (size_of(center_mm) + radius_mm + size_of(shaft->from_mm) + size_of(shaft->to_mm) + shaft->to_radius_mm);
    for (unsigned i = 0; i < shaft->plane_count; i++)
        if (lx_dot(shaft->planes[i], center_mm) + shaft->planes[i][3] < -radius_mm - room)
            return false;
    for (int i = 0; i < 3; i++) {
        way[i] = shaft->to_mm[i] - shaft->from_mm[i];
        offset[i] = center_mm[i] - shaft->from_mm[i];
    }
    const double length = lx_normalize(way), along = lx_dot(offset, way);
    const double aside = sqrt(fmax(lx_dot(offset, offset) - along * along, 0));
    const double slope = length > 0 ? growth / length : HUGE_VAL;
    if (fabs(slope) < 1)
        t = fmin(fmax((along + slope * aside / sqrt((1 - slope) * (1 + slope))) / length, 0), 1);
    else
        t = growth > 0; /* one ball holds the other */
    const double beyond = along - t * length;
    const double gap = sqrt(beyond * beyond + aside * aside) - shaft->from_radius_mm - t * growth;
    return !(gap > radius_mm + room);
}

bool lx_shaft_meets_box(const struct lx_shaft *shaft, const double low_mm[3], const double high_mm[3])
{
    double middle[3], half[3];
    for (int i = 0; i < 3; i++) {
        middle[i] = low_mm[i] + (high_mm[i] - low_mm[i]) / 2;
        half[i] = (high_mm[i] - low_mm[i]) / 2;
    }
    const double room = ROOM * (size_of(low_mm) + size_of(high_mm));
    for (unsigned i = 0; i < shaft->plane_count; i++) {
        const double *plane = shaft->planes[i];
        const double reach = fabs(plane[0]) * half[0] + fabs(plane[1]) * half[1] + fabs(plane[2]) * half[2];
        if (lx_dot(plane, middle) + plane[3] < -reach - room)
            return false;
    }
    return lx_shaft_meets_ball(shaft, middle, sqrt(lx_dot(half, half)));
}

bool lx_shaft_meets_hull(const struct lx_shaft *shaft, const double (*places_mm)[3], size_t count)
{
    double middle[3] = {0, 0, 0}, reach = 0;
    for (size_t k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            middle[i] += places_mm[k][i] / (double)count;
    for (size_t k = 0; k < count; k++) {
        const double offset[3] = {places_mm[k][0] - middle[0], places_mm[k][1] - middle[1],
                                  places_mm[k][2] - middle[2]};
        reach = fmax(reach, sqrt(lx_dot(offset, offset)));
    }
    const double room = ROOM * (size_of(middle) + reach);
    for (unsigned i = 0; i < shaft->plane_count; i++) {
        double farthest = -HUGE_VAL;
        for (size_t k = 0; k < count; k++)
            farthest = fmax(farthest, lx_dot(shaft->planes[i], places_mm[k]) + shaft->planes[i][3]);
        if (farthest < -room)
            return false;
    }
    return lx_shaft_meets_ball(shaft, middle, reach);
}

int lx_shape_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    if (shape->kind->gather)
        return shape->kind->gather(shape, shaft, obstacles);
    if (!lx_shaft_meets_ball(shaft, shape->anchor_mm, shape->radius_mm + shape->touch_mm))
        return 0;
    return lx_obstacles_append(obstacles, &(struct lx_obstacle){.type = LX_OBSTACLE_SHAPE, .shape = shape});
}

int lx_shape_gather_beside(const struct lx_shape *shape, const double normal[3], const struct lx_shaft *shaft,
                           struct lx_obstacles *obstacles)
{
    struct lx_obstacle beyond = {.type = LX_OBSTACLE_SPACE};
    double offset[3];
    for (int i = 0; i < 3; i++)
        offset[i] = shaft->from_mm[i] - shape->anchor_mm[i];
    shape->kind->normal(shape, offset, beyond.axis);
    const double facing = lx_dot(beyond.axis, normal);
    if (facing >= 1 - LX_SAME_NORMAL && !shape->kind->normal_seen)
        return 0;
    if (facing < 0)
        for (int i = 0; i < 3; i++)
            beyond.axis[i] = -beyond.axis[i];
    if (shape->kind->gather_beside)
        return shape->kind->gather_beside(shape, facing, &beyond, shaft, obstacles);
    return lx_is_other_front(shape, facing) ? 0 : lx_obstacles_append(obstacles, &beyond);
}
