/* SPDX-License-Identifier: MIT */
/*
 * The box: a closed body whose parts are six rectangles that face outwards, on axes that may be turned.  Which of them
 * is the top says the axis that is up, its own where it is turned.
 */
#include <math.h>

#include "../base/phrase.h"
#include "../base/vector.h"
#include "cuboid.h"
#include "part.h"
#include "turning.h"

static const char *const side_names[] = {"left", "right", "bottom", "top", "back", "front", NULL};

struct box_parameters {
    uint64_t given;
    double center_mm[3], size_mm[3], rotate[3];
    int up;
    struct lx_cuboid_materials materials;
};

static const struct lx_parameter materials_parameters[] = {
    LX_CUBOID_MATERIAL(0, "left", LX_N("Left side"),
                       LX_N("the material of the side at the lowest x, instead of material")),
    LX_CUBOID_MATERIAL(1, "right", LX_N("Right side"),
                       LX_N("the material of the side at the highest x, instead of material")),
    LX_CUBOID_MATERIAL(2, "bottom", LX_N("Bottom side"),
                       LX_N("the material of the side at the lowest y (z with up: z), instead of material")),
    LX_CUBOID_MATERIAL(3, "top", LX_N("Top side"),
                       LX_N("the material of the side at the highest y (z with up: z), instead of material")),
    LX_CUBOID_MATERIAL(
        4, "back", LX_N("Back side"),
        LX_N("the material of the side at the lowest z (the highest y with up: z), instead of material")),
    LX_CUBOID_MATERIAL(
        5, "front", LX_N("Front side"),
        LX_N("the material of the side at the highest z (the lowest y with up: z), instead of material")),
};

static const struct lx_table materials_table = {
    .parameters = materials_parameters,
    .count = LX_COUNT(materials_parameters),
    .size = sizeof(struct lx_cuboid_materials),
};

static const struct lx_parameter box_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct box_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the middle of the box lies",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct box_parameters, size_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .meaning = "the sizes of the box along its x, y and z",
    },
    {
        .name = "rotate",
        .label = "Rotation",
        .type = LX_REALS,
        .offset = offsetof(struct box_parameters, rotate),
        .count = 3,
        .unit = LX_UNIT_DEGREES,
        .initial = "[0, 0, 0]",
        .advised = {LX_BETWEEN(-360, 360)},
        .meaning = "how far it is turned about x, then about y, then about z, counter-clockwise as seen from where the "
                   "axis points to, about its middle",
    },
    {
        .name = "up",
        .label = "Upward axis",
        .type = LX_CHOICE,
        .offset = offsetof(struct box_parameters, up),
        .initial = "y",
        .choices = lx_cuboid_ups,
        .meaning = "the axis that is up before it is turned, which names the sides: the bottom is the lowest side "
                   "along it, the top the highest",
    },
    {
        .name = "materials",
        .label = "Materials of sides",
        .type = LX_GROUP,
        .offset = offsetof(struct box_parameters, materials),
        .group = &materials_table,
        .meaning = "materials of single sides; a side that is not named has the material of the box",
    },
};

static const struct lx_table box_table = {
    .parameters = box_parameters,
    .count = LX_COUNT(box_parameters),
    .size = sizeof(struct box_parameters),
};

static struct lx_cuboid cuboid_of(const struct box_parameters *box)
{
    struct lx_cuboid cuboid = {.up = box->up};
    for (int axis = 0; axis < 3; axis++) {
        const lx_bounded3 way = lx_turned_axis(box->rotate, axis);
        cuboid.axes[axis][0] = way.x.value, cuboid.axes[axis][1] = way.y.value, cuboid.axes[axis][2] = way.z.value;
        cuboid.center_mm[axis] = box->center_mm[axis];
        cuboid.size_mm[axis] = box->size_mm[axis];
    }
    return cuboid;
}

static struct lx_shape box_shape(const void *parameters)
{
    const struct lx_cuboid cuboid = cuboid_of(parameters);
    return lx_cuboid_shape(&cuboid);
}

/* From its middle along a direction. */
static double reach_of(const struct lx_shape *box, const double direction[3])
{
    return box->own[0] * fabs(lx_dot(direction, box->across)) + box->own[1] * fabs(lx_dot(direction, box->upward)) +
           box->own[2] * fabs(lx_dot(direction, box->axis));
}

static double box_farthest(const void *parameters, const double direction[3])
{
    const struct lx_shape box = box_shape(parameters);
    return lx_dot(direction, box.anchor_mm) + reach_of(&box, direction);
}

static void box_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct lx_shape box = box_shape(parameters);
    for (int i = 0; i < 3; i++) {
        const double along[3] = {i == 0, i == 1, i == 2}, reach = reach_of(&box, along);
        low_mm[i] = box.anchor_mm[i] - reach;
        high_mm[i] = box.anchor_mm[i] + reach;
    }
}

static void box_part(const void *parameters, unsigned side, struct lx_part *part)
{
    const struct box_parameters *box = parameters;
    const struct lx_material *material = &box->materials.sides[side];
    const struct lx_cuboid cuboid = cuboid_of(box);
    extern const struct lx_surface_kind lx_plate_kind;
    lx_cuboid_side(&cuboid, side, false, &part->own.plate);
    part->kind = &lx_plate_kind;
    part->parameters = &part->own.plate;
    part->shape = lx_surface_shape(&lx_plate_kind, &part->own.plate);
    part->material = lx_is_given(&materials_table, &box->materials, side_names[side]) ? material : NULL;
}

/* In front of no side that is seen. */
static bool box_is_dark(const struct lx_shape *box, const double place_mm[3])
{
    const double *axes[3] = {box->across, box->upward, box->axis};
    const double from[3] = {place_mm[0] - box->anchor_mm[0], place_mm[1] - box->anchor_mm[1],
                            place_mm[2] - box->anchor_mm[2]};
    bool is_before = false;
    for (int i = 0; i < 3; i++) {
        const double side = axes[i][2] < 0 ? -1 : 1; /* which of the two looks up */
        is_before = is_before || (axes[i][2] != 0 && side * lx_dot(from, axes[i]) > box->own[i]);
    }
    return !is_before;
}

static const struct lx_surface_words side_words = {
    .sentence = LX_N("The normal {0} of a side of a box points straight out of the box."),
    .formulas = {"\\mathbf{N}"},
};

const struct lx_surface_kind lx_box_kind = {
    .variant =
        {
            .name = "box",
            .meaning = "a closed box, seen from outside: six sides that face outwards",
            .example = "{type: box, center: [0, 0, 0], size: [300, 200, 200], rotate: [0, 30, 0], material: {specular: "
                       "0}, materials: {top: {diffuse: 0.2, specular: 0}}}",
            .table = &box_table,
        },
    .extent = box_extent,
    .shape = box_shape,
    .farthest = box_farthest,
    .is_dark = box_is_dark,
    .words = &side_words,
    .part_names = side_names,
    .part_count = LX_CUBOID_SIDES,
    .part = box_part,
};
