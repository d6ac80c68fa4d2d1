/* SPDX-License-Identifier: MIT */
/* Borders as pieces of great circles, circles, and rims, which are circles in space, and where two of them cross. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../base/vector.h"
#include "../../light/solid/elliptic.h"
#include "../../light/solid/extended.h"
#include "crossings.h"
#include "outline.h"

enum { MOST_BORDERS = 96 };

enum border_type { EDGE, CIRCLE, RIM };

struct border {
    enum border_type type;
    size_t body;              /* whose: borders of one polygon meet at its corners only */
    double from[3], to[3];    /* of an edge */
    double axis[3], cosine;   /* across an edge's plane; of a circle, and the cosine of its angle; of a rim */
    double center[3], radius; /* of a rim, and two directions in its plane */
    double u[3], v[3];
};

struct borders {
    struct border items[MOST_BORDERS];
    size_t count;
    bool is_full;
};

/* ---- collecting ---- */

static void add(struct borders *borders, const struct border *border)
{
    if (borders->count < MOST_BORDERS)
        borders->items[borders->count++] = *border;
    else
        borders->is_full = true;
}

/* False: it has no length. */
static bool make_edge(struct border *edge, size_t body, const double from[3], const double to[3])
{
    *edge = (struct border){.type = EDGE, .body = body};
    memcpy(edge->from, from, sizeof edge->from);
    memcpy(edge->to, to, sizeof edge->to);
    lx_cross(from, to, edge->axis);
    return lx_normalize(edge->axis) > 0;
}

static void add_edge(struct borders *borders, size_t body, const double from[3], const double to[3])
{
    struct border edge;
    if (make_edge(&edge, body, from, to))
        add(borders, &edge);
}

static void add_circle(struct borders *borders, size_t body, const double center[3], double radius)
{
    struct border circle = {.type = CIRCLE, .body = body};
    memcpy(circle.axis, center, sizeof circle.axis);
    const double sine = radius / lx_normalize(circle.axis);
    if (!(sine < 1))
        return;
    circle.cosine = sqrt((1 - sine) * (1 + sine));
    add(borders, &circle);
}

static void add_rim(struct borders *borders, size_t body, const double center[3], const double axis[3], double radius)
{
    struct border rim = {.type = RIM, .body = body, .radius = radius};
    const int least = fabs(axis[0]) < 0.6 ? 0 : fabs(axis[1]) < 0.6 ? 1 : 2;
    memcpy(rim.center, center, sizeof rim.center);
    memcpy(rim.axis, axis, sizeof rim.axis);
    for (int k = 0; k < 3; k++)
        rim.u[k] = (k == least) - axis[least] * axis[k];
    lx_normalize(rim.u);
    lx_cross(axis, rim.u, rim.v);
    add(borders, &rim);
}

/* The rims of a cylinder, and the two lines on it that are seen edge-on. */
static void add_tube(struct borders *borders, size_t body, const double center[3], const double axis[3], double radius,
                     double half)
{
    double ends[2][3], aside[3], turned[3];
    const double along = lx_dot(center, axis);
    for (int k = 0; k < 3; k++) {
        ends[0][k] = center[k] - half * axis[k];
        ends[1][k] = center[k] + half * axis[k];
        aside[k] = center[k] - along * axis[k];
    }
    add_rim(borders, body, ends[0], axis, radius);
    add_rim(borders, body, ends[1], axis, radius);
    const double away = lx_normalize(aside), sine = radius / away;
    if (!(sine < 1))
        return;
    const double cosine = sqrt((1 - sine) * (1 + sine));
    lx_cross(axis, aside, turned);
    for (int sign = -1; sign <= 1; sign += 2) {
        double from[3], to[3];
        for (int k = 0; k < 3; k++) {
            const double at = away * cosine * (cosine * aside[k] + sign * sine * turned[k]);
            from[k] = at + (along - half) * axis[k];
            to[k] = at + (along + half) * axis[k];
        }
        add_edge(borders, body, from, to);
    }
}

static void add_obstacle(struct borders *borders, size_t body, const struct lx_obstacle *obstacle)
{
    switch (obstacle->type) {
    case LX_OBSTACLE_POLYGON:
        for (unsigned i = 0; i < obstacle->corner_count; i++)
            add_edge(borders, body, obstacle->corners_mm[i], obstacle->corners_mm[(i + 1) % obstacle->corner_count]);
        break;
    case LX_OBSTACLE_DISK: add_rim(borders, body, obstacle->center_mm, obstacle->axis, obstacle->radius_mm); break;
    case LX_OBSTACLE_BALL: add_circle(borders, body, obstacle->center_mm, obstacle->radius_mm); break;
    case LX_OBSTACLE_TUBE:
        add_tube(borders, body, obstacle->center_mm, obstacle->axis, obstacle->radius_mm, obstacle->half_mm);
        break;
    case LX_OBSTACLE_SPACE:
    case LX_OBSTACLE_SHAPE: break;
    }
}

