/* SPDX-License-Identifier: MIT */
/*
 * The all-weather sky of R. Perez, R. Seals and J. Michalsky (All-weather model for sky luminance distribution, Solar
 * Energy 50, 1993, with the erratum in 51): the coefficients of the luminance by what the sun and the sky give.
 *
 *     clearness  = ((diffuse + direct) / diffuse + 1.041 Z^3) / (1 + 1.041 Z^3)
 *     brightness = diffuse m / extraterrestrial
 *
 * for the sun at the angle Z to the zenith and the air mass m of F. Kasten (1965).  From the clearness follows one of
 * eight lines of the table, and from the other two the coefficients.  In the lines of clearness from 1.065 to 2.8 a
 * brightness below 0.2 counts as 0.2.
 */
#ifndef LX_LIGHT_SKY_PEREZ_H
#define LX_LIGHT_SKY_PEREZ_H

#include <stdbool.h>

/* What is known of the weather: irradiances of a plane that faces the sun by the sun, of a horizontal one by the sky,
 * and of one that faces the sun outside of the atmosphere, all in one unit. */
struct lx_weather {
    double direct, diffuse, extraterrestrial;
    double altitude_deg;
};

struct lx_perez {
    double clearness, brightness;
    double diffuse[2];      /* from where to where the model has a sky, with this sun; the first may be the greater */
    double coefficients[5]; /* a to e: (1 + a exp(b / cos Z)) (1 + c exp(d chi) + e cos^2 chi) */
};

/* False: the model has no sky for this, but is asked beyond its data, or what it gives is not positive everywhere. */
bool lx_perez_find(const struct lx_weather *weather, struct lx_perez *perez);

#endif
