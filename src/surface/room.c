/* SPDX-License-Identifier: MIT */
/*
 * The room: a box along the axes, seen from inside.  Its parts are six rectangles that face inwards; each is seen from
 * its front alone, so that an observer outside looks through the walls that are nearest.  Which wall is the floor says
 * the axis that is up.
 */
#include <math.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/vector.h"
#include "cuboid.h"
#include "part.h"

static const char *const wall_names[] = {"left", "right", "floor", "ceiling", "back", "front", NULL};

struct room_parameters {
    uint64_t given;
    double center_mm[3], size_mm[3];
    int up;
    struct lx_cuboid_materials materials;
};

static const struct lx_parameter materials_parameters[] = {
    LX_CUBOID_MATERIAL(0, "left", LX_N("Left wall"),
                       LX_N("the material of the wall at the lowest x, instead of material")),
    LX_CUBOID_MATERIAL(1, "right", LX_N("Right wall"),
                       LX_N("the material of the wall at the highest x, instead of material")),
    LX_CUBOID_MATERIAL(2, "floor", LX_N("Floor"),
                       LX_N("the material of the floor, at the lowest y (z with up: z), instead of material")),
    LX_CUBOID_MATERIAL(3, "ceiling", LX_N("Ceiling"),
                       LX_N("the material of the ceiling, at the highest y (z with up: z), instead of material")),
    LX_CUBOID_MATERIAL(
        4, "back", LX_N("Back wall"),
        LX_N("the material of the wall at the lowest z (the highest y with up: z), instead of material")),
    LX_CUBOID_MATERIAL(
        5, "front", LX_N("Front wall"),
        LX_N("the material of the wall at the highest z (the lowest y with up: z), instead of material")),
};

static const struct lx_table materials_table = {
    .parameters = materials_parameters,
    .count = LX_COUNT(materials_parameters),
    .size = sizeof(struct lx_cuboid_materials),
};

static const struct lx_parameter room_parameters[] = {
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct room_parameters, center_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .meaning = "where the middle of the room lies",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct room_parameters, size_mm),
        .count = 3,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .meaning = "the sizes of the room along x, y and z",
    },
    {
        .name = "up",
        .label = "Upward axis",
        .type = LX_CHOICE,
        .offset = offsetof(struct room_parameters, up),
        .initial = "y",
        .choices = lx_cuboid_ups,
        .meaning = "the axis that is up, which names the walls: the floor is the lowest wall along it, the ceiling the "
                   "highest",
    },
    {
        .name = "materials",
        .label = "Materials of walls",
        .type = LX_GROUP,
        .offset = offsetof(struct room_parameters, materials),
        .group = &materials_table,
        .meaning = "materials of single walls; a wall that is not named has the material of the room",
    },
};

static const struct lx_table room_table = {
    .parameters = room_parameters,
    .count = LX_COUNT(room_parameters),
    .size = sizeof(struct room_parameters),
};

static void room_extent(const void *parameters, double low_mm[3], double high_mm[3])
{
    const struct room_parameters *room = parameters;
    for (int i = 0; i < 3; i++) {
        low_mm[i] = room->center_mm[i] - room->size_mm[i] / 2;
        high_mm[i] = room->center_mm[i] + room->size_mm[i] / 2;
    }
}

/* ---- walls ---- */

static struct lx_cuboid cuboid_of(const struct room_parameters *room)
{
    struct lx_cuboid cuboid = {.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .up = room->up};
    memcpy(cuboid.center_mm, room->center_mm, sizeof cuboid.center_mm);
    memcpy(cuboid.size_mm, room->size_mm, sizeof cuboid.size_mm);
    return cuboid;
}

/*
 * All walls have the same room for rounding.  They end where their neighbours begin, so that what lies on the edge of
 * one lies on the other, too: as something in the way of light each stands so much farther outside that it is behind
 * all of that, and is so much larger that nothing leads past an edge (lx_shape_in_the_way()).
 */
static void room_part(const void *parameters, unsigned wall, struct lx_part *part)
{
    const struct room_parameters *room = parameters;
    const struct lx_material *material = &room->materials.sides[wall];
    const struct lx_cuboid cuboid = cuboid_of(room);
    extern const struct lx_surface_kind lx_plate_kind;
    double touch = 0;
    for (unsigned i = 0; i < LX_CUBOID_SIDES; i++) {
        struct lx_plate_parameters plate;
        lx_cuboid_side(&cuboid, i, true, &plate);
        touch = fmax(touch, lx_surface_shape(&lx_plate_kind, &plate).touch_mm);
    }
    lx_cuboid_side(&cuboid, wall, true, &part->own.plate);
    part->kind = &lx_plate_kind;
    part->parameters = &part->own.plate;
    part->shape = lx_surface_shape(&lx_plate_kind, &part->own.plate);
    part->material = lx_is_given(&materials_table, &room->materials, wall_names[wall]) ? material : NULL;
    part->shape.touch_mm = touch;
    for (int i = 0; i < 2; i++)
        part->shape.half_mm[i] = part->own.plate.size_mm[i] / 2 + touch / 2;
    part->shape.behind_mm = 4 * touch;
}

/* ---- the whole ---- */

static const struct lx_surface_words wall_words = {
    .sentence = LX_N("The normal {0} of a wall of a room points straight into the room."),
    .formulas = {"\\mathbf{N}"},
};

/* Its middle, its axes and the halves of its sizes along them: what is met, hides and shines are its walls. */
static struct lx_shape room_shape(const void *parameters)
{
    const struct lx_cuboid cuboid = cuboid_of(parameters);
    return lx_cuboid_shape(&cuboid);
}

static bool room_surrounds(const void *parameters, const double place_mm[3])
{
    double low[3], high[3];
    bool is_inside = true;
    room_extent(parameters, low, high);
    for (int i = 0; i < 3; i++)
        is_inside = is_inside && place_mm[i] >= low[i] && place_mm[i] <= high[i];
    return is_inside;
}

static bool room_is_dark(const struct lx_shape *room, const double place_mm[3])
{
    const double *axes[3] = {room->across, room->upward, room->axis};
    const double from[3] = {place_mm[0] - room->anchor_mm[0], place_mm[1] - room->anchor_mm[1],
                            place_mm[2] - room->anchor_mm[2]};
    bool is_outside = false;
    for (int i = 0; i < 3; i++)
        is_outside = is_outside || fabs(lx_dot(from, axes[i])) > room->own[i] * (1 + 1e-12);
    return is_outside;
}

const struct lx_surface_kind lx_room_kind = {
    .variant =
        {
            .name = "room",
            .meaning = "a box that is seen from inside: six walls that face inwards",
            .example = "{type: room, center: [0, 0, 0], size: [4000, 2500, 5000], material: {specular: 0}, "
                       "materials: {floor: {diffuse: 0.2, specular: 0}}}",
            .table = &room_table,
        },
    .extent = room_extent,
    .shape = room_shape,
    .standing = lx_standing_within,
    .is_dark = room_is_dark,
    .words = &wall_words,
    .surrounds = room_surrounds,
    .part_names = wall_names,
    .part_count = LX_CUBOID_SIDES,
    .part = room_part,
};
