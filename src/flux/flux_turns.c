/* SPDX-License-Identifier: MIT */
/*
 * Turns: the lines at which the lit ranges of a plane do not go on smoothly (flux_edges.h).  Candidates are where two
 * conics meet, where one has its top or bottom, or leaves the plane; the places around a candidate tell whether light
 * ends there at all.  Most edges of many surfaces meet far from their shadows, or in the shadow of others.
 */
#include <math.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "flux_edges.h"

/* How far from a candidate the places around it are. */
static const double BESIDE = 1e-7;

enum { MOST_MET = 32, DEGREE = 4 };

struct turns {
    const struct lx_edges *edges;
    struct lx_plane_places *list;
    bool is_short; /* memory ran out */
};

static bool is_on_plane(struct lx_plane_place at)
{
    return fabs(at.u) < 0.5 && fabs(at.v) < 0.5;
}

/* On which side of an edge a place is: in the shadow or not, or, of the light's own edges, by its sign. */
static bool side_of(const struct lx_edges *edges, const struct lx_conic *edge, struct lx_plane_place at)
{
    return edge->caster == LX_NO_CASTER ? lx_conic_at(edge, at.u, at.v) > 0
                                        : lx_caster_hides(edges, edge->caster, at.u, at.v);
}

/* Notes a candidate unless a third surface hides the light there. */
static void note(struct turns *turns, const struct lx_conic *a, const struct lx_conic *b, struct lx_plane_place at)
{
    for (size_t i = 0; i < turns->edges->caster_count; i++)
        if (i != a->caster && i != b->caster && lx_caster_hides(turns->edges, i, at.u, at.v))
            return;
    struct lx_plane_places *list = turns->list;
    if (lx_reserve(&list->items, &list->capacity, list->count + 1, sizeof *list->items)) {
        turns->is_short = true;
        return;
    }
    list->items[list->count++] = at;
}

/* ---- of one edge ---- */

/* A candidate of one edge counts where light begins or ends as v grows past it, seen at the place `inside`. */
static void note_alone(struct turns *turns, const struct lx_conic *edge, struct lx_plane_place at, double inside)
{
    const struct lx_plane_place below = {inside, at.v - BESIDE}, above = {inside, at.v + BESIDE};
    if (fabs(at.v) < 0.5 && side_of(turns->edges, edge, below) != side_of(turns->edges, edge, above))
        note(turns, edge, edge, (struct lx_plane_place){inside, at.v});
}

static void note_edge(struct turns *turns, const struct lx_conic *edge)
{
    const double *c = edge->c;
    double roots[2];
    /* tops and bottoms: (c1 + c4 v)^2 = 4 c3 (c0 + c2 v + c5 v^2) */
    int count = c[3] == 0 ? 0
                          : lx_edge_roots(c[1] * c[1] - 4 * c[3] * c[0], 2 * c[1] * c[4] - 4 * c[3] * c[2],
                                          c[4] * c[4] - 4 * c[3] * c[5], roots);
    for (int i = 0; i < count; i++) {
        const struct lx_plane_place at = {-(c[1] + c[4] * roots[i]) / (2 * c[3]), roots[i]};
        if (is_on_plane(at))
            note_alone(turns, edge, at, at.u);
    }
    for (int side = -1; side <= 1; side += 2) {
        count = lx_edge_roots(c[0] + side * c[1] / 2 + c[3] / 4, c[2] + side * c[4] / 2, c[5], roots);
        for (int i = 0; i < count; i++)
            note_alone(turns, edge, (struct lx_plane_place){side * 0.5, roots[i]}, side * (0.5 - BESIDE));
    }
}

/* ---- where two edges meet ---- */

/* A polynomial c[0] + c[1] x + ... of a degree. */
struct polynomial {
    int degree;
    double c[DEGREE + 1];
};

static double value_of(const struct polynomial *p, double x)
{
    double value = 0;
    for (int i = p->degree; i >= 0; i--)
        value = value * x + p->c[i];
    return value;
}

static struct polynomial product(const struct polynomial *a, const struct polynomial *b)
{
    struct polynomial p = {.degree = a->degree + b->degree};
    for (int i = 0; i <= a->degree; i++)
        for (int k = 0; k <= b->degree; k++)
            p.c[i + k] += a->c[i] * b->c[k];
    return p;
}

static struct polynomial difference(struct polynomial a, const struct polynomial *b)
{
    a.degree = a.degree > b->degree ? a.degree : b->degree;
    for (int i = 0; i <= b->degree; i++)
        a.c[i] -= b->c[i];
    return a;
}

