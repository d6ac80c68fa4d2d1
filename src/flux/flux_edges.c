/* SPDX-License-Identifier: MIT */
/* Conics on a plane: made of what light has for edges in space, and cut by lines. */
#include "flux_edges.h"

#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/solid/extended.h"
#include "../world/blocking.h"

/* A quadratic form in space: q(Q) = square |Q - at|^2 + along (axis.(Q - at))^2 + (slope.(Q - at)) + rest. */
struct quadric {
    double at[3], axis[3], slope[3];
    double square, along, rest;
};

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

static double value_at(const void *data, const double place[3])
{
    const struct quadric *q = data;
    double from[3];
    subtract(place, q->at, from);
    double along = lx_dot(q->axis, from);
    return q->square * lx_dot(from, from) + q->along * along * along + lx_dot(q->slope, from) + q->rest;
}

/* A quadratic function of a place; NaN: there is none. */
typedef double quadratic(const void *data, const double place[3]);

/* Whether an edge may cross the plane. */
static bool may_cross(const double c[6])
{
    const double most = (fabs(c[1]) + fabs(c[2])) / 2 + (fabs(c[3]) + fabs(c[4]) + fabs(c[5])) / 4;
    return fabs(c[0]) <= most * (1 + 1e-9);
}

/* Its conic on the plane, from its values at six places; false: memory ran out. */
static bool add_conic(struct lx_edges *edges, size_t caster, quadratic *value, const void *data)
{
    static const double places[6][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}};
    const double straight = 1e-13; /* of its size: bends below are rounding */
    struct lx_conic edge = {.caster = caster};
    double values[6], *c = edge.c, size = 0;
    for (int p = 0; p < 6; p++) {
        double place[3];
        lx_values3(lx_edges_place(edges, places[p][0], places[p][1]), place);
        values[p] = value(data, place);
        if (isnan(values[p]))
            return true;
        size = fmax(size, fabs(values[p]));
    }
    c[0] = values[0];
    c[1] = (values[1] - values[2]) / 2;
    c[2] = (values[3] - values[4]) / 2;
    c[3] = (values[1] + values[2]) / 2 - values[0];
    c[5] = (values[3] + values[4]) / 2 - values[0];
    c[4] = values[5] - c[0] - c[1] - c[2] - c[3] - c[5];
    for (int i = 3; i < 6; i++)
        c[i] = fabs(c[i]) > straight * size ? c[i] : 0;
    if (!may_cross(c) || (caster == LX_NO_CASTER && edges->count == LX_MOST_OWN_EDGES))
        return true;
    if (lx_reserve(&edges->items, &edges->capacity, edges->count + 1, sizeof *edges->items))
        return false;
    edges->items[edges->count++] = edge;
    return true;
}

static bool add(struct lx_edges *edges, const struct quadric *q)
{
    return add_conic(edges, LX_NO_CASTER, value_at, q);
}

static bool add_plane(struct lx_edges *edges, const double at[3], const double normal[3])
{
    struct quadric q = {.square = 0};
    copy(at, q.at);
    copy(normal, q.slope);
    return add(edges, &q);
}

