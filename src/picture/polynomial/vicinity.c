/* SPDX-License-Identifier: MIT */
/* The surface around a square of pixels, seen by parallel lines of sight or from the observer's place. */
#include "vicinity.h"

#include <math.h>

#include "../../base/larger.h"
#include "../../base/vector.h"
#include "../../world/among.h"
#include "../../world/blocking.h"
#include "../../world/camera.h"
#include "../../world/general.h"
#include "../seen.h"
#include "smooth.h"

/* The least share of its radius by which a sphere rises above the screen where its slopes are bounded. */
static const double LEAST_HEIGHT = 1e-2;

/*
 * How far places on the screen are from the middle that are complex on one axis and within the square on the other:
 * their real parts, on both axes together, and the imaginary part; and those within the square.
 */
struct reach {
    double real, imaginary, tile;
    double straight; /* of a number for one axis, and a real one within the square for the other */
};

static double root_of_sum(double a, double b)
{
    return sqrt(a * a + b * b);
}

/* ---- where lines of sight meet the surface ---- */

/* Where the left one of two lines side by side, which may be the same, meets the surface.  False: not
 * both do. */
static bool meet(const struct lx_plan *plan, const struct lx_planned_surface *surface, const double x_mm[2],
                 double y_mm, double place[3], double *depth_of_left)
{
    const struct lx_shape *shape = &surface->shape;
    const struct lx_row_view view = lx_row_view_of(plan, y_mm);
    _Alignas(64) double x[LX_LANES], depth[LX_LANES], places[3][LX_LANES];
    for (size_t i = 0; i < LX_LANES; i++)
        x[i] = x_mm[i > 0];
    const size_t met = lx_meet_shape(plan->kernels, shape, &view, x, 2, depth, places[0], places[1], places[2]);
    for (int i = 0; i < 3; i++)
        place[i] = places[i][0];
    *depth_of_left = depth[0];
    return met == 2 && depth[0] > 0;
}

/* Whether what is flat and convex shows at all corners of a square, and so between them. */
static bool shows_corners(const struct lx_plan *plan, const struct lx_square *square)
{
    const double x[2] = {square->x_mm - square->half_mm[0], square->x_mm + square->half_mm[0]};
    double place[3], depth;
    return meet(plan, square->surface, x, square->y_mm - square->half_mm[1], place, &depth) &&
           meet(plan, square->surface, x, square->y_mm + square->half_mm[1], place, &depth);
}

const struct lx_planned_surface *lx_surface_seen(const struct lx_plan *plan, double x_mm, double y_mm)
{
    const struct lx_planned_surface *seen = NULL;
    const double x[2] = {x_mm, x_mm};
    const double at[2] = {x_mm, y_mm};
    double nearest = HUGE_VAL, depth, place[3];
    struct lx_found found;
    const bool is_found = lx_seen_within(plan, at, at, &found);
    const size_t count = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_planned_surface *surface = &plan->surfaces[lx_found_at(&found, is_found, i)];
        if (meet(plan, surface, x, y_mm, place, &depth) && depth < nearest) {
            nearest = depth;
            seen = surface;
        }
    }
    return seen;
}

/* Whether no other surface may stand between the observer and what a square shows. */
static bool is_free(const struct lx_plan *plan, const struct lx_square *square, const struct lx_vicinity *at)
{
    const struct lx_planned_surface *surface = square->surface;
    const struct lx_camera *camera = &plan->prepared->camera;
    const bool endless = !camera->is_perspective;
    const struct lx_ball part = lx_vicinity_ball(at);
    const struct lx_origin from = lx_eye(camera);
    struct lx_ball eye = {.center = {0, 0, 1}};
    for (int i = 0; i < 3 && !endless; i++)
        eye.center[i] = (i == 2 ? camera->z_mm : 0) - surface->shape.anchor_mm[i];
    struct lx_found found;
    const bool is_found = lx_among_balls(plan->prepared, surface->shape.anchor_mm, &part, &eye, endless, &found);
    const size_t count = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_planned_surface *other = &plan->surfaces[lx_found_at(&found, is_found, i)];
        if (other != surface && lx_shape_faces(&other->shape, &from) &&
            lx_shape_may_block(&other->shape, surface->shape.anchor_mm, &part, &eye, endless))
            return false;
    }
    return true;
}

/* ---- parallel lines of sight ---- */

/*
 * z = sqrt(q) with q = R^2 - x^2 - y^2; of x + i v the real part of q is more by v^2, the imaginary one 2 x v.  The
 * real part of a root is at least the root of the real part, so that of z, and the imaginary one no more than half of
 * q's over it.
 */
