/* SPDX-License-Identifier: MIT */
/*
 * The rectangle, a plate that is seen from its front and takes light away from both sides: its parameters, extent,
 * and float64 reference.  The kernels of the shade room hold the same formulas for blocks of rays.
 *
 * With n the axis, c the centre and d the direction of a ray from o, the plane is met at c + q,
 *
 *     q = n x ((o - c) x d) / (n.d),
 *
 * which has no part along a coordinate axis that n stands on and loses no digits for far observers.
 */
#include <math.h>
#include <string.h>

#include "../base/pose.h"
#include "../parameter/check.h"
#include "surface.h"

static const struct lx_parameter plate_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct lx_plate_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the centre of the rectangle lies: x to the right, y up, z towards the observer",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct lx_plate_parameters, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .meaning = "the width of the rectangle and its height, which runs along up",
    },
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct lx_plate_parameters, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 0, 1]",
        .meaning = "the direction to which the front of the rectangle looks, of any length",
    },
    {
        .name = "up",
        .label = "Up direction",
        .type = LX_REALS,
        .offset = offsetof(struct lx_plate_parameters, up),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning = "the direction along which the height runs, made perpendicular to axis; where it is not given and "
                   "the axis runs along y, (0, 0, 1)",
    },
};

static void check_plate(const struct lx_check *check, void *parameters)
{
    const struct lx_plate_parameters *plate = parameters;
    lx_check_pose(check, plate->axis, plate->up);
}

static const struct lx_table plate_table = {
    .parameters = plate_parameters,
    .count = LX_COUNT(plate_parameters),
    .size = sizeof(struct lx_plate_parameters),
    .check = check_plate,
};

/* Ends of a way that are no farther from the plate than this share of its size and place lie on it. */
static const double TOUCH = 1e-12;

static struct lx_pose pose_of(const struct lx_plate_parameters *plate)
{
    double up[3];
    if (lx_is_given(&plate_table, plate, "up"))
        memcpy(up, plate->up, sizeof up);
    else
        lx_usual_up(plate->axis, up);
    return lx_pose_of(plate->axis, up);
}

/* A unit direction as the shape keeps it, and back. */
static void keep_direction(lx_wide3 direction, double value[3], double error[3])
{
    lx_bounded3 rounded = lx_wide3_direction(direction);
    value[0] = rounded.x.value, value[1] = rounded.y.value, value[2] = rounded.z.value;
    error[0] = rounded.x.error, error[1] = rounded.y.error, error[2] = rounded.z.error;
}

static lx_bounded3 direction_of(const double value[3], const double error[3])
{
    return (lx_bounded3){{value[0], error[0]}, {value[1], error[1]}, {value[2], error[2]}};
}

/* The axis at a length near 1, without rounding. */
static void scaled_axis(const struct lx_plate_parameters *plate, double axis[3])
{
    double scale = lx_scale_for3(lx_exact3(plate->axis));
    for (int i = 0; i < 3; i++)
        axis[i] = plate->axis[i] * scale;
}

static struct lx_shape plate_shape(const void *parameters)
{
    const struct lx_plate_parameters *plate = parameters;
    struct lx_pose pose = pose_of(plate);
    struct lx_shape shape = {.type = LX_PLATE};
    memcpy(shape.anchor_mm, plate->center_mm, sizeof shape.anchor_mm);
    keep_direction(pose.axis, shape.axis, shape.axis_error);
    keep_direction(pose.across, shape.across, shape.across_error);
    keep_direction(pose.upward, shape.upward, shape.upward_error);
    scaled_axis(plate, shape.normal);
    shape.radius_mm = hypot(plate->size_mm[0], plate->size_mm[1]) / 2;
    double away = fabs(plate->center_mm[0]) + fabs(plate->center_mm[1]) + fabs(plate->center_mm[2]);
    shape.touch_mm = TOUCH * (shape.radius_mm + away);
    /* The edges belong to the plate: what rounding cannot tell from them does, too. */
    for (int i = 0; i < 2; i++)
        shape.half_mm[i] = plate->size_mm[i] / 2 + shape.touch_mm;
    return shape;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double plate_farthest(const void *parameters, const double direction[3])
{
    const struct lx_plate_parameters *plate = parameters;
    struct lx_shape shape = plate_shape(parameters);
    return dot(direction, plate->center_mm) + plate->size_mm[0] / 2 * fabs(dot(direction, shape.across)) +
           plate->size_mm[1] / 2 * fabs(dot(direction, shape.upward));
}

static void plate_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct lx_plate_parameters *plate = parameters;
    struct lx_shape shape = plate_shape(parameters);
    for (int i = 0; i < 3; i++) {
        double half = plate->size_mm[0] / 2 * fabs(shape.across[i]) + plate->size_mm[1] / 2 * fabs(shape.upward[i]);
        low_mm[i] = plate->center_mm[i] - half;
        high_mm[i] = plate->center_mm[i] + half;
    }
}