/* All places from which `apex` is seen under the cosine to the axis, a unit vector. */
static bool add_cone(struct lx_edges *edges, const double apex[3], const double axis[3], double cosine)
{
    struct quadric q = {.square = -cosine * cosine, .along = 1};
    copy(apex, q.at);
    copy(axis, q.axis);
    return add(edges, &q);
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

lx_bounded3 lx_edges_place(const struct lx_edges *edges, double u, double v)
{
    return lx_add3(lx_exact3(edges->plane->center_mm),
                   lx_add3(lx_mul3(edges->across, lx_exact(u)), lx_mul3(edges->upward, lx_exact(v))));
}

bool lx_caster_hides(const struct lx_edges *edges, size_t caster, double u, double v)
{
    const struct lx_prepared_surface *surface = edges->casters[caster].surface;
    const struct lx_emitter *emitter = edges->emitter;
    struct lx_element element = {
        .place_mm = lx_edges_place(edges, u, v), .normal = edges->plane->normal, .is_free = true};
    double place[3];
    lx_values3(element.place_mm, place);
    element.own = surface->kind->holds(&surface->shape, place) ? surface : NULL;
    return lx_hidden_by(surface, &element, emitter).value > 0.5;
}

/* Whether a surface may come between the plane and a light without size. */
static bool may_fall_on(const struct lx_cells *plane, const struct lx_shape *shape, const struct lx_emitter *emitter)
{
    const bool endless = lx_is_endless(emitter);
    const struct lx_ball from = {.radius = hypot(plane->size_mm[0], plane->size_mm[1]) / 2};
    struct lx_ball towards = {.radius = 0}, ball = {.radius = shape->radius_mm + lx_shape_room(shape)};
    lx_emitter_origin(emitter, towards.center);
    if (!endless)
        subtract(towards.center, plane->center_mm, towards.center);
    subtract(shape->anchor_mm, plane->center_mm, ball.center);
    return lx_may_block(&ball, &from, &towards, endless);
}

struct lx_origin lx_edges_light(const struct lx_edges *edges)
{
    struct lx_origin light = {.endless = lx_is_endless(edges->emitter)};
    lx_emitter_origin(edges->emitter, light.at);
    return light;
}

/* A surface without edges on the plane hides all of it or nothing. */
static bool add_caster(struct lx_edges *edges, const struct lx_prepared_surface *surface)
{
    const struct lx_shape *shape = &surface->shape;
    struct shadow shadow = {.shape = shape, .light = lx_edges_light(edges)};
    struct lx_caster caster = {.surface = surface, .first = edges->count};
    if (lx_reserve(&edges->casters, &edges->caster_capacity, edges->caster_count + 1, sizeof *edges->casters))
        return false;
    for (; shadow.edge < shape->kind->shadow_edges; shadow.edge++)
        if (!add_conic(edges, edges->caster_count, shadow_at, &shadow))
            return false;
    caster.count = edges->count - caster.first;
    edges->casters[edges->caster_count] = caster;
    if (caster.count > 0 || lx_caster_hides(edges, edges->caster_count, 0, 0))
        edges->caster_count++;
    return true;
}

/* ---- emitters ---- */

/* Where its profile breaks; a half-plane counts as the whole one. */
static bool add_point(struct lx_edges *edges, const struct lx_emitter *emitter)
{
    struct lx_break place;
    double normal[3];
    bool is_whole = true;
    for (size_t i = 0; is_whole && lx_profile_break(&emitter->profile, i, &place); i++) {
        lx_cross(place.axis, place.begin, normal);
        if (place.shape == LX_BREAK_PLANE)
            is_whole = add_plane(edges, emitter->position_mm, place.axis);
        else if (place.shape == LX_BREAK_HALF_PLANE)
            is_whole = add_plane(edges, emitter->position_mm, normal);
        else if (place.angle_rad > 0 && place.angle_rad < M_PI)
            is_whole = add_cone(edges, emitter->position_mm, place.axis, cos(place.angle_rad));
    }
    return is_whole;
}

/* Where faces set. */
static bool add_faces(struct lx_edges *edges, const struct lx_emitter *emitter)
{
    double normal[3], place[3];
    bool is_whole = true;
    if (lx_emitter_plane(emitter, place, normal))
        return add_plane(edges, place, normal);
    for (size_t i = 0; emitter->facets && i < emitter->facets->face_count && is_whole; i++) {
        const struct lx_face *face = &emitter->facets->faces[i];
        const lx_wide3 *corner = &emitter->facets->corners_mm[emitter->facets->loop[face->first]];
        const double at[3] = {lx_wide_value(corner->x), lx_wide_value(corner->y), lx_wide_value(corner->z)};
        lx_values3(lx_wide3_direction(face->normal), normal);
        is_whole = add_plane(edges, at, normal);
    }
    return is_whole;
}

size_t lx_edges_most(const struct lx_edges *edges)
{
    return 2 * edges->count + edges->caster_count + 1;
}

int lx_edges_make(const struct lx_prepared *prepared, const struct lx_cells *plane, const struct lx_emitter *emitter,
                  const bool *aside, bool casts, struct lx_edges *edges)
{
    const lx_bounded size[2] = {lx_exact(plane->size_mm[0]), lx_exact(plane->size_mm[1])};
    *edges = (struct lx_edges){.plane = plane,
                               .emitter = emitter,
                               .across = lx_mul3(lx_wide3_direction(plane->pose.across), size[0]),
                               .upward = lx_mul3(lx_wide3_direction(plane->pose.upward), size[1]),
                               .knows_shadows = !casts || lx_has_one_way(emitter)};
    bool is_whole = (!lx_is_point(emitter) || add_point(edges, emitter)) && add_faces(edges, emitter);
    /* sources of some size have no edges, but a penumbra */
    for (size_t s = 0; casts && edges->knows_shadows && is_whole && s < prepared->surface_count; s++) {
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        if (aside[s] || !may_fall_on(plane, &surface->shape, emitter))
            continue;
        if (surface->kind->shadow_edges > 0)
            is_whole = add_caster(edges, surface);
        else
            edges->knows_shadows = false;
    }
    edges->places = lx_new_array(2 * edges->count + 2, sizeof *edges->places);
    edges->dark = lx_new_array(lx_edges_most(edges), sizeof *edges->dark);
    return is_whole && edges->places && edges->dark ? 0 : -1;
}

void lx_edges_clear(struct lx_edges *edges)
{
    free(edges->items);
    free(edges->casters);
    free(edges->places);
    free(edges->dark);
    *edges = (struct lx_edges){.count = 0};
}

/* ---- lines ---- */

int lx_edge_roots(double a, double b, double c, double roots[2])
{
    double square = b * b - 4 * a * c;
    int count = 0;
    if (!(square >= 0))
        return 0;
    double q = -(b + copysign(sqrt(square), b)) / 2;
    if (q != 0)
        roots[count++] = a / q;
    if (c != 0)
        roots[count++] = q / c;
    return count;
}

static int by_place(const void *left, const void *right)
{
    const struct lx_crossing *a = left, *b = right;
    return lx_by_value(&a->at, &b->at);
}

static int by_begin(const void *left, const void *right)
{
    const struct lx_line_part *a = left, *b = right;
    return lx_by_value(&a->from, &b->from);
}

/* Where a + b x + c x^2 is 0, and where it all but touches 0: its two roots may be lost to rounding, and a place more
 * does no harm. */
static int crossings(double a, double b, double c, double roots[2])
{
    const double size = fabs(a) + fabs(b) + fabs(c);
    const int count = lx_edge_roots(a, b, c, roots);
    if (count > 0 || c == 0 || !(b * b - 4 * a * c >= -1e-14 * size * size))
        return count;
    roots[0] = -b / (2 * c);
    return 1;
}

/* Where some edges, one after the other, cross a line, in order, between its ends; how many. */
static size_t cut_line(const struct lx_edges *edges, size_t first, size_t count, const struct lx_plane_line *line)
{
    const double u = line->middle[0], v = line->middle[1], du = line->slope[0], dv = line->slope[1];
    size_t found = 0;
    edges->places[found++] = (struct lx_crossing){-0.5, LX_LINE_END};
    for (size_t i = first; i < first + count; i++) {
        const double *c = edges->items[i].c;
        double roots[2];
        const int n = crossings(lx_conic_at(&edges->items[i], u, v),
                                du * (c[1] + 2 * c[3] * u + c[4] * v) + dv * (c[2] + 2 * c[5] * v + c[4] * u),
                                du * (c[3] * du + c[4] * dv) + c[5] * dv * dv, roots);
        for (int k = 0; k < n; k++)
            if (fabs(roots[k]) < 0.5)
                edges->places[found++] = (struct lx_crossing){roots[k], i};
    }
    edges->places[found++] = (struct lx_crossing){0.5, LX_LINE_END};
    qsort(edges->places, found, sizeof *edges->places, by_place);
    return found;
}

/* The ranges that a caster hides are appended to the dark ones. */
static size_t note_dark(const struct lx_edges *edges, size_t caster, const struct lx_plane_line *line,
                        size_t dark_count)
{
    const struct lx_caster *one = &edges->casters[caster];
    const size_t count = cut_line(edges, one->first, one->count, line);
    bool is_dark = false;
    for (size_t i = 0; i + 1 < count; i++) {
        const struct lx_crossing *from = &edges->places[i], *to = from + 1;
        const double middle = from->at + (to->at - from->at) / 2;
        if (!(middle > from->at && middle < to->at)) /* too narrow to be asked */
            continue;
        const bool was_dark = is_dark;
        is_dark = lx_caster_hides(edges, caster, line->middle[0] + middle * line->slope[0],
                                  line->middle[1] + middle * line->slope[1]);
        if (is_dark && !was_dark)
            edges->dark[dark_count++] = (struct lx_line_part){.from = from->at, .bounds = {from->edge}};
        if (is_dark) {
            edges->dark[dark_count - 1].to = to->at;
            edges->dark[dark_count - 1].bounds[1] = to->edge;
        }
    }
    return dark_count;
}

size_t lx_edges_lit(const struct lx_edges *edges, const struct lx_plane_line *line, struct lx_line_part *lit)
{
    size_t dark_count = 0, lit_count = 0, own = 0, k = 0;
    for (size_t i = 0; i < edges->caster_count; i++)
        dark_count = note_dark(edges, i, line, dark_count);
    if (dark_count > 0)
        qsort(edges->dark, dark_count, sizeof *edges->dark, by_begin);
    while (own < edges->count && edges->items[own].caster == LX_NO_CASTER)
        own++;
    const size_t count = cut_line(edges, 0, own, line);
    struct lx_crossing reached = {-0.5, LX_LINE_END}; /* all before is dark or in the list */
    for (size_t i = 1; i < count; i++) {
        const struct lx_crossing end = edges->places[i];
        for (; k < dark_count && edges->dark[k].from < end.at; k++) {
            const struct lx_line_part *dark = &edges->dark[k];
            if (dark->from > reached.at)
                lit[lit_count++] = (struct lx_line_part){reached.at, dark->from, {reached.edge, dark->bounds[0]}};
            if (dark->to > reached.at)
                reached = (struct lx_crossing){dark->to, dark->bounds[1]};
        }
        if (end.at > reached.at) {
            lit[lit_count++] = (struct lx_line_part){reached.at, end.at, {reached.edge, end.edge}};
            reached = end;
        }
    }
    return lit_count;
}
