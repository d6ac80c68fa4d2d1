/* SPDX-License-Identifier: MIT */
/* The position index, by the fit to Guth's measurements that lighting handbooks print. */
#include "glare.h"

#include <math.h>

/* Where the field of view ends: above / ahead and aside / ahead. */
static const double MOST_ABOVE = 1.9, MOST_ASIDE = 3;

double lx_position_index(double ahead, double aside, double above)
{
    const double degrees = 57.29577951308232;
    aside = fabs(aside);
    if (!(ahead > 0) || above < 0 || above > MOST_ABOVE * ahead || aside > MOST_ASIDE * ahead)
        return (double)NAN;
    double across = hypot(aside, above);
    double off = atan2(across, ahead) * degrees;                  /* from the line of sight */
    double tilt = across > 0 ? atan2(aside, above) * degrees : 0; /* from the vertical through it */
    double slope = 35.2 - 0.31889 * tilt - 1.22 * exp(-2 * tilt / 9);
    double bend = 21 + 0.26667 * tilt - 0.002963 * tilt * tilt;
    return exp(1e-3 * slope * off + 1e-5 * bend * off * off);
}
