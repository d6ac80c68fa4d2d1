/* SPDX-License-Identifier: MIT */
/*
 * What a mesh puts between elements and an extended source: its outlines in a shaft, and the triangles that reach
 * beyond where the source begins, but for those on which the element lies; and what is behind the face of an element
 * of its own.
 */
#include <string.h>

#include "../base/vector.h"
#include "mesh.h"
#include "mesh_edges.h"
#include "obstacle.h"

/* A search for outlines in a shaft, which is in the frame of the tree. */
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

static void carry_plane(const struct lx_shape *shape, const double plane[4], double room_mm, double made[4])
{
    made[0] = lx_dot(plane, shape->across);
    made[1] = lx_dot(plane, shape->upward);
    made[2] = lx_dot(plane, shape->axis);
    made[3] = (lx_dot(plane, shape->anchor_mm) + plane[3] + room_mm) / lx_mesh_size_of(shape);
}

/* A shaft in the frame of the tree, wider by what lies on a face without touching it. */
static struct lx_shaft shaft_in_tree(const struct lx_shape *shape, const struct lx_shaft *shaft)
{
    const double touch = shape->touch_mm;
    struct lx_shaft made = {.plane_count = shaft->plane_count};
    carry_ball(shape, shaft->from_mm, shaft->from_radius_mm + touch, made.from_mm, &made.from_radius_mm);
    carry_ball(shape, shaft->to_mm, shaft->outline_radius_mm + touch, made.to_mm, &made.to_radius_mm);
    for (unsigned i = 0; i < shaft->plane_count; i++)
        carry_plane(shape, shaft->planes[i], touch, made.planes[i]);
    carry_plane(shape, shaft->before, -touch, made.before);
    return made;
}

/* A pyramid from the place is bounded by its planes alone: the hull of balls around it need not be asked, which takes
 * longer than all of them. */
enum { PYRAMID = 5 };

static bool meets_shaft(const void *data, const double low[3], const double high[3])
{
    static const double ROOM = 1e-11; /* the tree is no larger than 1 */
    const struct lx_shaft *shaft = &((const struct gathering *)data)->shaft;
    if (shaft->plane_count < PYRAMID)
        return lx_shaft_meets_box(shaft, low, high);
    for (unsigned i = 0; i < shaft->plane_count; i++) {
        const double *plane = shaft->planes[i];
        double most = plane[3];
        for (int k = 0; k < 3; k++)
            most += plane[k] * (plane[k] > 0 ? high[k] : low[k]);
        if (most < -ROOM)
            return false;
    }
    return true;
}

static bool edge_meets_shaft(const struct lx_shaft *shaft, const double ends[2][3])
{
    static const double ROOM = 1e-11;
    if (shaft->plane_count < PYRAMID)
        return lx_shaft_meets_hull(shaft, ends, 2);
    for (unsigned i = 0; i < shaft->plane_count; i++) {
        const double *plane = shaft->planes[i];
        if (lx_dot(plane, ends[0]) + plane[3] < -ROOM && lx_dot(plane, ends[1]) + plane[3] < -ROOM)
            return false;
    }
    return true;
}

/* Whether a box is not all before the source. */
static bool reaches_beyond(const void *data, const double low[3], const double high[3])
{
    const struct gathering *gathering = data;
    const double *plane = gathering->shaft.before;
    double least = plane[3];
    for (int k = 0; k < 3; k++)
        least += plane[k] * (plane[k] > 0 ? low[k] : high[k]);
    return least < 0;
}

static bool take_edge(void *data, const double from[3], const double to[3], int change)
{
    struct gathering *gathering = data;
    const double ends[2][3] = {{from[0], from[1], from[2]}, {to[0], to[1], to[2]}};
    struct lx_outline_edge edge = {.change = change};
    if (!edge_meets_shaft(&gathering->shaft, ends))
        return true;
    lx_mesh_leave_place(gathering->shape, from, edge.from_mm);
    lx_mesh_leave_place(gathering->shape, to, edge.to_mm);
    gathering->failed = lx_obstacles_append_edge(gathering->obstacles, &edge) < 0;
    return !gathering->failed;
}

static bool take_triangle(void *data, const struct lx_tree_triangle *triangle)
{
    struct gathering *gathering = data;
    struct lx_sheet sheet = {.turn = lx_triangle_turn(triangle, gathering->shaft.from_mm)};
    if (!lx_shaft_meets_hull(&gathering->shaft, triangle->corners, 3))
        return true;
    for (int c = 0; c < 3; c++) {
        sheet.names[c] = triangle->names[c];
        lx_mesh_leave_place(gathering->shape, triangle->corners[c], sheet.corners_mm[c]);
    }
    gathering->failed = lx_obstacles_append_sheet(gathering->obstacles, &sheet) < 0;
    return !gathering->failed;
}

int lx_mesh_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    const struct lx_mesh_body *body = shape->body;
    if (!lx_shaft_meets_ball(shaft, shape->anchor_mm, shape->radius_mm + shape->touch_mm))
        return 0;
    struct gathering gathering = {
        .shape = shape,
        .shaft = shaft_in_tree(shape, shaft),
        .obstacles = obstacles,
    };
    struct lx_tree_outline outline = {
        .touch = shape->touch_mm / lx_mesh_size_of(shape),
        .meets = meets_shaft,
        .reaches_beyond = reaches_beyond,
        .take_edge = take_edge,
        .take_triangle = take_triangle,
        .data = &gathering,
    };
    memcpy(outline.place, gathering.shaft.from_mm, sizeof outline.place);
    lx_tree_outline(body->tree, &outline);
    return gathering.failed || lx_obstacles_append_layered(obstacles, shape) ? -1 : 0;
}

int lx_mesh_gather_beside(const struct lx_shape *shape, double facing, const struct lx_obstacle *beyond,
                          const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    struct lx_obstacle behind = *beyond;
    if (lx_mesh_face_normal(shape, shaft->from_mm, behind.axis)) {
        for (int k = 0; k < 3 && facing < 0; k++)
            behind.axis[k] = -behind.axis[k];
        if (lx_obstacles_append(obstacles, &behind))
            return -1;
    }
    return lx_mesh_gather(shape, shaft, obstacles);
}

unsigned lx_mesh_layers(const struct lx_shape *shape, const double from_mm[3], const double way[3])
{
    const struct lx_mesh_body *body = shape->body;
    struct lx_tree_ray ray = {.from = 0, .to = 1};
    lx_mesh_enter(shape, from_mm, ray.origin);
    lx_mesh_enter(shape, way, ray.direction);
    return lx_tree_count(body->tree, &ray, shape->touch_mm / lx_mesh_size_of(shape));
}