/* axis . from, from the centre, in twice the precision: which side a place lies on */
static lx_bounded height_over(const double axis[3], const struct lx_pair from[3])
{
    double error;
    struct lx_pair height = lx_exact_dot(
        6, (double[]){axis[0], axis[1], axis[2], axis[0], axis[1], axis[2]},
        (double[]){from[0].high, from[1].high, from[2].high, from[0].low, from[1].low, from[2].low}, &error);
    return lx_rounded(height.high, error, 1);
}

/* Component i of a x b, where b is a pair of numbers off by `b_error` each. */
static struct lx_pair cross_component(int i, const double a[3], const struct lx_pair b[3], double b_error,
                                      double *error)
{
    int j = (i + 1) % 3, k = (i + 2) % 3;
    struct lx_pair component = lx_exact_dot(4, (double[]){a[j], a[j], -a[k], -a[k]},
                                            (double[]){b[k].high, b[k].low, b[j].high, b[j].low}, error);
    *error = (*error + (fabs(a[j]) + fabs(a[k])) * b_error) * LX_BOUND_SLACK;
    return component;
}

/* Where a ray meets the plane, from the centre: n x (from x d) / (n.d). */
static lx_bounded3 meet_plane(const double axis[3], const struct lx_pair from[3], const double direction[3],
                              lx_bounded slope)
{
    struct lx_pair moment[3]; /* d x from */
    double errors[3], offset_error;
    for (int i = 0; i < 3; i++)
        moment[i] = cross_component(i, direction, from, 0, &errors[i]);
    double moment_error = fmax(fmax(errors[0], errors[1]), errors[2]);
    lx_bounded offset[3];
    for (int i = 0; i < 3; i++) {
        struct lx_pair component = cross_component(i, axis, moment, moment_error, &offset_error);
        offset[i] = lx_negate(lx_div(lx_rounded(component.high, offset_error, 1), slope));
    }
    return (lx_bounded3){offset[0], offset[1], offset[2]};
}

static struct lx_hit plate_hit(const struct lx_shape *plate, const struct lx_ray *ray)
{
    double slope_error;
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(ray->origin_mm[i], plate->anchor_mm[i]);
    lx_bounded height = height_over(plate->normal, from);
    struct lx_pair along = lx_exact_dot(3, plate->normal, ray->direction, &slope_error);
    lx_bounded slope = lx_rounded(along.high, slope_error, 1);
    if (!(height.value > 0 && slope.value < 0))
        return (struct lx_hit){.exists = false};

    lx_bounded3 offset = meet_plane(plate->normal, from, ray->direction, slope);
    double place[3] = {offset.x.value, offset.y.value, offset.z.value};
    if (!(fabs(dot(place, plate->across)) <= plate->half_mm[0] && fabs(dot(place, plate->upward)) <= plate->half_mm[1]))
        return (struct lx_hit){.exists = false};

    struct lx_hit hit = {
        .exists = true,
        .t = -height.value / slope.value,
        .place_mm = lx_add3(lx_exact3(plate->anchor_mm), offset),
        .normal = direction_of(plate->axis, plate->axis_error),
    };
    /* along the coordinates that a line of sight keeps nothing is rounded */
    lx_bounded *places[] = {&hit.place_mm.x, &hit.place_mm.y, &hit.place_mm.z};
    for (int i = 0; i < 3; i++)
        if (ray->direction[i] == 0)
            *places[i] = lx_exact(ray->origin_mm[i]);
    return hit;
}