static void add_source(struct borders *borders, const struct lx_emitter *emitter, const double place_mm[3])
{
    const struct lx_facets *facets = emitter->facets;
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    double center[3], from[3], to[3];
    for (int k = 0; k < 3; k++)
        center[k] = emitter->center_mm[k] - place_mm[k];
    if (lx_is_elliptic(emitter))
        return; /* where borders cross it the integrals find by themselves */
    if (!lx_has_axis(emitter))
        add_circle(borders, 0, center, emitter->radius_mm);
    else if (lx_is_disk(emitter))
        add_rim(borders, 0, center, axis, emitter->radius_mm);
    else if (!facets)
        add_tube(borders, 0, center, axis, emitter->radius_mm, emitter->height_mm / 2);
    for (int sign = -1; sign <= 1 && lx_is_capsule(emitter); sign += 2) {
        for (int k = 0; k < 3; k++)
            from[k] = center[k] + sign * lx_half_height(emitter) * axis[k];
        add_circle(borders, 0, from, emitter->radius_mm);
    }
    for (size_t i = 0; facets && i < facets->edge_count; i++) {
        const lx_wide3 *a = &facets->corners_mm[facets->edges[i].from], *b = &facets->corners_mm[facets->edges[i].to];
        const double first[3] = {a->x.high, a->y.high, a->z.high}, second[3] = {b->x.high, b->y.high, b->z.high};
        for (int k = 0; k < 3; k++) {
            from[k] = first[k] - place_mm[k];
            to[k] = second[k] - place_mm[k];
        }
        add_edge(borders, 0, from, to);
    }
}

/* ---- crossings ---- */

static int append(struct lx_directions *directions, const double direction[3])
{
    if (lx_reserve(&directions->items, &directions->capacity, directions->count + 1, sizeof *directions->items))
        return -1;
    memcpy(directions->items[directions->count++], direction, sizeof *directions->items);
    return 0;
}

/* Whether a direction in an edge's plane lies on it. */
static bool is_on_edge(const struct border *edge, const double d[3])
{
    double before[3], behind[3];
    lx_cross(edge->from, d, before);
    lx_cross(d, edge->to, behind);
    return lx_dot(before, edge->axis) >= 0 && lx_dot(behind, edge->axis) >= 0;
}

static void place_on_rim(const struct border *rim, double phi, double place[3])
{
    const double c = rim->radius * cos(phi), s = rim->radius * sin(phi);
    for (int k = 0; k < 3; k++)
        place[k] = rim->center[k] + c * rim->u[k] + s * rim->v[k];
}

/* Less than 0 inside of a circle's cone, or of a rim's. */
static double outside_of(const struct border *border, const double d[3])
{
    if (border->type == CIRCLE)
        return border->cosine * sqrt(lx_dot(d, d)) - lx_dot(border->axis, d);
    const double height = lx_dot(border->axis, border->center), along = lx_dot(border->axis, d);
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const double off = height * d[k] - along * border->center[k];
        square += off * off;
    }
    return square - border->radius * border->radius * along * along;
}

static int cross_edges(const struct border *a, const struct border *b, struct lx_directions *directions)
{
    double d[3];
    lx_cross(a->axis, b->axis, d);
    for (int sign = 0; sign < 2; sign++) {
        if (is_on_edge(a, d) && is_on_edge(b, d))
            return append(directions, d);
        for (int k = 0; k < 3; k++)
            d[k] = -d[k];
    }
    return 0;
}

static int cross_edge_and_circle(const struct border *edge, const struct border *circle,
                                 struct lx_directions *directions)
{
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = edge->to[k] - edge->from[k];
    const double square = circle->cosine * circle->cosine, from = lx_dot(circle->axis, edge->from),
                 change = lx_dot(circle->axis, way);
    const double a = change * change - square * lx_dot(way, way), b = from * change - square * lx_dot(edge->from, way),
                 c = from * from - square * lx_dot(edge->from, edge->from), below = b * b - a * c;
    if (!(below > 0))
        return 0;
    const double root = sqrt(below), larger = b > 0 ? -b - root : -b + root, shares[2] = {larger / a, c / larger};
    for (int i = 0; i < 2; i++) {
        const double t = shares[i];
        if (t > 0 && t < 1 &&
            append(directions, (const double[]){edge->from[0] + t * way[0], edge->from[1] + t * way[1],
                                                edge->from[2] + t * way[2]}))
            return -1;
    }
    return 0;
}

/* Where the rim comes through the edge's plane. */
static int cross_edge_and_rim(const struct border *edge, const struct border *rim, struct lx_directions *directions)
{
    const double a = lx_dot(edge->axis, rim->center), b = rim->radius * lx_dot(edge->axis, rim->u),
                 c = rim->radius * lx_dot(edge->axis, rim->v), reach = hypot(b, c);
    if (!(fabs(a) < reach))
        return 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        double d[3];
        place_on_rim(rim, atan2(c, b) + sign * acos(-a / reach), d);
        if (is_on_edge(edge, d) && append(directions, d))
            return -1;
    }
    return 0;
}

