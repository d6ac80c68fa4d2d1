/* SPDX-License-Identifier: MIT */
/* Asking cones: how a cell is seen behind them, and whether a single way is open. */
#include <math.h>

#include "../base/vector.h"
#include "region.h"
#include "occluder_cone.h"

/* The effort of asking a surface for a single way. */
enum { WAY_EFFORT = 1 };
/* Ends of ways that are left out, as a share of them. */
static const double ENDS = 1e-9;

static void sub(const double a[3], const double b[3], double difference[3])
{
    for (int i = 0; i < 3; i++)
        difference[i] = a[i] - b[i];
}

bool lx_may_stand_before(const struct lx_occluder_cones *cones, const double center_mm[3], double radius_mm,
                         const double behind_mm[3], double behind_radius_mm)
{
    double way[3], from[3];
    sub(behind_mm, cones->place_mm, way);
    sub(center_mm, cones->place_mm, from);
    const double far = lx_normalize(way), near = lx_normalize(from);
    if (near - radius_mm > far + behind_radius_mm)
        return false;
    if (near <= radius_mm || far <= behind_radius_mm)
        return true;
    const double widths = asin(radius_mm / near) + asin(behind_radius_mm / far);
    return widths >= M_PI || lx_dot(way, from) >= cos(widths) - 1e-12;
}

/* How a ball lets a cell be seen: it hides what is in it, and what is beyond the places at which tangents touch it. */
static enum lx_outlook look_at_ball(const struct lx_occluder_cones *cones, const struct lx_occluder_cone *ball,
                                    const struct lx_tile_cell *cell)
{
    double way[3], from[3], apart[3];
    if (!lx_may_stand_before(cones, ball->center_mm, ball->radius_mm, cell->center_mm, cell->radius_mm))
        return LX_ALL_SEEN;
    sub(cell->center_mm, ball->center_mm, apart);
    if (sqrt(lx_dot(apart, apart)) + cell->radius_mm < ball->radius_mm)
        return LX_NONE_SEEN;
    sub(cell->center_mm, cones->place_mm, way);
    sub(ball->center_mm, cones->place_mm, from);
    const double far = lx_normalize(way), away = lx_normalize(from),
                 touch = away * away - ball->radius_mm * ball->radius_mm;
    if (!(touch > 0 && far > cell->radius_mm && far - cell->radius_mm >= sqrt(touch)))
        return LX_PART_SEEN;
    const double margin = asin(ball->radius_mm / away) - asin(cell->radius_mm / far);
    return margin > 0 && lx_dot(way, from) > cos(margin) ? LX_NONE_SEEN : LX_PART_SEEN;
}

/* Whether the way to a place passes through a ball. */
static bool ball_takes(const struct lx_occluder_cones *cones, const struct lx_occluder_cone *ball,
                       const double place_mm[3])
{
    double from[3], way[3], square = 0;
    sub(ball->center_mm, cones->place_mm, from);
    sub(place_mm, cones->place_mm, way);
    const double share = fmin(fmax(lx_dot(from, way) / lx_dot(way, way), 0), 1);
    for (int i = 0; i < 3; i++)
        square += (from[i] - share * way[i]) * (from[i] - share * way[i]);
    return square < ball->radius_mm * ball->radius_mm;
}

enum lx_outlook lx_occluder_cone_look(const struct lx_occluder_cones *cones, const struct lx_occluder_cone *cone,
                                      const struct lx_tile_cell *cell)
{
    enum lx_outlook sight = LX_NONE_SEEN;
    if (cone->is_ball)
        return look_at_ball(cones, cone, cell);
    if (cone->shape)
        return lx_may_stand_before(cones, cone->center_mm, cone->radius_mm, cell->center_mm, cell->radius_mm) &&
                       !lx_region_is_free(cones, cone->shape, cell)
                   ? LX_PART_SEEN
                   : LX_ALL_SEEN;
    const bool is_round = lx_dot(cell->first_mm, cell->first_mm) == 0;
    for (size_t k = cone->first; k < cone->first + cone->count; k++) {
        const double *plane = cones->planes[k], middle = lx_dot(plane, cell->center_mm) + plane[3];
        const double spread =
            is_round ? cell->radius_mm : fabs(lx_dot(plane, cell->first_mm)) + fabs(lx_dot(plane, cell->second_mm));
        if (middle + spread <= cones->touch_mm)
            return LX_ALL_SEEN;
        if (middle - spread < -cones->touch_mm)
            sight = LX_PART_SEEN;
    }
    return sight;
}

/* Looks at one more cone. */
static enum lx_outlook look_at(const struct lx_occluder_cones *cones, const struct lx_occluder_cone *cone,
                               const struct lx_tile_cell *cell, struct lx_partly *partly)
{
    const enum lx_outlook sight = lx_occluder_cone_look(cones, cone, cell);
    if (sight != LX_PART_SEEN)
        return sight;
    if (partly->count == LX_MOST_PARTLY)
        partly->is_all = true;
    else
        partly->cones[partly->count++] = cone;
    return sight;
}

enum lx_outlook lx_occluder_cones_look(const struct lx_occluder_cones *cones, const struct lx_tile_cell *cell,
                                       const struct lx_partly *around, struct lx_partly *partly)
{
    const bool asks_all = !around || around->is_all;
    const size_t count = asks_all ? cones->count : around->count;
    partly->count = 0;
    partly->is_all = false;
    for (size_t i = 0; i < count; i++)
        if (look_at(cones, asks_all ? &cones->items[i] : around->cones[i], cell, partly) == LX_NONE_SEEN)
            return LX_NONE_SEEN;
    return partly->count > 0 ? LX_PART_SEEN : LX_ALL_SEEN;
}

bool lx_partly_have_shapes(const struct lx_partly *partly)
{
    for (unsigned i = 0; i < partly->count; i++)
        if (partly->cones[i]->shape)
            return true;
    return false;
}

bool lx_partly_are_horizons(const struct lx_partly *partly)
{
    for (unsigned i = 0; i < partly->count; i++)
        if (!partly->cones[i]->is_horizon)
            return false;
    return true;
}

static bool shape_takes(const struct lx_occluder_cones *cones, const struct lx_shape *shape, const double place_mm[3])
{
    double from[3], way[3];
    lx_effort_take(cones->effort, WAY_EFFORT);
    sub(place_mm, cones->place_mm, way);
    for (int i = 0; i < 3; i++) {
        from[i] = cones->place_mm[i] + ENDS * way[i];
        way[i] *= 1 - 2 * ENDS;
    }
    if (!shape->kind->takes)
        return shape->kind->blocks(shape, lx_exact3(from), lx_exact3(way), false).value != 0;
    for (int i = 0; i < 3; i++)
        from[i] -= shape->anchor_mm[i];
    return shape->kind->takes(shape, from, way, false);
}

bool lx_occluder_cones_leave(const struct lx_occluder_cones *cones, const double place_mm[3])
{
    for (size_t i = 0; i < cones->count; i++) {
        const struct lx_occluder_cone *cone = &cones->items[i];
        bool hidden = true;
        for (size_t k = cone->first; k < cone->first + cone->count && hidden; k++)
            hidden = lx_dot(cones->planes[k], place_mm) + cones->planes[k][3] > 0;
        if (cone->is_ball ? ball_takes(cones, cone, place_mm)
            : cone->shape ? shape_takes(cones, cone->shape, place_mm)
                          : hidden)
            return false;
    }
    return true;
}
