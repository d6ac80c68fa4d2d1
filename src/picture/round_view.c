/* SPDX-License-Identifier: MIT */
/*
 * Derivatives of the visible places of round bodies.
 *
 * With w the way from p to the centre, or its part across the axis, w.w has no less a real part than least^2, and u =
 * w/sqrt(w.w) is no longer than sqrt((1 + k^2)/(1 - k^2)) where the imaginary part of w is no more than k times the
 * real one.  u changes by (I - u u^T) dw/sqrt(w.w), and I - u u^T, a projection, is no larger than u u^T, |u|^2.
 */
#include "round_view.h"

#include <math.h>

#include "../base/larger.h"
#include "../base/vector.h"

double lx_distance_from_axis(const struct lx_area_light *cylinder, const double from_center[3])
{
    const double along = lx_dot(cylinder->axis, from_center);
    return sqrt(lx_larger(lx_dot(from_center, from_center) - along * along, 0));
}

/*
 * The place C + s rho E, s from 0 to 1, rho = b/sqrt(1 - q) with q = b^2/w.w.  E is across u and turns with it:
 * E = E0 - (u.E0)(u + u0)/(1 + u.u0).  By real ways E moves no farther than u; else, with v = u - u0, by no more than
 * (1 + |v|/(2 - |v|))^2 as far.
 */
static bool move_with_ball(double radius, double least, double u_square, const struct lx_deviation *place,
                           struct lx_round_view *view)
{
    const double q = view->share, rho = radius / sqrt(1 - q), longer = radius * q / ((1 - q) * sqrt(1 - q));
    const double turned = u_square * (place->first + lx_beyond_real(place)) / least;
    const double turns = (1 + turned / (2 - turned)) * (1 + turned / (2 - turned)) * u_square;
    view->along = (rho + longer) / least;
    view->aside = (rho * turns + longer * sqrt(u_square) * (1 + turns * lx_beyond_real(place) / least)) / least;
    return turned < 1;
}

/*
 * The place R (cos(f) u + sin(f) v), v across u and the axis, f = 2 atan(t T): |df| <= |dr|/sqrt(1 - q), where r = R/D,
 * as |(1 + t^2) + r (1 - t^2)| is no less than 1 + t^2.  A rotation by the complex angle f is no larger than
 * exp|Im f|.
 */
static void move_with_side(double radius, double least, double u_square, const struct lx_deviation *place,
                           struct lx_round_view *view)
{
    const double turns = sqrt(view->share / (1 - view->share)), beyond = lx_beyond_real(place);
    view->along = radius / least * (1 + turns);
    view->aside = radius / least * exp(turns * sqrt(u_square) * beyond / least) * u_square * (1 + turns);
}

bool lx_round_view_of(const struct lx_area_light *lamp, const struct lx_vicinity *at, struct lx_round_view *view)
{
    const double densest = 0.8; /* the share from which on bounds are of no use */
    const struct lx_deviation *place = &at->place_deviation;
    const double radius = lamp->round_mm;
    const double from_center[3] = {at->place[0] - lamp->center[0], at->place[1] - lamp->center[1],
                                   at->place[2] - lamp->center[2]};
    const double distance =
        lamp->is_ball ? sqrt(lx_dot(from_center, from_center)) : lx_distance_from_axis(lamp, from_center);
    const double margin = 1e-9 * distance + lamp->touch_mm, moved = place->first + place->second + margin;
    const double nearest = distance - moved, imaginary = place->imaginary;
    if (!(nearest > imaginary))
        return false;
    const double square = (nearest - imaginary) * (nearest + imaginary), least = sqrt(square);
    const double k_square = imaginary * imaginary / (nearest * nearest);
    const double u_square = (1 + k_square) / (1 - k_square);
    *view = (struct lx_round_view){
        .distance = distance,
        .most = hypot(distance + moved, imaginary),
        .share = radius * radius / square,
    };
    if (!(view->share < densest))
        return false;
    if (lamp->is_ball)
        return move_with_ball(radius, least, u_square, place, view);
    move_with_side(radius, least, u_square, place, view);
    return true;
}
