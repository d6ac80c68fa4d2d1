/* SPDX-License-Identifier: MIT */
/*
 * The side of a cylinder, a tube that is seen from outside and takes light away from both sides; its ends are open.
 *
 * With n the axis, of the length l, R the radius, and d the direction of a ray from o, both from the centre, let
 * e = n x d and f = -n x e, l^2 times the part of d across the axis.  The ray passes the axis at |o.e|/|e|, and meets
 * the infinite cylinder at the offset from the axis
 *
 *     q = ((o.e) e - sqrt(R^2 e^2 - (o.e)^2) f/l) / e^2,
 *
 * in which nothing cancels but the square of the root, formed in twice the precision.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/pose.h"
#include "../base/vector.h"
#include "cylinder.h"
#include "sheet.h"

struct cylinder_parameters {
    uint64_t given; /* always first: which keys the user wrote */
    double center_mm[3];
    double radius_mm, height_mm;
    double axis[3];
};

static const struct lx_parameter cylinder_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct cylinder_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the middle of the cylinder lies: x to the right, y up, z towards the observer",
    },
    {
        .name = "radius",
        .label = "Radius",
        .type = LX_REAL,
        .offset = offsetof(struct cylinder_parameters, radius_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 5000)},
        .meaning = "the radius of the cylinder",
    },
    {
        .name = "height",
        .label = "Height",
        .type = LX_REAL,
        .offset = offsetof(struct cylinder_parameters, height_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 10000)},
        .meaning = "the length of the cylinder along its axis; both ends are open",
    },
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct cylinder_parameters, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning =
            "the direction of the cylinder's axis, of any length; along the line of sight, (0, 0, 1), nothing of "
            "its side is seen",
    },
};

static const struct lx_table cylinder_table = {
    .parameters = cylinder_parameters,
    .count = LX_COUNT(cylinder_parameters),
    .size = sizeof(struct cylinder_parameters),
};

static struct lx_shape cylinder_shape(const void *parameters)
{
    const struct cylinder_parameters *cylinder = parameters;
    double up[3];
    lx_usual_up(cylinder->axis, up);
    struct lx_shape shape =
        lx_plane_lay(cylinder->center_mm, cylinder->axis, up, hypot(cylinder->radius_mm, cylinder->height_mm / 2));
    shape.own[0] = cylinder->radius_mm;
    shape.own[1] = cylinder->height_mm / 2 + shape.touch_mm;
    return shape;
}

static double cylinder_farthest(const void *parameters, const double direction[3])
{
    const struct cylinder_parameters *cylinder = parameters;
    const struct lx_shape shape = cylinder_shape(parameters);
    const double aside = hypot(lx_dot(direction, shape.across), lx_dot(direction, shape.upward));
    return lx_dot(direction, cylinder->center_mm) + cylinder->radius_mm * aside +
           cylinder->height_mm / 2 * fabs(lx_dot(direction, shape.axis));
}

static void cylinder_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct cylinder_parameters *cylinder = parameters;
    const struct lx_shape shape = cylinder_shape(parameters);
    for (int i = 0; i < 3; i++) {
        const double half = cylinder->radius_mm * hypot(shape.across[i], shape.upward[i]) +
                            cylinder->height_mm / 2 * fabs(shape.axis[i]);
        low_mm[i] = cylinder->center_mm[i] - half;
        high_mm[i] = cylinder->center_mm[i] + half;
    }
}

/* How a ray passes by the axis: e, e^2, o.e, and what is under the root. */
struct passing {
    lx_bounded3 across;
    lx_bounded square, moment, below;
};

