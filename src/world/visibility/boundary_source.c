/* SPDX-License-Identifier: MIT */
/* The source of a boundary: of which shapes it is as an element sees it, and whether obstacles are before it. */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "../../light/solid/extended.h"
#include "boundary_bodies.h"

/* ---- what is before it ---- */

/* How far an obstacle comes at most along a unit direction from the element. */
static double extent_of(const struct lx_obstacle *obstacle, const double direction[3])
{
    double most = -HUGE_VAL;
    if (obstacle->type == LX_OBSTACLE_POLYGON) {
        for (unsigned i = 0; i < obstacle->corner_count; i++)
            most = fmax(most, lx_dot(direction, obstacle->corners_mm[i]));
        return most;
    }
    const double middle = lx_dot(direction, obstacle->center_mm);
    if (obstacle->type == LX_OBSTACLE_BALL)
        return middle + obstacle->radius_mm;
    const double along = fmin(fabs(lx_dot(direction, obstacle->axis)), 1);
    return middle + obstacle->radius_mm * sqrt(1 - along * along) +
           (obstacle->type == LX_OBSTACLE_TUBE ? obstacle->half_mm * along : 0);
}

/* Whether an obstacle is on the front side of a plane, normal.x = height from the place. */
static bool is_in_front(const struct lx_obstacle *obstacle, const double normal[3], double height)
{
    return extent_of(obstacle, (const double[]){-normal[0], -normal[1], -normal[2]}) < -height;
}

static void corner_from(const struct lx_occlusion *occlusion, const struct lx_facets *facets, unsigned i,
                        double corner[3])
{
    const lx_wide3 *wide = &facets->corners_mm[i];
    corner[0] = wide->x.high - occlusion->place_mm[0];
    corner[1] = wide->y.high - occlusion->place_mm[1];
    corner[2] = wide->z.high - occlusion->place_mm[2];
}

/* The plane of a face: its normal, and how high it is over the element: below 0 where it looks to it. */
static double plane_of(const struct lx_occlusion *occlusion, const struct lx_facets *facets, size_t f, double normal[3])
{
    const struct lx_face *face = &facets->faces[f];
    double corner[3];
    normal[0] = face->normal.x.high, normal[1] = face->normal.y.high, normal[2] = face->normal.z.high;
    corner_from(occlusion, facets, facets->loop[face->first], corner);
    return lx_dot(normal, corner);
}

/* Whether a face that looks to the element has an obstacle before its plane. */
static bool is_before_face(const struct lx_occlusion *occlusion, const struct lx_facets *facets,
                           const struct lx_obstacle *obstacle)
{
    for (size_t f = 0; f < facets->face_count; f++) {
        double normal[3];
        const double height = plane_of(occlusion, facets, f, normal);
        if (height < 0 && is_in_front(obstacle, normal, height))
            return true;
    }
    return false;
}

/* The plane of what is round: the one that touches a ball, or a side, where that is nearest, or one of an end. */
static bool is_before_round(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                            const struct lx_obstacle *obstacle)
{
    double center[3], back[3];
    for (int k = 0; k < 3; k++) {
        center[k] = emitter->center_mm[k] - occlusion->place_mm[k];
        back[k] = -center[k];
    }
    if (!lx_has_axis(emitter)) {
        const double away = lx_normalize(back);
        return is_in_front(obstacle, back, emitter->radius_mm - away);
    }
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    const double half = lx_half_height(emitter);
    const struct lx_boundary_tube tube = lx_boundary_tube_of(center, axis, emitter->radius_mm, half);
    const double opposite[3] = {-axis[0], -axis[1], -axis[2]};
    return (lx_emitter_kind(emitter)->has_side && tube.away > tube.radius &&
            is_in_front(obstacle, tube.out, tube.radius - tube.away)) ||
           (tube.height > half && is_in_front(obstacle, axis, half - tube.height)) ||
           (tube.height < -half && is_in_front(obstacle, opposite, half + tube.height));
}

/*
 * Whether the source is beyond a plane which all rays to it that meet the obstacle have met it before: of what is flat
 * its own, of a ball the one through its centre that looks to the element, of a pipe those that touch it on its other
 * side.
 */
