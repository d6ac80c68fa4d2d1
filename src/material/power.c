/* SPDX-License-Identifier: MIT */
/* Powers S^n of the cosine between two vectors. */
#include <math.h>

#include "power.h"

lx_bounded lx_power_value(const struct lx_lobe *lobe, lx_bounded3 normal, lx_bounded3 view, lx_bounded3 towards)
{
    lx_bounded3 pair[2];
    lx_lobe_kind_of(lobe)->power->pair(normal, view, towards, pair);
    return lx_cosine_power(lx_dot3(pair[0], pair[1]), lx_square3(lx_cross3(pair[0], pair[1])), lobe->exponent);
}

double lx_power_log(double exponent, double cosine, double sine_squared, double off, double *error)
{
    if (!(cosine > 0))
        return -HUGE_VAL;
    *error = exponent * off * fmin(sqrt(sine_squared) / cosine, 1 / off);
    return exponent * (sine_squared < 0.5 ? log1p(-sine_squared) / 2 : log(cosine));
}

static double square(double a)
{
    return a * a;
}

double lx_cross_square(const double a[3], const double b[3])
{
    return square(a[1] * b[2] - a[2] * b[1]) + square(a[2] * b[0] - a[0] * b[2]) + square(a[0] * b[1] - a[1] * b[0]);
}
