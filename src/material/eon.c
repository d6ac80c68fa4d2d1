/* SPDX-License-Identifier: MIT */
/*
 * EON, the energy-preserving model of Oren and Nayar's kind by J. Portsmouth, P. Kutz and S. Hill (2024): single
 * scattering by Y. Fujii's form of it, D = A_F (1 + r q), A_F = 1/(1 + c r), c = 1/2 - 2/(3 pi), of which the albedo is
 * E(m) = A_F (1 + r G(m)/pi), and multiple scattering by as much as that is short of all:
 *
 *     rho E_m/(1 - rho (1 - E_m)) (1 - E(N.L)) (1 - E(N.V))/(1 - E_m),   1 - E = A_F r (c - G/pi)
 *
 * with E_m = A_F (1 + d r), d = 2/3 - 28/(15 pi), the mean of E.  A_F r (c - d) is 1 - E_m, so that nothing cancels.
 */
#include <math.h>

#include "eon.h"
#include "material.h"
#include "rough.h"

static const double C = 0.5 - 2 / (3 * M_PI), D = 2.0 / 3 - 28 / (15 * M_PI);

double lx_eon_multiple(double roughness, double rho)
{
    const double single = 1 / (1 + C * roughness), missing = single * roughness * (C - D), mean = 1 - missing;
    return rho * mean / (1 - rho * missing) * single * roughness / (C - D);
}

/* own[0]: A_F, own[1]: A_F r, own[2]: the factor of multiple scattering */
static void prepare(const struct lx_material *material, struct lx_lobe *lobe)
{
    const double r = material->roughness;
    if (r == 0)
        lobe->model = LX_LAMBERT;
    lobe->own[0] = 1 / (1 + C * r);
    lobe->own[1] = lobe->own[0] * r;
    lobe->own[2] = lx_eon_multiple(r, material->diffuse);
}

/* c - G/pi, G = sin(a) (a - sin(a) cos(a)) + 2/3 (tan(a) (1 - sin(a)^3) - sin(a)), of an angle by its cosine. */
static double missing(double cosine)
{
    const double c = fmin(cosine, 1), s = sqrt((1 - c) * (1 + c)), angle = atan2(s, c);
    return C - (s * (angle - s * c) + 2.0 / 3 * s * (c * (1 + s * s / (1 + s)) - 1)) / M_PI;
}

/* Its slope is less than 0.4. */
static double missing_error(double off)
{
    return 0.4 * off + 4 * DBL_EPSILON;
}

/* What single scattering lacks is missing() A_F r; multiple scattering gives rho E_m/(1 - rho (1 - E_m)) of that. */
static double albedo(const struct lx_lobe *lobe, double n_dot_v)
{
    const double lacks = lobe->own[1] * missing(n_dot_v);
    return 1 - lacks + lobe->own[2] * (C - D) * missing(n_dot_v);
}

static lx_bounded value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    const struct lx_slope slope = lx_slope_of(normal, view, towards);
    const double lit = missing(slope.lit.value), seen = missing(slope.seen.value), error = missing_error(0);
    const double made = lobe->own[0] + lobe->own[1] * slope.value.value + lobe->own[2] * lit * seen;
    const double by_multiple =
        (lit + error) * missing_error(slope.seen.error) + (seen + error) * missing_error(slope.lit.error);
    return lx_rounded(fmax(made, 0),
                      lobe->own[1] * slope.value.error + lobe->own[2] * by_multiple + 16 * DBL_EPSILON * lobe->own[0],
                      16);
}

static double log_value(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error)
{
    double lit, off;
    const double slope = lx_slope_at(at, towards, moved, &lit, &off);
    const double turned = moved + at->view_error + 2 * at->normal_error + 4 * DBL_EPSILON;
    const double made =
        lobe->own[0] + lobe->own[1] * slope + lobe->own[2] * missing(lit) * missing(fmax(at->n_dot_v, 0));
    if (!(made > 0))
        return -HUGE_VAL;
    *error = (lobe->own[1] * off + lobe->own[2] * missing_error(turned) + 16 * DBL_EPSILON) / made;
    return log(made);
}

const struct lx_lobe_kind lx_eon_lobe = {
    .most_diffuse = 1, /* multiple scattering adds up only where less is sent back than falls in */
    .words =
        {
            .definition = LX_ROUGH_SLOPE ", \\qquad q = \\frac{\\max(0, s)}{\\max(\\mathbf{N} \\cdot \\mathbf{L}, "
                                         "\\mathbf{N} \\cdot \\mathbf{V})} + "
                                         "\\min(0, s), \\qquad D = A_F (1 + r\\, q) + m\\, g(\\mathbf{N} \\cdot "
                                         "\\mathbf{L})\\, g(\\mathbf{N} \\cdot "
                                         "\\mathbf{V})",
            .constant =
                "A_F = \\frac{1}{1 + c\\, r}, \\qquad c = \\frac{1}{2} - \\frac{2}{3 \\pi}, \\qquad g(\\cos "
                "\\alpha) = c - \\frac{1}{\\pi} \\left( \\sin \\alpha\\, (\\alpha - \\sin \\alpha \\cos \\alpha) "
                "+ \\frac{2}{3} (\\tan \\alpha\\, (1 - \\sin^3 \\alpha) - \\sin \\alpha) \\right)",
            .step =
                "D = A_F (1 + r\\, q) + m\\, g(\\mathbf{N} \\cdot \\mathbf{L})\\, g(\\mathbf{N} \\cdot \\mathbf{V}) "
                "= ",
        },
    .prepare = prepare,
    .albedo = albedo,
    .value = value,
    .log_value = log_value,
    .kinks = lx_slope_kinks,
};
