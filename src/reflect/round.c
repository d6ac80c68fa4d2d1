/* SPDX-License-Identifier: MIT */
/*
 * Occluder cones of what is round.  A ball or a tube that stands apart hides what is in the cone of the ways that touch
 * it, beyond where they do; where a face reaches into it, what is inside is hidden, too.
 */
#include "round.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

/* Corners of what stands for a circle. */
enum { MOST_ROUND = 40 };

static void sub(const double a[3], const double b[3], double difference[3])
{
    for (int i = 0; i < 3; i++)
        difference[i] = a[i] - b[i];
}

/* How many corners stand for a circle that is seen under a half angle of this sine. */
static int round_corners(double sine)
{
    return sine < 0.5 ? 16 : sine < 0.8 ? 24 : MOST_ROUND;
}

static void corners_around(const double center_mm[3], const double first[3], const double second[3], double radius_mm,
                           int count, double corners[MOST_ROUND][3])
{
    const double step = 2 * M_PI / count;
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            corners[k][i] = center_mm[i] + radius_mm * (cos(k * step) * first[i] + sin(k * step) * second[i]);
}

/* A circle as a polygon of as much area. */
void lx_occluder_cones_disk(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *disk)
{
    const double height = lx_occluder_cones_height(cones, disk->axis, disk->center_mm), radius = disk->half_mm[0];
    double from[3], corners[MOST_ROUND][3];
    if (disk->half_mm[1] > 0) {
        lx_occluder_cones_shape(cones, shape); /* a hole makes it hollow */
        return;
    }
    if (fabs(height) <= cones->touch_mm)
        return;
    sub(cones->place_mm, disk->center_mm, from);
    const int count = round_corners(radius / hypot(radius, sqrt(lx_dot(from, from))));
    const double step = 2 * M_PI / count;
    corners_around(disk->center_mm, disk->across, disk->upward, radius * sqrt(step / sin(step)), count, corners);
    lx_occluder_cones_polygon(cones, (const double(*)[3])corners, count, disk->axis, disk->center_mm, height);
}

/* A cone of all that is in a prism around a circle, of as much area. */
static void add_prism(struct lx_occluder_cones *cones, const double center_mm[3], const double first[3],
                      const double second[3], double radius_mm)
{
    const double step = 2 * M_PI / MOST_ROUND, reach = radius_mm * sqrt(step / sin(step));
    double corners[MOST_ROUND][3];
    corners_around(center_mm, first, second, reach, MOST_ROUND, corners);
    lx_occluder_cones_begin(cones);
    for (int k = 0; k < MOST_ROUND; k++) {
        double inwards[3];
        for (int i = 0; i < 3; i++)
            inwards[i] = 2 * center_mm[i] - corners[k][i] - corners[(k + 1) % MOST_ROUND][i];
        lx_occluder_cones_plane(cones, inwards, corners[k]);
    }
}

/* ---- balls ---- */

/* Whether some of a face is in a ball, as far as balls around faces tell. */
static bool enters_ball(const struct lx_matte_face *face, const struct lx_smooth_sheet *ball)
{
    const double radius = ball->half_mm[0] * (1 - 1e-9);
    double from[3];
    sub(ball->center_mm, face->center_mm, from);
    return sqrt(lx_dot(from, from)) < radius + face->radius_mm &&
           lx_sheet_distance(&face->sheet, ball->center_mm) < radius;
}

static void add_ball(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *ball)
{
    lx_occluder_cones_begin(cones);
    if (cones->failed)
        return;
    struct lx_occluder_cone *cone = &cones->items[cones->count - 1];
    cone->is_ball = true;
    memcpy(cone->center_mm, ball->center_mm, sizeof cone->center_mm);
    cone->radius_mm = ball->half_mm[0];
}

/* The circle in which a ball cuts the plane of a flat face. */
static void add_section(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *ball,
                        const struct lx_smooth_sheet *face)
{
    double from[3], middle[3];
    sub(ball->center_mm, face->center_mm, from);
    const double height = lx_dot(from, face->axis);
    for (int i = 0; i < 3; i++)
        middle[i] = ball->center_mm[i] - height * face->axis[i];
    add_prism(cones, middle, face->across, face->upward,
              sqrt(fmax(ball->half_mm[0] * ball->half_mm[0] - height * height, 0)));
}

/*
 * The tangent of the half angle at which the corners of a pyramid are that takes as much of the view as a cone of
 * cosine c.  Each of its spherical triangles has two such sides b; tan(area/2) = t sin(step) / (1 + t cos(step)) with
 * t = tan^2(b/2).
 */