static bool deviation_on_sphere(double radius, const double place[3], struct reach reach,
                                struct lx_deviation *deviation)
{
    const double height = place[2], away = root_of_sum(place[0], place[1]), farthest = away + reach.real,
                 nearest = lx_larger(away - reach.real, 0);
    const double least = (radius - farthest) * (radius + farthest);
    if (!(farthest < radius && least > LEAST_HEIGHT * LEAST_HEIGHT * radius * radius))
        return false;
    const double lowest = sqrt(least), highest = sqrt(radius * radius - nearest * nearest);
    const double across = lx_larger(fabs(place[0]), fabs(place[1])) + reach.real;
    const double imaginary = 2 * across * reach.imaginary, square = least + reach.imaginary * reach.imaginary;
    const double below = away + reach.tile, tile_low = height - sqrt((radius - below) * (radius + below));
    const double tile_high =
        sqrt(radius * radius - lx_larger(away - reach.tile, 0) * lx_larger(away - reach.tile, 0)) - height;
    *deviation = (struct lx_deviation){
        .first = root_of_sum(reach.real, lx_larger(height - lowest, highest - height)),
        .second = sqrt(square + imaginary * imaginary / (4 * square)) - lowest,
        .imaginary = root_of_sum(reach.imaginary, imaginary / (2 * lowest)),
        .tile = root_of_sum(reach.tile, lx_larger(tile_low, tile_high)),
    };
    return true;
}

static bool deviation_on_plate(const double normal[3], struct reach reach, struct lx_deviation *deviation)
{
    const double longer = 1 / normal[2]; /* lengths on the plate than on the screen */
    *deviation = (struct lx_deviation){
        .first = reach.real * longer, .imaginary = reach.imaginary * longer, .tile = reach.tile * longer};
    return normal[2] > 1e-3;
}

/* ---- lines of sight from the observer's place ---- */

/*
 * The line d = (x, y, -h) meets the surface, which has the normal n there, at the share t of its length to the screen.
 * By a change u of the place on the screen it moves by t (u - d (n.u)/(n.d)), whatever the surface's shape, also where
 * u is complex.
 */
struct pencil {
    double h, length, across; /* of d, and its part along the screen */
    double t;
    double cosine, sine, n_across; /* of n to -d, and its part along the screen */
    double bend;                   /* 1/R; 0 for a plate */
};

/*
 * By how many times as much as its place on the screen, at most, the place on the surface moves where both are no
 * farther from the middle than `off` and `moved`; infinite where lines of sight may touch the surface.  With n.n = 1
 * what n changes by has no more than half its square along n.
 */
static double slope_within(const struct pencil *pencil, double off, double moved)
{
    const double turned = moved * pencil->bend, most = pencil->n_across + turned;
    const double facing = pencil->cosine * (1 - turned * turned / 2) - pencil->sine * turned;
    const double least = pencil->length * facing - most * off, share = most / least;
    if (!(least > 0))
        return HUGE_VAL;
    return (pencil->t + moved / pencil->h) * root_of_sum(1 + (pencil->across + off) * share, pencil->h * share);
}

/*
 * How far from the middle the place on the surface moves at most while that on the screen does by `off`, in steps: one
 * is believed where the slope within what is assumed to be reached does not lead beyond that.  Infinite: unknown.
 */
static double farthest_by(const struct pencil *pencil, double off)
{
    enum { STEPS = 3, TRIALS = 5 };
    double reached = 0;
    for (int step = 1; step <= STEPS; step++) {
        const double length = off / STEPS, until = length * step;
        double next = reached + slope_within(pencil, until - length, reached) * length, assumed;
        int trial = 0;
        do {
            assumed = next * 1.02;
            next = reached + slope_within(pencil, until, assumed) * length;
        } while (next > assumed && ++trial < TRIALS);
        if (!(next <= assumed && next < HUGE_VAL))
            return HUGE_VAL;
        reached = next;
    }
    return reached;
}

/*
 * On a sphere a complex place g + i f from its centre has g.g - f.f = R^2 and g.f = 0: what g is beyond the sphere is
 * of second order, and f lies across it.  On a plate g itself is a place on it.
 */
static bool deviation_in_perspective(const struct pencil *pencil, struct reach reach, struct lx_deviation *deviation)
{
    const double first = farthest_by(pencil, reach.real), tile = farthest_by(pencil, reach.tile);
    const double imaginary = slope_within(pencil, reach.real, first) * reach.imaginary, bend = pencil->bend;
    *deviation = (struct lx_deviation){
        .first = first,
        .second = imaginary * imaginary * bend / (1 + root_of_sum(1, imaginary * bend)),
        .imaginary = imaginary,
        .tile = tile,
    };
    return first < HUGE_VAL && tile < HUGE_VAL && imaginary < HUGE_VAL;
}

