/* SPDX-License-Identifier: MIT */
/*
 * Planes of flat surfaces.  With n the axis, c the centre and d the direction of a ray from o, the plane is met at
 * c + q,
 *
 *     q = n x ((o - c) x d) / (n.d),
 *
 * which has no part along a coordinate axis that n stands on and loses no digits for far observers.
 */
#include <math.h>
#include <string.h>

#include "../base/pose.h"
#include "../base/vector.h"
#include "plane.h"

/* Ends of a way that are no farther from the plate than this share of its size and place lie on it. */
static const double TOUCH = 1e-12;

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

lx_bounded3 lx_shape_axis(const struct lx_shape *shape)
{
    return direction_of(shape->axis, shape->axis_error);
}

lx_bounded3 lx_shape_across(const struct lx_shape *shape)
{
    return direction_of(shape->across, shape->across_error);
}

lx_bounded3 lx_shape_upward(const struct lx_shape *shape)
{
    return direction_of(shape->upward, shape->upward_error);
}

void lx_scaled_axis(const double axis[3], double scaled[3])
{
    double scale = lx_scale_for3(lx_exact3(axis));
    for (int i = 0; i < 3; i++)
        scaled[i] = axis[i] * scale;
}

struct lx_shape lx_plane_lay(const double center_mm[3], const double axis[3], const double up[3], double radius_mm)
{
    struct lx_pose pose = lx_pose_of(axis, up);
    struct lx_shape shape = {.type = LX_GENERAL, .radius_mm = radius_mm};
    memcpy(shape.anchor_mm, center_mm, sizeof shape.anchor_mm);
    keep_direction(pose.axis, shape.axis, shape.axis_error);
    keep_direction(pose.across, shape.across, shape.across_error);
    keep_direction(pose.upward, shape.upward, shape.upward_error);
    lx_scaled_axis(axis, shape.normal);
    double away = fabs(center_mm[0]) + fabs(center_mm[1]) + fabs(center_mm[2]);
    shape.touch_mm = TOUCH * (shape.radius_mm + away);
    return shape;
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

/* Component i of a x b, where b is pairs of numbers that are off by `b_error`. */
static struct lx_pair cross_component(int i, const double a[3], const struct lx_pair b[3], const double b_error[3],
                                      double *error)
{
    int j = (i + 1) % 3, k = (i + 2) % 3;
    struct lx_pair component = lx_exact_dot(4, (double[]){a[j], a[j], -a[k], -a[k]},
                                            (double[]){b[k].high, b[k].low, b[j].high, b[j].low}, error);
    *error = (*error + fabs(a[j]) * b_error[k] + fabs(a[k]) * b_error[j]) * LX_BOUND_SLACK;
    return component;
}

/* Where a ray meets the plane, from the centre: n x (from x d) / (n.d). */
static lx_bounded3 meet_plane(const double axis[3], const struct lx_pair from[3], const struct lx_ray *ray,
                              lx_bounded slope)
{
    struct lx_pair moment[3]; /* d x from */
    double errors[3], offset_error;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        moment[i] = cross_component(i, ray->direction, from, ray->origin_error, &errors[i]);
        errors[i] += ray->direction_error[j] * (fabs(from[k].high) + ray->origin_error[k]) +
                     ray->direction_error[k] * (fabs(from[j].high) + ray->origin_error[j]);
    }
    const double most = fmax(fmax(errors[0], errors[1]), errors[2]), moment_error[3] = {most, most, most};
    lx_bounded offset[3];
    for (int i = 0; i < 3; i++) {
        struct lx_pair component = cross_component(i, axis, moment, moment_error, &offset_error);
        offset[i] = lx_negate(lx_div(lx_rounded(component.high, offset_error, 1), slope));
    }
    return (lx_bounded3){offset[0], offset[1], offset[2]};
}

void lx_keep_coordinates(const struct lx_ray *ray, lx_bounded3 *place_mm)
{
    lx_bounded *places[] = {&place_mm->x, &place_mm->y, &place_mm->z};
    for (int i = 0; i < 3; i++)
        if (ray->direction[i] == 0 && ray->direction_error[i] == 0)
            *places[i] = (lx_bounded){ray->origin_mm[i], ray->origin_error[i]};
}

