/* SPDX-License-Identifier: MIT */
/*
 * Blinn's model (1977) with Phong's power: S = N.H, H = (L + V)/|L + V| being the half vector.  S > 0 where
 * N.L > -N.V.  Where L turns, H turns by 1/|L + V| of that; its angle to N is at least half that of L to M.
 * Normalised as in docs/MATHS.
 */
#include <math.h>

#include "../base/vector.h"
#include "power.h"

static void pair(lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards, lx_bounded3 pair[2])
{
    pair[0] = normal;
    pair[1] = lx_unit3(lx_add3(towards, view));
}

static lx_bounded normalization(double exponent)
{
    const lx_bounded n = lx_exact(exponent);
    const lx_bounded above = lx_mul(lx_add(n, lx_exact(2)), lx_add(n, lx_exact(4)));
    return lx_div(above, lx_scale(lx_add(n, lx_rounded(exp2(-exponent / 2), 0, 2)), 8));
}

static double log_value(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error)
{
    double half[3];
    for (int i = 0; i < 3; i++)
        half[i] = towards[i] + at->view[i];
    const double square = lx_dot(half, half), cosine = lx_dot(at->normal, half) / sqrt(square);
    moved = moved + at->view_error + 2 * DBL_EPSILON;
    const double off = at->normal_error + moved * (2 / sqrt(square));
    return lx_power_log(lobe->exponent, cosine, lx_cross_square(at->normal, half) / square, off, error);
}

/*
 * Newton's method for the place on the circle where N.H is greatest: its square is a^2/(2 + 2b) with a = N.L + N.V and
 * b = V.L, so that 2 (1 + b) a' = a b'.
 */
static double climb(const struct lx_lobe_at *at, const double first[3], const double second[3], double tau)
{
    enum { STEPS = 6 };
    const double a_cos = lx_dot(at->normal, first), a_sin = lx_dot(at->normal, second);
    const double b_cos = lx_dot(at->view, first), b_sin = lx_dot(at->view, second);
    for (int i = 0; i < STEPS; i++) {
        const double c = cos(tau), s = sin(tau), a1 = a_sin * c - a_cos * s, a2 = -(a_cos * c + a_sin * s);
        const double b1 = b_sin * c - b_cos * s, b2 = -(b_cos * c + b_sin * s), a = at->n_dot_v - a2, b = 1 - b2;
        const double slope = 2 * b * a2 + a1 * b1 - a * b2;
        const double step = (2 * b * a1 - a * b1) / slope;
        if (!(slope < 0) || !(fabs(step) < 1))
            break;
        tau -= step;
    }
    return tau;
}

/*
 * N.H is the same on both sides of the plane of N and V: its ridge is where the circle crosses that plane.  Near
 * L = -V it changes within the distance from there.
 */
size_t lx_half_peaks(bool is_sharp, const struct lx_lobe_at *at, const double a[3], const double b[3],
                     double tau[LX_MOST_PEAKS])
{
    static const double NEAR = 0.9;
    const double back_a = -lx_dot(at->view, a), back_b = -lx_dot(at->view, b);
    size_t count = 0;
    if (is_sharp || hypot(back_a, back_b) > NEAR)
        tau[count++] = atan2(back_b, back_a);
    if (!is_sharp)
        return count;
    double plane[3];
    lx_cross(at->normal, at->view, plane);
    const double crossing = atan(-lx_dot(plane, a) / lx_dot(plane, b));
    tau[count++] = climb(at, a, b, atan2(lx_dot(at->mirrored, b), lx_dot(at->mirrored, a)));
    tau[count++] = crossing;
    tau[count++] = climb(at, a, b, crossing);
    return count;
}

static size_t peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                    double tau[LX_MOST_PEAKS])
{
    static const double SHARP = 8;
    return lx_half_peaks(lobe->exponent > SHARP, at, a, b, tau);
}

static const double *end(const struct lx_lobe_at *at, double *limit)
{
    *limit = -at->n_dot_v;
    return at->normal;
}

static double greatest_square(double cosine)
{
    return fmax((1 + cosine) / 2, 0);
}

static double least_angle(const struct lx_lobe_at *at, const double towards[3], double spread)
{
    double half[3];
    for (int k = 0; k < 3; k++)
        half[k] = towards[k] + at->view[k];
    const double length = sqrt(lx_dot(half, half));
    return length > spread ? lx_angle_between(at->normal, half) - asin(fmin(spread / (length - spread) * 1.01, 1)) : 0;
}

static double width(double exponent, double half)
{
    const double of_angle = 1 / sqrt(fmax(exponent, 1));
    return half * of_angle;
}

static double angle_error(double off, double half, double unit)
{
    return (off + 2 * unit) / half + 3 * unit;
}

static const struct lx_power_lobe power = {
    .pair = pair,
    .moving = 1,
    .asks_half = true,
    .turns_of_normal = 1,
    .greatest_square = greatest_square,
    .least_angle = least_angle,
    .width = width,
    .angle_error = angle_error,
};

const struct lx_lobe_kind lx_blinn_phong_lobe = {
    .words =
        {
            .definition = "\\mathbf{H} = \\frac{\\mathbf{L} + \\mathbf{V}}{|\\mathbf{L} + \\mathbf{V}|}, \\qquad S = "
                          "\\max(0, \\mathbf{N} \\cdot \\mathbf{H})",
            .brightness = LX_POWER_BRIGHTNESS,
            .normalized = LX_POWER_NORMALIZED,
            .constant = "c = \\frac{(n + 2)(n + 4)}{8 \\left( n + 2^{-n/2} \\right)}",
            .vector = "\\mathbf{H} = \\frac{\\mathbf{L} + \\mathbf{V}}{|\\mathbf{L} + \\mathbf{V}|}",
            .cosine = "S = \\max(0, \\mathbf{N} \\cdot \\mathbf{H})",
        },
    .is_lambertian = true,
    .normalization = normalization,
    .value = lx_power_value,
    .log_value = log_value,
    .peaks = peaks,
    .end = end,
    .power = &power,
};
