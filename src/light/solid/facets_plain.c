/* SPDX-License-Identifier: MIT */
/* Lambert's sum taken apart as in facets_contour.c, where its terms are explained, by bounded numbers. */
#include "facets_plain.h"

/* theta - sin(theta), whose slope is at most theta^2/2: by its series where that would cancel. */
static lx_bounded excess_of(lx_bounded theta)
{
    const double angle = theta.value, square = angle * angle, most = fabs(angle) + theta.error;
    double value = angle - sin(angle);
    if (angle < 1) {
        double sum = 1;
        for (int k = 8; k > 0; k--)
            sum = 1 - square / (2 * k + 2) / (2 * k + 3) * sum;
        value = angle * square / 6 * sum;
    }
    return lx_rounded(value, fmin(2, most * most / 2) * theta.error, 16);
}

static lx_bounded between(lx_wide from, lx_wide to, double error, double scale)
{
    lx_bounded way = lx_sub(lx_exact(to.high), lx_exact(from.high));
    if (to.low != 0 || from.low != 0)
        way = lx_add(way, lx_sub(lx_exact(to.low), lx_exact(from.low)));
    return (lx_bounded){way.value * scale, (way.error + error) * scale};
}

static lx_bounded3 between3(const struct lx_plain_contour *contour, lx_wide3 from, lx_wide3 to, double error)
{
    return (lx_bounded3){between(from.x, to.x, error, contour->scale), between(from.y, to.y, error, contour->scale),
                         between(from.z, to.z, error, contour->scale)};
}

static lx_bounded3 edge_between(const struct lx_plain_contour *contour, unsigned from, unsigned to)
{
    return between3(contour, contour->corners_mm[from], contour->corners_mm[to], 2 * contour->corner_error_mm);
}

static void fail(struct lx_plain_contour *contour)
{
    contour->sum.error = HUGE_VAL;
}

struct lx_plain_contour lx_plain_start(const struct lx_facets *facets, const double place_mm[3], const double normal[3],
                                       double scale)
{
    return (struct lx_plain_contour){
        .corners_mm = facets->corners_mm,
        .corner_error_mm = facets->corner_error_mm,
        .place_mm = {place_mm[0], place_mm[1], place_mm[2]},
        .normal = lx_exact3(normal),
        .scale = scale,
    };
}

/* A corner as it is seen; the sum fails where it may be below the horizon. */
static struct lx_plain_vertex look_at(struct lx_plain_contour *contour, unsigned corner)
{
    struct lx_plain_vertex vertex = {
        .a = between3(contour, lx_wide3_of(contour->place_mm), contour->corners_mm[corner], contour->corner_error_mm)};
    const lx_bounded height = lx_dot3(contour->normal, vertex.a);
    if (!(height.value > height.error))
        fail(contour);
    vertex.distance = lx_sqrt(lx_square3(vertex.a));
    vertex.inverse = lx_div(lx_exact(1), vertex.distance);
    return vertex;
}

/* u - u0 of a corner, u0 being the direction of the base. */
static lx_bounded3 difference(const struct lx_plain_contour *contour, const struct lx_plain_vertex *vertex,
                              lx_bounded3 w)
{
    const struct lx_plain_vertex *base = &contour->base_vertex;
    const double extent2 = w.x.value * w.x.value + w.y.value * w.y.value + w.z.value * w.z.value;
    if (!(extent2 < vertex->distance.value * vertex->distance.value))
        return lx_sub3(lx_mul3(vertex->a, vertex->inverse), lx_mul3(base->a, base->inverse));
    const lx_bounded sum = lx_mul(base->distance, lx_add(base->distance, vertex->distance));
    const lx_bounded factor = lx_div(lx_dot3(w, lx_add3(vertex->a, base->a)), sum);
    return lx_mul3(lx_sub3(w, lx_mul3(base->a, factor)), vertex->inverse);
}

static struct lx_plain_vertex at_corner(struct lx_plain_contour *contour, unsigned corner)
{
    if (corner == contour->base)
        return contour->base_vertex;
    if (corner == contour->known)
        return contour->known_vertex;
    struct lx_plain_vertex vertex = look_at(contour, corner);
    vertex.d = difference(contour, &vertex, edge_between(contour, contour->base, corner));
    return vertex;
}

/* The part between the arc and the chord of an edge. */
static lx_bounded segment_of(const struct lx_plain_contour *contour, const struct lx_plain_vertex *p,
                             const struct lx_plain_vertex *r, lx_bounded3 e)
{
    const lx_bounded3 g = lx_cross3(p->distance.value < r->distance.value ? p->a : r->a, e);
    const lx_bounded length2 = lx_square3(g), inverse = lx_mul(p->inverse, r->inverse);
    const lx_bounded cosine = lx_mul(lx_dot3(p->a, r->a), inverse);
    if (!(length2.value > length2.error)) /* seen end on */
        return (lx_bounded){0, HUGE_VAL};
    const lx_bounded length = lx_sqrt(length2), theta = lx_angle(lx_mul(length, inverse), cosine);
    return lx_mul(lx_dot3(contour->normal, g), lx_div(excess_of(theta), length));
}

void lx_plain_add(struct lx_plain_contour *contour, unsigned from, unsigned to)
{
    if (!contour->begun) {
        contour->begun = true;
        contour->base = contour->known = from;
        contour->base_vertex = contour->known_vertex = look_at(contour, from);
    }
    const struct lx_plain_vertex p = at_corner(contour, from), r = at_corner(contour, to);
    contour->known = from;
    contour->known_vertex = p;
    const lx_bounded chord = lx_dot3(contour->normal, lx_cross3(p.d, r.d));
    const lx_bounded segment = segment_of(contour, &p, &r, edge_between(contour, from, to));
    contour->sum = lx_add(contour->sum, lx_add(chord, segment));
}
