/* SPDX-License-Identifier: MIT */
/*
 * Bounds of extended sources as analytic functions of the place on the screen, as kernel_smooth.h has them of points
 * (docs/MATHS.md, "Squares of a picture").
 *
 * The irradiance by a face in front of which the element is, all of it above the horizon, is an integral over places s
 * on it of (N.w)(-a.w)/(w.w)^2, w = s - p, a the face's normal: analytic as long as no w.w becomes 0, and no larger
 * than |N| |w|^2/|w.w|^2 times the area; by a ball of radius b about C it is pi b^2 N.w/(w.w)^(3/2), w = C - p.  The
 * side of a cylinder, whose places move with p (round_view.h), is R times its height times the integral over t from -1
 * to 1 of (N.w) 2 D (1 - q)^(3/2) (1 - t^2)/((1 + t^2 + (1 - t^2) R/D)^2 (w.w)^2), q = R^2/D^2, which over t alone
 * comes to no more than twice D |1 - q|^(3/2).
 */
#ifndef LX_PICTURE_AREA_LIGHT_BOUND_H
#define LX_PICTURE_AREA_LIGHT_BOUND_H

#include "../kernel/kernel.h"

/* The largest |a| of a law where r and r^2 have these real parts at least, which are above 0: no coefficient is below
 * it. */
static inline double lx_law_at(const struct lx_area_light_law *law, double r, double square)
{
    return 1 / (law->none + law->root * r + law->square * square);
}

/* What r^2 a(r) comes to at most over a ball as a vicinity sees it, as an analytic function; 1/square by the law 1/r^2;
 * infinite where that is not certain. */
double lx_most_of_ball(const struct lx_area_light *lamp, const struct lx_vicinity *at);

/* A bound of the brightness by a source in the vicinity, `gain` being diffuse times radiance times the area that shines
 * (of a ball, of its section; of a cylinder, of the section along its axis and one end); 0 where it does not light the
 * square; infinite where it may not be analytic. */
double lx_smooth_area_light_bound(const struct lx_area_light *lamp, double gain, const struct lx_vicinity *at);

#endif
