/* SPDX-License-Identifier: MIT */
/*
 * The planar source: a flat piece that shines from one side, or from both, with the same radiance everywhere, such as a
 * luminous panel.  Its outline is a polygon, a rectangle or a disk.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/pose.h"
#include "array.h"
#include "spread.h"

struct rectangle_parameters {
    uint64_t given;
    double center_mm[3];
    double size_mm[2];
    double axis[3], aim_mm[3], up[3];
};

struct disk_parameters {
    uint64_t given;
    double center_mm[3];
    double radius_mm;
    double axis[3], aim_mm[3];
};

struct planar_parameters {
    uint64_t given;
    struct lx_vectors vertices_mm;
    struct rectangle_parameters rectangle;
    struct disk_parameters disk;
    double intensity; /* W/sr or cd, along the normal */
    int sides;
    struct lx_spread spread;
    struct lx_array array;
};

/* ---- tables ---- */

#define CENTER_AND_AIM(type_)                                                                                          \
    {                                                                                                                  \
        .name = "center",                                                                                              \
        .label = "Centre",                                                                                             \
        .type = LX_REALS,                                                                                              \
        .offset = offsetof(type_, center_mm),                                                                          \
        .count = 3,                                                                                                    \
        .unit = LX_UNIT_MM,                                                                                            \
        .required = true,                                                                                              \
        .advised = LX_SPREAD_PLACES,                                                                                   \
        .meaning = "where its centre lies",                                                                            \
    },                                                                                                                 \
        {                                                                                                              \
            .name = "axis",                                                                                            \
            .label = "Axis",                                                                                           \
            .type = LX_REALS,                                                                                          \
            .offset = offsetof(type_, axis),                                                                           \
            .count = 3,                                                                                                \
            .nonzero = true,                                                                                           \
            .initial = "[0, 0, -1]",                                                                                   \
            .meaning = "the direction in which it shines, its normal, of any length",                                  \
        },                                                                                                             \
    {                                                                                                                  \
        .name = "aim", .label = "Aim", .type = LX_REALS, .offset = offsetof(type_, aim_mm), .count = 3,                \
        .unit = LX_UNIT_MM, .meaning = "the point at which it is aimed, instead of axis",                              \
    }

static const struct lx_parameter rectangle_parameters[] = {
    CENTER_AND_AIM(struct rectangle_parameters),
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct rectangle_parameters, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 10000)},
        .meaning = "its width and its height, which runs along up",
    },
    {
        .name = "up",
        .label = "Up direction",
        .type = LX_REALS,
        .offset = offsetof(struct rectangle_parameters, up),
        .count = 3,
        .nonzero = true,
        .initial = "[0, 1, 0]",
        .meaning = "the direction along which the height runs, made perpendicular to axis; where it is not given and "
                   "the axis runs along y, (0, 0, 1)",
    },
};

static const struct lx_rule aim_rules[] = {
    {LX_RULE_EXCLUSIVE, "axis", "aim", NULL},
    {LX_RULE_DISTINCT, "aim", "center", NULL},
};

static void check_rectangle(const struct lx_check *check, void *parameters);

static const struct lx_table rectangle_table = {
    .parameters = rectangle_parameters,
    .count = LX_COUNT(rectangle_parameters),
    .rules = aim_rules,
    .rule_count = LX_COUNT(aim_rules),
    .size = sizeof(struct rectangle_parameters),
    .check = check_rectangle,
};

static const struct lx_parameter disk_parameters[] = {
    CENTER_AND_AIM(struct disk_parameters),
    {
        .name = "radius",
        .label = "Radius",
        .type = LX_REAL,
        .offset = offsetof(struct disk_parameters, radius_mm),
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .advised = {LX_BETWEEN(1, 5000)},
        .meaning = "its radius",
    },
};

static const struct lx_table disk_table = {
    .parameters = disk_parameters,
    .count = LX_COUNT(disk_parameters),
    .rules = aim_rules,
    .rule_count = LX_COUNT(aim_rules),
    .size = sizeof(struct disk_parameters),
};

enum { FRONT, BOTH };

static const char *const sides_names[] = {"front", "both", NULL};

