/* SPDX-License-Identifier: MIT */
/* Conics on a plane: made of what light has for edges in space, and cut by lines. */
#include "flux_edges.h"

#include <math.h>

#include "../base/vector.h"
#include "../light/extended.h"
#include "blocking.h"

/* A quadratic form in space: q(Q) = square |Q - at|^2 + along (axis.(Q - at))^2 + (slope.(Q - at)) + rest. */
struct quadric {
    double at[3], axis[3], slope[3];
    double square, along, rest;
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void subtract(const double a[3], const double b[3], double difference[3])
{
    for (int i = 0; i < 3; i++)
        difference[i] = a[i] - b[i];
}

static void copy(const double from[3], double to[3])
{
    for (int i = 0; i < 3; i++)
        to[i] = from[i];
}

static void value_of(lx_bounded3 a, double value[3])
{
    value[0] = a.x.value, value[1] = a.y.value, value[2] = a.z.value;
}

static double value_at(const void *data, const double place[3])
{
    const struct quadric *q = data;
    double from[3];
    subtract(place, q->at, from);
    double along = dot(q->axis, from);
    return q->square * dot(from, from) + q->along * along * along + dot(q->slope, from) + q->rest;
}

/* A quadratic function of a place; NaN: there is none. */
typedef double quadratic(const void *data, const double place[3]);

/* Its conic on the plane, from its values at six places. */
static void add_conic(const struct lx_cells *plane, quadratic *value, const void *data, struct lx_edges *edges)
{
    static const double places[6][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}};
    double across[3], upward[3], values[6];
    if (edges->count == LX_MOST_EDGES)
        return;
    value_of(lx_wide3_direction(plane->pose.across), across);
    value_of(lx_wide3_direction(plane->pose.upward), upward);
    for (int p = 0; p < 6; p++) {
        double place[3];
        for (int i = 0; i < 3; i++)
            place[i] = plane->center_mm[i] + places[p][0] * plane->size_mm[0] * across[i] +
                       places[p][1] * plane->size_mm[1] * upward[i];
        values[p] = value(data, place);
        if (isnan(values[p]))
            return;
    }
    double *c = edges->conics[edges->count++].c;
    c[0] = values[0];
    c[1] = (values[1] - values[2]) / 2;
    c[2] = (values[3] - values[4]) / 2;
    c[3] = (values[1] + values[2]) / 2 - values[0];
    c[5] = (values[3] + values[4]) / 2 - values[0];
    c[4] = values[5] - c[0] - c[1] - c[2] - c[3] - c[5];
}

static void add(const struct lx_cells *plane, const struct quadric *q, struct lx_edges *edges)
{
    add_conic(plane, value_at, q, edges);
}

static void add_plane(const struct lx_cells *plane, const double at[3], const double normal[3], struct lx_edges *edges)
{
    struct quadric q = {.square = 0};
    copy(at, q.at);
    copy(normal, q.slope);
    add(plane, &q, edges);
}

/* All places from which `apex` is seen under the cosine to the axis, a unit vector. */
static void add_cone(const struct lx_cells *plane, const double apex[3], const double axis[3], double cosine,
                     struct lx_edges *edges)
{
    struct quadric q = {.square = -cosine * cosine, .along = 1};
    copy(apex, q.at);
    copy(axis, q.axis);
    add(plane, &q, edges);
}

/* ---- surfaces in the way ---- */

struct shadow {
    const struct lx_shape *shape;
    struct lx_origin light;
    unsigned edge;
};

static double shadow_at(const void *data, const double place[3])
{
    const struct shadow *shadow = data;
    return shadow->shape->kind->shadow_edge(shadow->shape, &shadow->light, shadow->edge, place);
}

/* Whether a surface may come between the plane and a light without size; what does not would take the room for edges of
 * those that do. */
static bool may_fall_on(const struct lx_cells *plane, const struct lx_shape *shape, const struct lx_emitter *emitter)
{
    const bool endless = emitter->type == LX_DIRECTION;
    const struct lx_ball from = {.radius = hypot(plane->size_mm[0], plane->size_mm[1]) / 2};
    struct lx_ball towards = {.radius = 0}, ball = {.radius = shape->radius_mm + lx_shape_room(shape)};
    value_of(emitter->towards, towards.center);
    if (!endless)
        subtract(emitter->position_mm, plane->center_mm, towards.center);
    subtract(shape->anchor_mm, plane->center_mm, ball.center);
    return lx_may_block(&ball, &from, &towards, endless);
}

static void add_shadow(const struct lx_cells *plane, const struct lx_shape *shape, const struct lx_emitter *emitter,
                       struct lx_edges *edges)
{
    struct shadow shadow = {.shape = shape, .light.endless = emitter->type == LX_DIRECTION};
    copy(emitter->position_mm, shadow.light.at);
    if (shadow.light.endless)
        value_of(emitter->towards, shadow.light.at);
    for (; shadow.edge < shape->kind->shadow_edges; shadow.edge++)
        add_conic(plane, shadow_at, &shadow, edges);
}

