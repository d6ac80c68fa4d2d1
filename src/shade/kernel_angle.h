/* SPDX-License-Identifier: MIT */
/*
 * Angles for the kernels of extended sources, in float64 and without branches: everything is of
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

/* |z| <= 0.04; error below 1e-16 relative */
LANE double small_gap(double z)
{
    double series = 1.0 / 25;
    for (int k = 11; k >= 1; k--)
        series = 1.0 / (2 * k + 1) - z * series;
    return z * series;
}

/*
 * atan(sqrt z)/sqrt z for z >= 0.  Halving an angle turns z into (sqrt z/(1 + sqrt(1 + z)))^2, which takes 1 to 0.172
 * and that to 0.0396.
 */
LANE double arc_over_tangent(double z, int halvings)
{
    double scale = 1;
    for (int i = 0; i < halvings; i++) {
        double inverse = 1 / (1 + sqrt(1 + z));
        scale *= 2 * inverse;
        z *= inverse * inverse;
    }
    return scale * (1 - small_gap(z));
}

/* The cosine of small angles does not tell them; below this z the series does. */
static const double series_end = 0.04;

/* gap(z) for z >= 0 */
LANE double gap(double z)
{
    double direct = 1 - arc_over_tangent(z, 3);
    double series = small_gap(least(z, series_end));
    return z < series_end ? series : direct;
}

/* gap(-zeta^2) for 0 <= zeta < 1, told rest = (1 - zeta)/(1 + zeta), too */
LANE double negative_gap(double zeta, double rest)
{
    const double half_ln2 = 0.34657359027997264;
    double direct = 1 + half_ln2 * log2_of_double(rest, 2 * zeta / (1 + zeta)) / greatest(zeta, 0.1);
    double z = zeta * zeta;
    double series = small_gap(-least(z, series_end));
    return z < series_end ? series : direct;
}

/* The angle from 0 to pi of the point (x, y), y >= 0; 0 for (0, 0). */
LANE double angle_of(double y, double x)
{
    double size = fabs(x);
    double t = y / greatest(sqrt(x * x + y * y) + size, SMALLEST);
    double angle = 2 * t * arc_over_tangent(t * t, 2);
    return x < 0 ? M_PI - angle : angle;
}