static struct passing pass(const struct lx_shape *cylinder, const struct lx_ray *ray, const struct lx_pair from[3])
{
    const double *n = cylinder->normal, *d = ray->direction, radius = lx_cylinder_radius(cylinder);
    struct lx_pair e[3];
    double errors[5], size = 0, e_error = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        e[i] = lx_exact_dot(2, (double[]){n[j], -n[k]}, (double[]){d[k], d[j]}, &errors[i]);
        errors[i] += fabs(n[j]) * ray->direction_error[k] + fabs(n[k]) * ray->direction_error[j];
        e_error = fmax(e_error, errors[i]);
    }
    double left[9], right[9], squares[2][6], of_origin = 0;
    for (int i = 0; i < 3; i++) {
        of_origin += (fabs(e[i].high) + e_error) * ray->origin_error[i];
        left[i] = from[i].high, left[3 + i] = from[i].high, left[6 + i] = from[i].low;
        right[i] = e[i].high, right[3 + i] = e[i].low, right[6 + i] = e[i].high;
        squares[0][i] = e[i].high, squares[1][i] = e[i].high;
        squares[0][3 + i] = 2 * e[i].high, squares[1][3 + i] = e[i].low;
        size += fabs(from[i].high);
    }
    const struct lx_pair moment = lx_exact_dot(9, left, right, &errors[3]);
    const struct lx_pair square = lx_exact_dot(6, squares[0], squares[1], &errors[4]);
    const struct lx_pair r2 = lx_exact_product(radius, radius);
    double rest;
    const struct lx_pair below =
        lx_exact_dot(5, (double[]){square.high, square.high, square.low, -moment.high, -2 * moment.high},
                     (double[]){r2.high, r2.low, r2.high, moment.high, moment.low}, &rest);
    const double moment_error =
        errors[3] + of_origin + 3 * size * e_error + LX_ROUNDING * LX_ROUNDING * 8 * size * sqrt(square.high);
    const double square_error = errors[4] + 6 * e_error * (sqrt(square.high) + e_error);
    const double left_out = 8 * LX_ROUNDING * LX_ROUNDING * (square.high * r2.high + moment.high * moment.high);
    return (struct passing){
        .across = {lx_rounded(e[0].high, errors[0], 1), lx_rounded(e[1].high, errors[1], 1),
                   lx_rounded(e[2].high, errors[2], 1)},
        .square = lx_rounded(square.high, square_error, 1),
        .moment = lx_rounded(moment.high, moment_error, 1),
        .below = lx_rounded(
            below.high,
            rest + square_error * r2.high + (2 * fabs(moment.high) + moment_error) * moment_error + left_out, 1),
    };
}

static struct lx_hit cylinder_hit(const struct lx_shape *cylinder, const struct lx_ray *ray)
{
    const struct lx_hit none = {.exists = false};
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(ray->origin_mm[i], cylinder->anchor_mm[i]);
    const struct passing at = pass(cylinder, ray, from);
    if (!(at.below.value >= 0 && at.square.value > 0))
        return none;
    const lx_bounded3 n = lx_exact3(cylinder->normal), d = lx_ray_direction(ray);
    const lx_bounded3 o = {{from[0].high, fabs(from[0].low) + ray->origin_error[0]},
                           {from[1].high, fabs(from[1].low) + ray->origin_error[1]},
                           {from[2].high, fabs(from[2].low) + ray->origin_error[2]}};
    const lx_bounded length = lx_sqrt(lx_square3(n)), root = lx_sqrt(at.below);
    const lx_bounded3 f = lx_cross3(at.across, n);
    const lx_bounded t = lx_div(lx_sub(lx_negate(lx_dot3(o, f)), lx_mul(length, root)), at.square);
    const lx_bounded z = lx_div(lx_add(lx_dot3(o, n), lx_mul(t, lx_dot3(d, n))), length);
    if (!(t.value > 0 && fabs(z.value) <= lx_cylinder_half(cylinder)))
        return none;
    const lx_bounded3 ahead = lx_mul3(f, lx_div(root, length));
    const lx_bounded3 sum = lx_sub3(lx_mul3(at.across, at.moment), ahead);
    const lx_bounded3 q = {lx_div(sum.x, at.square), lx_div(sum.y, at.square), lx_div(sum.z, at.square)};
    const lx_bounded radius = lx_exact(lx_cylinder_radius(cylinder));
    struct lx_hit hit = {
        .exists = true,
        .t = t.value,
        .place_mm = lx_add3(lx_exact3(cylinder->anchor_mm), lx_add3(q, lx_mul3(lx_shape_axis(cylinder), z))),
        .normal = {lx_div(q.x, radius), lx_div(q.y, radius), lx_div(q.z, radius)},
    };
    lx_keep_coordinates(ray, &hit.place_mm);
    return hit;
}

