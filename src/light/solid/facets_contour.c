/* SPDX-License-Identifier: MIT */
/*
 * Lambert's sum 1/2 sum theta_i (N.g_i) cancels to nothing where a source is small, far, thin or grazing.  So it is
 * taken apart.  With u the directions of the corners, theta (N.g) = N.(u x u') + (theta - sin theta) (N.g): the first
 * terms make the area of the polygon of the u, projected along N; it is summed as that of the d = u - u0, u0 being
 * the direction of a corner that is seen (the base), which are known to all their digits.  The others are the areas
 * between the arcs and their chords, third powers of what is small.  What the projection cancels besides is left to
 * wide numbers.
 *
 * Edges are cut at the horizon.  Where the contour leaves through it and comes back, the arc of the horizon between
 * closes it: (theta - sin theta) |N|.  Several such arcs, which only rounding or a source that is convex but for
 * rounding brings about, are all measured from the first crossing: their sum is the same.
 *
 * Errors: one operation on wide numbers is good to 2^-98; a vector made of some of them to UNIT times the sizes that
 * it was made of.  Cutting an edge at a height wrong by beta takes away or adds at most beta^2 of the area.
 */
#include "facets_contour.h"

/* Some sixteen roundings. */
static const double UNIT = 0x1p-94;

/* Sines below the root of this: theta - sin theta by its series. */
static const double SMALL = 0x1p-10;

/* asin(s) - s = s^3 times the sum of these times s^(2k) */
enum { TERMS = 11 };
static const lx_wide terms[TERMS] = {
    {0x1.5555555555555p-3, 0x1.5555555555555p-57},  {0x1.3333333333333p-4, 0x1.999999999999ap-59},
    {0x1.6db6db6db6db7p-5, -0x1.2492492492492p-60}, {0x1.f1c71c71c71c7p-6, 0x1.c71c71c71c71cp-62},
    {0x1.6e8ba2e8ba2e9p-6, -0x1.1745d1745d174p-60}, {0x1.1c4ec4ec4ec4fp-6, -0x1.d89d89d89d89ep-61},
    {0x1.c99999999999ap-7, -0x1.999999999999ap-61}, {0x1.7a87878787878p-7, 0x1.e1e1e1e1e1e1ep-61},
    {0x1.3fde50d79435ep-7, 0x1.435e50d79435ep-61},  {0x1.12ef3cf3cf3cfp-7, 0x1.e79e79e79e79ep-62},
    {0x1.df3bd37a6f4dfp-8, -0x1.90b21642c8591p-62},
};

/* (asin(s) - s)/s^3 for a small s^2 */
static lx_wide segment_series(lx_wide square)
{
    lx_wide sum = terms[TERMS - 1];
    for (int k = TERMS - 2; k >= 0; k--)
        sum = lx_wide_add(lx_wide_mul(sum, square), terms[k]);
    return sum;
}

static double size(lx_wide3 a)
{
    return sqrt(a.x.high * a.x.high + a.y.high * a.y.high + a.z.high * a.z.high);
}

static lx_wide3 scaled(lx_wide3 a, double scale)
{
    return (lx_wide3){lx_wide_scale(a.x, scale), lx_wide_scale(a.y, scale), lx_wide_scale(a.z, scale)};
}

static lx_wide3 negate(lx_wide3 a)
{
    return (lx_wide3){lx_wide_negate(a.x), lx_wide_negate(a.y), lx_wide_negate(a.z)};
}

lx_wide3 lx_contour_between(const struct lx_contour *contour, unsigned from, unsigned to)
{
    return scaled(lx_wide3_sub(contour->corners_mm[to], contour->corners_mm[from]), contour->scale);
}

lx_wide3 lx_contour_way(const struct lx_contour *contour, unsigned corner)
{
    return scaled(lx_wide3_sub(contour->corners_mm[corner], contour->place_mm), contour->scale);
}

struct lx_contour lx_contour_start(const lx_wide3 *corners_mm, lx_wide3 place_mm, lx_wide3 normal, double scale,
                                   double nearest_mm)
{
    return (struct lx_contour){
        .corners_mm = corners_mm,
        .place_mm = place_mm,
        .normal = normal,
        .scale = scale,
        .nearest = nearest_mm * scale,
        .normal_length = lx_wide3_length(normal),
    };
}

lx_wide lx_contour_height(const struct lx_contour *contour, unsigned corner)
{
    return lx_wide3_dot(contour->normal, lx_contour_way(contour, corner));
}

/* ---- vertices ---- */

/*
 * d = a/|a| - b/|b| with a = b + w: as w/|a| - b (w.(a + b))/(|a| |b| (|a| + |b|)) where w is short, so that it has all
 * its digits.
 */