struct lx_hit lx_plane_meet(const struct lx_shape *plane, const struct lx_ray *ray, double offset_mm[3])
{
    double slope_error;
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(ray->origin_mm[i], plane->anchor_mm[i]), offset_mm[i] = 0;
    lx_bounded height = height_over(plane->normal, from);
    struct lx_pair along = lx_exact_dot(3, plane->normal, ray->direction, &slope_error);
    for (int i = 0; i < 3; i++)
        slope_error += fabs(plane->normal[i]) * ray->direction_error[i];
    lx_bounded slope = lx_rounded(along.high, slope_error, 1);
    if (!(height.value > 0 && slope.value < 0))
        return (struct lx_hit){.exists = false};
    lx_bounded3 offset = meet_plane(plane->normal, from, ray, slope);
    offset_mm[0] = offset.x.value, offset_mm[1] = offset.y.value, offset_mm[2] = offset.z.value;
    struct lx_hit hit = {
        .exists = true,
        .t = -height.value / slope.value,
        .place_mm = lx_add3(lx_exact3(plane->anchor_mm), offset),
        .normal = lx_shape_axis(plane),
    };
    lx_keep_coordinates(ray, &hit.place_mm);
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

struct lx_plane_crossing lx_plane_cross(const struct lx_shape *plane, lx_bounded3 place_mm, lx_bounded3 towards,
                                        bool endless)
{
    struct lx_plane_crossing way;
    lx_bounded3 axis = lx_shape_axis(plane);
    way.from = lx_sub3(place_mm, lx_exact3(plane->anchor_mm));
    way.start = lx_dot3(way.from, axis), way.change = lx_dot3(towards, axis);
    lx_bounded end = endless ? way.change : lx_dot3(lx_add3(way.from, towards), axis);
    way.crosses = is_between(way.start, plane->touch_mm, end, endless ? 0 : plane->touch_mm);
    return way;
}

bool lx_plane_holds_opening(const struct lx_shape *plane, const struct lx_shape_opening *opening, double middle_mm[3])
{
    const double near = 1e-9 * (plane->radius_mm + opening->radius_mm);
    for (int i = 0; i < 3; i++)
        middle_mm[i] = opening->center_mm[i] - plane->anchor_mm[i];
    return fabs(lx_dot(middle_mm, plane->axis)) <= near && fabs(lx_dot(opening->axis, plane->axis)) >= 1 - 1e-12;
}

lx_bounded lx_plane_is_within(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded room, double beyond)
{
    const lx_bounded places[3] = {place_mm.x, place_mm.y, place_mm.z};
    bool is_certain = room.value == 0;
    if (room.value < -beyond - room.error)
        return lx_exact(0);
    for (int i = 0; i < 3 && is_certain; i++)
        is_certain = places[i].error == 0 && lx_exact_difference(places[i].value, shape->anchor_mm[i]).low == 0;
    return (lx_bounded){1, is_certain || room.value > room.error ? 0 : 1};
}

double lx_plane_beside(const struct lx_shape *plane, const double place_mm[3], const double way[3], bool endless,
                       double crossing_mm[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - plane->anchor_mm[i];
    double height = lx_dot(from, plane->axis), change = lx_dot(way, plane->axis);
    double end = endless ? change : height + change;
    if (end == 0 || change == 0)
        return plane->radius_mm;
    double above = end > 0 ? height : -height; /* on the side to which the way leads */
    for (int i = 0; i < 3; i++)
        crossing_mm[i] = from[i] - height / change * way[i];
    return above;
}

/* axis . (place - centre), whose sign tells the side. */
static double height_of(const struct lx_shape *plane, const double place_mm[3])
{
    struct lx_pair from[3];
    for (int i = 0; i < 3; i++)
        from[i] = lx_exact_difference(place_mm[i], plane->anchor_mm[i]);
    return height_over(plane->normal, from).value;
}

enum lx_standing lx_plane_standing(const struct lx_shape *plane, double highest_mm, double observer_z_mm,
                                   bool perspective)
{
    if (perspective)
        return height_of(plane, (double[]){0, 0, observer_z_mm}) > 0 ? LX_STANDS_BEFORE : LX_SEES_BACK;
    if (!(plane->normal[2] > 0))
        return LX_SEES_BACK;
    return observer_z_mm > highest_mm ? LX_STANDS_BEFORE : LX_STANDS_TOO_LOW;
}

bool lx_plane_is_dark(const struct lx_shape *plane, const double place_mm[3])
{
    return !(height_of(plane, place_mm) > 0);
}

bool lx_plane_faces(const struct lx_shape *plane, const struct lx_origin *eye)
{
    double way[3];
    lx_way_to(eye, plane->anchor_mm, way);
    return lx_dot(way, plane->axis) > 0;
}

void lx_plane_normal(const struct lx_shape *plane, const double offset_mm[3], double normal[3])
{
    (void)offset_mm;
    memcpy(normal, plane->axis, sizeof plane->axis);
}

/* ---- coordinates ---- */

void lx_plane_locate(const struct lx_shape *plane, const double offset_mm[3], const double normal[3], double at[3])
{
    (void)normal;
    at[0] = lx_dot(offset_mm, plane->across);
    at[1] = lx_dot(offset_mm, plane->upward);
    at[2] = 0;
}

void lx_plane_place(const struct lx_shape *plane, const double at[3], double place_mm[3], double normal[3])
{
    for (int i = 0; i < 3; i++) {
        double offset = at[0] * plane->across[i] + at[1] * plane->upward[i];
        place_mm[i] = plane->anchor_mm[i] + offset;
        normal[i] = plane->axis[i];
    }
}

static lx_bounded coordinate(const struct lx_shape *plane, const double at[3], int i)
{
    lx_bounded across = {plane->across[i], plane->across_error[i]}, upward = {plane->upward[i], plane->upward_error[i]};
    lx_bounded offset = lx_add(lx_mul(across, lx_exact(at[0])), lx_mul(upward, lx_exact(at[1])));
    return lx_add(lx_exact(plane->anchor_mm[i]), offset);
}

void lx_plane_element(const struct lx_shape *plane, const double at[3], lx_bounded3 *place_mm, lx_bounded3 *normal)
{
    *place_mm = (lx_bounded3){coordinate(plane, at, 0), coordinate(plane, at, 1), coordinate(plane, at, 2)};
    *normal = lx_shape_axis(plane);
}

void lx_plane_directions(const struct lx_shape *plane, const double at[3], double first[3], double second[3])
{
    (void)plane, (void)at;
    for (int i = 0; i < 3; i++)
        first[i] = i == 0, second[i] = i == 1;
}

void lx_plane_move(const struct lx_shape *plane, const double at[3], const double first[3], const double second[3],
                   const double step_mm[2], double moved[3])
{
    (void)plane;
    for (int i = 0; i < 3; i++)
        moved[i] = at[i] + (step_mm[0] * first[i] + step_mm[1] * second[i]);
}

void lx_plane_middle(const struct lx_shape *plane, const struct lx_origin *eye, double at[3])
{
    (void)plane, (void)eye;
    at[0] = at[1] = at[2] = 0;
}

/* Where the plane mirrors a light to the observer; false: nowhere. */
static bool find_mirror(const struct lx_shape *plane, const struct lx_origin *light, const struct lx_origin *viewer,
                        double at[3])
{
    double to_light[3], to_eye[3], place[3], normal[3];
    bool far_light = lx_way_to(light, plane->anchor_mm, to_light),
         far_eye = lx_way_to(viewer, plane->anchor_mm, to_eye);
    double light_height = lx_dot(to_light, plane->axis), eye_height = lx_dot(to_eye, plane->axis);
    if (!(light_height > 0 && eye_height > 0) || (far_light && far_eye))
        return false;
    /* from the nearer of the two, against the mirrored direction to the other */
    const double *from = far_light ? to_eye : to_light, *other = far_light ? to_light : to_eye;
    double height = far_light ? eye_height : light_height, other_height = far_light ? light_height : eye_height;
    for (int i = 0; i < 3; i++) {
        double mirrored = 2 * other_height * plane->axis[i] - other[i]; /* of a direction, or of a place */
        double share = far_light || far_eye ? height / other_height : height / (height + other_height);
        place[i] = far_light || far_eye ? from[i] - share * mirrored
                                        : from[i] + share * (other[i] - 2 * other_height * plane->axis[i] - from[i]);
    }
    lx_plane_normal(plane, place, normal);
    lx_plane_locate(plane, place, normal, at);
    return true;
}

int lx_plane_guess(const struct lx_shape *plane, const struct lx_origin *light, const struct lx_origin *viewer,
                   bool for_least, double at[LX_MOST_GUESSES][3])
{
    double way[3];
    int count = 0;
    (void)for_least;
    if (!lx_way_to(light, plane->anchor_mm, way))
        lx_plane_locate(plane, way, plane->axis, at[count++]);
    return count + find_mirror(plane, light, viewer, at[count]);
}

double lx_plane_least_cosine(const struct lx_shape *plane, const double towards[3], double away)
{
    double height = lx_dot(towards, plane->axis);
    if (!(away > 0))
        return height;
    return height > 0 ? height / (away + plane->radius_mm) : -1;
}

double lx_plane_curvature(const struct lx_shape *plane)
{
    (void)plane;
    return 0;
}

/* Light this near to the plane of a circle, as an angle, counts as in it. */
static const double IN_PLANE = 1e-9;

double lx_circle_edge(const double center_mm[3], const double axis[3], double radius_mm, const struct lx_origin *light,
                      const double place_mm[3])
{
    double from[3], way[3], offset[3];
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - center_mm[i];
    if (light->endless) {
        memcpy(way, light->at, sizeof way);
    } else {
        for (int i = 0; i < 3; i++) { /* the way begins at the light, so that its start does not vary */
            way[i] = place_mm[i] - light->at[i];
            from[i] = light->at[i] - center_mm[i];
        }
    }
    const double height = lx_dot(axis, from), change = lx_dot(axis, way);
    if (light->endless ? fabs(change) <= IN_PLANE : fabs(height) <= IN_PLANE * sqrt(lx_dot(from, from)))
        return light->endless ? height : change; /* the cone is flat: its square would have no crossings */
    for (int i = 0; i < 3; i++)
        offset[i] = from[i] * change - way[i] * height;
    return lx_dot(offset, offset) - radius_mm * radius_mm * change * change;
}