static void cylinder_normal(const struct lx_shape *cylinder, const double offset_mm[3], double normal[3])
{
    double along;
    lx_cylinder_split(cylinder, offset_mm, normal, &along);
    lx_normalize(normal);
}

/* Whether a way that crosses the infinite cylinder at the share t does so on its length and between the ends. */
static lx_bounded crosses_at(const struct lx_shape *cylinder, lx_bounded3 place_mm, lx_bounded t, lx_bounded start,
                             lx_bounded change, lx_bounded touch, bool endless)
{
    const lx_bounded z = lx_add(start, lx_mul(t, change));
    const lx_bounded half = lx_exact(lx_cylinder_half(cylinder) - cylinder->touch_mm);
    const lx_bounded room = lx_sub(half, (lx_bounded){fabs(z.value), z.error});
    lx_bounded crosses = lx_plane_is_within(cylinder, place_mm, room, cylinder->touch_mm);
    crosses = lx_both(crosses, lx_step(lx_sub(t, touch), false));
    if (!endless)
        crosses = lx_both(crosses, lx_step(lx_sub(lx_sub(lx_exact(1), touch), t), false));
    return crosses;
}

/*
 * Across the axis the way is p + t v, p from the axis: it crosses the infinite cylinder where
 * v^2 t^2 + 2 p.v t + p^2 - R^2 = 0.  What is nearer to an end of the way than `touch` is on the surface itself.
 */
static lx_bounded cylinder_blocks(const struct lx_shape *cylinder, lx_bounded3 place_mm, lx_bounded3 towards,
                                  bool endless)
{
    const lx_bounded3 axis = lx_shape_axis(cylinder), from = lx_sub3(place_mm, lx_exact3(cylinder->anchor_mm));
    const lx_bounded start = lx_dot3(from, axis), change = lx_dot3(towards, axis);
    const lx_bounded3 p = lx_sub3(from, lx_mul3(axis, start)), v = lx_sub3(towards, lx_mul3(axis, change));
    const lx_bounded a = lx_square3(v), b = lx_dot3(p, v);
    const lx_bounded moment = lx_dot3(axis, lx_cross3(p, v)), radius = lx_exact(lx_cylinder_radius(cylinder));
    const lx_bounded below = lx_sub(lx_mul(lx_mul(radius, radius), a), lx_mul(moment, moment));
    if (!(a.value > a.error) || below.value + below.error < 0)
        return lx_exact(0);
    const lx_bounded root = lx_sqrt(below), touch = lx_div(lx_exact(cylinder->touch_mm), lx_sqrt(a));
    lx_bounded open = lx_exact(1);
    for (int sign = -1; sign <= 1; sign += 2) {
        const lx_bounded t = lx_div(lx_add(lx_negate(b), lx_scale(root, sign)), a);
        open = lx_both(open, lx_not(crosses_at(cylinder, place_mm, t, start, change, touch, endless)));
    }
    const lx_bounded crosses = lx_not(open), meets = lx_step(below, false);
    return lx_both(meets, crosses);
}

/* A way in plain float64: its parts across the axis and along it, the square of the former, and what is under the root,
 * which cancels no more than the moment is rounded. */
struct plain_way {
    double p[3], v[3], start, change, square, middle, moment, below;
};

