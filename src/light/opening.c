/* SPDX-License-Identifier: MIT */
/* Openings of luminaires: their keys, what files declare, and the emitters that they are made of. */
#include "opening.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/phrase.h"
#include "../base/pose.h"
#include "solid/facets.h"
#include "spread.h"

const char *const lx_opening_words[] = {"point", "file", NULL};

/* ---- tables ---- */

#define SIZE(count_, meaning_)                                                                                         \
    {                                                                                                                  \
        .name = "size", .label = "Size", .type = LX_REALS, .offset = offsetof(struct lx_opening_shape, size_mm),       \
        .count = count_, .unit = LX_UNIT_MM, .required = true, .legal = LX_ABOVE(0), .advised = {LX_BETWEEN(1, 5000)}, \
        .meaning = meaning_,                                                                                           \
    }

#define LENGTH(name_, label_, member_, meaning_)                                                                       \
    {                                                                                                                  \
        .name = name_, .label = label_, .type = LX_REAL, .offset = offsetof(struct lx_opening_shape, member_),         \
        .unit = LX_UNIT_MM, .required = true, .legal = LX_ABOVE(0), .advised = {LX_BETWEEN(1, 5000)},                  \
        .meaning = meaning_,                                                                                           \
    }

#define CENTER                                                                                                         \
    {                                                                                                                  \
        .name = "center", .label = "Centre", .type = LX_REALS, .offset = offsetof(struct lx_opening_shape, center_mm), \
        .count = 3, .unit = LX_UNIT_MM, .advised = LX_SPREAD_PLACES,                                                   \
        .meaning = "where its centre lies; not given: at the luminaire's position",                                    \
    }

#define AXIS(meaning_)                                                                                                 \
    {                                                                                                                  \
        .name = "axis", .label = "Axis", .type = LX_REALS, .offset = offsetof(struct lx_opening_shape, axis),          \
        .count = 3, .nonzero = true, .meaning = meaning_,                                                              \
    }

#define TABLE(name_)                                                                                                   \
    static const struct lx_table name_##_table = {                                                                     \
        .parameters = name_##_parameters,                                                                              \
        .count = LX_COUNT(name_##_parameters),                                                                         \
        .size = sizeof(struct lx_opening_shape),                                                                       \
    }

static const struct lx_parameter rectangle_parameters[] = {
    SIZE(2, LX_N("its lengths along the luminaire's C = 0 and along C = 90")),
    CENTER,
};
TABLE(rectangle);

static const struct lx_parameter disk_parameters[] = {
    LENGTH("radius", LX_N("Radius"), radius_mm, LX_N("its radius")),
    CENTER,
    AXIS(LX_N("its normal, of any length; not given: the luminaire's axis")),
};
TABLE(disk);

static const struct lx_parameter box_parameters[] = {
    SIZE(3, LX_N("its lengths along the luminaire's C = 0, along C = 90 and along its axis")),
    CENTER,
};
TABLE(box);

static const struct lx_parameter sphere_parameters[] = {
    LENGTH("radius", LX_N("Radius"), radius_mm, LX_N("its radius")),
    CENTER,
};
TABLE(sphere);

static const struct lx_parameter cylinder_parameters[] = {
    LENGTH("radius", LX_N("Radius"), radius_mm, LX_N("its radius")),
    LENGTH("height", LX_N("Height"), height_mm, LX_N("its length along the axis; both ends are closed")),
    CENTER,
    AXIS(LX_N("the direction of its axis, of any length; not given: the luminaire's axis")),
};
TABLE(cylinder);

#define SHAPE(name_, label_, meaning_)                                                                                 \
    {                                                                                                                  \
        .name = #name_, .label = label_, .type = LX_GROUP, .offset = offsetof(struct lx_opening, name_),               \
        .group = &name_##_table, .meaning = meaning_,                                                                  \
    }

static const struct lx_parameter opening_parameters[] = {
    SHAPE(rectangle, LX_N("Rectangle"), LX_N("a rectangle across the luminaire's axis")),
    SHAPE(disk, LX_N("Disk"), LX_N("a disk")),
    SHAPE(box, LX_N("Box"), LX_N("a box along the luminaire's directions, all of whose faces are luminous")),
    SHAPE(sphere, LX_N("Sphere"), LX_N("the surface of a sphere")),
    SHAPE(cylinder, LX_N("Cylinder"), LX_N("the surface of a cylinder with its ends")),
};

static const struct lx_rule opening_rules[] = {
    {LX_RULE_ONE, "rectangle", NULL, "rectangle|disk|box|sphere|cylinder"},
};

const struct lx_table lx_opening_table = {
    .parameters = opening_parameters,
    .count = LX_COUNT(opening_parameters),
    .rules = opening_rules,
    .rule_count = LX_COUNT(opening_rules),
    .size = sizeof(struct lx_opening),
};

/* ---- what files declare ---- */

