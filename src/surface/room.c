/* SPDX-License-Identifier: MIT */
/*
 * The room: a box along the axes, seen from inside.  Its parts are six rectangles that face inwards; each is seen from
 * its front alone, so that an observer outside looks through the walls that are nearest.  Which wall is the floor says
 * the axis that is up.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../parameter/check.h"
#include "cuboid.h"
#include "part.h"

static const char *const wall_names[] = {"left", "right", "floor", "ceiling", "back", "front", NULL};

struct room_parameters {
    uint64_t given;
    double center_mm[3], size_mm[3];
    int up;
    struct lx_cuboid_materials materials;
    struct lx_groups openings;
};

struct glass_parameters {
    uint64_t given;
    double index, transmittance;
};

struct opening_parameters {
    uint64_t given;
    int wall;
    double center_mm[2], size_mm[2];
    struct glass_parameters glass;
};

enum { MOST_OPENINGS = 64 };

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

static const struct lx_parameter glass_parameters[] = {
    {
        .name = "n",
        .label = "Refractive index",
        .type = LX_REAL,
        .offset = offsetof(struct glass_parameters, index),
        .initial = "1.52",
        .legal = LX_BETWEEN(1, 10),
        .advised = {LX_BETWEEN(1.3, 2)},
        .meaning = "the refractive index of the glass",
    },
    {
        .name = "transmittance",
        .label = "Inner transmittance",
        .type = LX_REAL,
        .offset = offsetof(struct glass_parameters, transmittance),
        .initial = "0.96",
        .legal = {.given = true, .low = 0, .high = 1, .low_open = true},
        .advised = {LX_BETWEEN(0.3, 1)},
        .meaning = "what is left of the light that enters at right angles where it reaches the other face; what faces "
                   "reflect is taken besides",
    },
};

static const struct lx_table glass_table = {
    .parameters = glass_parameters,
    .count = LX_COUNT(glass_parameters),
    .size = sizeof(struct glass_parameters),
};

static const struct lx_parameter opening_parameters[] = {
    {
        .name = "wall",
        .label = "Wall",
        .type = LX_CHOICE,
        .offset = offsetof(struct opening_parameters, wall),
        .choices = wall_names,
        .required = true,
        .meaning = "the wall, floor or ceiling that it is in",
    },
    {
        .name = "center",
        .label = "Centre",
        .type = LX_REALS,
        .offset = offsetof(struct opening_parameters, center_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .initial = "[0, 0]",
        .meaning = "where its middle lies from the middle of the wall: to the right as seen from inside, and up; in "
                   "the floor and the ceiling the second runs along y, with up: y along z",
    },
    {
        .name = "size",
        .label = "Size",
        .type = LX_REALS,
        .offset = offsetof(struct opening_parameters, size_mm),
        .count = 2,
        .unit = LX_UNIT_MM,
        .required = true,
        .legal = LX_ABOVE(0),
        .meaning = "its width and its height",
    },
    {
        .name = "glass",
        .label = "Glass",
        .type = LX_GROUP,
        .offset = offsetof(struct opening_parameters, glass),
        .group = &glass_table,
        .meaning = "a pane of clear glass in it; not given: nothing is in it",
    },
};

static const struct lx_table opening_table = {
    .parameters = opening_parameters,
    .count = LX_COUNT(opening_parameters),
    .size = sizeof(struct opening_parameters),
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
    {
        .name = "openings",
        .label = "Openings",
        .type = LX_GROUPS,
        .offset = offsetof(struct room_parameters, openings),
        .initial = "[]",
        .group = &opening_table,
        .meaning = "windows and other holes in walls, through which light comes and goes",
    },
};

static void check_room(const struct lx_check *check, void *parameters);

static const struct lx_table room_table = {
    .parameters = room_parameters,
    .count = LX_COUNT(room_parameters),
    .size = sizeof(struct room_parameters),
    .check = check_room,
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

/* A rectangle of a wall, from its middle along the wall's own sides. */
struct piece {
    double low[2], high[2];
};

static const struct opening_parameters *opening_at(const struct room_parameters *room, size_t i)
{
    return (const struct opening_parameters *)room->openings.items + i;
}

/* Whether up runs along the width of a wall, as it lies: of those at the ends of x where z is up. */
static bool is_sideways(const struct room_parameters *room, const struct lx_plate_parameters *plate)
{
    return room->up == 1 && plate->axis[0] != 0;
}

/* The hole of an opening in its wall.  Seen from inside, the width runs to the right along up x axis. */
static void hole_of(const struct room_parameters *room, const struct opening_parameters *opening,
                    const struct lx_plate_parameters *plate, struct piece *hole)
{
    double across[3];
    lx_cross(plate->up, plate->axis, across);
    for (int k = 0; k < 2; k++) {
        double middle = opening->center_mm[k], half = opening->size_mm[k] / 2;
        if (is_sideways(room, plate)) { /* its width runs along z, which is up, or against it, its height along y */
            half = opening->size_mm[1 - k] / 2;
            middle = (k == 0 ? 1 : -1) * across[2] * opening->center_mm[1 - k];
        }
        hole->low[k] = middle - half;
        hole->high[k] = middle + half;
    }
}

