/* SPDX-License-Identifier: MIT */
/* Residuals between the nodes of a window: at nine places, in its middle and beside its edges, and what they tell. */
#ifndef LX_REFLECT_BETWEEN_H
#define LX_REFLECT_BETWEEN_H

#include <math.h>
#include <stdbool.h>

#include "rule.h"

enum { LX_BETWEEN = 9 };

/* Residuals may be larger between the places by this factor. */
static const double LX_BETWEEN_FACTOR = 2;

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

/* By how much they change from the middle to the edges: along s and t, towards the low and the high one. */
static inline void lx_between_changes(const double places[LX_BETWEEN], double changes[2][2])
{
    for (int way = 0; way < 2; way++)
        for (int side = 0; side < 2; side++) {
            const int step = (way == 0 ? 1 : 3) * (side ? 1 : -1), other = way == 0 ? 3 : 1;
            for (int r = -1; r <= 1; r++) {
                const double change = places[4 + r * other + step] - places[4 + r * other];
                changes[way][side] = fmax(changes[way][side], fabs(change));
            }
        }
}

static inline double lx_between_change(const double changes[2][2])
{
    return fmax(changes[0][0], changes[0][1]) + fmax(changes[1][0], changes[1][1]);
}

/* Where a window is to be cut: in two along s, along t, or in four. */
struct lx_cuts {
    bool is_cut[2];
    double at[2]; /* from -1 to 1 */
};

/* Across the direction in which the residual changes more, or both; where it changes beside one edge, near to that. */
static inline struct lx_cuts lx_between_cuts(const double changes[2][2])
{
    const double much = 6, near = 0.6;
    struct lx_cuts cuts = {0};
    double greatest[2];
    for (int way = 0; way < 2; way++) {
        const double low = changes[way][0], high = changes[way][1];
        greatest[way] = fmax(low, high);
        cuts.at[way] = low > much * high ? -near : high > much * low ? near : 0;
    }
    for (int way = 0; way < 2; way++)
        cuts.is_cut[way] = greatest[way] * 2 >= greatest[1 - way];
    return cuts;
}

/* Part i of a window that is cut so, into lx_window_parts() parts. */
static inline unsigned lx_window_parts(const struct lx_cuts *cuts)
{
    return cuts->is_cut[0] && cuts->is_cut[1] ? 4 : 2;
}

static inline struct lx_window lx_window_part(const struct lx_window *window, const struct lx_cuts *cuts, unsigned i)
{
    struct lx_window part = *window;
    for (int way = 0; way < 2; way++) {
        const bool is_high = (cuts->is_cut[0] && way == 1 ? i >> 1 : i) & 1;
        if (!cuts->is_cut[way])
            continue;
        const double low = is_high ? cuts->at[way] : -1, high = is_high ? 1 : cuts->at[way];
        part.middle[way] = window->middle[way] + window->half[way] * (low + high) / 2;
        part.half[way] = window->half[way] * (high - low) / 2;
    }
    return part;
}

#endif
