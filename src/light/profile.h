/* SPDX-License-Identifier: MIT */
/*
 * Angular profiles: how the intensity of a point source depends on the direction, as a factor g of its strength.  There
 * are three makers: a power of the cosine and a cone about an axis, or both together, and the tabulated distribution
 * of a luminaire (distribution.h).  Whoever wants to know something of a profile asks the functions here; only the
 * kernels' constants are made from what it holds.
 */
#ifndef LX_LIGHT_PROFILE_H
#define LX_LIGHT_PROFILE_H

#include <stdbool.h>
#include <stddef.h>

#include "../base/bounded.h"

/* How a cone falls from 1 at its inner to 0 at its outer angle; LX_NO_CONE: 1 everywhere. */
enum lx_falloff { LX_SMOOTHSTEP, LX_SQUARED, LX_LINEAR, LX_HARD, LX_NO_CONE };

struct lx_pointed;

/*
 * The angular profile g = f(theta) * max(0, cos theta)^exponent, with x^0 = 1, or that of a luminaire.  The cone's
 * angles stand as angles and as versines 1 - cos, whose differences keep their digits where cosines lose them.
 */
struct lx_profile {
    enum lx_falloff falloff;
    double exponent;
    lx_bounded3 axis; /* unit; of a luminaire its direction gamma = 0, or its beam */
    lx_bounded inner_rad, outer_rad, inner_versine, outer_versine;
    const struct lx_pointed *luminaire; /* instead of all of that but the axis; NULL: none.  It outlives the profile. */
};

/* The profile that is 1 everywhere. */
struct lx_profile lx_profile_isotropic(void);

/* max(0, cos theta)^exponent about an axis. */
struct lx_profile lx_profile_cosine(lx_bounded3 axis, double exponent);

/* A cone with its angles in degrees; equal angles make it hard. */
struct lx_profile lx_profile_cone(lx_bounded3 axis, enum lx_falloff falloff, double inner_deg, double outer_deg,
                                  double exponent);

/* The distribution of a luminaire. */
struct lx_profile lx_profile_luminaire(const struct lx_pointed *luminaire);

/* Whether it is 1 in all directions. */
static inline bool lx_profile_is_isotropic(const struct lx_profile *profile)
{
    return profile->falloff == LX_NO_CONE && profile->exponent == 0 && !profile->luminaire;
}

/* Whether two profiles differ in their axes at most, so that one formula with one set of constants does for both;
 * luminaires stand alone. */
bool lx_profile_is_alike(const struct lx_profile *a, const struct lx_profile *b);

/* g for the unit direction L from where it shines to the light. */
lx_bounded lx_profile_value(const struct lx_profile *profile, lx_bounded3 towards);

/* g along the axis. */
double lx_profile_on_axis(const struct lx_profile *profile);

/* The error of cos^exponent for an error of the angle, at most. */
double lx_power_slope(double exponent);

/*
 * What float32 adds to g, of 1, where directions are off by `off` and distances by the share `moved`.  In a penumbra
 * what the cone's measure t is a part of is exact (kernel_edge.h), t itself is off by the share that the distance is,
 * and some roundings; a width near the roundings of float64 is not for float32: infinite, as where g jumps unforeseen.
 */
double lx_profile_error_single(const struct lx_profile *profile, double off, double moved);

/*
 * Where a profile is not smooth: on a cone about an axis, in a half-plane that begins at an axis (`begin` is the
 * direction in it that is perpendicular to the axis), or in the plane perpendicular to the axis.
 */
enum lx_break_shape { LX_BREAK_CONE, LX_BREAK_HALF_PLANE, LX_BREAK_PLANE };
enum lx_break_order { LX_JUMP, LX_KINK, LX_BEND }; /* of the value, of its slope, of a higher derivative */

struct lx_break {
    enum lx_break_shape shape;
    enum lx_break_order order;
    double axis[3], begin[3];
    double angle_rad; /* of the cone, from the axis */
};

/* The i-th of them; false: there are no more. */
bool lx_profile_break(const struct lx_profile *profile, size_t i, struct lx_break *place);

#endif
