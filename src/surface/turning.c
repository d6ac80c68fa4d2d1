/* SPDX-License-Identifier: MIT */
/* Turning the axes by sines and cosines with bounds. */
#include "turning.h"

#include <math.h>

/* Sine and cosine of degrees, without error at multiples of 90. */
static void turn_by(double degrees, lx_bounded *sine, lx_bounded *cosine)
{
    const double turn = fmod(degrees, 360), quarters = round(turn / 90);
    const double rest = turn - 90 * quarters;
    const lx_bounded angle = rest == 0 ? lx_exact(0) : lx_rounded(rest * (M_PI / 180), 0, 4);
    const lx_bounded other = rest == 0 ? lx_exact(0) : lx_rounded((90 - fabs(rest)) * (M_PI / 180), 0, 4);
    const lx_bounded s = rest == 0 ? lx_exact(0) : lx_sin(angle), c = rest == 0 ? lx_exact(1) : lx_sin(other);
    switch (((int)quarters % 4 + 4) % 4) {
    case 0: *sine = s, *cosine = c; break;
    case 1: *sine = c, *cosine = lx_negate(s); break;
    case 2: *sine = lx_negate(s), *cosine = lx_negate(c); break;
    default: *sine = lx_negate(c), *cosine = s; break;
    }
}

/* Turns a vector about an axis. */
static lx_bounded3 turned(lx_bounded3 v, int axis, double degrees)
{
    lx_bounded sine, cosine, at[3] = {v.x, v.y, v.z};
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    turn_by(degrees, &sine, &cosine);
    const lx_bounded first = lx_sub(lx_mul(cosine, at[y]), lx_mul(sine, at[z]));
    at[z] = lx_add(lx_mul(sine, at[y]), lx_mul(cosine, at[z]));
    at[y] = first;
    return (lx_bounded3){at[0], at[1], at[2]};
}

lx_bounded3 lx_turned_axis(const double degrees[3], int axis)
{
    const double unit[3] = {axis == 0, axis == 1, axis == 2};
    lx_bounded3 made = lx_exact3(unit);
    for (int i = 0; i < 3; i++)
        made = turned(made, i, degrees[i]);
    return made;
}
