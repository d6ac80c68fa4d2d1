/* SPDX-License-Identifier: MIT */
/* What a mesh puts between elements and an extended source: its triangles in a shaft, which the tree finds. */
#include <math.h>
#include <string.h>

#include "../base/vector.h"
#include "mesh.h"
#include "obstacle.h"

/* Cutting sources by obstacles takes too long for more of them: larger meshes take no light of extended sources. */
enum { MOST_OBSTACLES = 24 };

/* A search for triangles in a shaft, which is in the frame of the tree. */
struct gathering {
    const struct lx_shape *shape;
    struct lx_shaft shaft;
    struct lx_obstacles *obstacles;
    bool failed;
};

static void carry_ball(const struct lx_shape *shape, const double center_mm[3], double radius_mm, double center[3],
                       double *radius)
{
    double offset[3];
    for (int k = 0; k < 3; k++)
        offset[k] = center_mm[k] - shape->anchor_mm[k];
    lx_mesh_enter(shape, offset, center);
    *radius = radius_mm / lx_mesh_size_of(shape);
}

/* A shaft in the frame of the tree, wider by what lies on a face without touching it. */
static struct lx_shaft shaft_in_tree(const struct lx_shape *shape, const struct lx_shaft *shaft)
{
    const double size = lx_mesh_size_of(shape), touch = shape->touch_mm;
    struct lx_shaft made = {.plane_count = shaft->plane_count};
    carry_ball(shape, shaft->from_mm, shaft->from_radius_mm + touch, made.from_mm, &made.from_radius_mm);
    carry_ball(shape, shaft->to_mm, shaft->to_radius_mm + touch, made.to_mm, &made.to_radius_mm);
    for (unsigned i = 0; i < shaft->plane_count; i++) {
        const double *plane = shaft->planes[i];
        made.planes[i][0] = lx_dot(plane, shape->across);
        made.planes[i][1] = lx_dot(plane, shape->upward);
        made.planes[i][2] = lx_dot(plane, shape->axis);
        made.planes[i][3] = (lx_dot(plane, shape->anchor_mm) + plane[3] + touch) / size;
    }
    return made;
}

static bool meets_shaft(const void *data, const double low[3], const double high[3])
{
    const struct gathering *gathering = data;
    return lx_shaft_meets_box(&gathering->shaft, low, high);
}

static bool take_triangle(void *data, const struct lx_tree_triangle *triangle)
{
    struct gathering *gathering = data;
    const struct lx_shape *shape = gathering->shape;
    struct lx_obstacle obstacle = {.type = LX_OBSTACLE_POLYGON, .corner_count = 3, .touch_mm = shape->touch_mm};
    if (!lx_shaft_meets_hull(&gathering->shaft, triangle->corners, 3))
        return true;
    for (int c = 0; c < 3; c++) {
        lx_mesh_leave(shape, triangle->corners[c], obstacle.corners_mm[c]);
        for (int k = 0; k < 3; k++)
            obstacle.corners_mm[c][k] = obstacle.corners_mm[c][k] * lx_mesh_size_of(shape) + shape->anchor_mm[k];
    }
    gathering->failed = lx_obstacles_append(gathering->obstacles, &obstacle) < 0;
    return !gathering->failed;
}

int lx_mesh_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    const struct lx_mesh_body *body = shape->body;
    if (body->tree->triangle_count > MOST_OBSTACLES)
        return 0;
    struct gathering gathering = {shape, shaft_in_tree(shape, shaft), obstacles, false};
    const struct lx_tree_search search = {meets_shaft, take_triangle, &gathering};
    lx_tree_search(body->tree, &search);
    return gathering.failed ? -1 : 0;
}