/* u = x a + y b + z a x b with u.a and u.b the cosines. */
static int cross_circles(const struct border *a, const struct border *b, struct lx_directions *directions)
{
    double turned[3], d[3];
    lx_cross(a->axis, b->axis, turned);
    const double k = lx_dot(a->axis, b->axis), square = lx_dot(turned, turned);
    const double x = (a->cosine - k * b->cosine) / square, y = (b->cosine - k * a->cosine) / square;
    const double below = (1 - x * x - y * y - 2 * x * y * k) / square;
    if (!(below > 0))
        return 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        for (int i = 0; i < 3; i++)
            d[i] = x * a->axis[i] + y * b->axis[i] + sign * sqrt(below) * turned[i];
        if (append(directions, d))
            return -1;
    }
    return 0;
}

/* Along the rim, where it gets into the other's cone or out of it. */
static int follow_rim(const struct border *rim, const struct border *other, struct lx_directions *directions)
{
    enum { STEPS = 48, HALVINGS = 50 };
    double d[3], before;
    place_on_rim(rim, 0, d);
    before = outside_of(other, d);
    for (int i = 1; i <= STEPS; i++) {
        double from = 2 * M_PI * (i - 1) / STEPS, to = 2 * M_PI * i / STEPS;
        place_on_rim(rim, to, d);
        const double now = outside_of(other, d);
        if ((now > 0) != (before > 0)) {
            for (int k = 0; k < HALVINGS; k++) {
                const double middle = (from + to) / 2;
                place_on_rim(rim, middle, d);
                *((outside_of(other, d) > 0) == (before > 0) ? &from : &to) = middle;
            }
            if (append(directions, d))
                return -1;
        }
        before = now;
    }
    return 0;
}

static int cross_borders(const struct border *a, const struct border *b, struct lx_directions *directions)
{
    if (a->type > b->type)
        return cross_borders(b, a, directions);
    if (a->type == EDGE)
        return b->type == EDGE     ? cross_edges(a, b, directions)
               : b->type == CIRCLE ? cross_edge_and_circle(a, b, directions)
                                   : cross_edge_and_rim(a, b, directions);
    return b->type == CIRCLE ? cross_circles(a, b, directions) : follow_rim(b, a, directions);
}

/* Those of the lines that bound what an outline hides, and of all else but flat sources, which it knows. */
static int cross_outline(const struct borders *borders, const struct lx_sheet_outline *outline, bool knows_source,
                         struct lx_directions *directions)
{
    for (size_t n = 0; n < outline->lay_count; n++) {
        const struct lx_trapezoid_map *lay = &outline->lays[n];
        const struct lx_sweep_frame *frame = lay->line_count > 0 ? &outline->sweeps->items[n].frame : NULL;
        uint32_t before = UINT32_MAX;
        for (size_t i = 0; i < 2 * lay->part_count; i++) {
            const struct lx_outline_part *part = &lay->parts[i / 2];
            const uint32_t number = i % 2 ? part->upper : part->lower;
            const struct lx_outline_line *line = &lay->lines[number];
            struct border edge;
            double from[3], to[3];
            if (line->kind != LX_OUTLINE_EDGE || number == before)
                continue;
            before = number;
            for (int k = 0; k < 3; k++) {
                from[k] = line->from[0] * frame->x[k] + line->from[1] * frame->y[k] + line->from[2] * frame->z[k];
                to[k] = line->to[0] * frame->x[k] + line->to[1] * frame->y[k] + line->to[2] * frame->z[k];
            }
            if (!make_edge(&edge, 0, from, to))
                continue;
            for (size_t b = 0; b < borders->count; b++)
                if ((borders->items[b].body > 0 || !knows_source) &&
                    cross_borders(&edge, &borders->items[b], directions))
                    return -1;
        }
    }
    return 0;
}

int lx_find_crossings(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                      struct lx_directions *directions)
{
    struct borders borders;
    int failed = 0;
    borders.count = 0;
    borders.is_full = false;
    add_source(&borders, emitter, occlusion->place_mm);
    for (size_t i = 0; i < occlusion->obstacles.count && !borders.is_full; i++)
        add_obstacle(&borders, i + 1, &occlusion->obstacles.items[i]);
    if (occlusion->has_outline && !borders.is_full)
        failed = cross_outline(&borders, occlusion->outline, emitter->facets != NULL, directions);
    for (size_t i = 0; i < borders.count && !borders.is_full; i++)
        for (size_t k = i + 1; k < borders.count && !failed; k++)
            if (borders.items[i].body != borders.items[k].body || borders.items[i].type != borders.items[k].type)
                failed = cross_borders(&borders.items[i], &borders.items[k], directions);
    return failed;
}
