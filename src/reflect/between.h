/* SPDX-License-Identifier: MIT */
/* Residuals between the nodes of a window: at nine places, in its middle and beside its edges, and what they tell. */
#ifndef LX_REFLECT_BETWEEN_H
#define LX_REFLECT_BETWEEN_H

#include <math.h>

#include "rule.h"

enum { LX_BETWEEN = 9 };

/* Residuals may be larger between the places by this factor. */
static const double LX_BETWEEN_FACTOR = 2;

/* Errors of the rules of integration, as a share of what arrives: of cells that are cut to size, and of the areas of
 * round tiles. */
static const double LX_FLAT_RULE = 2e-8, LX_ROUND_RULE = 4e-7;

/* Place p in the window's coordinates, from -1 to 1. */
static inline void lx_between_place(int p, double at[2])
{
    const double beside = 0.97;
    at[0] = (p % 3 - 1) * beside;
    at[1] = (p / 3 - 1) * beside;
}

/* The mean without signs, by Simpson's rule. */
static inline double lx_between_mean(const double places[LX_BETWEEN])
{
    double mean = 0;
    for (int p = 0; p < LX_BETWEEN; p++)
        mean += (p % 3 == 1 ? 4 : 1) * (p / 3 == 1 ? 4 : 1) / 36.0 * fabs(places[p]);
    return mean;
}

static inline double lx_between_greatest(const double places[LX_BETWEEN])
{
    double greatest = 0;
    for (int p = 0; p < LX_BETWEEN; p++)
        greatest = fmax(greatest, fabs(places[p]));
    return greatest;
}

/* By how much they change along direction `way`, from the middle to the edges. */
static inline double lx_between_change(const double places[LX_BETWEEN], int way)
{
    const int step = way == 0 ? 1 : 3, other = 4 - step;
    double change = 0;
    for (int r = -1; r <= 1; r++)
        for (int sign = -1; sign <= 1; sign += 2)
            change = fmax(change, fabs(places[4 + r * other + sign * step] - places[4 + r * other]));
    return change;
}

/* Across which directions a window is to be cut, as lx_tiling_cut() has it. */
static inline unsigned char lx_between_cuts(const double residual[2])
{
    return residual[0] > 2 * residual[1] ? 1 : residual[1] > 2 * residual[0] ? 2 : 3;
}

/* Part i of a window that is cut so, into lx_window_parts() parts. */
static inline unsigned lx_window_parts(unsigned char cuts)
{
    return cuts == 3 ? 4 : 2;
}

static inline struct lx_window lx_window_part(const struct lx_window *window, unsigned char cuts, unsigned i)
{
    return cuts == 3 ? lx_window_quarter(window, (int)i) : lx_window_half(window, cuts - 1, (int)i);
}

#endif
