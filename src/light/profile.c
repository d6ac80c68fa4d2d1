/* SPDX-License-Identifier: MIT */
/* Angular profiles: their values, their errors in float32, and where they break. */
#include "profile.h"

#include <float.h>
#include <math.h>

#include "distribution.h"

/* ---- makers ---- */

struct lx_profile lx_profile_isotropic(void)
{
    return (struct lx_profile){.falloff = LX_NO_CONE};
}

struct lx_profile lx_profile_cosine(lx_bounded3 axis, double exponent)
{
    return (struct lx_profile){.falloff = LX_NO_CONE, .axis = axis, .exponent = exponent};
}

static lx_bounded radians(double degrees)
{
    return lx_mul(lx_exact(degrees), lx_rounded(M_PI / 180, 0, 3));
}

/* 1 - cos = 2 sin^2 of the half angle */
static lx_bounded versine(lx_bounded angle)
{
    lx_bounded sine = lx_sin(lx_scale(angle, 0.5));
    return lx_scale(lx_mul(sine, sine), 2);
}

struct lx_profile lx_profile_cone(lx_bounded3 axis, enum lx_falloff falloff, double inner_deg, double outer_deg,
                                  double exponent)
{
    lx_bounded inner = radians(inner_deg), outer = radians(outer_deg);
    return (struct lx_profile){
        .falloff = inner_deg == outer_deg ? LX_HARD : falloff,
        .exponent = exponent,
        .axis = axis,
        .inner_rad = inner,
        .outer_rad = outer,
        .inner_versine = versine(inner),
        .outer_versine = versine(outer),
    };
}

struct lx_profile lx_profile_luminaire(const struct lx_pointed *luminaire)
{
    return (struct lx_profile){.falloff = LX_NO_CONE, .axis = luminaire->axis, .luminaire = luminaire};
}

bool lx_profile_is_alike(const struct lx_profile *a, const struct lx_profile *b)
{
    return !a->luminaire && !b->luminaire && a->falloff == b->falloff && a->exponent == b->exponent &&
           (a->falloff == LX_NO_CONE ||
            (a->inner_rad.value == b->inner_rad.value && a->outer_rad.value == b->outer_rad.value));
}

/* ---- values ---- */

static lx_bounded clamp01(lx_bounded a)
{
    if (a.value >= 1)
        return (lx_bounded){1, fmax(a.error - (a.value - 1), 0)};
    return lx_positive(a);
}

static lx_bounded cone(const struct lx_profile *profile, lx_bounded cosine, lx_bounded sine_squared)
{
    lx_bounded one = lx_exact(1);
    lx_bounded versine = cosine.value > 0 ? lx_div(sine_squared, lx_add(one, cosine)) : lx_sub(one, cosine);
    lx_bounded inside = lx_sub(profile->outer_versine, versine);
    lx_bounded t;
    switch (profile->falloff) {
    case LX_HARD: return lx_step(inside, true);
    case LX_LINEAR:
        t = lx_div(lx_sub(profile->outer_rad, lx_angle(lx_sqrt(sine_squared), cosine)),
                   lx_sub(profile->outer_rad, profile->inner_rad));
        return clamp01(t);
    case LX_SMOOTHSTEP:
        t = clamp01(lx_div(inside, lx_sub(profile->outer_versine, profile->inner_versine)));
        return lx_mul(lx_mul(t, t), lx_sub(lx_exact(3), lx_scale(t, 2)));
    case LX_SQUARED:
        t = clamp01(lx_div(inside, lx_sub(profile->outer_versine, profile->inner_versine)));
        return lx_mul(t, t);
    case LX_NO_CONE: break;
    }
    return one;
}

lx_bounded lx_profile_value(const struct lx_profile *profile, lx_bounded3 towards)
{
    if (profile->luminaire)
        return lx_pointed_value(profile->luminaire, towards);
    if (lx_profile_is_isotropic(profile))
        return lx_exact(1);
    lx_bounded cosine = lx_negate(lx_dot3(profile->axis, towards));
    lx_bounded sine_squared = lx_square3(lx_cross3(profile->axis, towards));
    lx_bounded power = lx_cosine_power(cosine, sine_squared, profile->exponent);
    return lx_mul(cone(profile, cosine, sine_squared), power);
}

double lx_profile_on_axis(const struct lx_profile *profile)
{
    return profile->luminaire ? lx_profile_value(profile, lx_negate3(profile->axis)).value : 1;
}

/* ---- float32 ---- */

double lx_power_slope(double exponent)
{
    if (exponent == 0)
        return 0;
    return exponent < 1 ? HUGE_VAL : fmax(1, 0.61 * sqrt(exponent));
}

double lx_profile_error_single(const struct lx_profile *profile, double off, double moved)
{
    static const double unit = 0x1p-24;
    if (profile->luminaire) /* angles of up to 2 pi are rounded, shares of a step and values are */
        return profile->luminaire->distribution->slope * (off + 12 * unit) + 4 * unit;
    const double width = profile->outer_versine.value - profile->inner_versine.value;
    const double cone = 1.5 * moved + 3 * unit + 4 * DBL_EPSILON / width;
    const double error = lx_power_slope(profile->exponent) * off;
    switch (profile->falloff) {
    case LX_NO_CONE: return error;
    case LX_HARD: return error + 4 * DBL_EPSILON / profile->outer_versine.value;
    case LX_LINEAR:
    case LX_SMOOTHSTEP: return error + cone; /* t dg/dt is at most 1 */
    case LX_SQUARED: break;
    }
    return error + 2 * cone;
}

/* ---- where it breaks ---- */

/* A cone, linear in the angle or not, has an edge at its outer and one at its inner angle, and a cosine one at 90
 * degrees. */
bool lx_profile_break(const struct lx_profile *profile, size_t i, struct lx_break *place)
{
    if (profile->luminaire)
        return lx_pointed_break(profile->luminaire, i, place);
    const bool has_pattern = profile->exponent > 0;
    const size_t cones = profile->falloff == LX_NO_CONE ? 0 : profile->falloff == LX_HARD ? 1 : 2;
    *place = (struct lx_break){.axis = {profile->axis.x.value, profile->axis.y.value, profile->axis.z.value}};
    if (has_pattern && i == 0) {
        place->shape = LX_BREAK_PLANE;
        place->order = profile->exponent < 2 ? LX_KINK : LX_BEND;
        return true;
    }
    i -= has_pattern;
    if (i >= cones)
        return false;
    place->shape = LX_BREAK_CONE;
    place->angle_rad = i == 0 ? profile->outer_rad.value : profile->inner_rad.value;
    const bool is_kink = profile->falloff == LX_LINEAR || (profile->falloff == LX_SQUARED && i == 1);
    place->order = profile->falloff == LX_HARD ? LX_JUMP : is_kink ? LX_KINK : LX_BEND;
    return true;
}
