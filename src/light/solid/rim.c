/* SPDX-License-Identifier: MIT */
/* Arcs of circles above the horizon, in wide numbers: rim.h has the formulas. */
#include "rim.h"

static lx_wide square(lx_wide a)
{
    return lx_wide_mul(a, a);
}

struct lx_rim lx_rim_of(lx_wide rho, lx_wide height, lx_wide radius, lx_wide3 normal)
{
    struct lx_rim rim = {.rho = rho, .height = height, .radius = radius, .normal = normal};
    lx_wide one = lx_wide_of(1), h2 = square(height);
    rim.near2 = lx_wide_add(square(lx_wide_sub(rho, radius)), h2);
    rim.far2 = lx_wide_add(square(lx_wide_add(rho, radius)), h2);
    rim.k = lx_wide_add(lx_wide_add(square(rho), square(radius)), h2);
    rim.kappa = lx_wide_scale(lx_wide_mul(rho, radius), 2);
    rim.w = lx_wide_mul(lx_wide_sqrt(rim.near2), lx_wide_sqrt(rim.far2));
    rim.lambda = lx_wide_sqrt(lx_wide_div(rim.near2, rim.far2));
    rim.slope = lx_wide_div(lx_wide_of(2), lx_wide_mul(rim.far2, lx_wide_add(one, rim.lambda)));
    return rim;
}

struct lx_horizon lx_rim_horizon(const struct lx_rim *rim)
{
    struct lx_horizon horizon = {.crossed = false};
    const lx_wide3 *n = &rim->normal;
    lx_wide tilt = lx_wide_sqrt(lx_wide_add(square(n->x), square(n->y)));
    horizon.middle = lx_wide_add(lx_wide_mul(rim->rho, n->x), lx_wide_mul(rim->height, n->z));
    horizon.reach = lx_wide_mul(rim->radius, tilt);
    if (!(horizon.reach.high > 0))
        return horizon;
    lx_wide c0 = lx_wide_div(n->x, tilt), s0 = lx_wide_div(n->y, tilt);
    horizon.top = (struct lx_mark){c0, s0};
    lx_wide above = lx_wide_add(horizon.reach, horizon.middle), below = lx_wide_sub(horizon.reach, horizon.middle);
    if (!(above.high > 0 && below.high > 0))
        return horizon;
    lx_wide c = lx_wide_div(lx_wide_negate(horizon.middle), horizon.reach);
    lx_wide s = lx_wide_div(lx_wide_mul(lx_wide_sqrt(above), lx_wide_sqrt(below)), horizon.reach);
    lx_wide cc = lx_wide_mul(c0, c), ss = lx_wide_mul(s0, s), sc = lx_wide_mul(s0, c), cs = lx_wide_mul(c0, s);
    horizon.crossed = true;
    horizon.rise = (struct lx_mark){lx_wide_add(cc, ss), lx_wide_sub(sc, cs)};
    horizon.set = (struct lx_mark){lx_wide_sub(cc, ss), lx_wide_add(sc, cs)};
    horizon.half_turn = lx_wide_scale(lx_wide_atan2(lx_wide_sqrt(above), lx_wide_sqrt(below)), 2);
    return horizon;
}

/* 1 + cos; on the near side by the sine, so that a mark's error is one of its angle alone. */
static lx_wide from_near(struct lx_mark mark)
{
    lx_wide one = lx_wide_of(1);
    if (mark.cosine.high < 0)
        return lx_wide_div(square(mark.sine), lx_wide_sub(one, mark.cosine));
    return lx_wide_add(one, mark.cosine);
}

lx_wide3 lx_rim_place(const struct lx_rim *rim, struct lx_mark mark)
{
    return (lx_wide3){
        lx_wide_add(lx_wide_sub(rim->rho, rim->radius), lx_wide_mul(rim->radius, from_near(mark))),
        lx_wide_mul(rim->radius, mark.sine),
        rim->height,
    };
}