static bool is_beyond_obstacle(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                               const struct lx_obstacle *obstacle)
{
    double axes[3][3], nearest;
    unsigned count = 1;
    memcpy(axes[0], obstacle->axis, sizeof axes[0]);
    if (obstacle->type == LX_OBSTACLE_BALL) {
        memcpy(axes[0], obstacle->center_mm, sizeof axes[0]);
        const double away = lx_normalize(axes[0]);
        lx_emitter_extent(emitter, occlusion->place_mm, axes[0], &nearest);
        return nearest > away + obstacle->touch_mm;
    }
    if (obstacle->type == LX_OBSTACLE_POLYGON) {
        double first[3], second[3];
        for (int k = 0; k < 3; k++) {
            first[k] = obstacle->corners_mm[1][k] - obstacle->corners_mm[0][k];
            second[k] = obstacle->corners_mm[2][k] - obstacle->corners_mm[0][k];
        }
        lx_cross(first, second, axes[0]);
        lx_normalize(axes[0]);
    } else if (obstacle->type == LX_OBSTACLE_TUBE) {
        const struct lx_boundary_tube tube =
            lx_boundary_tube_of(obstacle->center_mm, obstacle->axis, obstacle->radius_mm, obstacle->half_mm);
        for (int k = 0; k < 3; k++) {
            axes[1][k] = -tube.out[k];
            axes[2][k] = obstacle->center_mm[k];
        }
        lx_normalize(axes[2]);
        count = 3;
    }
    const double *at = obstacle->type == LX_OBSTACLE_POLYGON ? obstacle->corners_mm[0] : obstacle->center_mm;
    const double side = lx_dot(axes[0], at);
    for (int k = 0; k < 3 && side < 0; k++)
        axes[0][k] = -axes[0][k];
    for (unsigned i = 0; i < count; i++) {
        lx_emitter_extent(emitter, occlusion->place_mm, axes[i], &nearest);
        if (nearest > fmax(extent_of(obstacle, axes[i]), 0) + obstacle->touch_mm)
            return true;
    }
    return false;
}

bool lx_boundary_is_before(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter)
{
    for (size_t i = 0; i < occlusion->obstacles.count; i++) {
        const struct lx_obstacle *obstacle = &occlusion->obstacles.items[i];
        const bool is_before = emitter->facets ? is_before_face(occlusion, emitter->facets, obstacle)
                                               : is_before_round(occlusion, emitter, obstacle);
        if (!is_before && !is_beyond_obstacle(occlusion, emitter, obstacle))
            return false;
    }
    return true;
}

/* ---- the source ---- */

/* The edges of an outline, each from one corner to another. */
struct rim {
    unsigned from[LX_BOUNDARY_SIDES], to[LX_BOUNDARY_SIDES], count;
};

static bool looks_to_place(const struct lx_occlusion *occlusion, const struct lx_facets *facets, int face)
{
    double normal[3];
    return face != LX_NO_FACE && plane_of(occlusion, facets, (size_t)face, normal) < 0;
}

/* The edges between faces that look to the element and others; false: there are too many. */
static bool find_rim(const struct lx_occlusion *occlusion, const struct lx_facets *facets, struct rim *rim)
{
    rim->count = 0;
    for (size_t e = 0; e < facets->edge_count; e++) {
        const struct lx_edge *edge = &facets->edges[e];
        const bool left = looks_to_place(occlusion, facets, edge->left);
        if (left == looks_to_place(occlusion, facets, edge->right))
            continue;
        if (rim->count + 1 == LX_BOUNDARY_SIDES)
            return false;
        rim->from[rim->count] = left ? edge->from : edge->to;
        rim->to[rim->count++] = left ? edge->to : edge->from;
    }
    return true;
}

bool lx_boundary_face(const struct lx_occlusion *occlusion, const struct lx_facets *facets, size_t f,
                      struct lx_boundary_polygon *outline, double away[3])
{
    const struct lx_face *face = &facets->faces[f];
    outline->count = 0;
    const double height = plane_of(occlusion, facets, f, away);
    for (int k = 0; k < 3; k++)
        away[k] = -away[k];
    if (!(height < 0))
        return true;
    if (face->count + 1 > LX_BOUNDARY_SIDES)
        return false;
    for (unsigned i = 0; i < face->count; i++)
        corner_from(occlusion, facets, facets->loop[face->first + i], outline->corners[i]);
    outline->count = face->count;
    return true;
}

