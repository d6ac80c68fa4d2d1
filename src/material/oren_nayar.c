/* SPDX-License-Identifier: MIT */
/*
 * The qualitative model of M. Oren and S. Nayar (1994) for surfaces of V-shaped grooves, whose slopes scatter by sigma:
 * D = A + B max(0, cos(phi)) sin(alpha) tan(beta).
 */
#include <math.h>

#include "material.h"
#include "rough.h"

/* own[0]: A, own[1]: B; what is smooth is Lambert's. */
static void prepare(const struct lx_material *material, struct lx_lobe *lobe)
{
    const double sigma = material->sigma_degrees * (M_PI / 180), square = sigma * sigma;
    if (square == 0)
        lobe->model = LX_LAMBERT;
    lobe->own[0] = 1 - square / (2 * (square + 0.33));
    lobe->own[1] = 0.45 * square / (square + 0.09);
}

/* A + 2 B/pi (sin(a) (a - sin(a) cos(a))/2 + tan(a) (1 - sin(a)^3)/3) of the view's angle a. */
static double albedo(const struct lx_lobe *lobe, double n_dot_v)
{
    const double c = n_dot_v, s = sqrt((1 - c) * (1 + c)), angle = atan2(s, c);
    const double by_slopes = s * (angle - s * c) / 2 + s * c * (1 + s * s / (1 + s)) / 3;
    return lobe->own[0] + lobe->own[1] * (2 / M_PI) * by_slopes;
}

static lx_bounded value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    const lx_bounded slope = lx_positive(lx_slope_of(normal, view, towards).value);
    const double made = lobe->own[0] + lobe->own[1] * slope.value;
    return lx_rounded(made, lobe->own[1] * slope.error, 16);
}

static double log_value(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error)
{
    double lit, off;
    const double slope = lx_slope_at(at, towards, moved, &lit, &off);
    const double made = lobe->own[0] + lobe->own[1] * fmax(slope, 0);
    *error = lobe->own[1] * off / made + 16 * DBL_EPSILON;
    return log(made);
}

const struct lx_lobe_kind lx_oren_nayar_lobe = {
    .words =
        {
            .definition = LX_ROUGH_SLOPE
            ", \\qquad D = A + B\\, \\frac{\\max(0, s)}{\\max(\\mathbf{N} \\cdot \\mathbf{L}, \\mathbf{N} \\cdot "
            "\\mathbf{V})}",
            .constant = "A = 1 - \\frac{\\sigma^2}{2 (\\sigma^2 + 0.33)}, \\qquad B = \\frac{0.45\\, "
                        "\\sigma^2}{\\sigma^2 + 0.09}",
            .step = "D = A + B\\, \\frac{\\max(0, s)}{\\max(\\mathbf{N} \\cdot \\mathbf{L}, \\mathbf{N} \\cdot "
                    "\\mathbf{V})} = ",
        },
    .prepare = prepare,
    .albedo = albedo,
    .value = value,
    .log_value = log_value,
    .kinks = lx_slope_kinks,
};