static double tangent_of_corners(double c, int count)
{
    const double step = 2 * M_PI / count, half = tan(M_PI * (1 - c) / count);
    const double t = fmin(half / (sin(step) - half * cos(step)), 0.999); /* a cone may be almost half of the view */
    return 2 * sqrt(t) / (1 - t);
}

bool lx_occluder_cones_ball(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *ball, const struct lx_matte_face *face)
{
    const double radius = ball->half_mm[0];
    double way[3], first[3], second[3], middle[3], corners[MOST_ROUND][3];
    if (ball->turn < 0) {
        lx_occluder_cones_shape(cones, shape); /* it is hollow */
        return true;
    }
    sub(ball->center_mm, cones->place_mm, way);
    const double away = lx_normalize(way), share = radius / away, below = 1 - share * share;
    if (!(below > 1e-12)) /* the place is inside */
        return false;
    if (enters_ball(face, ball)) {
        if (!face->is_flat) {
            add_ball(cones, ball);
            return true;
        }
        add_section(cones, ball, &face->sheet);
    }
    for (int i = 0; i < 3; i++)
        middle[i] = cones->place_mm[i] + away * below * way[i];
    lx_around_axis(way, first, second);
    const int count = round_corners(share);
    corners_around(middle, first, second, away * below * tangent_of_corners(sqrt(below), count), count, corners);
    lx_occluder_cones_polygon(cones, (const double(*)[3])corners, count, way, middle, -1);
    return true;
}

/* ---- tubes ---- */

/* How far the axis of a tube is from a face, at least: from the polygon that it makes along the axis, or from the ball
 * around it. */
static double distance_of_axis(const struct lx_matte_face *face, const struct lx_smooth_sheet *tube)
{
    double corners[4][3], at[4][2], from[3], nearest = HUGE_VAL;
    bool left = false, right = false;
    if (!lx_is_polygon(face)) {
        sub(face->center_mm, tube->center_mm, from);
        return hypot(lx_dot(from, tube->across), lx_dot(from, tube->upward)) - face->radius_mm;
    }
    const int count = lx_sheet_corners(&face->sheet, corners);
    for (int c = 0; c < count; c++) {
        sub(corners[c], tube->center_mm, from);
        at[c][0] = lx_dot(from, tube->across);
        at[c][1] = lx_dot(from, tube->upward);
    }
    for (int c = 0; c < count; c++) {
        const double *a = at[c], *b = at[(c + 1) % count], x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
        const double share = square > 0 ? fmin(fmax(-(a[0] * x + a[1] * y) / square, 0), 1) : 0;
        const double side = a[0] * y - a[1] * x;
        nearest = fmin(nearest, hypot(a[0] + share * x, a[1] + share * y));
        left = left || side > 0;
        right = right || side < 0;
    }
    return left && right ? nearest : 0;
}

/* Whether the place and all of a face are between the planes of both ends of a tube. */
static bool is_between_ends(const struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube,
                            const struct lx_matte_face *face)
{
    const double back[3] = {-tube->axis[0], -tube->axis[1], -tube->axis[2]}, most = tube->half_mm[1] + cones->touch_mm;
    return fabs(lx_occluder_cones_height(cones, tube->axis, tube->center_mm)) <= most &&
           lx_face_reach(face, tube->axis, tube->center_mm) <= most &&
           lx_face_reach(face, back, tube->center_mm) <= most;
}

/* Where a tube stands: what is before it is seen, what is behind it is hidden; BESIDE, it hides nothing. */
enum stand { BEFORE_FACE, BESIDE, ACROSS };

/* By a plane across a unit direction, which has the tube on this side and the face on the other, if there is one. */
static bool is_parted(const struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube,
                      const struct lx_matte_face *face, const double n[3], enum stand *stand)
{
    const double back[3] = {-n[0], -n[1], -n[2]}, along = fmin(fabs(lx_dot(n, tube->axis)), 1);
    const double nearest = -lx_face_reach(face, back, tube->center_mm);
    const double reach = tube->half_mm[1] * along + tube->half_mm[0] * sqrt(1 - along * along);
    if (!(reach <= nearest + cones->touch_mm))
        return false;
    *stand = lx_occluder_cones_height(cones, n, tube->center_mm) <= nearest ? BEFORE_FACE : BESIDE;
    return true;
}

