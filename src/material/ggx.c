/* SPDX-License-Identifier: MIT */
/*
 * GGX, facets by T. Trowbridge and K. Reitz (1975) and B. Walter et al. (2007): f = pi D G2 F/(4 N.L N.V) with the
 * weight N.L.  D = a^2/(pi (a^2 (N.H)^2 + |N x H|^2)^2), G2 is height-correlated (E. Heitz, 2014), so that
 *
 *     G2/(4 N.L N.V) = 1/(2 (N.L sqrt(a^2 + (1 - a^2) (N.V)^2) + N.V sqrt(a^2 + (1 - a^2) (N.L)^2))),
 *
 * and F = F0 + (1 - F0) (1 - V.H)^5 (C. Schlick, 1994).  There is none where N.V <= 0.
 */
#include <math.h>

#include "../base/vector.h"
#include "material.h"
#include "power.h"

/* An error is no greater than this, so that what is multiplied by 0 stays 0. */
static const double LARGEST = 1e100;

/* own[0]: a^2, own[1]: F0, own[2]: a */
static void prepare(const struct lx_material *material, struct lx_lobe *lobe)
{
    lobe->highlight = LX_HIGHLIGHT_COSINE;
    lobe->own[0] = material->alpha * material->alpha;
    lobe->own[1] = material->f0;
    lobe->own[2] = material->alpha;
}

/* The root of a^2 + (1 - a^2) cosine^2. */
static lx_bounded masked(const struct lx_lobe *lobe, lx_bounded cosine)
{
    const lx_bounded square = lx_rounded(lobe->own[0], 0, 1), rest = lx_sub(lx_exact(1), square);
    return lx_sqrt(lx_add(square, lx_mul(rest, lx_mul(cosine, cosine))));
}

static lx_bounded value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    const lx_bounded lit = lx_positive(lx_dot3(normal, towards)), n_dot_v = lx_dot3(normal, view);
    const lx_bounded seen = lx_positive(n_dot_v), square = lx_rounded(lobe->own[0], 0, 1);
    if (n_dot_v.value + n_dot_v.error <= 0)
        return lx_exact(0);
    const lx_bounded3 half = lx_unit3(lx_add3(towards, view));
    const lx_bounded cosine = lx_dot3(normal, half);
    const lx_bounded spread = lx_add(lx_mul(square, lx_mul(cosine, cosine)), lx_square3(lx_cross3(normal, half)));
    const lx_bounded f0 = lx_exact(lobe->own[1]);
    const lx_bounded versine = lx_positive(lx_sub(lx_exact(1), lx_dot3(view, half)));
    const lx_bounded fresnel = lx_add(f0, lx_mul(lx_sub(lx_exact(1), f0), lx_power(versine, 5)));
    const lx_bounded shadowed = lx_scale(lx_add(lx_mul(lit, masked(lobe, seen)), lx_mul(seen, masked(lobe, lit))), 2);
    const lx_bounded made = lx_div(lx_mul(square, fresnel), lx_mul(lx_mul(spread, spread), shadowed));
    if (!(made.value >= 0 && made.error < LARGEST)) /* L = -V, or both along the surface */
        return (lx_bounded){0, LARGEST};
    return made;
}

static double root(const struct lx_lobe *lobe, double cosine)
{
    return sqrt(lobe->own[0] + (1 - lobe->own[0]) * cosine * cosine);
}

/* As the value; where directions are off by an angle, D turns with the half vector. */
static double log_value(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double towards[3], double moved,
                        double *error)
{
    double half[3];
    for (int i = 0; i < 3; i++)
        half[i] = towards[i] + at->view[i];
    const double length_square = lx_dot(half, half), length = sqrt(length_square), square = lobe->own[0];
    const double lit = fmax(lx_dot(at->normal, towards), 0), seen = fmax(at->n_dot_v, 0);
    const double cosine = lx_dot(at->normal, half) / length;
    const double sine_square = lx_cross_square(at->normal, half) / length_square;
    const double spread = square * cosine * cosine + sine_square;
    const double versine = fmax(1 - length / 2, 0), fresnel = lobe->own[1] + (1 - lobe->own[1]) * pow(versine, 5);
    const double seen_root = root(lobe, seen), lit_root = root(lobe, lit);
    const double shadowed = 2 * (lit * seen_root + seen * lit_root);
    if (!(seen > 0 && fresnel > 0 && spread > 0 && shadowed > 0))
        return -HUGE_VAL;
    moved += at->view_error + 2 * DBL_EPSILON;
    const double off = at->normal_error + moved * (2 / length), turned = moved + at->normal_error;
    *error = 2 * (2 * sqrt(sine_square) * off + off * off) / spread + 4 * turned * (seen_root + lit_root) / shadowed +
             5 * moved * pow(versine, 4) / fresnel + 64 * DBL_EPSILON;
    return log(square * fresnel / (spread * spread * shadowed));
}

static size_t peaks(const struct lx_lobe *lobe, const struct lx_lobe_at *at, const double a[3], const double b[3],
                    double tau[LX_MOST_PEAKS])
{
    static const double SHARP = 0.5;
    return lx_half_peaks(lobe->own[2] < SHARP, at, a, b, tau);
}

const struct lx_lobe_kind lx_ggx_lobe = {
    .words =
        {
            .definition = "\\mathbf{H} = \\frac{\\mathbf{L} + \\mathbf{V}}{|\\mathbf{L} + \\mathbf{V}|}, \\qquad D = "
                          "\\frac{\\alpha^2}{\\pi \\left( 1 - (1 - \\alpha^2) (\\mathbf{N} \\cdot \\mathbf{H})^2 "
                          "\\right)^2}, \\qquad F = F_0 + (1 - F_0) (1 - \\mathbf{V} \\cdot \\mathbf{H})^5",
            .brightness =
                "\\left( k_d \\max(0, \\mathbf{N} \\cdot \\mathbf{L}) + k_s\\, \\pi\\, \\frac{D\\, G_2\\, F}{4 "
                "(\\mathbf{N} \\cdot \\mathbf{L}) (\\mathbf{N} \\cdot \\mathbf{V})} \\max(0, \\mathbf{N} "
                "\\cdot \\mathbf{L}) \\right)",
            .constant =
                "G_2 = \\frac{2 (\\mathbf{N} \\cdot \\mathbf{L}) (\\mathbf{N} \\cdot \\mathbf{V})}{(\\mathbf{N} "
                "\\cdot \\mathbf{L})\\, g(\\mathbf{N} \\cdot \\mathbf{V}) + (\\mathbf{N} \\cdot \\mathbf{V})\\, "
                "g(\\mathbf{N} \\cdot \\mathbf{L})}, \\qquad g(x)^2 = \\alpha^2 + (1 - \\alpha^2)\\, x^2",
            .step =
                "B_s = E_{\\perp}\\, p\\, k_s \\max(0, \\mathbf{N} \\cdot \\mathbf{L})\\, \\pi\\, \\frac{D\\, G_2\\, "
                "F}{4 (\\mathbf{N} \\cdot \\mathbf{L}) (\\mathbf{N} \\cdot \\mathbf{V})} = ",
        },
    .is_lambertian = true,
    .prepare = prepare,
    .value = value,
    .log_value = log_value,
    .peaks = peaks,
};