/* The root between two places of different signs, by halving. */
static double root_between(const struct polynomial *p, double from, double to)
{
    enum { HALVINGS = 40 };
    const bool rises = value_of(p, to) > 0;
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = (from + to) / 2;
        *((value_of(p, middle) > 0) == rises ? &to : &from) = middle;
    }
    return (from + to) / 2;
}

/* The roots of a polynomial from -1/2 to 1/2, and those of its derivatives, near which double roots are; in order. */
static int roots_of(const struct polynomial *p, double *roots)
{
    struct polynomial slope = {.degree = p->degree - 1};
    double ends[MOST_MET];
    if (p->degree < 1)
        return 0;
    for (int i = 0; i <= slope.degree; i++)
        slope.c[i] = (i + 1) * p->c[i + 1];
    int count = 0, end_count = 1;
    ends[0] = -0.5;
    end_count += roots_of(&slope, ends + 1);
    ends[end_count++] = 0.5;
    for (int i = 0; i + 1 < end_count; i++) {
        if (i > 0)
            roots[count++] = ends[i];
        if ((value_of(p, ends[i]) > 0) != (value_of(p, ends[i + 1]) > 0))
            roots[count++] = root_between(p, ends[i], ends[i + 1]);
    }
    return count;
}

static bool is_straight(const struct lx_conic *edge)
{
    return edge->c[3] == 0 && edge->c[4] == 0 && edge->c[5] == 0;
}

/* Where two straight edges meet; false: they are parallel. */
static bool meet_straight(const double a[6], const double b[6], struct lx_plane_place *at)
{
    const double turn = a[1] * b[2] - a[2] * b[1];
    if (!(fabs(turn) > 1e-12 * (fabs(a[1]) + fabs(a[2])) * (fabs(b[1]) + fabs(b[2]))))
        return false;
    at->u = (a[2] * b[0] - a[0] * b[2]) / turn;
    at->v = (a[0] * b[1] - a[1] * b[0]) / turn;
    return true;
}

/* The v at which two conics may meet: roots of their resultant. */
static int meet_lines(const double a[6], const double b[6], double *v)
{
    const struct polynomial a0 = {2, {a[0], a[2], a[5]}}, a1 = {1, {a[1], a[4]}}, a2 = {0, {a[3]}},
                            b0 = {2, {b[0], b[2], b[5]}}, b1 = {1, {b[1], b[4]}}, b2 = {0, {b[3]}};
    const struct polynomial a2b0 = product(&a2, &b0), b2a0 = product(&b2, &a0), a2b1 = product(&a2, &b1),
                            b2a1 = product(&b2, &a1), a1b0 = product(&a1, &b0), b1a0 = product(&b1, &a0);
    const struct polynomial x = difference(a2b0, &b2a0), y = difference(a2b1, &b2a1), z = difference(a1b0, &b1a0);
    const struct polynomial square = product(&x, &x), mixed = product(&y, &z);
    const struct polynomial resultant = a[3] == 0 && b[3] == 0 ? z : difference(square, &mixed);
    return roots_of(&resultant, v);
}

static void gradient(const double c[6], struct lx_plane_place at, double slope[2])
{
    slope[0] = c[1] + 2 * c[3] * at.u + c[4] * at.v;
    slope[1] = c[2] + c[4] * at.u + 2 * c[5] * at.v;
}

/* Newton's method; whether it comes to a place on the plane. */
static bool settle(const struct lx_conic *a, const struct lx_conic *b, struct lx_plane_place *at)
{
    enum { STEPS = 12 };
    const double settled = 1e-13;
    for (int i = 0; i < STEPS; i++) {
        double p[2], q[2];
        gradient(a->c, *at, p);
        gradient(b->c, *at, q);
        const double turn = p[0] * q[1] - p[1] * q[0];
        const double at_a = lx_conic_at(a, at->u, at->v), at_b = lx_conic_at(b, at->u, at->v);
        const double du = (at_a * q[1] - at_b * p[1]) / turn, dv = (at_b * p[0] - at_a * q[0]) / turn;
        if (!(fabs(du) < 1 && fabs(dv) < 1))
            return false;
        at->u -= du;
        at->v -= dv;
        if (fabs(du) + fabs(dv) < settled)
            return is_on_plane(*at);
    }
    return false;
}

/*
 * Notes where two edges meet if both are borders of light there: of the four sectors between them the lit ones are not
 * told by one of the edges alone.
 */