/* Whether heights lie on different sides, each beyond what counts as on the plate itself. */
static lx_bounded is_between(lx_bounded a, double a_touch, lx_bounded b, double b_touch)
{
    lx_bounded least_a = lx_exact(a_touch), least_b = lx_exact(b_touch);
    lx_bounded down = lx_both(lx_step(lx_sub(a, least_a), false), lx_step(lx_sub(lx_negate(b), least_b), false));
    lx_bounded up = lx_both(lx_step(lx_sub(lx_negate(a), least_a), false), lx_step(lx_sub(b, least_b), false));
    return lx_not(lx_both(lx_not(down), lx_not(up)));
}

static lx_bounded absolute(lx_bounded a)
{
    return (lx_bounded){fabs(a.value), a.error};
}

/*
 * A way from the height a, which changes by b over the whole way, crosses the plane after the share -a/b of it.  There
 * its offset along an edge is u - a/b v, u that of its start and v its change; it is compared with half the edge
 * without the division.  A way without end goes to the other side where b points there.
 */
static lx_bounded plate_blocks(const struct lx_shape *plate, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    lx_bounded3 axis = direction_of(plate->axis, plate->axis_error);
    lx_bounded3 from = lx_sub3(place_mm, lx_exact3(plate->anchor_mm));
    lx_bounded start = lx_dot3(from, axis), change = lx_dot3(towards, axis);
    lx_bounded end = endless ? change : lx_dot3(lx_add3(from, towards), axis);
    lx_bounded blocked = is_between(start, plate->touch_mm, end, endless ? 0 : plate->touch_mm);
    const lx_bounded3 edges[2] = {direction_of(plate->across, plate->across_error),
                                  direction_of(plate->upward, plate->upward_error)};
    for (int i = 0; i < 2 && !lx_is_zero(blocked); i++) {
        lx_bounded offset = lx_sub(lx_mul(lx_dot3(from, edges[i]), change), lx_mul(start, lx_dot3(towards, edges[i])));
        lx_bounded half = lx_mul(lx_exact(plate->half_mm[i]), absolute(change));
        blocked = lx_both(blocked, lx_step(lx_sub(half, absolute(offset)), true));
    }
    return blocked;
}

static bool plate_holds(const struct lx_shape *plate, const double place_mm[3])
{
    double from[3], near = 1e-9 * plate->radius_mm;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - plate->anchor_mm[i];
    return fabs(dot(from, plate->axis)) <= near && fabs(dot(from, plate->across)) <= plate->half_mm[0] + near &&
           fabs(dot(from, plate->upward)) <= plate->half_mm[1] + near;
}

/* axis . (place - centre), whose sign tells the side */
static double height_of(const struct lx_plate_parameters *plate, const double place_mm[3])
{
    double axis[3];
    struct lx_pair from[3];
    scaled_axis(plate, axis);
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(place_mm[i], plate->center_mm[i]);
    return height_over(axis, from).value;
}

static enum lx_standing plate_standing(const void *parameters, double observer_z_mm, bool perspective)
{
    const struct lx_plate_parameters *plate = parameters;
    if (perspective)
        return height_of(plate, (double[]){0, 0, observer_z_mm}) > 0 ? LX_STANDS_BEFORE : LX_STANDS_BEHIND;
    if (!(plate->axis[2] > 0))
        return LX_TURNED_AWAY;
    double low[3], high[3];
    plate_extent(parameters, low, high);
    return observer_z_mm > high[2] ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
}

static bool plate_is_dark(const void *parameters, const double place_mm[3])
{
    return !(height_of(parameters, place_mm) > 0);
}

const struct lx_surface_kind lx_plate_kind = {
    .variant =
        {
            .name = "rectangle",
            .meaning = "a flat rectangle, seen from its front only",
            .example = "{type: rectangle, center: [0, 0, 0], size: [600, 400], material: {diffuse: 0.7, specular: 0}}",
            .table = &plate_table,
        },
    .extent = plate_extent,
    .farthest = plate_farthest,
    .shape = plate_shape,
    .hit = plate_hit,
    .blocks = plate_blocks,
    .holds = plate_holds,
    .standing = plate_standing,
    .is_dark = plate_is_dark,
};
