/* SPDX-License-Identifier: MIT */
/*
 * Contours low above the horizon.  In azimuth phi and height z on the unit sphere the area inside is
 * 1/2 integral of (1 - z^2) dphi; where the contour does not go round the normal that is -1/2 integral of z^2 dphi.
 * All of its terms are small together with the area, and the arcs of the horizon that close it have none.
 *
 * Along a straight edge r = p + t e the height h = N.r is linear, and
 *
 *     z^2 dphi = N.(p x e) h^2/(|r|^2 (|r|^2 - h^2)) dt      (a unit N).
 *
 * It is integrated by Gauss's formula over pieces that are no longer than their distance from the element, on which
 * that is good to some 1e-25.
 */
#include "facets_contour.h"

enum { PAIRS = 10 };

/* Some sixteen roundings of wide numbers. */
static const double UNIT = 0x1p-94;

/* What Gauss's formula leaves out, with much room. */
static const double LEFT_OUT = 0x1p-64;

/* The shortest piece of an edge: a contour that is touched has no value. */
static const double SHORTEST = 0x1p-60;

/* The highest that the contour may get above the horizon, relative to the least distance. */
static const double LOW = 0.125;

/* Gauss's formula for 20 points: the positive places in [-1, 1], and the weights. */
static const struct {
    lx_wide x, weight;
} pairs[PAIRS] = {
    {{0x1.fc7b5a0c71ce0p-1, 0x1.72181cfa7567fp-55}, {0x1.209680274e8afp-6, 0x1.fc73983fd0ef4p-62}},
    {{0x1.ed8dba7bd769fp-1, -0x1.4c597b9cc8a04p-56}, {0x1.4c9b5ea53b67fp-5, 0x1.89da97ec3b190p-59}},
    {{0x1.d31064173fd92p-1, -0x1.73672edab9d36p-55}, {0x1.00b467df7e475p-4, -0x1.3ac2b0e3b0038p-58}},
    {{0x1.ada0bd5efd6e7p-1, 0x1.7ac409a6c8b90p-55}, {0x1.5519fe196e24ap-4, -0x1.bc1e5c170efd9p-58}},
    {{0x1.7e1f37346a54ep-1, -0x1.cad6555373b9fp-59}, {0x1.a1817a317a821p-4, -0x1.e22351b1b1503p-58}},
    {{0x1.45a8d3fa710dbp-1, 0x1.17ac7e2c2bdd9p-61}, {0x1.e41ff31573b48p-4, 0x1.872c21a05dc8ap-58}},
    {{0x1.05905c13f7ff7p-1, -0x1.06d28cd48471ep-55}, {0x1.0db2c5db26dffp-3, -0x1.779e855c1cffbp-57}},
    {{0x1.7eaccf15652c4p-2, 0x1.b7673f9fe2006p-57}, {0x1.230348f34a535p-3, 0x1.769adf7bb90a5p-57}},
    {{0x1.d281636928bc0p-3, 0x1.6ca937f7895eap-57}, {0x1.31819b52c5992p-3, 0x1.923461e3dd7efp-58}},
    {{0x1.3973df98b86b0p-4, -0x1.5040ab2e8b077p-58}, {0x1.38d6c490a3370p-3, 0x1.ee7b50b7712c8p-57}},
};

/* What the integrand is made of. */
struct edge {
    lx_wide3 a, e;
    lx_wide height, rise; /* at a, and along e */
};

static lx_wide value_at(const struct edge *edge, lx_wide t)
{
    lx_wide3 r = lx_wide3_add(edge->a, lx_wide3_mul(edge->e, t));
    lx_wide h = lx_wide_add(edge->height, lx_wide_mul(edge->rise, t)), square = lx_wide_mul(h, h);
    lx_wide r2 = lx_wide3_dot(r, r);
    return lx_wide_div(square, lx_wide_mul(r2, lx_wide_sub(r2, square)));
}

/* The integral of h^2/(r^2 (r^2 - h^2)) dt over a short piece, whose middle need not be a float64 number. */
static lx_wide integrate_piece(const struct edge *edge, double from, double to)
{
    lx_wide middle = lx_wide_scale(lx_wide_add(lx_wide_of(from), lx_wide_of(to)), 0.5), sum = lx_wide_of(0);
    lx_wide half = lx_wide_scale(lx_wide_sub(lx_wide_of(to), lx_wide_of(from)), 0.5);
    for (int i = 0; i < PAIRS; i++) {
        lx_wide way = lx_wide_mul(half, pairs[i].x);
        lx_wide both = lx_wide_add(value_at(edge, lx_wide_add(middle, way)), value_at(edge, lx_wide_sub(middle, way)));
        sum = lx_wide_add(sum, lx_wide_mul(both, pairs[i].weight));
    }
    return lx_wide_mul(sum, half);
}

static double size(lx_wide3 a)
{
    return sqrt(a.x.high * a.x.high + a.y.high * a.y.high + a.z.high * a.z.high);
}

/* The integral over the edge up to t = end; *failed where it comes too near. */
static lx_wide integrate(const struct edge *edge, double end, bool *failed)
{
    lx_wide sum = lx_wide_of(0);
    double length = size(edge->e), from = 0, step = end;
    while (from < end) {
        double to = fmin(end, from + step), middle = from / 2 + to / 2;
        /* The nearest pole, as seen from the middle of the piece, is as far as the element is from it. */
        lx_wide3 there = lx_wide3_add(edge->a, lx_wide3_mul(edge->e, lx_wide_of(middle)));
        if ((to - from) * length > size(there)) {
            step /= 2;
            if (!(step > SHORTEST * end)) {
                *failed = true;
                break;
            }
            continue;
        }
        sum = lx_wide_add(sum, integrate_piece(edge, from, to));
        from = to;
        step *= 2;
    }
    return sum;
}

void lx_contour_add_low(const struct lx_contour *contour, unsigned from, unsigned to, struct lx_low_area *low)
{
    lx_wide3 a = lx_contour_way(contour, from), b = lx_contour_way(contour, to);
    lx_wide begin = lx_wide_div(lx_wide3_dot(contour->normal, a), contour->normal_length);
    lx_wide end = lx_wide_div(lx_wide3_dot(contour->normal, b), contour->normal_length);
    double highest = fmax(begin.high, end.high), most = 1;
    if (!(highest > 0) || low->failed)
        return;
    low->failed |= !(highest <= LOW * contour->nearest);
    struct edge edge = {.a = a, .e = lx_contour_between(contour, from, to), .height = begin};
    lx_wide turn = lx_wide3_dot(contour->normal, lx_wide3_cross(a, edge.e));
    if (begin.high < 0) { /* from the end that is seen */
        edge.a = b;
        edge.e = lx_contour_between(contour, to, from);
        edge.height = end;
    }
    edge.rise = lx_wide_div(lx_wide3_dot(contour->normal, edge.e), contour->normal_length);
    if (begin.high < 0 || end.high < 0)
        most = fmin(1, -edge.height.high / edge.rise.high);
    if (!(most > 0) || low->failed)
        return;
    lx_wide part = integrate(&edge, most, &low->failed);
    low->sum = lx_wide_sub(low->sum, lx_wide_mul(turn, part));
    double away = size(a) + size(b), term = fabs(turn.high * part.high);
    low->error += UNIT * size(a) * size(edge.e) * part.high + term * (LEFT_OUT + 16 * UNIT * away / highest);
    low->error += 4 * (UNIT * away / contour->nearest) * (UNIT * away / contour->nearest);
}