static void find_direction(const struct lx_contour *contour, struct lx_contour_vertex *vertex)
{
    const struct lx_contour_vertex *base = &contour->base_vertex;
    double ratio = vertex->extent / vertex->distance.high;
    vertex->spread = fmin(2, 2 * ratio) * vertex->lambda;
    if (!(ratio < 1)) {
        lx_wide3 one = lx_wide3_mul(vertex->a, lx_wide_div(lx_wide_of(1), vertex->distance));
        lx_wide3 other = lx_wide3_mul(base->a, lx_wide_div(lx_wide_of(1), base->distance));
        vertex->d = lx_wide3_sub(one, other);
        return;
    }
    lx_wide inverse = lx_wide_div(lx_wide_of(1), vertex->distance);
    lx_wide product = lx_wide3_dot(vertex->w, lx_wide3_add(vertex->a, base->a));
    lx_wide sum = lx_wide_mul(base->distance, lx_wide_add(base->distance, vertex->distance));
    lx_wide factor = lx_wide_div(product, sum);
    vertex->d = lx_wide3_mul(lx_wide3_sub(vertex->w, lx_wide3_mul(base->a, factor)), inverse);
}

void lx_contour_set_base(struct lx_contour *contour, unsigned corner)
{
    struct lx_contour_vertex *base = &contour->base_vertex;
    contour->base = contour->known = corner;
    *base = (struct lx_contour_vertex){.a = lx_contour_way(contour, corner), .lambda = 1};
    base->distance = lx_wide3_length(base->a);
    base->height = lx_wide3_dot(contour->normal, base->a);
    contour->known_vertex = *base;
}

/* A corner below the horizon: nothing but that is of interest. */
static struct lx_contour_vertex at_corner(const struct lx_contour *contour, unsigned corner)
{
    if (corner == contour->base)
        return contour->base_vertex;
    if (corner == contour->known)
        return contour->known_vertex;
    struct lx_contour_vertex vertex = {.a = lx_contour_way(contour, corner), .lambda = 1};
    vertex.height = lx_wide3_dot(contour->normal, vertex.a);
    if (vertex.height.high < 0)
        return vertex;
    vertex.w = lx_contour_between(contour, contour->base, corner);
    vertex.distance = lx_wide3_length(vertex.a);
    vertex.extent = size(vertex.w);
    find_direction(contour, &vertex);
    return vertex;
}

/* Where the way e from a vertex, to so far below the horizon, meets it; *share is the part of e that leads there. */
static struct lx_contour_vertex at_horizon(const struct lx_contour *contour, const struct lx_contour_vertex *seen,
                                           lx_wide3 e, lx_wide height_beyond, lx_wide *share)
{
    lx_wide fall = lx_wide_negate(lx_wide3_dot(contour->normal, e));
    if (lx_wide_compare(fall, seen->height) <= 0) /* by rounding only */
        fall = lx_wide_sub(seen->height, height_beyond);
    *share = lx_wide_div(seen->height, fall);
    lx_wide3 way = lx_wide3_mul(e, *share);
    double length = size(way);
    struct lx_contour_vertex vertex = {.a = lx_wide3_add(seen->a, way), .w = lx_wide3_add(seen->w, way)};
    vertex.distance = lx_wide3_length(vertex.a);
    vertex.extent = seen->extent + length;
    vertex.lambda = (seen->distance.high + length) / vertex.distance.high;
    find_direction(contour, &vertex);
    return vertex;
}

/* ---- terms ---- */

static void add_term(struct lx_contour *contour, lx_wide term, double error)
{
    contour->sum = lx_wide_add(contour->sum, term);
    contour->error += error + 4 * UNIT * fabs(term.high);
}

static void add_chord(struct lx_contour *contour, const struct lx_contour_vertex *p, const struct lx_contour_vertex *r)
{
    add_term(contour, lx_wide3_dot(contour->normal, lx_wide3_cross(p->d, r->d)), 8 * UNIT * p->spread * r->spread);
}

/* (theta - sin theta) for a sine, its square, and cosine; *error takes the share of the atan2. */
static lx_wide segment(lx_wide sine, lx_wide square, lx_wide cosine, double *angle, double *error)
{
    if (square.high < SMALL && cosine.high > 0) {
        *angle = fabs(sine.high);
        return lx_wide_mul(lx_wide_mul(sine, square), segment_series(square));
    }
    lx_wide theta = lx_wide_atan2(sine, cosine);
    *angle = fabs(theta.high);
    *error += UNIT * *angle;
    return lx_wide_sub(theta, sine);
}

/*
 * The part between the arc and the chord of p and r, which are so much of the way e apart; a is an end of the whole
 * edge.  The cross product of p and r is that of a and e, but for its length.
 */
