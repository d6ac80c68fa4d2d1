/* SPDX-License-Identifier: MIT */
/*
 * The disk, a plate with a round edge, seen from its front, that takes light away from both sides: its parameters, and
 * where its plane (plane.h) ends.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/pose.h"
#include "../base/vector.h"
#include "plane.h"
#include "sheet.h"

struct disk_parameters {
    uint64_t given; /* always first: which keys the user wrote */
    double center_mm[3];
    double radius_mm;
    double axis[3];
};

static const struct lx_parameter disk_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct disk_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the centre of the disk lies: x to the right, y up, z towards the observer",
    },
    {
        .name = "radius",
        .label = "Radius",
        .type = LX_REAL,
        .offset = offsetof(struct disk_parameters, radius_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 5000)},
        .meaning = "the radius of the disk",
    },
    {
        .name = "axis",
        .label = "Axis",
        .type = LX_REALS,
        .offset = offsetof(struct disk_parameters, axis),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 0, 1]",
        .meaning = "the direction to which the front of the disk looks, of any length",
    },
};

static const struct lx_table disk_table = {
    .parameters = disk_parameters,
    .count = LX_COUNT(disk_parameters),
    .size = sizeof(struct disk_parameters),
};

/* The edge belongs to the disk: what rounding cannot tell from it does, too. */
static double reach_of(const struct lx_shape *disk)
{
    return disk->half_mm[0];
}

static struct lx_shape disk_shape(const void *parameters)
{
    const struct disk_parameters *disk = parameters;
    double up[3];
    lx_usual_up(disk->axis, up);
    struct lx_shape shape = lx_plane_lay(disk->center_mm, disk->axis, up, disk->radius_mm);
    shape.half_mm[0] = shape.half_mm[1] = disk->radius_mm + shape.touch_mm;
    return shape;
}

static double disk_farthest(const void *parameters, const double direction[3])
{
    const struct disk_parameters *disk = parameters;
    const struct lx_shape shape = disk_shape(parameters);
    const double across = lx_dot(direction, shape.across), upward = lx_dot(direction, shape.upward);
    return lx_dot(direction, disk->center_mm) + disk->radius_mm * hypot(across, upward);
}

static void disk_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct disk_parameters *disk = parameters;
    const struct lx_shape shape = disk_shape(parameters);
    for (int i = 0; i < 3; i++) {
        const double half = disk->radius_mm * hypot(shape.across[i], shape.upward[i]);
        low_mm[i] = disk->center_mm[i] - half;
        high_mm[i] = disk->center_mm[i] + half;
    }
}

static struct lx_hit disk_hit(const struct lx_shape *disk, const struct lx_ray *ray)
{
    double place[3];
    const struct lx_hit hit = lx_plane_meet(disk, ray, place);
    const double square = lx_dot(place, place), reach = reach_of(disk);
    return hit.exists && square <= reach * reach ? hit : (struct lx_hit){.exists = false};
}

/*
 * A way from the height a, which changes by b over the whole way, crosses the plane at u - a/b v from the centre, u its
 * start and v the way.  That is compared with the radius without the division.
 */
static lx_bounded disk_blocks(const struct lx_shape *disk, lx_bounded3 place_mm, lx_bounded3 towards, bool endless)
{
    const struct lx_plane_crossing way = lx_plane_cross(disk, place_mm, towards, endless);
    if (lx_is_zero(way.crosses))
        return way.crosses;
    const lx_bounded3 offset = lx_sub3(lx_mul3(way.from, way.change), lx_mul3(towards, way.start));
    const lx_bounded reach = lx_mul(lx_exact(disk->radius_mm), way.change);
    const double beyond = disk->touch_mm * (disk->radius_mm + reach_of(disk)) * way.change.value * way.change.value;
    const lx_bounded room = lx_sub(lx_mul(reach, reach), lx_square3(offset));
    return lx_both(way.crosses, lx_plane_is_within(disk, place_mm, room, beyond));
}

static bool disk_meets(const struct lx_shape *disk, const double from_mm[3], const double direction[3], double *t,
                       double offset_mm[3])
{
    const double height = lx_dot(disk->axis, from_mm), slope = lx_dot(disk->axis, direction), reach = reach_of(disk);
    if (!(height > 0 && slope < 0))
        return false;
    *t = -height / slope;
    for (int i = 0; i < 3; i++)
        offset_mm[i] = from_mm[i] + *t * direction[i];
    return lx_dot(offset_mm, offset_mm) <= reach * reach;
}

static bool disk_takes(const struct lx_shape *disk, const double from_mm[3], const double way[3], bool endless)
{
    const double start = lx_dot(disk->axis, from_mm), change = lx_dot(disk->axis, way), touch = disk->touch_mm;
    const double end = endless ? change : start + change, end_touch = endless ? 0 : touch, reach = reach_of(disk);
    double square = 0;
    if (!((start > touch && end < -end_touch) || (start < -touch && end > end_touch)))
        return false;
    for (int i = 0; i < 3; i++) {
        const double offset = from_mm[i] * change - way[i] * start;
        square += offset * offset;
    }
    return square <= reach * reach * change * change;
}

static int disk_gather(const struct lx_shape *disk, const struct lx_shaft *shaft, struct lx_obstacles *obstacles)
{
    struct lx_obstacle round = {.type = LX_OBSTACLE_DISK, .radius_mm = disk->radius_mm, .touch_mm = disk->touch_mm};
    if (!lx_shaft_meets_ball(shaft, disk->anchor_mm, reach_of(disk)))
        return 0;
    memcpy(round.center_mm, disk->anchor_mm, sizeof round.center_mm);
    memcpy(round.axis, disk->axis, sizeof round.axis);
    return lx_obstacles_append(obstacles, &round);
}

