/* SPDX-License-Identifier: MIT */
/* How large the light of an extended source may be at complex places of the screen. */
#include "area_light_bound.h"

#include <math.h>

#include "../base/larger.h"
#include "../base/vector.h"
#include "round_view.h"

/* More edges, and faces, are not looked at for each square. */
enum { MOST_EDGES = 64 };

/* Where the square is of some plane, which its places are above by `height` less or more `deviation`. */
enum side { BEHIND, BEFORE, UNSURE };

static enum side side_of(double height, double deviation)
{
    return height > deviation ? BEFORE : height < -deviation ? BEHIND : UNSURE;
}

/* How far a source reaches from its centre in a direction, or no less. */
static double reach_of(const struct lx_area_light *lamp, const double direction[3])
{
    double farthest = -HUGE_VAL;
    if (lamp->is_disk || lamp->has_side) {
        const double cosine = lx_dot(direction, lamp->axis);
        return lamp->half_mm * fabs(cosine) + lamp->round_mm * sqrt(lx_larger(1 - cosine * cosine, 0));
    }
    for (size_t e = 0; e < lamp->edge_count && lamp->edge_count <= MOST_EDGES; e++) {
        const struct lx_area_light_edge_double *edge = &lamp->edges_double[e];
        farthest = lx_larger(farthest, lx_larger(lx_dot(direction, edge->from), lx_dot(direction, edge->to)));
    }
    return farthest > -HUGE_VAL ? farthest : lamp->radius_mm;
}

/* The side of the horizon of all elements on which a source is throughout, as BEFORE is above. */
static enum side side_of_horizon(const struct lx_area_light *lamp, const struct lx_vicinity *at, double margin)
{
    const double *n = at->normal, below[3] = {-n[0], -n[1], -n[2]}, turn = at->normal_deviation.tile;
    const double height = lx_dot(n, lamp->center) - at->level;
    const double deviation = turn * (sqrt(lx_dot(lamp->center, lamp->center)) + lamp->radius_mm) + margin;
    if (height - reach_of(lamp, below) > deviation)
        return BEFORE;
    return height + reach_of(lamp, n) < -deviation ? BEHIND : UNSURE;
}

/* The side of a cylinder's ends and of its hull, which is seen from outside. */
static enum side side_of_cylinder(const struct lx_area_light *lamp, const double from_center[3], double deviation)
{
    const double along = lx_dot(lamp->axis, from_center);
    const enum side side = side_of(lx_distance_from_axis(lamp, from_center) - lamp->round_mm, deviation),
                    end = side_of(fabs(along) - lamp->half_mm, deviation);
    return side == UNSURE || end == UNSURE ? UNSURE : side == BEFORE || end == BEFORE ? BEFORE : BEHIND;
}

/* Whether the square is before some part of the source that shines, or behind all; UNSURE, too, where parts of it are
 * on either side of a face. */
static enum side side_of_faces(const struct lx_area_light *lamp, const struct lx_vicinity *at,
                               const double from_center[3], double margin)
{
    const double deviation = at->place_deviation.tile + margin;
    enum side side = BEHIND;
    if (lamp->has_side)
        return side_of_cylinder(lamp, from_center, deviation);
    if (!lamp->facets)
        return lamp->is_ball ? BEFORE : side_of(lx_dot(lamp->axis, from_center), deviation);
    for (size_t f = 0; f < lamp->face_count && side != UNSURE; f++) {
        const struct lx_area_light_face_double *face = &lamp->faces_double[f];
        const enum side of_face = side_of(lx_dot(face->normal, from_center) - face->height, deviation);
        side = of_face == BEHIND ? side : of_face;
    }
    return lamp->edge_count <= MOST_EDGES ? side : UNSURE;
}

/* The distance of a source's nearest place, or less. */
static double least_distance(const struct lx_area_light *lamp, const double from_center[3])
{
    if (!lamp->has_side)
        return sqrt(lx_dot(from_center, from_center)) - lamp->radius_mm;
    return hypot(lx_larger(lx_distance_from_axis(lamp, from_center) - lamp->round_mm, 0),
                 lx_larger(fabs(lx_dot(lamp->axis, from_center)) - lamp->half_mm, 0));
}

/* The most that r^2 a(r) comes to over a ball that is seen from w, w.w having the real part `least` at least, |w| no
 * more than `most`, and its imaginary part being no more than `imaginary`. */
static double most_of_ball(const struct lx_area_light *lamp, double least, double most, double imaginary)
{
    const double radius = lamp->round_mm, nearest = sqrt(least) - radius, farthest = most + radius;
    const double aside = most * imaginary / sqrt(lx_larger(least - radius * radius, 0));
    if (!(nearest > 0 && aside < nearest / 2))
        return HUGE_VAL;
    return farthest * farthest * lx_law_at(&lamp->law, nearest, (nearest - aside) * (nearest + aside));
}

double lx_most_of_ball(const struct lx_area_light *lamp, const struct lx_vicinity *at)
{
    const struct lx_deviation *place = &at->place_deviation;
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += (at->place[k] - lamp->center[k]) * (at->place[k] - lamp->center[k]);
    const double away = sqrt(square), near = away - place->first - place->second;
    const double least = near * near - place->imaginary * place->imaginary;
    if (lamp->law.none == 0 && lamp->law.root == 0)
        return 1 / lamp->law.square;
    return near > 0 && least > 0
               ? most_of_ball(lamp, least, hypot(away + place->first + place->second, place->imaginary),
                              place->imaginary)
               : HUGE_VAL;
}

double lx_smooth_area_light_bound(const struct lx_area_light *lamp, double gain, const struct lx_vicinity *at)
{
    const struct lx_deviation *normal = &at->normal_deviation;
    struct lx_deviation place = at->place_deviation;
    struct lx_round_view view = {.most = 0};
    const double from_center[3] = {at->place[0] - lamp->center[0], at->place[1] - lamp->center[1],
                                   at->place[2] - lamp->center[2]};
    const double away = sqrt(lx_dot(from_center, from_center)), margin = 1e-9 * away + lamp->touch_mm;
    const enum side horizon = side_of_horizon(lamp, at, margin);
    const enum side faces = side_of_faces(lamp, at, from_center, margin);
    if (horizon == BEHIND || faces == BEHIND)
        return 0;
    if (lamp->has_side && lx_distance_from_axis(lamp, from_center) > lamp->round_mm) {
        if (!lx_round_view_of(lamp, at, &view))
            return HUGE_VAL;
        const double aside = view.aside * lx_beyond_real(&place);
        place.second += aside, place.imaginary += aside;
    }
    const double nearest = least_distance(lamp, from_center) - place.first - margin;
    if (horizon == UNSURE || faces == UNSURE || !(0.9 * nearest > place.second + place.imaginary))
        return HUGE_VAL;
    const double imaginary = place.imaginary * place.imaginary;
    const double least = (nearest - place.second) * (nearest - place.second) - imaginary;
    const double most = sqrt((nearest + place.second) * (nearest + place.second) + imaginary);
    const double across = view.most * (1 + view.share) * sqrt(1 + view.share); /* of the way to a cylinder's side */
    const double size = gain * hypot(1 + normal->second, normal->imaginary) * most * lx_larger(most, across) / least;
    return lamp->is_ball ? size / least * lx_most_of_ball(lamp, at) : size * lx_law_at(&lamp->law, sqrt(least), least);
}
