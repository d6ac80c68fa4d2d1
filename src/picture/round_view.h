/* SPDX-License-Identifier: MIT */
/*
 * What of a round body a place sees, where that place is a complex one (docs/MATHS.md, "Squares of a picture").
 *
 * As p moves, so does what is seen.  A ball of the radius b about C is for p what a disk about C is that faces p and
 * has the radius b/sqrt(1 - b^2/d^2), d the distance of C; each of its places keeps its share of the radius and turns
 * with the line to C.  The side of a cylinder of the radius R is seen at the angles 2 atan(t T), |t| <= 1, from the
 * direction of p, T = sqrt((D - R)/(D + R)), D the distance of p from the axis; each of its places keeps t and its
 * height.  Both are analytic functions of p as long as p is outside, and their derivatives are bounded here.
 */
#ifndef LX_PICTURE_ROUND_VIEW_H
#define LX_PICTURE_ROUND_VIEW_H

#include "../kernel/kernel.h"

/* How the visible places of a ball, or of a cylinder's side, are seen from a vicinity. */
struct lx_round_view {
    double distance;     /* of the place in the middle from the centre, or from the axis */
    double most;         /* of the absolute value of that distance */
    double share;        /* of the square of the radius over that of the distance */
    double along, aside; /* how far visible places move at most: real ones for a unit of real ways; and, for one of
                            what is beyond those, both in their real and in their imaginary part */
};

/* False: some places of the vicinity may not be outside. */
bool lx_round_view_of(const struct lx_area_light *lamp, const struct lx_vicinity *at, struct lx_round_view *view);

/* The distance of a place from a cylinder's axis. */
double lx_distance_from_axis(const struct lx_area_light *cylinder, const double from_center[3]);

/* What is beyond the real ways of places: the length that `aside` is for. */
static inline double lx_beyond_real(const struct lx_deviation *place)
{
    return place->second + place->imaginary;
}

#endif
