/* SPDX-License-Identifier: MIT */
/*
 * Advice about lighting designs: luminaires too near to be points, luminaires in radiometric units, and rooms whose
 * floor and ceiling lie elsewhere than luminaires and measuring grids look.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "../light/array.h"
#include "../surface/part.h"
#include "mend.h"
#include "object.h"

static const double *vector_of(const struct lx_table *table, const void *parameters, const char *key)
{
    return lx_const_member(lx_find_parameter(table, key), parameters);
}

/* A share of a surface's size: what is no farther away lies on it. */
static const double MOUNTED = 1e-9;

/* How far a place is from the nearest part of a surface. */
static double distance_to(const struct lx_item *surface, const double place_mm[3])
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
    double least = HUGE_VAL, offset[3], direction[3];
    for (unsigned k = 0; k < lx_part_count(kind); k++) {
        struct lx_part part;
        lx_part_make(kind, surface->parameters, k, &part);
        for (int i = 0; i < 3; i++)
            offset[i] = place_mm[i] - part.shape.anchor_mm[i];
        const double distance = fabs(lx_shape_distance(&part.shape, offset, direction));
        /* a luminaire that is mounted on a wall does not light it */
        least = distance > MOUNTED * part.shape.radius_mm ? fmin(least, distance) : least;
    }
    return least;
}

/* A luminaire so near to a surface that it is no point. */
static void advise_near(struct lx_walk *walk, const struct lx_scene_parameters *scene, size_t light, lx_node_id id)
{
    static const double TIMES = 5;
    const struct lx_item *item = &scene->lights.items[light];
    const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
    const double opening_mm = kind->opening_mm && !lx_array_of(item) ? kind->opening_mm(item->parameters) : 0;
    const double *place_mm = vector_of(item->variant->table, item->parameters, "position");
    struct lx_step list = {NULL, "lights", 0}, element = {&list, NULL, light}, step = {&element, "position", 0};
    for (size_t s = 0; opening_mm > 0 && s < scene->surfaces.count; s++) {
        char number[LX_NUMBER_SIZE], away[LX_NUMBER_SIZE], length[LX_NUMBER_SIZE];
        const double distance = distance_to(&scene->surfaces.items[s], place_mm);
        if (!(distance < TIMES * opening_mm))
            continue;
        const lx_node_id at = lx_document_find(walk->document, id, "position");
        lx_walk_tell(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, at), &step, LX_MSG_LUMINAIRE_NEAR,
                     LX_ARGS(lx_write_number((double)s, number), lx_write_digits(distance, 4, away),
                             lx_write_digits(opening_mm, 4, length)));
        lx_hint(walk->diagnostics,
                scene->reflections.choice == LX_REFLECTIONS_NONE ? LX_MSG_HINT_OPENING : LX_MSG_HINT_OPENING_SLOW,
                NULL);
        return;
    }
}

/* ---- units ---- */

static bool is_luminaire(const struct lx_item *light)
{
    const struct lx_light_kind *kind = (const struct lx_light_kind *)light->variant;
    const struct lx_light_common *common = light->common;
    const char *file;
    return common->enabled && kind->photometry && kind->photometry(light->parameters, &file);
}

/* Luminaires' files are in candela and lumens. */
static void advise_units(struct lx_walk *walk, size_t light, lx_node_id id)
{
    char name[40];
    struct lx_text text = {0};
    const lx_node_id units = lx_document_find(walk->document, walk->document->root, "units");
    snprintf(name, sizeof name, "lights[%zu]", light);
    lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, units ? units : id),
                   &(struct lx_step){NULL, "units", 0}, LX_MSG_LUMINAIRE_UNITS, name, NULL);
    lx_mend_add(&text, "units=photometric");
    lx_mend_hint(walk, &text);
}

/* ---- which way is up ---- */

/* What looks somewhere from a place: a luminaire or a measuring grid. */
struct looker {
    const char *list;
    size_t index;
    lx_node_id node;
    const double *place_mm, *axis;
    bool is_written; /* the axis is */
};

/* The wall of a room that is met from a place inside; NULL: none. */
static const char *wall_met(const struct lx_item *room, const struct looker *looker)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)room->variant;
    const char *name = NULL;
    double nearest = HUGE_VAL;
    struct lx_ray ray = {{0}, {0}, {0}, {0}};
    if (!lx_surface_surrounds(kind, room->parameters, looker->place_mm))
        return NULL;
    memcpy(ray.origin_mm, looker->place_mm, sizeof ray.origin_mm);
    memcpy(ray.direction, looker->axis, sizeof ray.direction);
    for (unsigned k = 0; k < lx_part_count(kind); k++) {
        struct lx_part part;
        lx_part_make(kind, room->parameters, k, &part);
        const struct lx_hit hit = part.kind->hit(&part.shape, &ray);
        if (!hit.exists || hit.t >= nearest)
            continue;
        nearest = hit.t;
        name = lx_part_name(kind, k);
    }
    return name;
}

