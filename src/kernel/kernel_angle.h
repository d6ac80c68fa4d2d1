/* SPDX-License-Identifier: MIT */
/*
 * Angles for the kernels of round sources, in float64 and without branches: everything is of
 *
 *     gap(z) = 1 - atan(sqrt z)/sqrt z = z/3 - z^2/5 + z^3/7 ...,   for z < 0 the same with atanh,
 *
 * which keeps its digits where the arc tangent is nearly its argument.  Included by kernel.c, once for an
 * instruction set.
 */
#define LANE static inline __attribute__((always_inline))

LANE double least(double a, double b)
{
    return a < b ? a : b;
}

LANE double greatest(double a, double b)
{
    return a > b ? a : b;
}

/* gap(z) for |z| <= SERIES_END, below which a direct form of gap(-z) loses digits; error below 1e-16 relative */
static const double SERIES_END = 0.04;

LANE double small_gap(double z)
{
    double series = 1.0 / 25;
    for (int k = 11; k >= 1; k--)
        series = 1.0 / (2 * k + 1) - z * series;
    return z * series;
}

/* gap(z) for 0 <= z <= 1, by the polynomial of kernel_functions.h */
LANE double gap_to_one(double z)
{
    double value = gap_terms_double[GAP_TERMS_double - 1];
    LX_UNROLLED
    for (int k = GAP_TERMS_double - 2; k >= 0; k--)
        value = value * z + gap_terms_double[k];
    return z * value;
}

/* gap(z) for z >= 0; beyond 1 the angle is what 1/z leaves of 90 degrees */
LANE double gap(double z)
{
    double inverse = 1 / greatest(z, 1), part = gap_to_one(least(z, inverse)), root = sqrt(inverse);
    return z > 1 ? 1 - root * (M_PI / 2 - root * (1 - part)) : part;
}

/*
 * log2(w) of w = 1 - q, given both: near 1 it comes from q, which keeps the digits that w has lost.  With w = 2^e m, m
 * within [sqrt(1/2), sqrt(2)): log2 m = 2/ln 2 (s + s^3/3 + s^5/5 ...), s = (m - 1)/(m + 1).
 */
LANE double log2_of_rest(double w, double q)
{
    const double magic = 6755399441055744.0; /* 1.5 * 2^52 */
    const uint64_t bias = 1023, mantissa = 52;
    const union {
        double real;
        uint64_t bits;
    } v = {.real = greatest(w, SMALLEST)}, root = {.real = 0.70710678118654752}, counter = {.real = magic};
    uint64_t biased = (v.bits - root.bits + (bias << mantissa)) >> mantissa;
    const union {
        uint64_t bits;
        double real;
    } m = {.bits = v.bits - ((biased - bias) << mantissa)}, whole = {.bits = counter.bits + biased};
    double exponent = whole.real - (magic + (double)bias);
    double above = q < 0.25 ? -q : m.real - 1;
    double s = above / (m.real + 1), s2 = s * s, series = 1.0 / 21;
    for (int k = 9; k >= 0; k--)
        series = series * s2 + 1.0 / (2 * k + 1);
    return exponent + 2.8853900817779268 * s * series;
}

/* gap(-zeta^2) for 0 <= zeta < 1, told rest = (1 - zeta)/(1 + zeta), too */
LANE double negative_gap(double zeta, double rest)
{
    const double half_ln2 = 0.34657359027997264;
    double direct = 1 + half_ln2 * log2_of_rest(rest, 2 * zeta / (1 + zeta)) / greatest(zeta, 0.1);
    double z = zeta * zeta;
    double series = small_gap(-least(z, SERIES_END));
    return z < SERIES_END ? series : direct;
}

/* The angle from 0 to pi of the point (x, y), y >= 0; 0 for (0, 0). */
LANE double angle_of(double y, double x)
{
    double size = fabs(x);
    double t = y / greatest(sqrt(x * x + y * y) + size, SMALLEST);
    double angle = 2 * t * (1 - gap_to_one(t * t));
    return x < 0 ? M_PI - angle : angle;
}
