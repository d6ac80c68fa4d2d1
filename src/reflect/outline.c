/* SPDX-License-Identifier: MIT */
/* Outlines of surfaces as lights see them. */
#include "outline.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../light/sky/dome.h"
#include "../light/solid/extended.h"
#include "../surface/mesh_faces.h"
#include "../surface/sheet.h"

/* The straight pieces that a round outline has; the most outlines of all lights together. */
enum { PIECES = 16, MOST = 200000 };

/* ---- lights ---- */

static void set_reach(struct lx_outline_light *light, const double way[3], double length_mm)
{
    for (int side = 0; side < 2; side++, light->reach_count++)
        for (int k = 0; k < 3; k++)
            light->reach_mm[light->reach_count][k] = (side ? -1 : 1) * length_mm * way[k];
}

/* Corners of facets; where these are many, those that are farthest along the axes. */
static void reach_of_facets(const struct lx_facets *facets, struct lx_outline_light *light)
{
    const size_t most = sizeof light->reach_mm / sizeof *light->reach_mm;
    light->reach_count = (unsigned)(facets->corner_count <= most ? facets->corner_count : 6);
    for (size_t c = 0; c < facets->corner_count; c++) {
        const lx_wide3 *corner = &facets->corners_mm[c];
        const double at[3] = {lx_wide_value(corner->x) - facets->center_mm[0],
                              lx_wide_value(corner->y) - facets->center_mm[1],
                              lx_wide_value(corner->z) - facets->center_mm[2]};
        for (unsigned i = 0; i < light->reach_count; i++) {
            double *reach = light->reach_mm[i];
            const double sign = i % 2 ? -1 : 1;
            if (facets->corner_count <= most ? i == c : sign * at[i / 2] > sign * reach[i / 2])
                memcpy(reach, at, sizeof at);
        }
    }
}

static void set_light(const struct lx_emitter *emitter, struct lx_outline_light *light)
{
    const double axis[3] = {emitter->axis.x.value, emitter->axis.y.value, emitter->axis.z.value};
    double across[3], upward[3];
    *light = (struct lx_outline_light){.emitter = emitter, .at.endless = lx_is_endless(emitter) || lx_is_dome(emitter)};
    lx_emitter_origin(emitter, light->at.at);
    if (emitter->facets)
        reach_of_facets(emitter->facets, light);
    if (!lx_is_extended(emitter) || emitter->facets)
        return;
    lx_around_axis(axis, across, upward);
    set_reach(light, across, emitter->radius_mm);
    set_reach(light, upward, emitter->radius_mm);
    if (!lx_is_disk(emitter))
        set_reach(light, axis, lx_half_height(emitter) + (lx_emitter_kind(emitter)->bulges ? emitter->radius_mm : 0));
}

/* ---- outlines of surfaces ---- */

struct drawing {
    struct lx_outlines *outlines;
    const struct lx_outline_light *light;
    uint32_t surface;
    bool failed;
};

/* Adds the line between two places; `turn` is 1 where the surface is on its left as the light sees it, else -1. */
static bool add(struct drawing *drawing, const double from_mm[3], const double to_mm[3], double turn)
{
    struct lx_outlines *outlines = drawing->outlines;
    struct lx_shadow_outline outline = {.light = (uint32_t)(drawing->light - outlines->lights),
                                        .surface = drawing->surface};
    double way[3], along[3];
    if (outlines->count == MOST)
        return true;
    lx_way_to(&drawing->light->at, from_mm, way);
    for (int k = 0; k < 3; k++) {
        outline.from_mm[k] = from_mm[k];
        outline.to_mm[k] = to_mm[k];
        along[k] = turn * (to_mm[k] - from_mm[k]);
    }
    lx_cross(way, along, outline.dark);
    if (!(lx_normalize(outline.dark) > 0)) /* its shadow has no length */
        return true;
    drawing->failed =
        lx_reserve(&outlines->items, &outlines->capacity, outlines->count + 1, sizeof *outlines->items) != 0;
    if (!drawing->failed)
        outlines->items[outlines->count++] = outline;
    return !drawing->failed;
}

/* Adds a line beside which the surface goes on towards a place. */
static bool add_beside(void *data, const double from_mm[3], const double to_mm[3], const double inside_mm[3])
{
    struct drawing *drawing = data;
    double way[3], along[3], inwards[3], left[3];
    lx_way_to(&drawing->light->at, from_mm, way);
    for (int k = 0; k < 3; k++) {
        along[k] = to_mm[k] - from_mm[k];
        inwards[k] = inside_mm[k] - from_mm[k];
    }
    lx_cross(way, along, left);
    return add(drawing, from_mm, to_mm, lx_dot(left, inwards) > 0 ? 1 : -1);
}

static bool add_mesh_edge(void *data, const double from_mm[3], const double to_mm[3], int change)
{
    return add(data, from_mm, to_mm, change > 0 ? -1 : 1);
}

/* A place from which all of a mesh looks as the light sees it. */
static void add_mesh(struct drawing *drawing, const struct lx_shape *mesh)
{
    const double far = 1e6;
    double place[3];
    for (int k = 0; k < 3; k++)
        place[k] = drawing->light->at.endless ? mesh->anchor_mm[k] + far * mesh->radius_mm * drawing->light->at.at[k]
                                              : drawing->light->at.at[k];
    lx_mesh_outline(mesh, place, add_mesh_edge, drawing);
}

static void add_surface(struct drawing *drawing, const struct lx_shape *shape)
{
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    if (lx_shape_sheets(shape, sheets) > 0 && sheets->type->rim)
        sheets->type->rim(sheets, &drawing->light->at, PIECES, add_beside, drawing);
    else if (lx_mesh_count(shape) > 0)
        add_mesh(drawing, shape);
}

/* ---- making ---- */

static bool casts(const struct lx_prepared *prepared, const struct lx_emitter *emitter)
{
    if (lx_is_uniform(emitter) || emitter->is_back || (lx_is_dome(emitter) && !lx_is_sun(emitter->dome)))
        return false;
    return lx_has_one_way(emitter) ? prepared->shadows : prepared->shadows_extended;
}

int lx_outlines_make(const struct lx_prepared *prepared, struct lx_outlines *outlines)
{
    const size_t count = lx_item_count(&prepared->emitters);
    struct drawing drawing = {.outlines = outlines};
    *outlines = (struct lx_outlines){.prepared = prepared, .lights = lx_new_array(count, sizeof *outlines->lights)};
    if (!outlines->lights)
        return -1;
    for (size_t i = 0; i < count && !drawing.failed; i++) {
        if (!casts(prepared, &prepared->emitters.items[i]))
            continue;
        struct lx_outline_light *light = &outlines->lights[outlines->light_count++];
        set_light(&prepared->emitters.items[i], light);
        drawing.light = light;
        for (size_t s = 0; s < prepared->surface_count && !drawing.failed; s++) {
            drawing.surface = (uint32_t)s;
            add_surface(&drawing, &prepared->surfaces[s].shape);
        }
    }
    return drawing.failed ? -1 : 0;
}

void lx_outlines_clear(struct lx_outlines *outlines)
{
    free(outlines->lights);
    free(outlines->items);
    *outlines = (struct lx_outlines){0};
}