/* ---- emitters ---- */

/* Where its profile breaks; a half-plane counts as the whole one. */
static void add_point(const struct lx_cells *plane, const struct lx_emitter *emitter, struct lx_edges *edges)
{
    struct lx_break place;
    double normal[3];
    for (size_t i = 0; lx_profile_break(&emitter->profile, i, &place); i++) {
        lx_cross(place.axis, place.begin, normal);
        if (place.shape == LX_BREAK_PLANE)
            add_plane(plane, emitter->position_mm, place.axis, edges);
        else if (place.shape == LX_BREAK_HALF_PLANE)
            add_plane(plane, emitter->position_mm, normal, edges);
        else if (place.angle_rad > 0 && place.angle_rad < M_PI)
            add_cone(plane, emitter->position_mm, place.axis, cos(place.angle_rad), edges);
    }
}

/* Where faces set. */
static void add_faces(const struct lx_cells *plane, const struct lx_emitter *emitter, struct lx_edges *edges)
{
    double normal[3];
    if (emitter->type == LX_DISK) {
        value_of(emitter->axis, normal);
        add_plane(plane, emitter->center_mm, normal, edges);
    }
    for (size_t i = 0; emitter->type == LX_FACETS && i < emitter->facets->face_count; i++) {
        const struct lx_face *face = &emitter->facets->faces[i];
        const lx_wide3 *corner = &emitter->facets->corners_mm[emitter->facets->loop[face->first]];
        const double at[3] = {lx_wide_value(corner->x), lx_wide_value(corner->y), lx_wide_value(corner->z)};
        value_of(lx_wide3_direction(face->normal), normal);
        add_plane(plane, at, normal, edges);
    }
}

void lx_edges_add(const struct lx_prepared *prepared, const struct lx_cells *plane, const struct lx_emitter *emitter,
                  bool may_be_hidden, struct lx_edges *edges)
{
    if (emitter->type == LX_POINT)
        add_point(plane, emitter, edges);
    add_faces(plane, emitter, edges);
    for (size_t s = 0; may_be_hidden && s < prepared->surface_count; s++)
        if (may_fall_on(plane, &prepared->surfaces[s].shape, emitter))
            add_shadow(plane, &prepared->surfaces[s].shape, emitter, edges);
}

/* ---- lines ---- */

struct found {
    double *list;
    size_t count, most;
};

static void note(struct found *found, double x)
{
    if (fabs(x) < 0.5 && found->count < found->most)
        found->list[found->count++] = x;
}

/* The roots of a + b x + c x^2, by the form that does not cancel. */
static void note_roots(double a, double b, double c, struct found *found)
{
    double square = b * b - 4 * a * c;
    if (!(square >= 0))
        return;
    double q = -(b + copysign(sqrt(square), b)) / 2;
    if (q != 0)
        note(found, a / q);
    if (c != 0)
        note(found, q / c);
}

size_t lx_edges_across(const struct lx_edges *edges, double v, double *u, size_t most)
{
    struct found found = {.list = u, .most = most};
    for (size_t i = 0; i < edges->count; i++) {
        const double *c = edges->conics[i].c;
        note_roots(c[0] + v * (c[2] + v * c[5]), c[1] + v * c[4], c[3], &found);
    }
    return found.count;
}

/* Where two straight edges meet. */
static void note_corner(const double a[6], const double b[6], struct found *found)
{
    double size_a = fabs(a[1]) + fabs(a[2]), size_b = fabs(b[1]) + fabs(b[2]);
    if (fabs(a[3]) + fabs(a[4]) + fabs(a[5]) > 1e-9 * size_a || fabs(b[3]) + fabs(b[4]) + fabs(b[5]) > 1e-9 * size_b)
        return;
    double turn = a[1] * b[2] - a[2] * b[1];
    if (fabs(turn) > 1e-12 * size_a * size_b)
        note(found, (a[0] * b[1] - a[1] * b[0]) / turn);
}

size_t lx_edges_turn(const struct lx_edges *edges, double *v, size_t most)
{
    struct found found = {.list = v, .most = most};
    for (size_t i = 0; i < edges->count; i++) {
        const double *c = edges->conics[i].c;
        /* (c1 + c4 v)^2 = 4 c3 (c0 + c2 v + c5 v^2), then the sides u = -1/2 and 1/2 */
        note_roots(c[1] * c[1] - 4 * c[3] * c[0], 2 * c[1] * c[4] - 4 * c[3] * c[2], c[4] * c[4] - 4 * c[3] * c[5],
                   &found);
        for (int side = -1; side <= 1; side += 2)
            note_roots(c[0] + side * c[1] / 2 + c[3] / 4, c[2] + side * c[4] / 2, c[5], &found);
        for (size_t k = 0; k < i; k++)
            note_corner(c, edges->conics[k].c, &found);
    }
    return found.count;
}