static bool is_cut(const struct room_parameters *room, unsigned wall)
{
    for (size_t i = 0; i < room->openings.count; i++)
        if (opening_at(room, i)->wall == (int)wall)
            return true;
    return false;
}

/* What is left of a plate where it is cut to a piece of it. */
static void cut_plate(const struct piece *piece, struct lx_plate_parameters *plate)
{
    double across[3];
    lx_cross(plate->up, plate->axis, across);
    for (int k = 0; k < 3; k++)
        plate->center_mm[k] += (piece->low[0] + piece->high[0]) / 2 * across[k] +
                               (piece->low[1] + piece->high[1]) / 2 * plate->up[k];
    for (int k = 0; k < 2; k++)
        plate->size_mm[k] = piece->high[k] - piece->low[k];
}

/* Piece i of what holes leave of a wall, in bands between their lower and upper ends; returns how many there are. */
static size_t piece_of_wall(const struct room_parameters *room, unsigned wall, size_t i, struct piece *piece)
{
    const struct lx_cuboid cuboid = cuboid_of(room);
    struct lx_plate_parameters plate;
    struct piece holes[MOST_OPENINGS];
    double ends[2 * MOST_OPENINGS + 2];
    size_t hole_count = 0, end_count = 0, count = 0;
    lx_cuboid_side(&cuboid, wall, true, &plate);
    const double half[2] = {plate.size_mm[0] / 2, plate.size_mm[1] / 2}, least = 1e-9 * fmax(half[0], half[1]);
    for (size_t k = 0; k < room->openings.count && k < MOST_OPENINGS; k++) {
        if (opening_at(room, k)->wall != (int)wall)
            continue;
        hole_of(room, opening_at(room, k), &plate, &holes[hole_count]);
        ends[end_count++] = holes[hole_count].low[1];
        ends[end_count++] = holes[hole_count++].high[1];
    }
    ends[end_count++] = -half[1];
    ends[end_count++] = half[1];
    qsort(ends, end_count, sizeof *ends, lx_by_value);
    for (size_t band = 0; band + 1 < end_count; band++) {
        const double low = fmax(ends[band], -half[1]), high = fmin(ends[band + 1], half[1]);
        double from = -half[0];
        while (high - low > least && from < half[0]) {
            double to = half[0], next = half[0];
            for (size_t k = 0; k < hole_count; k++) /* the next hole in the band */
                if (holes[k].low[1] < (low + high) / 2 && holes[k].high[1] > (low + high) / 2 &&
                    holes[k].high[0] > from && holes[k].low[0] < to) {
                    to = fmax(holes[k].low[0], from);
                    next = holes[k].high[0];
                }
            if (to - from > least && count++ == i)
                *piece = (struct piece){{from, low}, {to, high}};
            from = to < half[0] ? next : half[0];
        }
    }
    return count;
}

/*
 * All walls have the same room for rounding.  They end where their neighbours begin, so that what lies on the edge of
 * one lies on the other, too: as something in the way of light each stands so much farther outside that it is behind
 * all of that, and is so much larger that nothing leads past an edge (lx_shape_in_the_way()).
 */
static void lay_part(const void *parameters, unsigned wall, const struct piece *piece, struct lx_part *part)
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
    if (piece)
        cut_plate(piece, &part->own.plate);
    part->kind = &lx_plate_kind;
    part->parameters = &part->own.plate;
    part->shape = lx_surface_shape(&lx_plate_kind, &part->own.plate);
    part->material = lx_is_given(&materials_table, &room->materials, wall_names[wall]) ? material : NULL;
    part->shape.touch_mm = touch;
    for (int i = 0; i < 2; i++)
        part->shape.half_mm[i] = part->own.plate.size_mm[i] / 2 + touch / 2;
    part->shape.behind_mm = 4 * touch;
}

static void room_part(const void *parameters, unsigned wall, struct lx_part *part)
{
    lay_part(parameters, wall, NULL, part);
}

/* Piece i of all walls; returns how many there are. */
static size_t find_piece(const struct room_parameters *room, size_t i, unsigned *wall, struct piece *piece)
{
    size_t count = 0;
    for (unsigned w = 0; w < LX_CUBOID_SIDES; w++) {
        struct piece found;
        const size_t before = count, pieces = piece_of_wall(room, w, i - before, &found);
        count += pieces;
        if (i >= before && i < count) {
            *wall = w;
            *piece = found;
        }
    }
    return count;
}

