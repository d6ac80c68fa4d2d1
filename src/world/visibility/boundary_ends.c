/* SPDX-License-Identifier: MIT */
/* Whether pieces of a border are closed. */
#include <math.h>
#include <string.h>

#include "../../base/vector.h"
#include "boundary_ends.h"

/* Ends that are no farther apart than this meet. */
static const double GAP = 1e-9;

/* Borders are told apart to this angle, and integrals along them are known to it. */
static const double WIDTH = 2e-12;

/* The angle of a piece, or more, and how near to the element its curve comes. */
static double length_of(const struct lx_boundary_side *side, double from, double to, double *nearest_mm)
{
    double a[3], b[3], way[3], turned[3];
    *nearest_mm = side->nearest_mm;
    if (side->is_circle)
        return side->longest * (to - from);
    lx_boundary_place(side, from, a);
    lx_boundary_place(side, to, b);
    for (int k = 0; k < 3; k++)
        way[k] = b[k] - a[k];
    const double square = lx_dot(way, way), share = square > 0 ? fmin(fmax(-lx_dot(a, way) / square, 0), 1) : 0;
    lx_cross(a, b, turned);
    for (int k = 0; k < 3; k++)
        way[k] = a[k] + share * way[k];
    *nearest_mm = sqrt(lx_dot(way, way));
    return atan2(sqrt(lx_dot(turned, turned)), lx_dot(a, b));
}

/* Whether a side's curve runs clockwise about what is inside. */
static bool runs_back(const struct lx_boundary_side *side)
{
    double turned[3];
    lx_cross(side->from, side->to, turned);
    return !side->is_circle && lx_dot(turned, side->g) < 0;
}

void lx_boundary_ends_add(struct lx_boundary_ends *ends, const struct lx_boundary_side *side, double from, double to,
                          int sign, double error_mm)
{
    double nearest_mm;
    const double length = length_of(side, from, to, &nearest_mm);
    const unsigned last = runs_back(side) == (sign > 0) ? 0 : 1;
    ends->unsure += length * (WIDTH + 2 * error_mm / nearest_mm);
    if (ends->count > 0 && ends->side == side && ends->to == from) {
        double *end = ends->at[ends->count - 1][last];
        lx_boundary_place(side, to, end);
        lx_normalize(end);
    } else if (ends->count < LX_BOUNDARY_PIECES) {
        double(*piece)[3] = ends->at[ends->count++];
        lx_boundary_place(side, from, piece[1 - last]);
        lx_boundary_place(side, to, piece[last]);
        lx_normalize(piece[0]);
        lx_normalize(piece[1]);
    } else {
        ends->is_full = true;
    }
    ends->side = side;
    ends->to = to;
}

void lx_boundary_ends_overlook(struct lx_boundary_ends *ends, const struct lx_boundary_side *side, double to)
{
    double nearest_mm;
    ends->unsure += WIDTH * length_of(side, 0, to, &nearest_mm);
}

bool lx_boundary_ends_meet(struct lx_boundary_ends *ends)
{
    bool is_taken[LX_BOUNDARY_PIECES] = {false};
    for (unsigned i = 0; i < ends->count && !ends->is_full; i++) {
        double least = HUGE_VAL;
        unsigned next = 0;
        for (unsigned j = 0; j < ends->count; j++) {
            const double *end = ends->at[i][1], *start = ends->at[j][0];
            const double way[3] = {start[0] - end[0], start[1] - end[1], start[2] - end[2]};
            const double square = lx_dot(way, way);
            if (!is_taken[j] && square < least) {
                least = square;
                next = j;
            }
        }
        if (!(least <= GAP * GAP))
            return false;
        is_taken[next] = true;
        ends->unsure += sqrt(least);
    }
    return !ends->is_full;
}