/* The outline of facets as the element sees them, without corners where it sees nothing of them.  False: it has too
 * many. */
static bool find_outline(const struct lx_occlusion *occlusion, const struct lx_facets *facets,
                         struct lx_boundary_polygon *outline)
{
    enum { MOST_EDGES = 64 }; /* of bodies whose outlines have few corners */
    struct rim rim;
    double unused[3];
    if (facets->face_count == 1)
        return lx_boundary_face(occlusion, facets, 0, outline, unused);
    if (facets->edge_count > MOST_EDGES || !find_rim(occlusion, facets, &rim))
        return false;
    outline->count = 0;
    for (unsigned i = 0, next = 0; i < rim.count; i++) {
        const unsigned end = rim.to[next];
        corner_from(occlusion, facets, rim.from[next], outline->corners[outline->count++]);
        for (next = 0; next < rim.count && rim.from[next] != end;)
            next++;
        if (next == rim.count)
            return false;
    }
    return true;
}

/* A square around a disk, its outline apart, or around a ball. */
static void make_square(const double center[3], const double p[3], const double q[3], double radius,
                        struct lx_boundary_polygon *square)
{
    const double WIDER = 1.02;
    square->count = 4;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            square->corners[i][k] =
                center[k] + WIDER * radius * ((i == 0 || i == 3 ? 1 : -1) * p[k] + (i < 2 ? 1 : -1) * q[k]);
}

/* An end of a cylinder, or a disk; nothing where it is seen edge-on. */
static void add_disk(const double center[3], const double axis[3], double radius, struct lx_boundary_shapes *shapes)
{
    struct lx_boundary_shape *shape = &shapes->items[shapes->count];
    if (!lx_boundary_disk(center, axis, radius, &shape->curve, &shapes->unsure))
        return;
    shape->has_curve = true;
    make_square(shape->curve.g, shape->curve.p, shape->curve.q, 1, &shape->polygon);
    shapes->count++;
}

static bool shape_ball(const double center[3], double radius, struct lx_boundary_shapes *shapes)
{
    const double MOST = 2; /* a tangent */
    struct lx_boundary_shape *shape = &shapes->items[0];
    struct lx_boundary_body body = {.sides = &shape->curve};
    if (!lx_boundary_add_ball(center, radius, &body) || !(shape->curve.sine < MOST * shape->curve.limit))
        return false;
    shape->has_curve = true;
    make_square(shape->curve.g, shape->curve.p, shape->curve.q, shape->curve.sine / shape->curve.limit,
                &shape->polygon);
    shapes->count = 1;
    return true;
}

static void shape_cylinder(const double center[3], const double axis[3], double radius, double half,
                           struct lx_boundary_shapes *shapes)
{
    const struct lx_boundary_tube tube = lx_boundary_tube_of(center, axis, radius, half);
    if (tube.away > tube.radius) {
        shapes->items[0] = (struct lx_boundary_shape){.polygon = lx_boundary_side_of_tube(&tube)};
        shapes->count = 1;
    }
    for (int i = 0; i < 2; i++)
        if (tube.away > tube.radius || (i == 0 ? tube.height > tube.half : tube.height < -tube.half))
            add_disk(tube.ends[i], axis, radius, shapes);
}

bool lx_boundary_shape(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                       struct lx_boundary_shapes *shapes)
{
    double center[3];
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    shapes->count = 0;
    shapes->unsure = 0;
    for (int k = 0; k < 3; k++)
        center[k] = emitter->center_mm[k] - occlusion->place_mm[k];
    if (emitter->facets) {
        shapes->items[0].has_curve = false;
        if (!find_outline(occlusion, emitter->facets, &shapes->items[0].polygon))
            return false;
        shapes->count = shapes->items[0].polygon.count > 0;
        return true;
    }
    if (!lx_has_axis(emitter))
        return shape_ball(center, emitter->radius_mm, shapes);
    if (lx_is_capsule(emitter))
        return false;
    if (lx_emitter_kind(emitter)->has_side)
        shape_cylinder(center, axis, emitter->radius_mm, lx_half_height(emitter), shapes);
    else if (lx_dot(center, axis) < 0)
        add_disk(center, axis, emitter->radius_mm, shapes);
    return true;
}
