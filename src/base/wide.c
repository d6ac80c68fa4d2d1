/* SPDX-License-Identifier: MIT */
/*
 * Wide arithmetic after Dekker and Joldes, Muller, Popescu; products are split after Veltkamp instead of by fma(),
 * which is a slow library call on plain x86-64.  Arc tangent and logarithm bring their argument near to 0 or 1 by
 * halving (tan(a/2) = tan(a)/(1 + sqrt(1 + tan(a)^2)); square roots) and sum their series there.
 */
#include "wide.h"

/* The terms 1/(2k + 1) of both series. */
enum { TERMS = 13 };
static const lx_wide reciprocals[TERMS] = {
    {0x1.0000000000000p+0, 0x0.0p+0},
    {0x1.5555555555555p-2, 0x1.5555555555555p-56},
    {0x1.999999999999ap-3, -0x1.999999999999ap-57},
    {0x1.2492492492492p-3, 0x1.2492492492492p-57},
    {0x1.c71c71c71c71cp-4, 0x1.c71c71c71c71cp-58},
    {0x1.745d1745d1746p-4, -0x1.745d1745d1746p-59},
    {0x1.3b13b13b13b14p-4, -0x1.3b13b13b13b14p-58},
    {0x1.1111111111111p-4, 0x1.1111111111111p-60},
    {0x1.e1e1e1e1e1e1ep-5, 0x1.e1e1e1e1e1e1ep-61},
    {0x1.af286bca1af28p-5, 0x1.af286bca1af28p-59},
    {0x1.8618618618618p-5, 0x1.8618618618618p-59},
    {0x1.642c8590b2164p-5, 0x1.642c8590b2164p-60},
    {0x1.47ae147ae147bp-5, -0x1.eb851eb851eb8p-61},
};

static const lx_wide PI = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},
                     LN2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/* ---- exact sums and products ---- */

/* |a| >= |b|, or a = 0 */
static lx_wide quick_sum(double a, double b)
{
    double sum = a + b;
    return (lx_wide){sum, b - (sum - a)};
}

static lx_wide exact_sum(double a, double b)
{
    double sum = a + b, part = sum - a;
    return (lx_wide){sum, (a - (sum - part)) + (b - part)};
}

/* a as a sum of two numbers of 26 bits */
static lx_wide split(double a)
{
    double scaled = 0x1.0000002p27 * a, high = scaled - (scaled - a);
    return (lx_wide){high, a - high};
}