static void give(const struct lx_table *table, void *parameters, const char *key)
{
    const struct lx_parameter *parameter = lx_find_parameter(table, key);
    *(uint64_t *)parameters |= (uint64_t)1 << (parameter - table->parameters);
}

/* The direction of the luminaire that is the axis of a round shape: 0 to 2 as radii_mm has them; -1: it needs none. */
static int axis_of(luxel_photometry_opening_shape shape)
{
    switch (shape) {
    case LUXEL_OPENING_ELLIPSE:
    case LUXEL_OPENING_CYLINDER: return 2;
    case LUXEL_OPENING_CYLINDER_LENGTH:
    case LUXEL_OPENING_FACING_LENGTH: return 0;
    case LUXEL_OPENING_CYLINDER_WIDTH:
    case LUXEL_OPENING_FACING_WIDTH: return 1;
    case LUXEL_OPENING_POINT:
    case LUXEL_OPENING_RECTANGLE:
    case LUXEL_OPENING_BOX:
    case LUXEL_OPENING_ELLIPSOID: break;
    }
    return -1;
}

/* A disk, cylinder or sphere of these lengths along the luminaire's directions, or one that is not round. */
static void set_round(int along, const double lengths_mm[3], const struct lx_pointed *pointed,
                      struct lx_opening *opening)
{
    const lx_bounded3 *const ways[3] = {&pointed->c0, &pointed->across, &pointed->axis};
    const double height = along < 0 ? 0 : lengths_mm[along];
    struct lx_opening_shape shape = {.height_mm = height};
    bool is_round = true;
    for (int i = 0; i < 3; i++)
        shape.radius_mm = i == along ? shape.radius_mm : fmax(shape.radius_mm, lengths_mm[i] / 2);
    for (int i = 0; i < 3; i++)
        is_round = is_round && (i == along || lengths_mm[i] / 2 == shape.radius_mm);
    for (int i = 0; i < 3 && !is_round; i++)
        shape.radii_mm[i] = i == along ? 0 : lengths_mm[i] / 2;
    if (along >= 0)
        lx_values3(*ways[along], shape.axis);
    if (along < 0) {
        opening->sphere = shape;
        give(&lx_opening_table, opening, "sphere");
    } else if (height > 0) {
        give(&cylinder_table, &shape, "axis");
        opening->cylinder = shape;
        give(&lx_opening_table, opening, "cylinder");
    } else {
        give(&disk_table, &shape, "axis");
        opening->disk = shape;
        give(&lx_opening_table, opening, "disk");
    }
}

bool lx_opening_of_file(const luxel_photometry_opening *declared, const struct lx_pointed *pointed,
                        struct lx_opening *opening)
{
    const double l = declared->length_mm, w = declared->width_mm, h = declared->height_mm;
    const double lengths_mm[3] = {l, w, h};
    *opening = (struct lx_opening){.word = -1};
    switch (declared->shape) {
    case LUXEL_OPENING_POINT: return false;
    case LUXEL_OPENING_RECTANGLE:
        memcpy(opening->rectangle.size_mm, lengths_mm, 2 * sizeof *lengths_mm);
        give(&lx_opening_table, opening, "rectangle");
        return l > 0 && w > 0;
    case LUXEL_OPENING_BOX:
        memcpy(opening->box.size_mm, lengths_mm, sizeof lengths_mm);
        give(&lx_opening_table, opening, "box");
        return l * w + w * h + h * l > 0;
    default: set_round(axis_of(declared->shape), lengths_mm, pointed, opening); return true;
    }
}

/* ---- emitters ---- */

/* The directions of a luminaire in plain numbers, and where its opening is. */
struct stand {
    double axis[3], c0[3], across[3];
    double center_mm[3];
};

static struct stand stand_of(const struct lx_table *table, const struct lx_opening_shape *shape,
                             const struct lx_emitter *point)
{
    struct stand stand;
    lx_values3(point->profile.luminaire->axis, stand.axis);
    lx_values3(point->profile.luminaire->c0, stand.c0);
    lx_values3(point->profile.luminaire->across, stand.across);
    memcpy(stand.center_mm, lx_is_given(table, shape, "center") ? shape->center_mm : point->position_mm,
           sizeof stand.center_mm);
    return stand;
}

static int add_sides(struct lx_shapes *shapes, struct lx_facets *facets)
{
    struct lx_emitter back = {.type = LX_FACETS, .is_back = true};
    if (lx_shapes_add_facets(shapes, facets))
        return -1;
    back.facets = lx_facets_turned(facets);
    return lx_shapes_add(shapes, &back);
}

/* A rectangle of a pose: w runs along up x axis, h along up. */
static int add_rectangle(struct lx_shapes *shapes, const double center_mm[3], double w, double h, const double axis[3],
                         const double up[3])
{
    const struct lx_pose pose = lx_pose_of(axis, up);
    return add_sides(shapes, lx_facets_of_pose(center_mm, (const double[]){w, h}, &pose));
}