static struct plain_way plain_way_of(const struct lx_shape *cylinder, const double from_mm[3], const double way[3])
{
    struct plain_way at;
    double cross[3];
    lx_cylinder_split(cylinder, from_mm, at.p, &at.start);
    lx_cylinder_split(cylinder, way, at.v, &at.change);
    for (int i = 0; i < 3; i++)
        cross[i] = at.p[(i + 1) % 3] * at.v[(i + 2) % 3] - at.p[(i + 2) % 3] * at.v[(i + 1) % 3];
    at.square = lx_dot(at.v, at.v);
    at.middle = lx_dot(at.p, at.v);
    at.moment = lx_dot(cylinder->axis, cross);
    const double reach = lx_cylinder_radius(cylinder) * sqrt(at.square);
    at.below = (reach - fabs(at.moment)) * (reach + fabs(at.moment));
    return at;
}

static bool cylinder_meets(const struct lx_shape *cylinder, const double from_mm[3], const double direction[3],
                           double *t, double offset_mm[3])
{
    const struct plain_way at = plain_way_of(cylinder, from_mm, direction);
    const double root = sqrt(fmax(at.below, 0)), *a = cylinder->axis;
    if (!(at.below >= 0 && at.square > 1e-30 * lx_dot(direction, direction)))
        return false;
    *t = (-at.middle - root) / at.square;
    const double z = at.start + *t * at.change;
    if (!(*t > 0 && fabs(z) <= lx_cylinder_half(cylinder)))
        return false;
    for (int i = 0; i < 3; i++) {
        const double e = a[(i + 1) % 3] * at.v[(i + 2) % 3] - a[(i + 2) % 3] * at.v[(i + 1) % 3];
        offset_mm[i] = (-at.moment * e - root * at.v[i]) / at.square + z * a[i];
    }
    return true;
}

static bool cylinder_takes(const struct lx_shape *cylinder, const double from_mm[3], const double way[3], bool endless)
{
    const struct plain_way at = plain_way_of(cylinder, from_mm, way);
    if (!(at.below > 0 && at.square > 1e-30 * lx_dot(way, way)))
        return false;
    const double root = sqrt(at.below), touch = cylinder->touch_mm / sqrt(at.square),
                 last = endless ? HUGE_VAL : 1 - touch;
    for (int sign = -1; sign <= 1; sign += 2) {
        const double t = (-at.middle + sign * root) / at.square;
        if (t > touch && t < last && fabs(at.start + t * at.change) <= lx_cylinder_half(cylinder))
            return true;
    }
    return false;
}

/*
 * Light from behind the wall on whose side the element is has to come through it; light from the inner side has to pass
 * the wall opposite, which it reaches at the share t = -2 p.v/v^2 of the way.
 */
static lx_bounded cylinder_hides(const struct lx_shape *cylinder, lx_bounded3 place_mm, double facing,
                                 lx_bounded3 towards, bool endless)
{
    const lx_bounded3 axis = lx_shape_axis(cylinder), from = lx_sub3(place_mm, lx_exact3(cylinder->anchor_mm));
    const lx_bounded start = lx_dot3(from, axis), change = lx_dot3(towards, axis);
    const lx_bounded3 p = lx_sub3(from, lx_mul3(axis, start)), v = lx_sub3(towards, lx_mul3(axis, change));
    const lx_bounded b = lx_dot3(p, v), through = lx_step(facing >= 0 ? lx_negate(b) : b, false);
    if (facing >= 0 || through.value > 0)
        return through;
    const lx_bounded a = lx_square3(v);
    if (!(a.value > a.error))
        return lx_exact(0);
    const lx_bounded t = lx_div(lx_scale(b, -2), a), touch = lx_div(lx_exact(cylinder->touch_mm), lx_sqrt(a));
    return crosses_at(cylinder, place_mm, t, start, change, touch, endless);
}