static bool is_any(const char *name, const char *first, const char *second)
{
    return strcmp(name, first) == 0 || strcmp(name, second) == 0;
}

/* The other axis that may be up in a room, where that makes its back and front floor and ceiling. */
static void mend_up(struct lx_walk *walk, const struct lx_item *room, size_t index, const char *wall)
{
    const struct lx_parameter *up = lx_find_parameter(room->variant->table, "up");
    struct lx_text text = {0};
    if (!up || !up->choices || !is_any(wall, "back", "front"))
        return;
    const char *now = lx_chosen(up, room->parameters);
    lx_mend_add(&text, "surfaces[%zu].up=%s", index, up->choices[strcmp(now, up->choices[0]) == 0]);
    lx_mend_hint(walk, &text);
}

static void report_looker(struct lx_walk *walk, const struct looker *looker, const char *wall, size_t room)
{
    char name[40];
    struct lx_step list = {NULL, looker->list, 0}, element = {&list, NULL, looker->index};
    const lx_node_id axis = lx_document_find(walk->document, looker->node, "axis");
    snprintf(name, sizeof name, "surfaces[%zu]", room);
    lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(walk->document, axis ? axis : looker->node), &element,
                   LX_MSG_LOOKS_AT_WALL, wall, name);
}

/* Luminaires and grids in a room that look at one of its walls, unless that is meant: their axis is written, and others
 * there look at the floor or the ceiling. */
static void advise_room(struct lx_walk *walk, const struct lx_item *room, size_t index, const struct looker *lookers,
                        size_t count)
{
    bool is_upright = false;
    for (size_t i = 0; i < count && !is_upright; i++) {
        const char *wall = wall_met(room, &lookers[i]);
        is_upright = wall && is_any(wall, "floor", "ceiling");
    }
    for (size_t i = 0; i < count; i++) {
        const char *wall = wall_met(room, &lookers[i]);
        if (!wall || is_any(wall, "floor", "ceiling") || (is_upright && lookers[i].is_written))
            continue;
        report_looker(walk, &lookers[i], wall, index);
        mend_up(walk, room, index, wall);
    }
}

/* The luminaires that are on and not aimed, and the grids.  Returns how many there are. */
static size_t find_lookers(const struct lx_walk *walk, const struct lx_scene_parameters *scene, struct looker *lookers)
{
    const struct lx_document *document = walk->document;
    size_t count = 0;
    lx_node_id id = lx_document_node(document, lx_document_find(document, document->root, "lights"))->first;
    for (size_t i = 0; i < scene->lights.count; i++, id = lx_document_node(document, id)->next) {
        const struct lx_item *light = &scene->lights.items[i];
        const struct lx_table *table = light->variant->table;
        if (is_luminaire(light) && !lx_is_given(table, light->parameters, "aim"))
            lookers[count++] = (struct looker){"lights",
                                               i,
                                               id,
                                               vector_of(table, light->parameters, "position"),
                                               vector_of(table, light->parameters, "axis"),
                                               lx_is_given(table, light->parameters, "axis")};
    }
    const lx_node_id grids = lx_document_find(document, document->root, "grids");
    id = grids ? lx_document_node(document, grids)->first : 0;
    for (size_t i = 0; i < scene->grids.count; i++, id = lx_document_node(document, id)->next) {
        const struct lx_grid *grid = (const struct lx_grid *)scene->grids.items + i;
        if (!grid->surface)
            lookers[count++] =
                (struct looker){"grids", i, id, grid->center_mm, grid->axis, lx_is_given(&lx_grid_table, grid, "axis")};
    }
    return count;
}

void lx_advise_design(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_scene_parameters *parameters = &scene->parameters;
    const struct lx_document *document = walk->document;
    bool is_told = parameters->units == LX_PHOTOMETRIC;
    lx_node_id id = lx_document_node(document, lx_document_find(document, document->root, "lights"))->first;
    for (size_t i = 0; i < parameters->lights.count; i++, id = lx_document_node(document, id)->next) {
        if (!is_luminaire(&parameters->lights.items[i]))
            continue;
        if (!is_told)
            advise_units(walk, i, id);
        is_told = true;
        advise_near(walk, parameters, i, id);
    }
    struct looker *lookers = lx_new_array(parameters->lights.count + parameters->grids.count, sizeof *lookers);
    const size_t count = lookers ? find_lookers(walk, parameters, lookers) : 0;
    walk->out_of_memory = walk->out_of_memory || !lookers;
    for (size_t s = 0; s < parameters->surfaces.count; s++)
        if (((const struct lx_surface_kind *)parameters->surfaces.items[s].variant)->part_names)
            advise_room(walk, &parameters->surfaces.items[s], s, lookers, count);
    free(lookers);
}