static enum stand stand_of(const struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube,
                           const struct lx_matte_face *face)
{
    const double *middle = face->is_flat ? face->sheet.center_mm : face->center_mm;
    double ways[6][3];
    enum stand stand;
    sub(middle, tube->center_mm, ways[0]);
    sub(tube->center_mm, cones->place_mm, ways[1]);
    const double aside[2] = {lx_dot(ways[0], tube->axis), lx_dot(ways[1], tube->axis)};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 2; k++) /* across the axis */
            ways[k][i] -= aside[k] * tube->axis[i];
        for (int k = 0; k < 2; k++) {
            ways[2 + k][i] = k ? -tube->axis[i] : tube->axis[i];
            ways[4 + k][i] = (k ? -1 : 1) * (face->is_flat ? face->sheet.axis[i] : tube->axis[i]);
        }
    }
    for (int k = 5; k >= 0; k--)
        if (lx_normalize(ways[k]) > 0 && is_parted(cones, tube, face, ways[k], &stand))
            return stand;
    return ACROSS;
}

/* The outline of a tube that is seen from outside: corners, in their order. */
struct tube_outline {
    double corners[2 * (MOST_ROUND + 2)][3];
    int count;
};

/*
 * Adds the end of a tube from one generator that is seen edge-on to the other, at angles from the direction to the
 * place; corners between them lie so far out that the sector is as large as that of the circle.
 */
static void add_end(struct tube_outline *outline, const double center_mm[3], const double out[3], const double aside[3],
                    double radius, double from, double to, int count)
{
    const double step = (to - from) / count, s = sin(fabs(step));
    const double beyond = fabs(to - from) / (s + sqrt(s * s + (count - 2) * s * fabs(to - from)));
    for (int k = 0; k <= count; k++) {
        const double t = from + k * step, reach = radius * (k == 0 || k == count ? 1 : beyond);
        for (int i = 0; i < 3; i++)
            outline->corners[outline->count][i] = center_mm[i] + reach * (cos(t) * out[i] + sin(t) * aside[i]);
        outline->count++;
    }
}

/* The cone behind a tube whose outline is convex as the place sees it, which is outside of it: of a face that is all
 * behind it.  False: something is seen through it. */
static bool add_outline(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube, const double out[3],
                        double away, double height)
{
    const double radius = tube->half_mm[0], half = tube->half_mm[1];
    const double near = fabs(height) - half, share = near / (fabs(height) + half), seen = acos(radius / away);
    struct tube_outline outline = {.count = 0};
    double aside[3], from[3], to[3], middle[3], edge[3];
    if (near > 0 && away * (1 - share) < radius * (1 + share))
        return false;
    lx_cross(tube->axis, out, aside);
    sub(tube->center_mm, cones->place_mm, middle);
    const int corners = round_corners(fmin(radius / hypot(away, fmax(near, 0)), 1));
    for (int sign = 1; sign >= -1; sign -= 2) {
        const double below = half - sign * height; /* of the place, under the plane of this end */
        const double to_angle = below > 0 ? -seen : 2 * M_PI - seen, turn = fabs(to_angle - seen);
        const bool is_edge_on = fabs(below) <= 1e-9 * radius;
        double end[3];
        for (int i = 0; i < 3; i++)
            end[i] = tube->center_mm[i] + sign * half * tube->axis[i];
        add_end(&outline, end, out, aside, radius, sign * seen, sign * to_angle,
                is_edge_on ? 1 : (int)fmax(ceil(corners * turn / (2 * M_PI)), 2));
    }
    lx_occluder_cones_begin(cones);
    for (int k = 0; k < outline.count; k++) {
        sub(outline.corners[k], cones->place_mm, from);
        sub(outline.corners[(k + 1) % outline.count], cones->place_mm, to);
        lx_cross(from, to, edge);
        const double sign = lx_dot(edge, middle) < 0 ? -1 : 1;
        for (int i = 0; i < 3; i++)
            edge[i] *= sign;
        lx_occluder_cones_plane(cones, edge, cones->place_mm);
    }
    return true;
}

/* Half-spaces beyond the edges of a polygon that stands for the end of a tube: nothing is seen but through that. */
static void look_through(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube, int sign)
{
    double end[3], from[3], to[3], middle[3], beyond[3], corners[MOST_ROUND][3];
    for (int i = 0; i < 3; i++)
        end[i] = tube->center_mm[i] + sign * tube->half_mm[1] * tube->axis[i];
    sub(end, cones->place_mm, middle);
    const double radius = tube->half_mm[0];
    const int count = round_corners(radius / hypot(radius, sqrt(lx_dot(middle, middle))));
    const double step = 2 * M_PI / count;
    corners_around(end, tube->across, tube->upward, radius * sqrt(step / sin(step)), count, corners);
    for (int k = 0; k < count; k++) {
        sub(corners[k], cones->place_mm, from);
        sub(corners[(k + 1) % count], cones->place_mm, to);
        lx_cross(from, to, beyond);
        const double inwards = lx_dot(beyond, middle) < 0 ? 1 : -1;
        for (int i = 0; i < 3; i++)
            beyond[i] *= inwards;
        lx_occluder_cones_begin(cones);
        lx_occluder_cones_plane(cones, beyond, cones->place_mm);
    }
}