static struct lx_obstacle tube_of(const struct lx_shape *cylinder)
{
    struct lx_obstacle tube = {
        .type = LX_OBSTACLE_TUBE,
        .radius_mm = lx_cylinder_radius(cylinder),
        .half_mm = lx_cylinder_half(cylinder) - cylinder->touch_mm,
        .touch_mm = cylinder->touch_mm,
    };
    memcpy(tube.center_mm, cylinder->anchor_mm, sizeof tube.center_mm);
    memcpy(tube.axis, cylinder->axis, sizeof tube.axis);
    return tube;
}

static int cylinder_gather(const struct lx_shape *cylinder, const struct lx_shaft *shaft,
                           struct lx_obstacles *obstacles)
{
    struct lx_obstacle tube = tube_of(cylinder);
    double offset[3], aside[3], along;
    if (!lx_shaft_meets_ball(shaft, cylinder->anchor_mm, cylinder->radius_mm))
        return 0;
    for (int i = 0; i < 3; i++)
        offset[i] = shaft->from_mm[i] - cylinder->anchor_mm[i];
    lx_cylinder_split(cylinder, offset, aside, &along);
    tube.is_around = sqrt(lx_dot(aside, aside)) < tube.radius_mm - tube.touch_mm;
    return lx_obstacles_append(obstacles, &tube);
}

/* An element that looks inwards loses what the wall opposite takes, too. */
static int cylinder_gather_beside(const struct lx_shape *cylinder, double facing, const struct lx_obstacle *beyond,
                                  const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    struct lx_obstacle tube = tube_of(cylinder);
    tube.is_around = true;
    (void)shaft;
    if (lx_obstacles_append(obstacles, beyond))
        return -1;
    return facing < 0 ? lx_obstacles_append(obstacles, &tube) : 0;
}

static bool cylinder_holds(const struct lx_shape *cylinder, const double place_mm[3])
{
    double from[3], aside[3], along, near = 1e-9 * cylinder->radius_mm;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - cylinder->anchor_mm[i];
    lx_cylinder_split(cylinder, from, aside, &along);
    return fabs(sqrt(lx_dot(aside, aside)) - lx_cylinder_radius(cylinder)) <= near &&
           fabs(along) <= lx_cylinder_half(cylinder) + near;
}

/* A source inside of the infinite cylinder lights nothing of the outer side. */
static bool cylinder_is_dark(const struct lx_shape *cylinder, const double place_mm[3])
{
    double from[3], aside[3], along;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - cylinder->anchor_mm[i];
    lx_cylinder_split(cylinder, from, aside, &along);
    return lx_dot(aside, aside) <= lx_cylinder_radius(cylinder) * lx_cylinder_radius(cylinder);
}

static double cylinder_distance(const struct lx_shape *cylinder, const double offset_mm[3], double direction[3])
{
    double aside[3], along;
    lx_cylinder_split(cylinder, offset_mm, aside, &along);
    const double out = lx_normalize(aside) - lx_cylinder_radius(cylinder);
    const double beyond = fmax(fabs(along) - lx_cylinder_half(cylinder), 0), length = hypot(out, beyond);
    for (int i = 0; i < 3; i++)
        direction[i] = beyond > 0 ? (out * aside[i] + copysign(beyond, along) * cylinder->axis[i]) / length : aside[i];
    return beyond > 0 || out > 0 ? length : -length;
}

/* How far beyond the limits of the tube a way crosses the infinite cylinder that goes so far by its axis. */
static double beside_crossing(const struct lx_shape *cylinder, double t, double start, double change, double length,
                              bool endless)
{
    double outside = fmax(fabs(start + t * change) - lx_cylinder_half(cylinder), -t * length);
    return endless ? outside : fmax(outside, (t - 1) * length);
}

