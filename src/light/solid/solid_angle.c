/* SPDX-License-Identifier: MIT */
/*
 * Integrals of profiles.  Those of luminaires come with them.  Without a cone they are 4 pi, and 2 pi/(m + 1) with an
 * exponent m > 0.
 *
 * With the profile cos^m within a hard cone of the half-angle b that integral is 2 pi F(b),
 *
 *     F(b) = (1 - cos(b)^(m+1))/(m+1).
 *
 * A soft edge is a mixture of hard cones: where f falls from 1 at the inner to 0 at the outer angle the integral is
 * 2 pi times that of -f'(b) F(b) over b between them, in which nothing cancels.  Gauss's rule takes it (gauss.h), on
 * panels that keep their distance from the singularity at 90 degrees and within which cos^m does not grow too much.
 */
#include "solid_angle.h"

#include <math.h>

#include "../distribution.h"
#include "../gauss.h"

/* Parts of an integral that matter no more. */
static const double NEGLIGIBLE = 1e-17;

/* The versine 1 - cos of the half-angle at the share s of the way from the inner to the outer angle. */
static double edge_versine(const struct lx_profile *profile, double s)
{
    double inner = profile->inner_versine.value;
    double versine = inner + s * (profile->outer_versine.value - inner);
    if (profile->falloff == LX_LINEAR) {
        double sine = sin((profile->inner_rad.value + s * (profile->outer_rad.value - profile->inner_rad.value)) / 2);
        versine = 2 * sine * sine;
    }
    return fmin(versine, 1);
}

/* -df/ds: with t = 1 - s f is t^2 (3 - 2t), t^2 or t */
static double edge_slope(enum lx_falloff falloff, double s)
{
    switch (falloff) {
    case LX_SMOOTHSTEP: return 6 * s * (1 - s);
    case LX_SQUARED: return 2 * (1 - s);
    default: return 1;
    }
}

/* F by the versine, to the last digits for small cones and large exponents. */
static double hard_cone(double versine, double exponent)
{
    return -expm1((exponent + 1) * log1p(-versine)) / (exponent + 1);
}

/* How much of the edge Gauss's rule may take at once from s on. */
static double panel_length(const struct lx_profile *profile, double s)
{
    double versine = edge_versine(profile, s), cosine = 1 - versine, power = profile->exponent + 1;
    if (exp((power + 1) * log1p(-versine)) < NEGLIGIBLE) /* F changes no more */
        return 1 - s;
    if (profile->falloff == LX_LINEAR) {
        double sine = sqrt(versine * (2 - versine)), width = profile->outer_rad.value - profile->inner_rad.value;
        return fmin(cosine / (2 + sqrt(power) / 2 + power * sine / 4) / width, 1 - s);
    }
    double width = profile->outer_versine.value - profile->inner_versine.value;
    return fmin(cosine / (2 + power / 4) / width, 1 - s);
}

/* The integral of -f' F over the edge. */
static double soft_cone(const struct lx_profile *profile)
{
    double sum = 0;
    for (double s = 0, length; s < 1; s += length) {
        length = panel_length(profile, s);
        for (int i = 0; i < LX_GAUSS_NODES; i++) {
            double at = s + length / 2 * (1 + lx_gauss[i].place);
            sum += length / 2 * lx_gauss[i].weight * edge_slope(profile->falloff, at) *
                   hard_cone(edge_versine(profile, at), profile->exponent);
        }
    }
    return sum;
}

double lx_profile_solid_angle(const struct lx_profile *profile)
{
    if (profile->luminaire)
        return profile->luminaire->distribution->solid_angle;
    switch (profile->falloff) {
    case LX_NO_CONE: return profile->exponent == 0 ? 4 * M_PI : 2 * M_PI / (profile->exponent + 1); /* 0^0 = 1 */
    case LX_HARD: return 2 * M_PI * hard_cone(edge_versine(profile, 1), profile->exponent);
    default: return 2 * M_PI * soft_cone(profile);
    }
}