static void add_segment(struct lx_contour *contour, const struct lx_contour_vertex *p,
                        const struct lx_contour_vertex *r, lx_wide3 a, lx_wide3 e, lx_wide share)
{
    lx_wide3 g = lx_wide3_cross(a, e);
    lx_wide one = lx_wide_of(1), length2 = lx_wide3_dot(g, g);
    if (!(length2.high > 0) || !(share.high > 0)) { /* seen end on, or touched */
        if (lx_wide3_dot(p->a, r->a).high < 0)
            contour->error = HUGE_VAL;
        return;
    }
    lx_wide inverse = lx_wide_div(one, lx_wide_mul(p->distance, r->distance));
    lx_wide factor = lx_wide_mul(share, inverse), cosine = lx_wide_mul(lx_wide3_dot(p->a, r->a), inverse);
    lx_wide square = lx_wide_mul(length2, lx_wide_mul(factor, factor)), part;
    double angle, error = 0, sine = sqrt(square.high);
    if (square.high < SMALL && cosine.high > 0) {
        angle = sine;
        part = lx_wide_mul(lx_wide_mul(square, factor), segment_series(square));
    } else {
        lx_wide length = lx_wide_sqrt(length2);
        part = lx_wide_div(segment(lx_wide_mul(length, factor), square, cosine, &angle, &error), length);
    }
    double known = size(a) * size(e) * factor.high * fmax(1, angle / sine);
    error += 4 * UNIT * fmin(2, angle * angle) * (known + angle * (p->lambda + r->lambda));
    add_term(contour, lx_wide_mul(lx_wide3_dot(contour->normal, g), part), error);
}

/* The arc of the horizon from p to r; `closes`: it leads from where the contour left to where it came back. */
static void add_horizon(struct lx_contour *contour, const struct lx_contour_vertex *p,
                        const struct lx_contour_vertex *r, bool closes)
{
    lx_wide scale = lx_wide_div(lx_wide_of(1), lx_wide_mul(p->distance, r->distance));
    double apart = p->extent + r->extent, nearer = fmin(p->distance.high, r->distance.high);
    lx_wide3 g = lx_wide3_cross(p->a, apart < r->distance.high ? lx_wide3_sub(r->w, p->w) : r->a);
    lx_wide sine = lx_wide_div(lx_wide_mul(lx_wide3_dot(contour->normal, g), scale), contour->normal_length);
    lx_wide cosine = lx_wide_mul(lx_wide3_dot(p->a, r->a), scale);
    double angle, error = 0, lambda = p->lambda + r->lambda, beta = UNIT * lambda;
    if (closes && cosine.high < 0 && sine.high < 0) /* all but half a turn */
        sine = lx_wide_negate(sine);
    lx_wide part = segment(sine, lx_wide_mul(sine, sine), cosine, &angle, &error);
    double known = fmin(2, apart / nearer) * lambda + angle * lambda;
    error += 4 * UNIT * fmin(2, angle * angle + known * known * UNIT) * known + beta * beta;
    add_term(contour, lx_wide_mul(part, contour->normal_length), error);
    add_chord(contour, p, r);
}

static void add_crossing(struct lx_contour *contour, const struct lx_contour_vertex *vertex, bool exits)
{
    if (!contour->crossed) {
        contour->crossed = true;
        contour->exited = exits;
        contour->crossing = *vertex;
        return;
    }
    bool closes = exits != contour->exited;
    if (exits)
        add_horizon(contour, vertex, &contour->crossing, closes);
    else
        add_horizon(contour, &contour->crossing, vertex, closes);
}

/*
 * Bounds the area that an edge sweeps when its corners move by so much: that times the integral of N.r/|r|^3 ds over
 * the part above the horizon.
 */
static void add_sweep(struct lx_contour *contour, double length, double highest, double corner_error_mm)
{
    double d = contour->nearest, moved = corner_error_mm * contour->scale;
    double area = moved * fmin(length / d, M_PI) / d * fmin(1, (highest + moved) / d);
    contour->corners_error += 4 * area + 4 * (moved / d) * (moved / d);
}

void lx_contour_add(struct lx_contour *contour, unsigned from, unsigned to, double corner_error_mm)
{
    struct lx_contour_vertex begin = at_corner(contour, from), end = at_corner(contour, to), p = begin, r = end;
    contour->known = from;
    contour->known_vertex = begin;
    bool begin_seen = begin.height.high >= 0, end_seen = end.height.high >= 0;
    if (!begin_seen && !end_seen)
        return;
    lx_wide3 e = lx_contour_between(contour, from, to);
    lx_wide share = lx_wide_of(1);
    if (!begin_seen)
        p = at_horizon(contour, &end, negate(e), begin.height, &share);
    if (!end_seen)
        r = at_horizon(contour, &begin, e, end.height, &share);
    add_segment(contour, &p, &r, size(begin.a) < size(end.a) ? begin.a : end.a, e, share);
    add_chord(contour, &p, &r);
    if (corner_error_mm > 0)
        add_sweep(contour, size(e) * share.high, fmax(begin.height.high, end.height.high), corner_error_mm);
    if (begin_seen != end_seen)
        add_crossing(contour, begin_seen ? &r : &p, begin_seen);
}