static const struct lx_parameter planar_parameters[] = {
    {
        .name = "vertices",
        .label = "Corners",
        .type = LX_VECTORS,
        .offset = offsetof(struct planar_parameters, vertices_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .advised = LX_SPREAD_PLACES,
        .meaning = "the corners of a polygon in one plane whose edges do not cross, counter-clockwise as seen from the "
                   "lit side",
    },
    {
        .name = "rectangle",
        .label = "Rectangle",
        .type = LX_GROUP,
        .offset = offsetof(struct planar_parameters, rectangle),
        .group = &rectangle_table,
        .meaning = "a rectangle as the outline",
    },
    {
        .name = "disk",
        .label = "Disk",
        .type = LX_GROUP,
        .offset = offsetof(struct planar_parameters, disk),
        .group = &disk_table,
        .meaning = "a disk as the outline",
    },
    {
        .name = "intensity",
        .label = "Intensity",
        .type = LX_REAL,
        .offset = offsetof(struct planar_parameters, intensity),
        .unit = LX_UNIT_INTENSITY,
        .legal = LX_FROM(0),
        .advised = {LX_BETWEEN(0.01, 10000)},
        .meaning = "the intensity, radiant or luminous, along the normal, from far away: the radiance times the area",
    },
    {
        .name = "sides",
        .label = "Sides",
        .type = LX_CHOICE,
        .offset = offsetof(struct planar_parameters, sides),
        .choices = sides_names,
        .initial = "front",
        .meaning = "which sides shine, each with the radiance: the front, to which the axis points or which sees the "
                   "corners run counter-clockwise, or both",
    },
    LX_SPREAD_PARAMETERS(struct planar_parameters),
    LX_ARRAY_PARAMETER(struct planar_parameters),
};

static const struct lx_rule planar_rules[] = {
    {LX_RULE_ONE, "vertices", NULL, "vertices|rectangle|disk"},
    {LX_RULE_ONE, "intensity", NULL, "intensity|radiance|power"},
    LX_SPREAD_RULES,
};

static void check_planar(const struct lx_check *check, void *parameters);

static const struct lx_table planar_table = {
    .parameters = planar_parameters,
    .count = LX_COUNT(planar_parameters),
    .rules = planar_rules,
    .rule_count = LX_COUNT(planar_rules),
    .size = sizeof(struct planar_parameters),
    .check = check_planar,
};

/* ---- shapes ---- */

/* The axis, as long as it may be, and rounded where it is aimed: near enough to judge it. */
static void rectangle_axis(const struct rectangle_parameters *rectangle, double axis[3])
{
    bool aimed = lx_is_given(&rectangle_table, rectangle, "aim");
    for (int i = 0; i < 3; i++)
        axis[i] = aimed ? rectangle->aim_mm[i] - rectangle->center_mm[i] : rectangle->axis[i];
}

static void check_rectangle(const struct lx_check *check, void *parameters)
{
    const struct rectangle_parameters *rectangle = parameters;
    double axis[3];
    rectangle_axis(rectangle, axis);
    lx_check_pose(check, axis, rectangle->up);
}

static struct lx_facets *rectangle_facets(const struct rectangle_parameters *rectangle)
{
    double axis[3], up[3];
    rectangle_axis(rectangle, axis);
    if (lx_is_given(&rectangle_table, rectangle, "up"))
        memcpy(up, rectangle->up, sizeof up);
    else
        lx_usual_up(axis, up);
    struct lx_pose pose = lx_is_given(&rectangle_table, rectangle, "aim")
                              ? lx_pose_towards(rectangle->center_mm, rectangle->aim_mm, up)
                              : lx_pose_of(axis, up);
    return lx_facets_of_pose(rectangle->center_mm, rectangle->size_mm, &pose);
}

static struct lx_emitter disk_shape(const struct disk_parameters *disk)
{
    bool aimed = lx_is_given(&disk_table, disk, "aim");
    lx_bounded3 axis = aimed ? lx_sub3(lx_exact3(disk->aim_mm), lx_exact3(disk->center_mm)) : lx_exact3(disk->axis);
    struct lx_emitter shape = {.type = LX_DISK, .radius_mm = disk->radius_mm, .axis = lx_unit3(axis)};
    memcpy(shape.center_mm, disk->center_mm, sizeof shape.center_mm);
    return shape;
}

/* Takes over the convex pieces of a polygon. */
static int add_pieces(struct lx_shapes *shapes, struct lx_facets **pieces, size_t count)
{
    int result = 0;
    for (size_t i = 0; i < count; i++)
        if (result == 0)
            result = lx_shapes_add_facets(shapes, pieces[i]);
        else
            lx_facets_free(pieces[i]);
    free(pieces);
    return result;
}

/* Adds the back of each piece that there is. */
static int add_backs(struct lx_shapes *shapes)
{
    const size_t count = shapes->emitters.count;
    for (size_t i = 0; i < count; i++) {
        struct lx_emitter back = shapes->emitters.items[i];
        if (back.type == LX_FACETS)
            back.facets = lx_facets_turned(back.facets);
        else
            back.axis = lx_negate3(back.axis);
        if (lx_shapes_add(shapes, &back))
            return -1;
    }
    return 0;
}

/* What the outline consists of, or what is wrong with it. */
static struct lx_shape_report make_shapes(const struct planar_parameters *planar, struct lx_shapes *shapes)
{
    struct lx_shape_report report = {LX_SHAPE_GOOD, 0, 0};
    int result;
    if (lx_is_given(&planar_table, planar, "disk")) {
        struct lx_emitter shape = disk_shape(&planar->disk);
        result = lx_shapes_add(shapes, &shape);
    } else if (lx_is_given(&planar_table, planar, "rectangle")) {
        result = lx_shapes_add_facets(shapes, rectangle_facets(&planar->rectangle));
    } else {
        struct lx_facets **pieces = NULL;
        size_t count = 0;
        const double(*vertices)[3] = (const double(*)[3])planar->vertices_mm.xyz;
        report = lx_facets_of_outline(vertices, planar->vertices_mm.count, &pieces, &count);
        if (report.fault != LX_SHAPE_GOOD)
            return report;
        result = add_pieces(shapes, pieces, count);
    }
    if (result == 0 && planar->sides == BOTH)
        result = add_backs(shapes);
    if (result < 0)
        report.fault = LX_SHAPE_OUT_OF_MEMORY;
    return report;
}

/* ---- checking ---- */

static bool same_place(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Without area: for one reason that can be pointed at, or as a whole. */
static void report_no_area(const struct lx_check *check, const struct lx_vectors *vertices)
{
    const size_t last = vertices->count - 1;
    if (same_place(vertices->xyz[last], vertices->xyz[0])) {
        lx_check_report(check, "vertices", last, LX_MSG_CLOSED_RING, NULL);
        lx_check_hint(check, LX_MSG_HINT_CLOSED_RING, NULL);
        return;
    }
    for (size_t i = 0; i < vertices->count; i++)
        if (same_place(vertices->xyz[i], vertices->xyz[(i + 1) % vertices->count])) {
            lx_check_report(check, "vertices", (i + 1) % vertices->count, LX_MSG_CORNER_TWICE, NULL);
            return;
        }
    lx_check_report(check, "vertices", LX_ALL_OF_IT, LX_MSG_NO_AREA, NULL);
}

static void report_outline(const struct lx_check *check, const struct lx_vectors *vertices,
                           struct lx_shape_report report)
{
    char second[LX_NUMBER_SIZE];
    lx_write_number((double)report.second, second);
    switch (report.fault) {
    case LX_SHAPE_NOT_FLAT: lx_check_report(check, "vertices", report.first, LX_MSG_NOT_FLAT, NULL); break;
    case LX_SHAPE_CROSSES: lx_check_report(check, "vertices", report.first, LX_MSG_EDGES_CROSS, LX_ARGS(second)); break;
    case LX_SHAPE_OUT_OF_MEMORY: check->walk->out_of_memory = true; break;
    default: report_no_area(check, vertices); break;
    }
}

static lx_bounded radiance_of(const struct planar_parameters *planar, const struct lx_shapes *shapes)
{
    if (lx_is_given(&planar_table, planar, "radiance"))
        return lx_exact(planar->spread.radiance);
    if (lx_is_given(&planar_table, planar, "power"))
        return lx_radiance_of_power(planar->spread.power, shapes);
    const lx_bounded area = lx_shapes_area(shapes); /* of all that shines */
    return lx_div(lx_exact(planar->intensity), planar->sides == BOTH ? lx_scale(area, 0.5) : area);
}

static void check_planar(const struct lx_check *check, void *parameters)
{
    const struct planar_parameters *planar = parameters;
    const char *outline = lx_is_given(&planar_table, planar, "disk")        ? "disk"
                          : lx_is_given(&planar_table, planar, "rectangle") ? "rectangle"
                                                                            : "vertices";
    struct lx_shapes shapes = {0};
    struct lx_shape_report report = make_shapes(planar, &shapes);
    if (report.fault != LX_SHAPE_GOOD)
        report_outline(check, &planar->vertices_mm, report);
    else
        lx_check_area(check, outline, &shapes);
    lx_shapes_clear(&shapes);
}

/* ---- the kind ---- */

static int prepare_planar(const void *parameters, struct lx_emitters *emitters)
{
    const struct planar_parameters *planar = parameters;
    struct lx_shapes shapes = {0};
    if (make_shapes(planar, &shapes).fault != LX_SHAPE_GOOD) {
        lx_shapes_clear(&shapes);
        return -1;
    }
    return lx_spread_emit(&planar->spread, radiance_of(planar, &shapes), &shapes, emitters);
}

const struct lx_light_kind lx_planar_kind = {
    .variant =
        {
            .name = "planar",
            .meaning = "a flat source that shines from one side or from both, such as a luminous panel",
            .example = "{type: planar, rectangle: {center: [0, 800, 2200], size: [600, 300], aim: [0, 0, 1000]}, "
                       "radiance: 90}",
            .table = &planar_table,
        },
    .prepare = prepare_planar,
};
