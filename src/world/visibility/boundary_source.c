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

/* A source and an obstacle, between which a plane is looked for. */
struct pair {
    const struct lx_occlusion *occlusion;
    const struct lx_emitter *emitter;
    const struct lx_obstacle *obstacle;
    enum lx_boundary_stand stand;
    double beyond_mm; /* how far the obstacle may reach over the plane */
};

/* Whether what is flat is almost parallel to a plane: what lies on the source hides nothing of it. */
static bool may_lie_on(const struct lx_obstacle *obstacle, const double n[3])
{
    static const double STEEP = 0.1;
    double size = 2 * obstacle->radius_mm;
    if (obstacle->type != LX_OBSTACLE_POLYGON && obstacle->type != LX_OBSTACLE_DISK)
        return false;
    for (unsigned i = 1; i < obstacle->corner_count; i++)
        for (int k = 0; k < 3; k++)
            size = fmax(size, fabs(obstacle->corners_mm[i][k] - obstacle->corners_mm[0][k]));
    const double back[3] = {-n[0], -n[1], -n[2]};
    return extent_of(obstacle, n) + extent_of(obstacle, back) < STEEP * size;
}

/*
 * Tries planes across a direction, of any length.  If one has the obstacle on this side and the source on the other,
 * rays from the element on this side meet the obstacle first; those from the other side meet it after the source, or
 * never.  What is on the plane is on either side.
 */
static bool is_parted(struct pair *pair, const double direction[3])
{
    double n[3] = {direction[0], direction[1], direction[2]}, nearest;
    if (!(lx_normalize(n) > 0))
        return false;
    lx_emitter_extent(pair->emitter, pair->occlusion->place_mm, n, &nearest);
    pair->beyond_mm = fmax(extent_of(pair->obstacle, n) - nearest, 0);
    if (!(pair->beyond_mm <= pair->obstacle->touch_mm))
        return false;
    pair->stand = nearest >= 0 ? LX_BOUNDARY_BEFORE : LX_BOUNDARY_BEYOND;
    return pair->stand == LX_BOUNDARY_BEYOND || !may_lie_on(pair->obstacle, n) ||
           extent_of(pair->obstacle, n) < nearest - pair->obstacle->touch_mm;
}

static bool is_parted_along(struct pair *pair, const double axis[3])
{
    return is_parted(pair, axis) || is_parted(pair, (const double[]){-axis[0], -axis[1], -axis[2]});
}

/* By the faces that look to the element. */
static bool is_parted_by_faces(struct pair *pair)
{
    const struct lx_facets *facets = pair->emitter->facets;
    for (size_t f = 0; f < facets->face_count; f++) {
        double normal[3];
        if (plane_of(pair->occlusion, facets, f, normal) < 0 &&
            is_parted(pair, (const double[]){-normal[0], -normal[1], -normal[2]}))
            return true;
    }
    return false;
}

/* By planes that touch a round source, or are its ends. */
static bool is_parted_by_round(struct pair *pair)
{
    const struct lx_emitter *emitter = pair->emitter;
    double center[3];
    for (int k = 0; k < 3; k++)
        center[k] = emitter->center_mm[k] - pair->occlusion->place_mm[k];
    if (!lx_has_axis(emitter))
        return is_parted(pair, center);
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    const struct lx_boundary_tube tube = lx_boundary_tube_of(center, axis, emitter->radius_mm, lx_half_height(emitter));
    return is_parted_along(pair, axis) || (lx_emitter_kind(emitter)->has_side &&
                                           is_parted(pair, (const double[]){-tube.out[0], -tube.out[1], -tube.out[2]}));
}

/* By planes of a flat obstacle, or that touch a pipe, or are its ends, on the way from the element. */
static bool is_parted_by_obstacle(struct pair *pair)
{
    const struct lx_obstacle *obstacle = pair->obstacle;
    double axis[3], first[3], second[3];
    if (obstacle->type == LX_OBSTACLE_BALL)
        return false;
    memcpy(axis, obstacle->axis, sizeof axis);
    if (obstacle->type == LX_OBSTACLE_POLYGON) {
        for (int k = 0; k < 3; k++) {
            first[k] = obstacle->corners_mm[1][k] - obstacle->corners_mm[0][k];
            second[k] = obstacle->corners_mm[2][k] - obstacle->corners_mm[0][k];
        }
        lx_cross(first, second, axis);
    }
    if (is_parted_along(pair, axis))
        return true;
    const struct lx_boundary_tube tube =
        lx_boundary_tube_of(obstacle->center_mm, obstacle->axis, obstacle->radius_mm, obstacle->half_mm);
    return obstacle->type == LX_OBSTACLE_TUBE &&
           is_parted(pair, (const double[]){-tube.out[0], -tube.out[1], -tube.out[2]});
}

/* Across the way from the obstacle to the source: from where its axis is nearest to that, and from its middle. */
static bool is_parted_between(struct pair *pair)
{
    const struct lx_obstacle *obstacle = pair->obstacle;
    const double *center = lx_emitter_center(pair->emitter);
    double way[3];
    for (int k = 0; k < 3; k++) {
        way[k] = center[k] - pair->occlusion->place_mm[k] - obstacle->center_mm[k];
        for (unsigned i = 0; i < obstacle->corner_count; i++)
            way[k] -= obstacle->corners_mm[i][k] / obstacle->corner_count;
    }
    if (is_parted(pair, way))
        return true;
    if (obstacle->type != LX_OBSTACLE_TUBE)
        return false;
    const double along = lx_dot(way, obstacle->axis);
    const double nearest = fmax(fmin(along, obstacle->half_mm), -obstacle->half_mm);
    double aside[3];
    for (int k = 0; k < 3; k++) {
        aside[k] = way[k] - along * obstacle->axis[k];
        way[k] -= nearest * obstacle->axis[k];
    }
    return is_parted(pair, way) || is_parted(pair, aside);
}

/* Whether the source is beyond the middle of a ball, where all rays that meet it have met it before. */
static bool is_behind_ball(const struct pair *pair)
{
    const struct lx_obstacle *ball = pair->obstacle;
    double axis[3], nearest;
    if (ball->type != LX_OBSTACLE_BALL)
        return false;
    memcpy(axis, ball->center_mm, sizeof axis);
    const double away = lx_normalize(axis);
    lx_emitter_extent(pair->emitter, pair->occlusion->place_mm, axis, &nearest);
    return nearest > away + ball->touch_mm;
}

enum lx_boundary_stand lx_boundary_stand(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                                         const struct lx_obstacle *obstacle, double *beyond_mm)
{
    struct pair pair = {occlusion, emitter, obstacle, LX_BOUNDARY_BEFORE, 0};
    const bool is_known = is_behind_ball(&pair) ||
                          (emitter->facets ? is_parted_by_faces(&pair) : is_parted_by_round(&pair)) ||
                          is_parted_by_obstacle(&pair) || is_parted_between(&pair);
    *beyond_mm = pair.beyond_mm;
    return is_known ? pair.stand : LX_BOUNDARY_UNKNOWN;
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