static lx_wide distance2(const struct lx_rim *rim, struct lx_mark mark)
{
    if (mark.cosine.high < 0)
        return lx_wide_add(rim->near2, lx_wide_mul(rim->kappa, from_near(mark)));
    return lx_wide_sub(rim->far2, lx_wide_mul(rim->kappa, lx_wide_sub(lx_wide_of(1), mark.cosine)));
}

/* Where a ratio is so small, an arc tangent is the ratio itself. */
static const double TINY = 0x1p-55;

/* delta/kappa */
static lx_wide lag(const struct lx_rim *rim, struct lx_mark mark)
{
    lx_wide one = lx_wide_of(1), y = lx_wide_mul(rim->slope, mark.sine);
    lx_wide x = lx_wide_add(from_near(mark), lx_wide_mul(rim->lambda, lx_wide_sub(one, mark.cosine)));
    if (rim->kappa.high * fabs(y.high) < TINY * x.high)
        return lx_wide_scale(lx_wide_div(y, x), 2);
    return lx_wide_scale(lx_wide_div(lx_wide_atan2(lx_wide_mul(rim->kappa, y), x), rim->kappa), 2);
}

/* The integral of sin w/D from one place to another with the squared distances d1 and d2. */
static lx_wide sine_integral(const struct lx_rim *rim, struct lx_mark from, struct lx_mark to, lx_wide d1, lx_wide d2)
{
    lx_wide share = lx_wide_div(lx_wide_sub(from_near(from), from_near(to)), lx_wide_add(d1, d2));
    lx_wide z = lx_wide_mul(rim->kappa, share);
    if (fabs(z.high) < TINY)
        return lx_wide_scale(share, 2);
    static const double NEAR = 0.05;
    if (fabs(z.high) < NEAR)
        return lx_wide_scale(lx_wide_div(lx_wide_atanh(z), rim->kappa), 2);
    return lx_wide_div(lx_wide_log(lx_wide_div(d1, d2)), rim->kappa);
}

static void add(struct lx_wide_sum *sum, lx_wide term, double size)
{
    sum->value = lx_wide_add(sum->value, term);
    sum->size += size + fabs(term.high);
}

/*
 * The sizes: each term's own roundings, and what a rounding of the angles of the ends does to their sum, R/|r|; the
 * logarithm's quotient, and the difference in it, are good to a rounding of 1.
 */
void lx_add_arc(struct lx_wide_sum *sum, const struct lx_rim *rim, struct lx_mark from, struct lx_mark to, lx_wide turn,
                double sign)
{
    const lx_wide3 *n = &rim->normal;
    lx_wide d1 = distance2(rim, from), d2 = distance2(rim, to), lag1 = lag(rim, from), lag2 = lag(rim, to);
    lx_wide lagged = lx_wide_sub(lag2, lag1);
    lx_wide by_sine = sine_integral(rim, from, to, d1, d2);
    lx_wide by_one = lx_wide_div(lx_wide_sub(turn, lx_wide_mul(rim->kappa, lagged)), rim->w);
    lx_wide even = lx_wide_div(lx_wide_mul(turn, rim->kappa), lx_wide_add(rim->k, rim->w));
    lx_wide by_cosine = lx_wide_div(lx_wide_sub(lx_wide_mul(rim->k, lagged), even), rim->w);

    lx_wide radius = lx_wide_scale(rim->radius, sign);
    lx_wide factors[3] = {
        lx_wide_negate(lx_wide_mul(lx_wide_mul(rim->height, n->y), radius)),
        lx_wide_mul(lx_wide_sub(lx_wide_mul(rim->rho, n->z), lx_wide_mul(rim->height, n->x)), radius),
        lx_wide_mul(lx_wide_mul(n->z, rim->radius), radius),
    };
    double k = rim->k.high, w = rim->w.high, kappa = rim->kappa.high, r = rim->radius.high;
    double lags = fabs(lag1.high) + fabs(lag2.high), ends = r / sqrt(d1.high) + r / sqrt(d2.high);
    double logarithm = 1 / d1.high + 1 / d2.high;
    if (kappa * logarithm > 1)
        logarithm = 1 / kappa;
    double size1 = fabs(factors[0].high) * 2 * logarithm + ends;
    double across = fabs(rim->rho.high * n->z.high) + fabs(rim->height.high * n->x.high);
    double size2 = r * across * (k * lags + even.high) / w;
    double size3 = fabs(factors[2].high) * (turn.high + kappa * lags) / w;
    add(sum, lx_wide_mul(factors[0], by_sine), size1);
    add(sum, lx_wide_mul(factors[1], by_cosine), size2);
    add(sum, lx_wide_mul(factors[2], by_one), size3);
}

