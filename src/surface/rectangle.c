/* SPDX-License-Identifier: MIT */
/*
 * The rectangle, a plate that is seen from its front and takes light away from both sides: its parameters, and where
 * its plane (plane.h) ends.  The kernels of the shade room hold the same formulas for blocks of rays.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/pose.h"
#include "../base/vector.h"
#include "../parameter/check.h"
#include "authored.h"
#include "plane.h"
#include "sheet.h"

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
    {
        .name = "mirror",
        .label = "Mirror",
        .type = LX_BOOLEAN,
        .offset = offsetof(struct lx_plate_parameters, mirror),
        .initial = "false",
        .meaning = "whether its front is a mirror, whatever its material: lamps' images in it light what it faces, and "
                   "it shows what sights that it mirrors meet; of walls the material has this key",
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

static struct lx_shape plate_shape(const void *parameters)
{
    const struct lx_plate_parameters *plate = parameters;
    double up[3];
    if (lx_is_given(&plate_table, plate, "up"))
        memcpy(up, plate->up, sizeof up);
    else
        lx_usual_up(plate->axis, up);
    struct lx_shape shape =
        lx_plane_lay(plate->center_mm, plate->axis, up, hypot(plate->size_mm[0], plate->size_mm[1]) / 2);
    shape.type = LX_PLATE;
    /* The edges belong to the plate: what rounding cannot tell from them does, too. */
    for (int i = 0; i < 2; i++)
        shape.half_mm[i] = plate->size_mm[i] / 2 + shape.touch_mm;
    return shape;
}

static bool plate_is_mirror(const void *parameters)
{
    return ((const struct lx_plate_parameters *)parameters)->mirror;
}