static bool disk_holds(const struct lx_shape *disk, const double place_mm[3])
{
    double from[3], near = 1e-9 * disk->radius_mm;
    for (int i = 0; i < 3; i++)
        from[i] = place_mm[i] - disk->anchor_mm[i];
    return fabs(lx_dot(from, disk->axis)) <= near && sqrt(lx_dot(from, from)) <= reach_of(disk) + near;
}

static bool disk_covers(const struct lx_shape *disk, const struct lx_shape_opening *opening)
{
    double middle[3];
    return lx_plane_holds_opening(disk, opening, middle) &&
           sqrt(lx_dot(middle, middle)) + opening->radius_mm <= disk->radius_mm * (1 + 1e-9);
}

static double disk_distance(const struct lx_shape *disk, const double offset_mm[3], double direction[3])
{
    const double height = lx_dot(offset_mm, disk->axis);
    const double away = hypot(lx_dot(offset_mm, disk->across), lx_dot(offset_mm, disk->upward));
    memcpy(direction, disk->axis, sizeof disk->axis);
    return copysign(hypot(fmax(away - reach_of(disk), 0), height), height);
}

/* Above it, where the way leads away from it, or where it crosses the plane outside. */
static double disk_beside(const struct lx_shape *disk, const double place_mm[3], const double way[3], bool endless)
{
    double crossing[3];
    const double above = lx_plane_beside(disk, place_mm, way, endless, crossing);
    return above >= 0 ? above : fmax(above, sqrt(lx_dot(crossing, crossing)) - reach_of(disk));
}

/* Its own plane, and the cone of the ways past its edge. */
static double disk_shadow_edge(const struct lx_shape *disk, const struct lx_origin *light, unsigned i,
                               const double place_mm[3])
{
    double from[3];
    if (i > 0)
        return lx_circle_edge(disk->anchor_mm, disk->axis, reach_of(disk), light, place_mm);
    for (int k = 0; k < 3; k++)
        from[k] = place_mm[k] - disk->anchor_mm[k];
    return lx_dot(disk->axis, from);
}

static void disk_outline(const struct lx_shape *disk, const struct lx_origin *eye, int i, int steps, double place_mm[3],
                         double inside_mm[3])
{
    const double turn = 2 * M_PI * i / steps;
    (void)eye;
    for (int k = 0; k < 3; k++) {
        place_mm[k] =
            disk->anchor_mm[k] + disk->radius_mm * (cos(turn) * disk->across[k] + sin(turn) * disk->upward[k]);
        inside_mm[k] = place_mm[k] + 1e-3 * (disk->anchor_mm[k] - place_mm[k]);
    }
}

static int disk_sheets(const struct lx_shape *disk, struct lx_smooth_sheet *sheets)
{
    return lx_sheets_of_sectors(disk, &lx_disk_sheet, disk->half_mm[0] - disk->touch_mm, 0, sheets);
}

static double wall_of_disk(const struct lx_shape *disk, const struct lx_origin *eye, unsigned i, const double at[3])
{
    (void)eye, (void)i;
    return disk->radius_mm - hypot(at[0], at[1]);
}

static void rim_of_disk(const struct lx_shape *disk, const struct lx_origin *eye, int i, int count, double at[3])
{
    const double turn = 2 * M_PI * i / count;
    (void)eye;
    at[0] = disk->radius_mm * cos(turn), at[1] = disk->radius_mm * sin(turn), at[2] = 0;
}

static const struct lx_surface_chart disk_chart = {
    .locate = lx_plane_locate,
    .place = lx_plane_place,
    .element = lx_plane_element,
    .directions = lx_plane_directions,
    .move = lx_plane_move,
    .walls = 1,
    .wall = wall_of_disk,
    .rim = rim_of_disk,
    .middle = lx_plane_middle,
    .guess = lx_plane_guess,
};

static double disk_support(const struct lx_shape *disk, const double direction[3], double place[3])
{
    const double across = lx_dot(direction, disk->across), upward = lx_dot(direction, disk->upward);
    const double length = hypot(across, upward), share = length > 0 ? reach_of(disk) / length : 0;
    for (int i = 0; i < 3; i++)
        place[i] = share * (across * disk->across[i] + upward * disk->upward[i]);
    return 0;
}

static const struct lx_surface_bounds disk_bounds = {
    .support = disk_support,
    .least_cosine = lx_plane_least_cosine,
    .widest_turn = M_PI,
    .curvature = lx_plane_curvature,
};

static const struct lx_surface_words disk_words = {
    .sentence = LX_N("The normal {0} of a disk is its axis."),
    .formulas = {"\\mathbf{N}"},
};

const struct lx_surface_kind lx_disk_kind = {
    .variant =
        {
            .name = "disk",
            .meaning = "a flat disk, seen from its front only",
            .example = "{type: disk, center: [0, 0, 0], radius: 300, material: {diffuse: 0.7, specular: 0}}",
            .table = &disk_table,
        },
    .extent = disk_extent,
    .shape = disk_shape,
    .hit = disk_hit,
    .normal = lx_plane_normal,
    .blocks = disk_blocks,
    .holds = disk_holds,
    .meets = disk_meets,
    .takes = disk_takes,
    .gather = disk_gather,
    .farthest = disk_farthest,
    .standing = lx_plane_standing,
    .faces = lx_plane_faces,
    .is_dark = lx_plane_is_dark,
    .covers = disk_covers,
    .distance = disk_distance,
    .beside = disk_beside,
    .shadow_edges = 2,
    .shadow_edge = disk_shadow_edge,
    .outline = disk_outline,
    .sheets = disk_sheets,
    .chart = &disk_chart,
    .bounds = &disk_bounds,
    .words = &disk_words,
};