/* The six faces; those of a length of 0 are left out, and of two that coincide one. */
static int add_box(struct lx_shapes *shapes, const struct stand *stand, const double size_mm[3])
{
    const double *const ways[3] = {stand->c0, stand->across, stand->axis};
    for (int way = 0; way < 3; way++) {
        const int w = way == 0 ? 2 : 0, h = way == 1 ? 2 : 1; /* which lengths run along the sides */
        if (!(size_mm[w] > 0 && size_mm[h] > 0))
            continue;
        for (int side = -1; side <= 1; side += 2) {
            double center[3], axis[3];
            for (int k = 0; k < 3; k++) {
                center[k] = stand->center_mm[k] + side * size_mm[way] / 2 * ways[way][k];
                axis[k] = side * ways[way][k];
            }
            if (side > 0 && size_mm[way] == 0)
                continue;
            if (add_rectangle(shapes, center, size_mm[w], size_mm[h], axis, ways[h]))
                return -1;
        }
    }
    return 0;
}

static int add_round(struct lx_shapes *shapes, enum lx_emitter_type type, const struct stand *stand,
                     const struct lx_opening_shape *shape, const double axis[3], const struct lx_profile *profile)
{
    struct lx_emitter round = {.type = type,
                               .radius_mm = shape->radius_mm,
                               .height_mm = type == LX_CYLINDER ? shape->height_mm : 0,
                               .profile = *profile};
    memcpy(round.center_mm, stand->center_mm, sizeof round.center_mm);
    memcpy(round.radii_mm, shape->radii_mm, sizeof round.radii_mm);
    round.axis = lx_unit3(lx_exact3(axis));
    if (lx_shapes_add(shapes, &round))
        return -1;
    if (type != LX_DISK)
        return 0;
    round.axis = lx_negate3(round.axis);
    round.is_back = true;
    return lx_shapes_add(shapes, &round);
}

static int make_shapes(const struct lx_opening *opening, const struct lx_emitter *point, struct lx_shapes *shapes)
{
    static const enum lx_emitter_type round_types[] = {LX_DISK, LX_BALL, LX_CYLINDER};
    const struct lx_opening_shape *const rounds[] = {&opening->disk, &opening->sphere, &opening->cylinder};
    const char *const names[] = {"disk", "sphere", "cylinder"};
    const struct lx_table *const tables[] = {&disk_table, &sphere_table, &cylinder_table};
    if (lx_is_given(&lx_opening_table, opening, "rectangle")) {
        const struct stand stand = stand_of(&rectangle_table, &opening->rectangle, point);
        return add_rectangle(shapes, stand.center_mm, opening->rectangle.size_mm[0], opening->rectangle.size_mm[1],
                             stand.axis, stand.across);
    }
    if (lx_is_given(&lx_opening_table, opening, "box")) {
        const struct stand stand = stand_of(&box_table, &opening->box, point);
        return add_box(shapes, &stand, opening->box.size_mm);
    }
    for (size_t i = 0; i < LX_COUNT(names); i++) {
        const struct stand stand = stand_of(tables[i], rounds[i], point);
        const bool has_axis = round_types[i] != LX_BALL && lx_is_given(tables[i], rounds[i], "axis");
        const double *axis = has_axis ? rounds[i]->axis : stand.axis;
        if (!lx_is_given(&lx_opening_table, opening, names[i]))
            continue;
        return add_round(shapes, round_types[i], &stand, rounds[i], axis, &point->profile);
    }
    return -1;
}

/* The area of all parts, each counted once, in m^2. */
static lx_bounded area_of(const struct lx_shapes *shapes)
{
    lx_bounded area = lx_exact(0);
    for (size_t i = 0; i < shapes->emitters.count; i++)
        if (!shapes->emitters.items[i].is_back)
            area = lx_add(area, lx_extended_area_mm2(&shapes->emitters.items[i]));
    return lx_div(area, lx_exact(1e6));
}

int lx_opening_emit(const struct lx_opening *opening, const struct lx_emitter *point, struct lx_emitters *emitters)
{
    struct lx_shapes shapes = {0};
    int result = make_shapes(opening, point, &shapes);
    const lx_bounded density =
        result == 0 ? lx_div(lx_strength(point), area_of(&shapes)) : lx_exact(0);
    for (size_t i = 0; i < shapes.emitters.count && result == 0; i++) {
        struct lx_emitter *emitter = &shapes.emitters.items[i];
        emitter->radiance = density;
        emitter->profile = point->profile;
        lx_law_copy(point, emitter);
        result = lx_emitters_make_room(emitters, 1, emitter->facets ? emitter->facets->face_count : 0, 0);
        if (result == 0) {
            result = lx_emitters_append(emitters, emitter);
            emitter->facets = NULL; /* they are the list's now */
        }
    }
    lx_shapes_clear(&shapes);
    return result;
}
