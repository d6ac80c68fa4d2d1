/* SPDX-License-Identifier: MIT */
/* Jets of powers of cosines and of cones, and their products. */
#include "jet.h"

#include <math.h>

#include "../../base/larger.h"
#include "../lights.h"

static double sine_of(double cosine)
{
    return sqrt(lx_larger(1 - cosine * cosine, 0));
}

struct lx_jet lx_jet_of_constant(double value)
{
    return (struct lx_jet){.least = value, .most = value, .size = value};
}

struct lx_jet lx_jet_times(const struct lx_jet *a, const struct lx_jet *b)
{
    enum lx_jet_order order = a->order > b->order ? a->order : b->order;
    bool both = a->order != LX_SMOOTH && b->order != LX_SMOOTH;
    return (struct lx_jet){
        .order = both && order == LX_FOLDED ? LX_STEEP : order,
        .least = a->least * b->least,
        .most = a->most * b->most,
        .size = a->size * b->size,
        .slope = a->slope * b->size + a->size * b->slope,
        .bend = a->bend * b->size + 2 * a->slope * b->slope + a->size * b->bend,
    };
}

struct lx_power lx_power_of(double exponent)
{
    const double n = exponent;
    struct lx_power power = {.exponent = n, .whole = lx_exponent_of(n).whole};
    if (n < 2)
        return power;
    /* The slope n cos^(n-1) sin is largest at cos^2 = (n-1)/n.  Of the second derivatives one is n cos^n; the other,
     * n cos^(n-2) (n sin^2 - 1), is largest at sin^2 = (3n-2)/n^2. */
    const double sine2 = lx_smaller((3 * n - 2) / (n * n), 1);
    power.slope_cosine = sqrt((n - 1) / n);
    power.slope = sqrt(n) * pow((n - 1) / n, (n - 1) / 2);
    power.bend_cosine = sqrt(1 - sine2);
    power.bend = n * pow(1 - sine2, (n - 2) / 2) * (2 - 2 / n);
    return power;
}

static double raise(const struct lx_power *power, double cosine)
{
    double result = 1;
    if (power->whole == 0)
        return power->exponent > 0 ? pow(cosine, power->exponent) : 1;
    for (unsigned bits = power->whole; bits > 0; bits >>= 1) {
        if (bits & 1)
            result *= cosine;
        cosine *= cosine;
    }
    return result;
}

/* max(0, cos) */
static struct lx_jet jet_of_cosine(struct lx_cosines cosines)
{
    const bool is_folded = cosines.least < 0;
    const double size = lx_larger(cosines.most, -cosines.least);
    return (struct lx_jet){
        .order = is_folded ? LX_FOLDED : LX_SMOOTH,
        .least = lx_larger(cosines.least, 0),
        .most = cosines.most,
        .size = size,
        .slope = is_folded ? 1 : sine_of(cosines.least),
        .bend = size,
    };
}

struct lx_jet lx_jet_of_power(const struct lx_power *power, struct lx_cosines cosines)
{
    const double n = power->exponent;
    if (!(cosines.most > 0))
        return lx_jet_of_constant(0);
    if (n == 1)
        return jet_of_cosine(cosines);
    const double most = raise(power, cosines.most), cosine = cosines.most, sine = sine_of(cosine);
    struct lx_jet jet = {.most = most, .size = most, .least = cosines.least > 0 ? raise(power, cosines.least) : 0};
    if (n >= 2) {
        jet.slope = cosine < power->slope_cosine ? n * most / cosine * sine : power->slope;
        double other = cosine < power->bend_cosine ? n * most / (cosine * cosine) * (n * sine * sine - 1) : power->bend;
        jet.bend = lx_larger(n * most, other);
    } else if (cosines.least > 0) {
        jet.slope = n * lx_larger(jet.least / cosines.least, 1);
        jet.bend = n * pow(cosines.least, n - 2);
    } else {
        jet.order = n > 1 ? LX_STEEP : LX_ROUGH;
        jet.slope = n;
    }
    return jet;
}

/* The part of a cone's width, from 0 at its outer to 1 at its inner edge, at a versine. */
static double part_of(const struct lx_profile *profile, double versine)
{
    double part;
    if (profile->falloff == LX_LINEAR) {
        double angle = 2 * asin(sqrt(lx_smaller(lx_larger(versine / 2, 0), 1)));
        part = (profile->outer_rad.value - angle) / (profile->outer_rad.value - profile->inner_rad.value);
    } else {
        double outer = profile->outer_versine.value;
        part = (outer - versine) / (outer - profile->inner_versine.value);
    }
    return lx_smaller(lx_larger(part, 0), 1);
}

static double fall(const struct lx_profile *profile, double versine)
{
    if (profile->falloff == LX_HARD)
        return versine <= profile->outer_versine.value ? 1 : 0;
    double t = part_of(profile, versine);
    return profile->falloff == LX_SMOOTHSTEP ? t * t * (3 - 2 * t) : profile->falloff == LX_SQUARED ? t * t : t;
}

struct lx_jet lx_jet_of_cone(const struct lx_profile *profile, struct lx_cosines cosines)
{
    const double room = 1e-9; /* of versines, for rounding */
    const double near = 1 - cosines.most - room, far = 1 - cosines.least + room;
    const double inner = profile->inner_versine.value, outer = profile->outer_versine.value;
    if (profile->falloff == LX_NO_CONE || far <= (profile->falloff == LX_HARD ? outer : inner))
        return lx_jet_of_constant(1);
    if (near >= outer)
        return lx_jet_of_constant(0);
    const double most = fall(profile, near);
    struct lx_jet jet = {.least = fall(profile, far), .most = most, .size = most};
    const double width = outer - inner, sine = sine_of(1 - lx_smaller(far, outer));
    switch (profile->falloff) {
    case LX_SMOOTHSTEP: /* by the versine v, whose gradient is the sine and whose second derivatives are the cosine */
        jet.slope = 1.5 / width * sine;
        jet.bend = 6 / (width * width) * sine * sine + 1.5 / width;
        break;
    case LX_SQUARED: /* a fold at the inner edge */
        jet.order = near < inner ? LX_STEEP : LX_SMOOTH;
        jet.slope = 2 / width * sine;
        jet.bend = 2 / (width * width) * sine * sine + 2 / width;
        break;
    case LX_LINEAR:
        jet.order = LX_STEEP;
        jet.slope = 1 / (profile->outer_rad.value - profile->inner_rad.value);
        break;
    default: jet.order = LX_ROUGH; break;
    }
    return jet;
}