static lx_wide exact_product(double a, double b)
{
    double product = a * b;
    lx_wide x = split(a), y = split(b);
    return (lx_wide){product, ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

/* ---- arithmetic ---- */

lx_wide lx_wide_of(double value)
{
    return (lx_wide){value, 0};
}

double lx_wide_value(lx_wide a)
{
    return a.high + a.low;
}

lx_wide lx_wide_pi(void)
{
    return PI;
}

lx_wide lx_wide_negate(lx_wide a)
{
    return (lx_wide){-a.high, -a.low};
}

lx_wide lx_wide_add(lx_wide a, lx_wide b)
{
    lx_wide high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
    lx_wide sum = quick_sum(high.high, high.low + low.high);
    return quick_sum(sum.high, low.low + sum.low);
}

lx_wide lx_wide_sub(lx_wide a, lx_wide b)
{
    return lx_wide_add(a, lx_wide_negate(b));
}

lx_wide lx_wide_mul(lx_wide a, lx_wide b)
{
    lx_wide product = exact_product(a.high, b.high);
    return quick_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

lx_wide lx_wide_div(lx_wide a, lx_wide b)
{
    double quotient = a.high / b.high;
    lx_wide rest = lx_wide_sub(a, lx_wide_mul(b, lx_wide_of(quotient)));
    return quick_sum(quotient, rest.high / b.high);
}

lx_wide lx_wide_scale(lx_wide a, double power_of_two)
{
    return (lx_wide){a.high * power_of_two, a.low * power_of_two};
}

lx_wide lx_wide_sqrt(lx_wide a)
{
    if (!(a.high > 0))
        return lx_wide_of(0);
    double root = sqrt(a.high);
    lx_wide rest = lx_wide_sub(a, exact_product(root, root));
    return quick_sum(root, rest.high / (2 * root));
}

int lx_wide_compare(lx_wide a, lx_wide b)
{
    double difference = lx_wide_sub(a, b).high;
    return (difference > 0) - (difference < 0);
}

/* ---- arc tangent and logarithm ---- */

/* x times the sum of square^k/(2k + 1) */
static lx_wide odd_series(lx_wide x, lx_wide square)
{
    lx_wide sum = reciprocals[TERMS - 1];
    for (int k = TERMS - 2; k >= 0; k--)
        sum = lx_wide_add(lx_wide_mul(sum, square), reciprocals[k]);
    return lx_wide_mul(x, sum);
}

/* 0 <= x <= 1; four halvings leave at most tan(pi/64) */
static lx_wide arc_tangent(lx_wide x)
{
    enum { HALVINGS = 4 };
    lx_wide one = lx_wide_of(1);
    for (int i = 0; i < HALVINGS; i++)
        x = lx_wide_div(x, lx_wide_add(one, lx_wide_sqrt(lx_wide_add(one, lx_wide_mul(x, x)))));
    return lx_wide_scale(odd_series(x, lx_wide_negate(lx_wide_mul(x, x))), 1 << HALVINGS);
}

static lx_wide absolute(lx_wide a)
{
    return a.high < 0 ? lx_wide_negate(a) : a;
}

lx_wide lx_wide_atan2(lx_wide y, lx_wide x)
{
    lx_wide above = absolute(y), along = absolute(x), angle;
    if (above.high == 0 && along.high == 0)
        return lx_wide_of(0);
    if (lx_wide_compare(above, along) <= 0)
        angle = arc_tangent(lx_wide_div(above, along));
    else
        angle = lx_wide_sub(lx_wide_scale(PI, 0.5), arc_tangent(lx_wide_div(along, above)));
    if (x.high < 0)
        angle = lx_wide_sub(PI, angle);
    return y.high < 0 ? lx_wide_negate(angle) : angle;
}

lx_wide lx_wide_log(lx_wide a)
{
    enum { ROOTS = 2 };
    static const double NEAR = 0.09; /* where the series needs no roots; beyond, they leave less than 2^(1/8) */
    int exponent = ilogb(a.high * M_SQRT2);
    double factor = 1;
    lx_wide one = lx_wide_of(1), m = lx_wide_scale(a, ldexp(1, -exponent));
    if (fabs(m.high - 1) > NEAR) {
        for (int i = 0; i < ROOTS; i++)
            m = lx_wide_sqrt(m);
        factor = 1 << ROOTS;
    }
    lx_wide u = lx_wide_div(lx_wide_sub(m, one), lx_wide_add(m, one));
    lx_wide log_m = lx_wide_scale(odd_series(u, lx_wide_mul(u, u)), 2 * factor);
    return lx_wide_add(log_m, lx_wide_mul(LN2, lx_wide_of(exponent)));
}

lx_wide lx_wide_atanh(lx_wide a)
{
    static const double NEAR = 0.05;
    lx_wide one = lx_wide_of(1);
    if (fabs(a.high) < NEAR)
        return odd_series(a, lx_wide_mul(a, a));
    return lx_wide_scale(lx_wide_log(lx_wide_div(lx_wide_add(one, a), lx_wide_sub(one, a))), 0.5);
}

/* ---- vectors ---- */

lx_wide3 lx_wide3_of(const double v[3])
{
    return (lx_wide3){lx_wide_of(v[0]), lx_wide_of(v[1]), lx_wide_of(v[2])};
}

void lx_wide3_values(lx_wide3 a, double values[3])
{
    values[0] = lx_wide_value(a.x), values[1] = lx_wide_value(a.y), values[2] = lx_wide_value(a.z);
}

lx_wide3 lx_wide3_add(lx_wide3 a, lx_wide3 b)
{
    return (lx_wide3){lx_wide_add(a.x, b.x), lx_wide_add(a.y, b.y), lx_wide_add(a.z, b.z)};
}

lx_wide3 lx_wide3_sub(lx_wide3 a, lx_wide3 b)
{
    return (lx_wide3){lx_wide_sub(a.x, b.x), lx_wide_sub(a.y, b.y), lx_wide_sub(a.z, b.z)};
}

lx_wide3 lx_wide3_mul(lx_wide3 a, lx_wide factor)
{
    return (lx_wide3){lx_wide_mul(a.x, factor), lx_wide_mul(a.y, factor), lx_wide_mul(a.z, factor)};
}

lx_wide lx_wide3_dot(lx_wide3 a, lx_wide3 b)
{
    return lx_wide_add(lx_wide_add(lx_wide_mul(a.x, b.x), lx_wide_mul(a.y, b.y)), lx_wide_mul(a.z, b.z));
}

lx_wide3 lx_wide3_cross(lx_wide3 a, lx_wide3 b)
{
    return (lx_wide3){
        lx_wide_sub(lx_wide_mul(a.y, b.z), lx_wide_mul(a.z, b.y)),
        lx_wide_sub(lx_wide_mul(a.z, b.x), lx_wide_mul(a.x, b.z)),
        lx_wide_sub(lx_wide_mul(a.x, b.y), lx_wide_mul(a.y, b.x)),
    };
}

lx_wide lx_wide3_length(lx_wide3 a)
{
    return lx_wide_sqrt(lx_wide3_dot(a, a));
}

lx_wide3 lx_wide3_unit(lx_wide3 a)
{
    lx_wide length = lx_wide3_length(a);
    return (lx_wide3){lx_wide_div(a.x, length), lx_wide_div(a.y, length), lx_wide_div(a.z, length)};
}