static double plate_farthest(const void *parameters, const double direction[3])
{
    const struct lx_plate_parameters *plate = parameters;
    struct lx_shape shape = plate_shape(parameters);
    return lx_dot(direction, plate->center_mm) + plate->size_mm[0] / 2 * fabs(lx_dot(direction, shape.across)) +
           plate->size_mm[1] / 2 * fabs(lx_dot(direction, shape.upward));
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

static struct lx_hit plate_hit(const struct lx_shape *plate, const struct lx_ray *ray)
{
    double place[3];
    const struct lx_hit hit = lx_plane_meet(plate, ray, place);
    const bool is_on_it = fabs(lx_dot(place, plate->across)) <= plate->half_mm[0] &&
                          fabs(lx_dot(place, plate->upward)) <= plate->half_mm[1];
    return hit.exists && is_on_it ? hit : (struct lx_hit){.exists = false};
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
static lx_bounded plate_blocks(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    const struct lx_shape moved = lx_shape_in_the_way(shape), *plate = &moved;
    const struct lx_plane_crossing way = lx_plane_cross(plate, place_mm, towards, endless);
    const lx_bounded3 edges[2] = {lx_shape_across(plate), lx_shape_upward(plate)};
    lx_bounded blocked = way.crosses;
    for (int i = 0; i < 2 && !lx_is_zero(blocked); i++) {
        lx_bounded offset =
            lx_sub(lx_mul(lx_dot3(way.from, edges[i]), way.change), lx_mul(way.start, lx_dot3(towards, edges[i])));
        const bool is_wall = shape->behind_mm > 0; /* beyond whose edges others stand */
        const double half_mm = plate->half_mm[i] - (is_wall ? 0 : plate->touch_mm);
        const lx_bounded change = absolute(way.change), half = lx_mul(lx_exact(half_mm), change);
        const double beyond = is_wall ? 0 : plate->touch_mm * change.value;
        blocked = lx_both(blocked, lx_plane_is_within(plate, place_mm, lx_sub(half, absolute(offset)), beyond));
    }
    return blocked;
}

/* Its true size: obstacles are cut out of light, and have no need of room for rounding at their edges. */
static int plate_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    const struct lx_shape moved = lx_shape_in_the_way(shape), *plate = &moved;
    struct lx_obstacle polygon = {.type = LX_OBSTACLE_POLYGON, .corner_count = 4, .touch_mm = plate->touch_mm};
    const double width = plate->half_mm[0] - plate->touch_mm, height = plate->half_mm[1] - plate->touch_mm;
    for (unsigned k = 0; k < polygon.corner_count; k++)
        for (int i = 0; i < 3; i++)
            polygon.corners_mm[k][i] = plate->anchor_mm[i] + (k == 1 || k == 2 ? width : -width) * plate->across[i] +
                                       (k >= 2 ? height : -height) * plate->upward[i];
    if (!lx_shaft_meets_hull(shaft, polygon.corners_mm, polygon.corner_count))
        return 0;
    return lx_obstacles_append(obstacles, &polygon);
}

static bool plate_holds(const struct lx_shape *plate, const double place_mm[3])
{
    double from[3], near = 1e-9 * plate->radius_mm;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - plate->anchor_mm[i];
    return fabs(lx_dot(from, plate->axis)) <= near && fabs(lx_dot(from, plate->across)) <= plate->half_mm[0] + near &&
           fabs(lx_dot(from, plate->upward)) <= plate->half_mm[1] + near;
}

static bool plate_covers(const struct lx_shape *plate, const struct lx_shape_opening *opening)
{
    const double near = 1e-9 * plate->radius_mm;
    double middle[3];
    return lx_plane_holds_opening(plate, opening, middle) &&
           fabs(lx_dot(middle, plate->across)) + opening->radius_mm <= plate->half_mm[0] + near &&
           fabs(lx_dot(middle, plate->upward)) + opening->radius_mm <= plate->half_mm[1] + near;
}

static double plate_distance(const struct lx_shape *plate, const double offset_mm[3], double direction[3])
{
    double side = fmax(fabs(lx_dot(offset_mm, plate->across)) - plate->half_mm[0], 0);
    double end = fmax(fabs(lx_dot(offset_mm, plate->upward)) - plate->half_mm[1], 0);
    double height = lx_dot(offset_mm, plate->axis);
    memcpy(direction, plate->axis, sizeof plate->axis);
    return copysign(hypot(hypot(side, end), height), height);
}

/* Above it, where the way leads away from it, or where it crosses the plane outside. */
static double plate_beside(const struct lx_shape *shape, const double place[3], const double way[3], bool endless)
{
    const struct lx_shape moved = lx_shape_in_the_way(shape), *plate = &moved;
    double crossing[3];
    const double above = lx_plane_beside(plate, place, way, endless, crossing);
    if (above >= 0)
        return above;
    double across = fabs(lx_dot(crossing, plate->across)) - plate->half_mm[0];
    double upward = fabs(lx_dot(crossing, plate->upward)) - plate->half_mm[1];
    return fmax(above, fmax(across, upward));
}

/* Its own plane, and the planes through its edges and the light. */
static double plate_shadow_edge(const struct lx_shape *plate, const struct lx_origin *light, unsigned i,
                                const double place_mm[3])
{
    double from[3], at[3], towards[3], normal[3];
    if (i == 0) {
        for (int k = 0; k < 3; k++)
            from[k] = place_mm[k] - plate->anchor_mm[k];
        return lx_dot(plate->axis, from);
    }
    i--;
    const double *out = i < 2 ? plate->across : plate->upward, *edge = i < 2 ? plate->upward : plate->across;
    const double reach = (i % 2 ? 1 : -1) * plate->half_mm[i / 2];
    for (int k = 0; k < 3; k++) {
        at[k] = plate->anchor_mm[k] + reach * out[k];
        from[k] = place_mm[k] - at[k];
    }
    lx_way_to(light, at, towards);
    for (int k = 0; k < 3; k++)
        normal[k] = edge[(k + 1) % 3] * towards[(k + 2) % 3] - edge[(k + 2) % 3] * towards[(k + 1) % 3];
    return lx_dot(normal, from);
}

static void plate_outline(const struct lx_shape *plate, const struct lx_origin *eye, int i, int steps,
                          double place_mm[3], double inside_mm[3])
{
    const double turn = fmod(4.0 * i / steps, 4), along = fmod(turn, 1);
    const double u[4] = {along, 1, 1 - along, 0}, v[4] = {0, along, 1, 1 - along};
    const int side = (int)turn % 4;
    (void)eye;
    for (int k = 0; k < 3; k++) {
        place_mm[k] = plate->anchor_mm[k] +
                      (u[side] - 0.5) * 2 * (plate->half_mm[0] - plate->touch_mm) * plate->across[k] +
                      (v[side] - 0.5) * 2 * (plate->half_mm[1] - plate->touch_mm) * plate->upward[k];
        inside_mm[k] = place_mm[k] + 1e-3 * (plate->anchor_mm[k] - place_mm[k]);
    }
}

/* Left, right, lower, upper. */
static double wall_of_plate(const struct lx_shape *plate, const struct lx_origin *eye, unsigned i, const double at[3])
{
    (void)eye;
    return plate->half_mm[i / 2] - plate->touch_mm + (i % 2 ? -at[i / 2] : at[i / 2]);
}

static void rim_of_plate(const struct lx_shape *plate, const struct lx_origin *eye, int i, int count, double at[3])
{
    (void)eye;
    lx_around_square(i, count, at);
    for (int k = 0; k < 2; k++)
        at[k] *= plate->half_mm[k] - plate->touch_mm;
    at[2] = 0;
}

static const struct lx_surface_chart plate_chart = {
    .locate = lx_plane_locate,
    .place = lx_plane_place,
    .element = lx_plane_element,
    .directions = lx_plane_directions,
    .move = lx_plane_move,
    .walls = 4,
    .wall = wall_of_plate,
    .rim = rim_of_plate,
    .middle = lx_plane_middle,
    .guess = lx_plane_guess,
};

/* ---- bounds and words ---- */

/* The corner. */
static double plate_support(const struct lx_shape *plate, const double direction[3], double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = copysign(plate->half_mm[0], lx_dot(direction, plate->across)) * plate->across[i] +
                   copysign(plate->half_mm[1], lx_dot(direction, plate->upward)) * plate->upward[i];
    return 0;
}

static const struct lx_surface_bounds plate_bounds = {
    .support = plate_support,
    .least_cosine = lx_plane_least_cosine,
    .widest_turn = M_PI,
    .curvature = lx_plane_curvature,
};

static const struct lx_surface_words plate_words = {
    .sentence = LX_N("The normal {0} of a plate is its axis."),
    .formulas = {"\\mathbf{N}"},
};

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
    .gather = plate_gather,
    .holds = plate_holds,
    .is_mirror = plate_is_mirror,
    .standing = lx_plane_standing,
    .faces = lx_plane_faces,
    .is_dark = lx_plane_is_dark,
    .normal = lx_plane_normal,
    .covers = plate_covers,
    .distance = plate_distance,
    .beside = plate_beside,
    .shadow_edges = 5,
    .shadow_edge = plate_shadow_edge,
    .outline = plate_outline,
    .sheets = lx_sheets_of_plate,
    .chart = &plate_chart,
    .bounds = &plate_bounds,
    .words = &plate_words,
};