static void note_meeting(struct turns *turns, const struct lx_conic *a, const struct lx_conic *b,
                         struct lx_plane_place at)
{
    double p[2], q[2];
    bool is_dark[2][2];
    gradient(a->c, at, p);
    gradient(b->c, at, q);
    const double length_p = hypot(p[0], p[1]), length_q = hypot(q[0], q[1]);
    if (!(length_p > 0 && length_q > 0))
        return;
    for (int i = 0; i < 4; i++) { /* half way between the two edges, whose directions are across the slopes */
        const double s = (i & 1 ? 1 : -1) / length_p, t = (i & 2 ? 1 : -1) / length_q;
        double du = -s * p[1] - t * q[1], dv = s * p[0] + t * q[0];
        const double length = hypot(du, dv);
        const struct lx_plane_place beside = {at.u + BESIDE * du / length, at.v + BESIDE * dv / length};
        const bool is_another = b->caster != a->caster || b->caster == LX_NO_CASTER;
        is_dark[p[0] * du + p[1] * dv > 0][q[0] * du + q[1] * dv > 0] =
            side_of(turns->edges, a, beside) || (is_another && side_of(turns->edges, b, beside));
    }
    const bool by_b = is_dark[0][0] == is_dark[1][0] && is_dark[0][1] == is_dark[1][1],
               by_a = is_dark[0][0] == is_dark[0][1] && is_dark[1][0] == is_dark[1][1];
    if (!by_a && !by_b)
        note(turns, a, b, at);
}

static void note_pair(struct turns *turns, const struct lx_conic *a, const struct lx_conic *b)
{
    struct lx_plane_place at;
    if (is_straight(a) && is_straight(b)) {
        if (meet_straight(a->c, b->c, &at) && is_on_plane(at))
            note_meeting(turns, a, b, at);
        return;
    }
    /* where light's own edges bend it but goes on beyond, that they meet matters little */
    if (a->caster == LX_NO_CASTER && b->caster == LX_NO_CASTER)
        return;
    double v[MOST_MET];
    const int count = meet_lines(a->c, b->c, v);
    for (int i = 0; i < 2 * count; i++) { /* of each edge the places on that line: one may have none, lying along it */
        const double *c = (i % 2 ? a : b)->c;
        double u[2];
        const double line = v[i / 2];
        const int met = lx_edge_roots(c[0] + line * (c[2] + line * c[5]), c[1] + line * c[4], c[3], u);
        for (int k = 0; k < met; k++) {
            at = (struct lx_plane_place){u[k], line};
            if (settle(a, b, &at))
                note_meeting(turns, a, b, at);
        }
    }
}

/* ---- of one surface ---- */

/* Where the way from the light past a place meets the plane; false: not on what is measured of it. */
static bool shadow_of(const struct lx_edges *edges, const struct lx_origin *light, const double place_mm[3],
                      struct lx_plane_place *at)
{
    const double *center = edges->plane->center_mm;
    const lx_bounded3 *normal = &edges->plane->normal, *across = &edges->across, *upward = &edges->upward;
    const double n[3] = {normal->x.value, normal->y.value, normal->z.value},
                 u[3] = {across->x.value, across->y.value, across->z.value},
                 v[3] = {upward->x.value, upward->y.value, upward->z.value};
    double from[3], way[3];
    for (int k = 0; k < 3; k++) {
        from[k] = place_mm[k] - center[k];
        way[k] = light->endless ? -light->at[k] : place_mm[k] - light->at[k];
    }
    const double fall = -lx_dot(n, way), height = lx_dot(n, from);
    if (!(fall > 0 && height >= 0))
        return false;
    for (int k = 0; k < 3; k++)
        from[k] += height / fall * way[k];
    *at = (struct lx_plane_place){lx_dot(u, from) / lx_dot(u, u), lx_dot(v, from) / lx_dot(v, v)};
    return is_on_plane(*at);
}

static void note_corners(struct turns *turns, const struct lx_caster *caster)
{
    const struct lx_shape *shape = &caster->surface->shape;
    const struct lx_origin light = lx_edges_light(turns->edges);
    double place_mm[3];
    struct lx_plane_place at;
    for (unsigned i = 0; shape->kind->shadow_corner && shape->kind->shadow_corner(shape, &light, i, place_mm); i++)
        if (caster->count > 0 && shadow_of(turns->edges, &light, place_mm, &at)) {
            const struct lx_conic *edge = &turns->edges->items[caster->first];
            note(turns, edge, edge, at);
        }
}

int lx_edges_turns(const struct lx_edges *edges, struct lx_plane_places *list)
{
    struct turns turns = {.edges = edges, .list = list};
    for (size_t i = 0; i < edges->count; i++) {
        note_edge(&turns, &edges->items[i]);
        for (size_t k = 0; k < i; k++)
            note_pair(&turns, &edges->items[k], &edges->items[i]);
    }
    for (size_t i = 0; i < edges->caster_count; i++)
        note_corners(&turns, &edges->casters[i]);
    return turns.is_short ? -1 : 0;
}
