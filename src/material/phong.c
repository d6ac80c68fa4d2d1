/* SPDX-License-Identifier: MIT */
/*
 * Phong's model (1975): S = R.V, R = 2 (N.L) N - L being the mirrored ray; R.V = M.L.  Normalised as in docs/MATHS.
 */
#include <math.h>

#include "../base/vector.h"
#include "power.h"

static void pair(lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards, lx_bounded3 pair[2])
{
    const lx_bounded twice = lx_scale(lx_dot3(normal, towards), 2);
    pair[0] = lx_sub3(lx_mul3(normal, twice), towards);
    pair[1] = view;
}

static lx_bounded normalization(double exponent)
{
    return lx_scale(lx_add(lx_exact(exponent), lx_exact(2)), 0.5);
}

/* M is off by twice what N is. */
static double log_value(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error)
{
    moved = moved + at->view_error + 2 * DBL_EPSILON;
    moved += at->normal_error;
    const double off = at->normal_error + moved;
    return lx_power_log(lobe->exponent, lx_dot(at->mirrored, towards), lx_cross_square(at->mirrored, towards), off,
                        error);
}

/* A sharp lobe has its peak at the place nearest to M. */
static size_t peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                    double tau[LX_MOST_PEAKS])
{
    static const double SHARP = 8;
    tau[0] = atan2(lx_dot(at->mirrored, b), lx_dot(at->mirrored, a));
    return lobe->exponent > SHARP;
}

static const double *end(const struct lx_lobe_at *at, double *limit)
{
    *limit = 0;
    return at->mirrored;
}

static double greatest_square(double cosine)
{
    return cosine > 0 ? cosine * cosine : 0;
}

static double least_angle(const struct lx_lobe_at *at, const double towards[3], double spread)
{
    return lx_angle_between(at->mirrored, towards) - spread;
}

static double width(double exponent, double half)
{
    (void)half;
    return 1 / sqrt(fmax(exponent, 1));
}

static double angle_error(double off, double half, double unit)
{
    (void)half;
    return off + 4 * unit;
}

static const struct lx_power_lobe power = {
    .pair = pair,
    .moving = 0,
    .turns_of_normal = 2,
    .greatest_square = greatest_square,
    .least_angle = least_angle,
    .width = width,
    .angle_error = angle_error,
};

const struct lx_lobe_kind lx_phong_lobe = {
    .words =
        {
            .definition = "\\mathbf{R} = 2 (\\mathbf{N} \\cdot \\mathbf{L}) \\mathbf{N} - \\mathbf{L}, \\qquad S = "
                          "\\max(0, \\mathbf{R} \\cdot \\mathbf{V})",
            .brightness = LX_POWER_BRIGHTNESS,
            .normalized = LX_POWER_NORMALIZED,
            .constant = "c = \\frac{n + 2}{2}",
            .vector = "\\mathbf{R} = 2 (\\mathbf{N} \\cdot \\mathbf{L}) \\mathbf{N} - \\mathbf{L}",
            .cosine = "S = \\max(0, \\mathbf{R} \\cdot \\mathbf{V})",
        },
    .is_lambertian = true,
    .normalization = normalization,
    .value = lx_power_value,
    .log_value = log_value,
    .peaks = peaks,
    .end = end,
    .power = &power,
};