/* Between places on the horizon the angle about N cannot be negative: what lies above them is convex. */
void lx_add_chord(struct lx_wide_sum *sum, lx_wide3 normal, lx_wide3 from, lx_wide3 to, lx_wide3 way)
{
    lx_wide length = lx_wide3_length(normal);
    lx_wide product = lx_wide_div(lx_wide3_dot(normal, lx_wide3_cross(from, way)), length);
    if (product.high < 0)
        product = lx_wide_of(0);
    double from_size = lx_wide3_length(from).high, to_size = lx_wide3_length(to).high;
    double nearest = fmin(from_size, to_size);
    lx_wide angle = lx_wide_atan2(product, lx_wide3_dot(from, to));
    add(sum, lx_wide_mul(angle, length), nearest > 0 ? lx_wide3_length(way).high / nearest : 1);
}

/*
 * All of it is above the horizon: with t = 2 h^2 R^2/(W + X), X = rho^2 + h^2 - R^2,
 *
 *     E = 2 pi R^2/(W (K + W)) ((h^2 + t) Na + h rho Nu)
 */
static void add_whole(struct lx_wide_sum *sum, const struct lx_rim *rim)
{
    const lx_wide3 *n = &rim->normal;
    lx_wide r2 = square(rim->radius), h2 = square(rim->height);
    lx_wide beyond = lx_wide_sub(rim->rho, rim->radius);
    lx_wide x = lx_wide_add(lx_wide_mul(beyond, lx_wide_add(rim->rho, rim->radius)), h2);
    lx_wide t = x.high > 0 ? lx_wide_div(lx_wide_scale(lx_wide_mul(h2, r2), 2), lx_wide_add(rim->w, x))
                           : lx_wide_scale(lx_wide_sub(rim->w, x), 0.5);
    lx_wide along = lx_wide_mul(n->z, lx_wide_add(h2, t));
    lx_wide across = lx_wide_mul(n->x, lx_wide_mul(rim->height, rim->rho));
    lx_wide factor =
        lx_wide_div(lx_wide_mul(lx_wide_scale(lx_wide_pi(), 4), r2), lx_wide_mul(rim->w, lx_wide_add(rim->k, rim->w)));
    add(sum, lx_wide_mul(factor, along), 0);
    add(sum, lx_wide_mul(factor, across), 0);
}

void lx_add_disk(struct lx_wide_sum *sum, const struct lx_rim *rim, const struct lx_horizon *horizon)
{
    if (!horizon->crossed) {
        if (horizon->middle.high > 0)
            add_whole(sum, rim);
        return;
    }
    lx_wide3 rise = lx_rim_place(rim, horizon->rise), set = lx_rim_place(rim, horizon->set);
    lx_wide along = lx_wide_sub(horizon->rise.cosine, horizon->set.cosine),
            across = lx_wide_sub(horizon->rise.sine, horizon->set.sine);
    lx_wide3 way = {lx_wide_mul(rim->radius, along), lx_wide_mul(rim->radius, across), lx_wide_of(0)};
    lx_add_arc(sum, rim, horizon->rise, horizon->set, lx_wide_scale(horizon->half_turn, 2), 1);
    lx_add_chord(sum, rim->normal, set, rise, way);
}