static struct pencil pencil_of(const struct lx_plan *plan, const struct lx_square *square, const struct lx_vicinity *at,
                               double bend)
{
    const struct lx_shape *shape = &square->surface->shape;
    const double h = plan->prepared->camera.z_mm, d[3] = {square->x_mm, square->y_mm, -h};
    const double length = sqrt(lx_dot(d, d)), cosine = -lx_dot(at->normal, d) / length;
    return (struct pencil){
        .h = h,
        .length = length,
        .across = root_of_sum(d[0], d[1]),
        .t = (h - shape->anchor_mm[2] - at->place[2]) / h,
        .cosine = cosine,
        .sine = sqrt(lx_larger(1 - cosine * cosine, 0)),
        .n_across = root_of_sum(at->normal[0], at->normal[1]),
        .bend = bend,
    };
}

/* ---- vicinities ---- */

/* The deviation of the view vector along a way that moves, as kernel_smooth.h finds that of the way to a light. */
static bool deviation_of_view(const double way[3], const struct lx_deviation *moves, struct lx_vicinity *at)
{
    const double d = sqrt(lx_dot(way, way)), nearest = d - moves->first - moves->second;
    if (!(0.9 * nearest > moves->imaginary && nearest > 0.05 * d))
        return false;
    const double k = moves->imaginary / nearest, more = 1 / sqrt(1 - k * k) - 1;
    for (int i = 0; i < 3; i++)
        at->view[i] = way[i] / d;
    at->view_deviation = (struct lx_deviation){
        .first = moves->first / d * sqrt(2), /* no more than the chord of that sine */
        .second = more * (1 + k) + k * k * (1 + more) + moves->second / nearest,
        .imaginary = k * (1 + more) + more,
        .tile = moves->tile / d * sqrt(2),
    };
    return true;
}

/* In perspective the view vector is the line of sight's own, backwards. */
static bool find_in_perspective(const struct lx_plan *plan, const struct lx_square *square, struct reach reach,
                                double bend, struct lx_vicinity *at)
{
    const struct pencil pencil = pencil_of(plan, square, at, bend);
    const double back[3] = {-square->x_mm, -square->y_mm, pencil.h};
    const struct lx_deviation moves = {.first = reach.real, .imaginary = reach.imaginary, .tile = reach.tile};
    if (bend == 0)
        at->straight = farthest_by(&pencil, reach.straight);
    return deviation_in_perspective(&pencil, reach, &at->place_deviation) && deviation_of_view(back, &moves, at);
}

static bool find_in_parallel(const struct lx_plan *plan, const struct lx_planned_surface *surface, struct reach reach,
                             double bend, struct lx_vicinity *at)
{
    const struct lx_shape *shape = &surface->shape;
    double observer[3], way[3];
    if (bend == 0)
        at->straight = reach.straight / at->normal[2];
    if (!(bend > 0 ? deviation_on_sphere(shape->radius_mm, at->place, reach, &at->place_deviation)
                   : deviation_on_plate(at->normal, reach, &at->place_deviation)))
        return false;
    if (!lx_observer_from(plan, surface, observer))
        return true;
    for (int i = 0; i < 3; i++)
        way[i] = observer[i] - at->place[i];
    return deviation_of_view(way, &at->place_deviation, at);
}

bool lx_find_vicinity(const struct lx_plan *plan, const struct lx_square *square, const struct lx_basis *basis,
                      struct lx_vicinity *at)
{
    const struct lx_shape *shape = &square->surface->shape;
    const double bend = lx_curvature(shape);
    const double half = lx_larger(square->half_mm[0], square->half_mm[1]), middle[2] = {square->x_mm, square->x_mm};
    const struct reach reach = {
        .real = root_of_sum((basis->reach + 1 / basis->reach) / 2, 1) * half,
        .imaginary = (basis->reach - 1 / basis->reach) / 2 * half,
        .tile = root_of_sum(square->half_mm[0], square->half_mm[1]),
        .straight = ((basis->reach + 1 / basis->reach) / 2 + 1) * half,
    };
    *at = (struct lx_vicinity){.view = {0, 0, 1}, .slip = basis->slip, .straight = HUGE_VAL};
    double depth;
    if (!meet(plan, square->surface, middle, square->y_mm, at->place, &depth) ||
        (bend == 0 && !shows_corners(plan, square)))
        return false;
    shape->kind->normal(shape, at->place, at->normal);
    if (!(plan->prepared->camera.is_perspective ? find_in_perspective(plan, square, reach, bend, at)
                                                : find_in_parallel(plan, square->surface, reach, bend, at)))
        return false;
    if (bend > 0) {
        const struct lx_deviation *place = &at->place_deviation;
        const double radius = shape->radius_mm;
        at->level = radius;
        at->normal_deviation = (struct lx_deviation){place->first / radius, place->second / radius,
                                                     place->imaginary / radius, place->tile / radius};
    }
    return is_free(plan, square, at);
}
