/* SPDX-License-Identifier: MIT */
/*
 * The luminance of the sky by direction, relative to that of the zenith: the fifteen types of CIE S 011/E:2003
 * (ISO 15469:2004), and as the sixteenth the traditional overcast sky of Moon and Spencer (1942), (1 + 2 cos Z)/3.
 *
 *     L/Lz = f(chi) phi(Z) / (f(Zs) phi(0)),   phi(Z) = 1 + a exp(b / cos Z),
 *     f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos^2 chi
 *
 * for the angle Z to the zenith, chi to the sun, and Zs of the sun to the zenith.  The all-weather sky of Perez
 * (perez.h) is LX_SKY_PEREZ: the same but for f(chi) = 1 + c exp(d chi) + e cos^2 chi.
 */
#ifndef LX_LIGHT_SKY_LUMINANCE_H
#define LX_LIGHT_SKY_LUMINANCE_H

#include "../../base/bounded.h"

enum { LX_SKY_UNIFORM = 5, LX_SKY_OVERCAST = 16, LX_SKY_KINDS = 16, LX_SKY_PEREZ };

struct lx_sky {
    unsigned kind;
    double a, b, c, d, e;
    double up[3], sun[3]; /* unit; the sun only where it matters */
    double scale;         /* 1 / (f(Zs) phi(0)) */
};

/* Whether it is brighter around the sun. */
bool lx_sky_has_sun(unsigned kind);

/* `sun` is above the horizon, or anything where it does not matter. */
struct lx_sky lx_sky_of_kind(unsigned kind, const double up[3], const double sun[3]);

/* By a, b, c, d, e of Perez's. */
struct lx_sky lx_sky_of_perez(const double coefficients[5], const double up[3], const double sun[3]);

/* In a unit direction, that of the horizon below it; good to LX_SKY_ROUNDING of its value. */
double lx_sky_luminance(const struct lx_sky *sky, const double towards[3]);
#define LX_SKY_ROUNDING (64 * DBL_EPSILON)

/* No direction has more. */
double lx_sky_greatest(const struct lx_sky *sky);

/* The irradiance of a horizontal plane. */
lx_bounded lx_sky_horizontal(const struct lx_sky *sky);

#endif