/* By the axis, or through one of the two places where it crosses the infinite cylinder. */
static double cylinder_beside(const struct lx_shape *cylinder, const double place_mm[3], const double way[3],
                              bool endless)
{
    double from[3], p[3], v[3], cross[3], start, change;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - cylinder->anchor_mm[i];
    lx_cylinder_split(cylinder, from, p, &start);
    lx_cylinder_split(cylinder, way, v, &change);
    for (int i = 0; i < 3; i++)
        cross[i] = p[(i + 1) % 3] * v[(i + 2) % 3] - p[(i + 2) % 3] * v[(i + 1) % 3];
    const double a = lx_dot(v, v), b = lx_dot(p, v), length = sqrt(lx_dot(way, way)),
                 radius = lx_cylinder_radius(cylinder);
    const double moment = lx_dot(cylinder->axis, cross), below = radius * radius * a - moment * moment;
    if (!(a > 1e-30 * length * length))
        return fabs(sqrt(lx_dot(p, p)) - radius);
    const double passes = fabs(moment) / sqrt(a) - radius, root = sqrt(fmax(below, 0));
    const double first = beside_crossing(cylinder, (-b - root) / a, start, change, length, endless);
    const double second = beside_crossing(cylinder, (-b + root) / a, start, change, length, endless);
    return fmax(passes, fmin(first, second));
}

/* The cylinder itself, the two planes of the ways that touch it, and the cones of those past its ends. */
static double cylinder_shadow_edge(const struct lx_shape *cylinder, const struct lx_origin *light, unsigned i,
                                   const double place_mm[3])
{
    double from[3], p[3], v[3], center[3], along, radius = lx_cylinder_radius(cylinder);
    for (int k = 0; k < 3; k++) {
        from[k] = place_mm[k] - cylinder->anchor_mm[k];
        center[k] = cylinder->anchor_mm[k] + (i == 2 ? -1 : 1) * lx_cylinder_half(cylinder) * cylinder->axis[k];
    }
    if (i >= 2)
        return lx_circle_edge(center, cylinder->axis, radius, light, place_mm);
    lx_cylinder_split(cylinder, from, p, &along);
    if (i == 0)
        return lx_dot(p, p) - radius * radius;
    if (light->endless) {
        lx_cylinder_split(cylinder, light->at, v, &along);
        const double touch = lx_dot(p, v), a = lx_dot(v, v);
        return a > 0 ? (lx_dot(p, p) - radius * radius) * a - touch * touch : (double)NAN;
    }
    for (int k = 0; k < 3; k++)
        v[k] = place_mm[k] - light->at[k], from[k] = light->at[k] - cylinder->anchor_mm[k];
    lx_cylinder_split(cylinder, from, p, &along);
    memcpy(from, v, sizeof from);
    lx_cylinder_split(cylinder, from, v, &along);
    const double touch = lx_dot(p, v), outside = lx_dot(p, p) - radius * radius;
    return outside > 0 ? outside * lx_dot(v, v) - touch * touch : (double)NAN;
}

/* Where the two planes of the ways that touch it meet its ends; from within them none touches. */
static bool cylinder_shadow_corner(const struct lx_shape *cylinder, const struct lx_origin *light, unsigned i,
                                   double place_mm[3])
{
    const double radius = lx_cylinder_radius(cylinder);
    double way[3], towards[3], aside[3], along, reach = 0;
    for (int k = 0; k < 3; k++)
        way[k] = light->at[k] - (light->endless ? 0 : cylinder->anchor_mm[k]);
    lx_cylinder_split(cylinder, way, towards, &along);
    const double away = lx_normalize(towards);
    if (!light->endless)
        reach = radius / away;
    if (i > 3 || !(away > 0 && reach < 1))
        return false;
    lx_cross(cylinder->axis, towards, aside);
    for (int k = 0; k < 3; k++)
        place_mm[k] = cylinder->anchor_mm[k] + (i & 1 ? 1 : -1) * lx_cylinder_half(cylinder) * cylinder->axis[k] +
                      radius * (reach * towards[k] + (i & 2 ? 1 : -1) * sqrt(1 - reach * reach) * aside[k]);
    return true;
}