static size_t room_piece_count(const void *parameters)
{
    unsigned wall;
    struct piece piece;
    return find_piece(parameters, SIZE_MAX, &wall, &piece);
}

static unsigned room_piece(const void *parameters, size_t i, struct lx_part *part)
{
    unsigned wall = 0;
    struct piece piece = {.low = {0}};
    const struct room_parameters *room = parameters;
    find_piece(room, i, &wall, &piece);
    lay_part(room, wall, is_cut(room, wall) ? &piece : NULL, part);
    return wall;
}

static size_t room_panes(const void *parameters, size_t i, struct lx_glass_pane *pane)
{
    const struct room_parameters *room = parameters;
    const struct lx_cuboid cuboid = cuboid_of(room);
    if (i >= room->openings.count)
        return room->openings.count;
    const struct opening_parameters *opening = opening_at(room, i);
    const bool is_glazed = lx_is_given(&opening_table, opening, "glass");
    struct lx_plate_parameters plate;
    struct piece hole;
    lx_cuboid_side(&cuboid, (unsigned)opening->wall, true, &plate);
    hole_of(room, opening, &plate, &hole);
    cut_plate(&hole, &plate);
    *pane = (struct lx_glass_pane){.half_mm = {plate.size_mm[0] / 2, plate.size_mm[1] / 2},
                                   .index = is_glazed ? opening->glass.index : 0,
                                   .transmittance = opening->glass.transmittance};
    memcpy(pane->center_mm, plate.center_mm, sizeof pane->center_mm);
    memcpy(pane->axis, plate.axis, sizeof pane->axis);
    memcpy(pane->upward, plate.up, sizeof pane->upward);
    lx_cross(plate.up, plate.axis, pane->across);
    memcpy(pane->room_center_mm, room->center_mm, sizeof pane->room_center_mm);
    memcpy(pane->room_axes, cuboid.axes, sizeof pane->room_axes);
    for (int k = 0; k < 3; k++)
        pane->room_half_mm[k] = room->size_mm[k] / 2;
    return room->openings.count;
}

/* ---- what openings must be ---- */

/* Reports an opening that reaches beyond its wall, with the room that there is. */
static void check_within(const struct lx_check *check, const struct room_parameters *room, size_t i)
{
    const struct opening_parameters *opening = opening_at(room, i);
    const struct lx_cuboid cuboid = cuboid_of(room);
    struct lx_plate_parameters plate;
    struct piece hole;
    char width[LX_NUMBER_SIZE], height[LX_NUMBER_SIZE];
    lx_cuboid_side(&cuboid, (unsigned)opening->wall, true, &plate);
    hole_of(room, opening, &plate, &hole);
    const bool is_turned = is_sideways(room, &plate);
    for (int k = 0; k < 2; k++) {
        const double half = plate.size_mm[k] / 2 * (1 + 1e-12);
        if (hole.low[k] >= -half && hole.high[k] <= half)
            continue;
        lx_check_report(check, "openings", i, LX_MSG_OPENING_BEYOND,
                        LX_ARGS(wall_names[opening->wall], lx_write_number(plate.size_mm[is_turned], width),
                                lx_write_number(plate.size_mm[!is_turned], height)));
        return;
    }
}

static bool overlap(const struct room_parameters *room, size_t i, size_t k)
{
    const struct opening_parameters *one = opening_at(room, i), *other = opening_at(room, k);
    bool is_common = one->wall == other->wall;
    for (int j = 0; j < 2; j++)
        is_common = is_common && fabs(one->center_mm[j] - other->center_mm[j]) <
                                     (one->size_mm[j] + other->size_mm[j]) / 2 * (1 - 1e-12);
    return is_common;
}

static void check_room(const struct lx_check *check, void *parameters)
{
    const struct room_parameters *room = parameters;
    char number[LX_NUMBER_SIZE];
    if (room->openings.count > MOST_OPENINGS) {
        lx_check_report(check, "openings", LX_ALL_OF_IT, LX_MSG_OPENINGS_MANY,
                        LX_ARGS(lx_write_number(MOST_OPENINGS, number)));
        return;
    }
    for (size_t i = 0; i < room->openings.count; i++) {
        check_within(check, room, i);
        for (size_t k = 0; k < i; k++)
            if (overlap(room, i, k))
                lx_check_report(check, "openings", i, LX_MSG_OPENINGS_OVERLAP,
                                LX_ARGS(lx_write_number((double)k, number)));
    }
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
    const struct lx_cuboid cuboid = cuboid_of(room);
    struct lx_shape shape = lx_cuboid_shape(&cuboid);
    for (int i = 0; i < 3 && room->openings.count > 0; i++)
        shape.own[i] = HUGE_VAL; /* light comes in from outside: no place is dark */
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
    .part_count = LX_CUBOID_SIDES,
    .part = room_part,
    .piece_count = room_piece_count,
    .piece = room_piece,
    .panes = room_panes,
};
