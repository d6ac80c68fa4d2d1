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
#include "part.h"

enum wall { LEFT, RIGHT, FLOOR, CEILING, BACK, FRONT, WALLS };

static const char *const wall_names[] = {"left", "right", "floor", "ceiling", "back", "front", NULL};

enum up { UP_Y, UP_Z };

static const char *const up_names[] = {"y", "z", NULL};

/* On which axis each wall stands, and on which side of the middle, by what is up. */
static const struct {
    int axis, side;
} wall_sides[][WALLS] = {
    [UP_Y] = {{0, -1}, {0, 1}, {1, -1}, {1, 1}, {2, -1}, {2, 1}},
    [UP_Z] = {{0, -1}, {0, 1}, {2, -1}, {2, 1}, {1, 1}, {1, -1}},
};

struct room_materials {
    uint64_t given;
    struct lx_material walls[WALLS];
};

struct room_parameters {
    uint64_t given;
    double center_mm[3], size_mm[3];
    int up;
    struct room_materials materials;
};

static const struct lx_parameter materials_parameters[] = {
    {
        .name = "left",
        .label = "Left wall",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[LEFT]),
        .group = &lx_material_table,
        .meaning = "the material of the wall at the lowest x, instead of material",
    },
    {
        .name = "right",
        .label = "Right wall",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[RIGHT]),
        .group = &lx_material_table,
        .meaning = "the material of the wall at the highest x, instead of material",
    },
    {
        .name = "floor",
        .label = "Floor",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[FLOOR]),
        .group = &lx_material_table,
        .meaning = "the material of the floor, at the lowest y (z with up: z), instead of material",
    },
    {
        .name = "ceiling",
        .label = "Ceiling",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[CEILING]),
        .group = &lx_material_table,
        .meaning = "the material of the ceiling, at the highest y (z with up: z), instead of material",
    },
    {
        .name = "back",
        .label = "Back wall",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[BACK]),
        .group = &lx_material_table,
        .meaning = "the material of the wall at the lowest z (the highest y with up: z), instead of material",
    },
    {
        .name = "front",
        .label = "Front wall",
        .type = LX_GROUP,
        .offset = offsetof(struct room_materials, walls[FRONT]),
        .group = &lx_material_table,
        .meaning = "the material of the wall at the highest z (the lowest y with up: z), instead of material",
    },
};

static const struct lx_table materials_table = {
    .parameters = materials_parameters,
    .count = LX_COUNT(materials_parameters),
    .size = sizeof(struct room_materials),
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
        .choices = up_names,
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

/* Where the wall lies and which way it looks, as a user would write it. */
static void place_wall(const struct room_parameters *room, unsigned wall, struct lx_plate_parameters *plate)
{
    const int axis = wall_sides[room->up][wall].axis, side = wall_sides[room->up][wall].side;
    const int upward = axis == 1 ? 2 : 1, across = 3 - axis - upward;
    *plate = (struct lx_plate_parameters){.up = {0, 1, 0}};
    memcpy(plate->center_mm, room->center_mm, sizeof plate->center_mm);
    plate->center_mm[axis] += side * room->size_mm[axis] / 2;
    plate->axis[axis] = -side;
    plate->size_mm[0] = room->size_mm[across];
    plate->size_mm[1] = room->size_mm[upward];
}

/*
 * All walls have the same room for rounding.  They end where their neighbours begin, so that what lies on the edge of
 * one lies on the other, too: as something in the way of light each stands so much farther outside that it is behind
 * all of that, and is so much larger that nothing leads past an edge (lx_shape_in_the_way()).
 */
static void room_part(const void *parameters, unsigned wall, struct lx_part *part)
{
    const struct room_parameters *room = parameters;
    const struct lx_material *material = &room->materials.walls[wall];
    extern const struct lx_surface_kind lx_plate_kind;
    double touch = 0;
    for (unsigned i = 0; i < WALLS; i++) {
        struct lx_plate_parameters plate;
        place_wall(room, i, &plate);
        touch = fmax(touch, lx_surface_shape(&lx_plate_kind, &plate).touch_mm);
    }
    place_wall(room, wall, &part->own.plate);
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
    const struct room_parameters *room = parameters;
    struct lx_shape shape = {.type = LX_GENERAL, .across = {1, 0, 0}, .upward = {0, 1, 0}, .axis = {0, 0, 1}};
    memcpy(shape.anchor_mm, room->center_mm, sizeof shape.anchor_mm);
    shape.radius_mm = sqrt(lx_dot(room->size_mm, room->size_mm)) / 2;
    for (int i = 0; i < 3; i++)
        shape.own[i] = room->size_mm[i] / 2;
    return shape;
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
    .part_count = WALLS,
    .part = room_part,
};