/* Whether a face is the inner side of a tube. */
static bool is_inside_of(const struct lx_matte_face *face, const struct lx_smooth_sheet *tube)
{
    const struct lx_smooth_sheet *sheet = &face->sheet;
    return sheet->type->has_ends && sheet->turn < 0 &&
           memcmp(sheet->center_mm, tube->center_mm, sizeof sheet->center_mm) == 0 &&
           memcmp(sheet->axis, tube->axis, sizeof sheet->axis) == 0 &&
           memcmp(sheet->half_mm, tube->half_mm, sizeof sheet->half_mm) == 0;
}

/* The inner side of a tube, of which a place beyond an end sees what is behind that, one within or on it all; false:
 * nothing. */
static bool look_inside(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube, bool is_within,
                        double height)
{
    if (fabs(height) > tube->half_mm[1] + cones->touch_mm)
        look_through(cones, tube, height > 0 ? 1 : -1);
    else
        return is_within;
    return true;
}

/* From inside of a tube a face that is outside is seen through an end; *seen: at all.  False: by both ends, perhaps. */
static bool look_outside(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *tube,
                         const struct lx_matte_face *face, bool *seen)
{
    const double back[3] = {-tube->axis[0], -tube->axis[1], -tube->axis[2]}, half = tube->half_mm[1];
    const double highest = lx_face_reach(face, tube->axis, tube->center_mm);
    const double lowest = -lx_face_reach(face, back, tube->center_mm);
    const double height = lx_occluder_cones_height(cones, tube->axis, tube->center_mm);
    const double end = half - cones->touch_mm; /* a face may lie in the plane of an end */
    if (!(fabs(height) < end) || (highest > end && lowest < -end))
        return false;
    *seen = highest > end || lowest < -end;
    if (*seen)
        look_through(cones, tube, highest > end ? 1 : -1);
    return true;
}

/* Between its ends a tube is as good as one without end: two planes touch it.  Before a face it is its outline. */
bool lx_occluder_cones_tube(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *tube, const struct lx_matte_face *face)
{
    const double radius = tube->half_mm[0];
    double from[3], inwards[3], aside[3], edge[3], chord[3];
    sub(cones->place_mm, tube->center_mm, from);
    const double x = lx_dot(from, tube->across), y = lx_dot(from, tube->upward), away = hypot(x, y);
    const bool is_outside = away > radius * (1 + 1e-9);
    const double outwards = x * lx_dot(cones->normal, tube->across) + y * lx_dot(cones->normal, tube->upward);
    const bool is_within = away < radius * (1 - 1e-9) || (!is_outside && outwards < 0); /* on the wall by its normal */
    if (is_inside_of(face, tube))
        return look_inside(cones, tube, is_within, lx_dot(from, tube->axis));
    const enum stand stand = stand_of(cones, tube, face);
    bool seen;
    if (stand == BESIDE)
        return true;
    if (stand == BEFORE_FACE && is_within && look_outside(cones, tube, face, &seen))
        return seen;
    for (int i = 0; i < 3; i++)
        inwards[i] = -(x * tube->across[i] + y * tube->upward[i]) / away;
    const double out[3] = {-inwards[0], -inwards[1], -inwards[2]};
    if (stand == BEFORE_FACE && is_outside && !is_between_ends(cones, tube, face) &&
        add_outline(cones, tube, out, away, lx_dot(from, tube->axis)))
        return true;
    const bool is_entered = distance_of_axis(face, tube) < radius * (1 - 1e-9);
    if (!is_between_ends(cones, tube, face) || (is_entered && !(is_outside && face->is_flat))) {
        lx_occluder_cones_shape(cones, shape);
        return true;
    }
    if (!is_outside)
        return false;
    const double sine = radius / away, cosine = sqrt(1 - sine * sine);
    for (int i = 0; i < 3; i++)
        chord[i] = tube->center_mm[i] - radius * sine * inwards[i];
    lx_cross(tube->axis, inwards, aside);
    lx_occluder_cones_begin(cones);
    lx_occluder_cones_plane(cones, inwards, chord);
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < 3; i++)
            edge[i] = sine * inwards[i] + side * cosine * aside[i];
        lx_occluder_cones_plane(cones, edge, cones->place_mm);
    }
    if (is_entered)
        add_prism(cones, tube->center_mm, tube->across, tube->upward, radius);
    return true;
}