static double cylinder_support(const struct lx_shape *cylinder, const double direction[3], double place[3])
{
    double aside[3], along;
    lx_cylinder_split(cylinder, direction, aside, &along);
    lx_normalize(aside);
    for (int i = 0; i < 3; i++)
        place[i] =
            lx_cylinder_radius(cylinder) * aside[i] + copysign(lx_cylinder_half(cylinder), along) * cylinder->axis[i];
    return 0;
}

static int cylinder_sheets(const struct lx_shape *cylinder, struct lx_smooth_sheet *sheets)
{
    const double half_mm = lx_cylinder_half(cylinder) - cylinder->touch_mm;
    return lx_sheets_of_sectors(cylinder, &lx_tube_sheet, lx_cylinder_radius(cylinder), half_mm, sheets);
}

static const struct lx_surface_bounds cylinder_bounds = {
    .support = cylinder_support,
    .widest_turn = M_PI,
};

static const struct lx_surface_words cylinder_words = {
    .sentence = LX_N("The normal of a cylinder with the centre {0}, the unit vector {1} along its axis and the radius "
                     "{2} there is {3}."),
    .formulas = {"\\mathbf{C}", "\\mathbf{A}", "R",
                 "\\mathbf{N} = (\\mathbf{P} - \\mathbf{C} - ((\\mathbf{P} - \\mathbf{C}) \\cdot \\mathbf{A})\\,"
                 "\\mathbf{A}) / R"},
};

/* What is on the surface, to 1e-9 of its size, is not within. */
static bool cylinder_encloses(const struct lx_shape *cylinder, const double place_mm[3])
{
    const double near = 1e-9 * cylinder->radius_mm;
    double offset[3], aside[3], along;
    for (int i = 0; i < 3; i++)
        offset[i] = place_mm[i] - cylinder->anchor_mm[i];
    lx_cylinder_split(cylinder, offset, aside, &along);
    return fabs(along) < lx_cylinder_half(cylinder) - near &&
           sqrt(lx_dot(aside, aside)) < lx_cylinder_radius(cylinder) - near;
}

static unsigned cylinder_openings(const struct lx_shape *cylinder, struct lx_shape_opening openings[LX_MOST_OPENINGS])
{
    for (int end = 0; end < 2; end++) {
        openings[end] = (struct lx_shape_opening){.radius_mm = lx_cylinder_radius(cylinder)};
        for (int i = 0; i < 3; i++) {
            const double along = (lx_cylinder_half(cylinder) - cylinder->touch_mm) * cylinder->axis[i];
            openings[end].axis[i] = cylinder->axis[i];
            openings[end].center_mm[i] = cylinder->anchor_mm[i] + (end ? along : -along);
        }
    }
    return 2;
}

const struct lx_surface_kind lx_cylinder_kind = {
    .variant =
        {
            .name = "cylinder",
            .meaning = "the side of a cylinder, seen from outside, with open ends",
            .example = "{type: cylinder, center: [0, 0, 1000], radius: 150, height: 500, material: {shininess: 40}}",
            .table = &cylinder_table,
        },
    .extent = cylinder_extent,
    .shape = cylinder_shape,
    .hit = cylinder_hit,
    .normal = cylinder_normal,
    .blocks = cylinder_blocks,
    .holds = cylinder_holds,
    .meets = cylinder_meets,
    .takes = cylinder_takes,
    .farthest = cylinder_farthest,
    .is_dark = cylinder_is_dark,
    .hides = cylinder_hides,
    .gather = cylinder_gather,
    .gather_beside = cylinder_gather_beside,
    .encloses = cylinder_encloses,
    .openings = cylinder_openings,
    .distance = cylinder_distance,
    .beside = cylinder_beside,
    .shadow_edges = 4,
    .shadow_edge = cylinder_shadow_edge,
    .shadow_corner = cylinder_shadow_corner,
    .outline = lx_cylinder_outline,
    .sheets = cylinder_sheets,
    .chart = &lx_cylinder_chart,
    .bounds = &cylinder_bounds,
    .words = &cylinder_words,
};
