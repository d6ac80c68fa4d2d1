/* SPDX-License-Identifier: MIT */
/* Outlines of surfaces as lights see them. */
#include "outline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
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
    *light = (struct lx_outline_light){.emitter = emitter, .at.endless = lx_is_endless(emitter)};
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
static bool add_beside(struct drawing *drawing, const double from_mm[3], const double to_mm[3],
                       const double inside_mm[3])
{
    double way[3], along[3], inwards[3], left[3];
    lx_way_to(&drawing->light->at, from_mm, way);
    for (int k = 0; k < 3; k++) {
        along[k] = to_mm[k] - from_mm[k];
        inwards[k] = inside_mm[k] - from_mm[k];
    }
    lx_cross(way, along, left);
    return add(drawing, from_mm, to_mm, lx_dot(left, inwards) > 0 ? 1 : -1);
}

static void add_plate(struct drawing *drawing, const struct lx_smooth_sheet *sheet)
{
    double corners[4][3], normal[3];
    for (int c = 0; c < 4; c++)
        lx_sheet_place(sheet, c == 0 || c == 3 ? -1 : 1, c < 2 ? -1 : 1, corners[c], normal);
    for (int c = 0; c < 4 && !drawing->failed; c++)
        add_beside(drawing, corners[c], corners[(c + 1) % 4], sheet->center_mm);
}

/* Place i of a circle. */
static void on_circle(const double center_mm[3], double radius_mm, const double across[3], const double upward[3],
                      int i, double place_mm[3])
{
    const double angle = 2 * M_PI * i / PIECES;
    for (int k = 0; k < 3; k++)
        place_mm[k] = center_mm[k] + radius_mm * (cos(angle) * across[k] + sin(angle) * upward[k]);
}

/* Adds a circle, from each place of which the surface goes on by `inwards`; NULL: to the middle. */
static void add_circle(struct drawing *drawing, const double center_mm[3], double radius_mm, const double across[3],
                       const double upward[3], const double *inwards)
{
    for (int i = 0; i < PIECES && !drawing->failed; i++) {
        double from[3], to[3], inside[3];
        on_circle(center_mm, radius_mm, across, upward, i, from);
        on_circle(center_mm, radius_mm, across, upward, i + 1, to);
        for (int k = 0; k < 3; k++)
            inside[k] = inwards ? (from[k] + to[k]) / 2 + inwards[k] : center_mm[k];
        add_beside(drawing, from, to, inside);
    }
}

/* A circle inside of which the surface has a hole. */
static void add_hole(struct drawing *drawing, const struct lx_smooth_sheet *disk)
{
    for (int i = 0; i < PIECES && disk->half_mm[1] > 0 && !drawing->failed; i++) {
        double from[3], to[3], inside[3];
        on_circle(disk->center_mm, disk->half_mm[1], disk->across, disk->upward, i, from);
        on_circle(disk->center_mm, disk->half_mm[1], disk->across, disk->upward, i + 1, to);
        for (int k = 0; k < 3; k++)
            inside[k] = from[k] + to[k] - disk->center_mm[k];
        add_beside(drawing, from, to, inside);
    }
}

/* The circle in which ways from the light touch a ball; inside of it there is none. */
static void add_ball(struct drawing *drawing, const double center_mm[3], double radius_mm)
{
    double way[3], across[3], upward[3], middle[3];
    lx_way_to(&drawing->light->at, center_mm, way);
    const double away = lx_normalize(way), sine = drawing->light->at.endless ? 0 : radius_mm / away;
    if (!(sine < 1))
        return;
    lx_around_axis(way, across, upward);
    for (int k = 0; k < 3; k++)
        middle[k] = center_mm[k] + radius_mm * sine * way[k];
    add_circle(drawing, middle, radius_mm * sqrt(1 - sine * sine), across, upward, NULL);
}

/* Both rims of a tube, and where ways from the light touch its side. */
static void add_tube(struct drawing *drawing, const struct lx_smooth_sheet *tube)
{
    const double radius = tube->half_mm[0], half = tube->half_mm[1];
    double way[3];
    for (int side = -1; side <= 1; side += 2) {
        double rim[3], inwards[3];
        for (int k = 0; k < 3; k++) {
            rim[k] = tube->center_mm[k] + side * half * tube->axis[k];
            inwards[k] = -side * half * tube->axis[k];
        }
        add_circle(drawing, rim, radius, tube->across, tube->upward, inwards);
    }
    lx_way_to(&drawing->light->at, tube->center_mm, way);
    const double x = lx_dot(way, tube->across), y = lx_dot(way, tube->upward), away = hypot(x, y);
    const double cosine = drawing->light->at.endless ? 0 : radius / away;
    for (int side = -1; side <= 1 && away > 0 && cosine < 1 && !drawing->failed; side += 2) {
        const double angle = atan2(y, x) + side * acos(cosine);
        double ends[2][3];
        for (int k = 0; k < 3; k++) {
            const double touch =
                tube->center_mm[k] + radius * (cos(angle) * tube->across[k] + sin(angle) * tube->upward[k]);
            ends[0][k] = touch - half * tube->axis[k];
            ends[1][k] = touch + half * tube->axis[k];
        }
        add_beside(drawing, ends[0], ends[1], tube->center_mm);
    }
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
    if (lx_shape_sheets(shape, sheets) == 0) {
        if (lx_mesh_count(shape) > 0)
            add_mesh(drawing, shape);
        return;
    }
    switch (sheets->type) {
    case LX_SHEET_DISK:
        add_circle(drawing, sheets->center_mm, sheets->half_mm[0], sheets->across, sheets->upward, NULL);
        add_hole(drawing, sheets);
        break;
    case LX_SHEET_TUBE: add_tube(drawing, sheets); break;
    case LX_SHEET_BALL: add_ball(drawing, sheets->center_mm, sheets->half_mm[0]); break;
    default: add_plate(drawing, sheets);
    }
}

/* ---- making ---- */

static bool casts(const struct lx_prepared *prepared, const struct lx_emitter *emitter)
{
    return !lx_is_uniform(emitter) && !emitter->is_back &&
           (lx_is_extended(emitter) ? prepared->shadows_extended : prepared->shadows);
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
