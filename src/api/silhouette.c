/* SPDX-License-Identifier: MIT */
/* The silhouettes of a scene's surfaces: of meshes by their triangles, of others by what their kinds outline. */
#include <luxel/mesh.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../scene/scene.h"
#include "../surface/mesh.h"
#include "../surface/part.h"
#include "../surface/sheet.h"
#include "../surface/silhouette.h"

/* How far two vectors may be from unit ones at right angles. */
static const double SLACK = 1e-6;

static bool are_axes(const double right[3], const double up[3])
{
    return fabs(lx_dot(right, right) - 1) < SLACK && fabs(lx_dot(up, up) - 1) < SLACK &&
           fabs(lx_dot(right, up)) < SLACK;
}

/* Lines in mm out of those in the frame of the tree. */
static luxel_silhouette *make(const struct lx_silhouette *traced, double size, const double anchor[2])
{
    luxel_silhouette *made = lx_new_array(1, sizeof *made);
    luxel_silhouette_line *lines = lx_new_array(traced->line_count, sizeof *lines);
    double(*places)[2] = lx_new_array(traced->place_count, sizeof *places);
    if (!made || !lines || !places) {
        free(places);
        free(lines);
        free(made);
        return NULL;
    }
    for (size_t i = 0; i < traced->place_count; i++)
        for (int axis = 0; axis < 2; axis++)
            places[i][axis] = anchor[axis] + size * traced->places[i][axis];
    for (size_t i = 0, begin = 0; i < traced->line_count; begin = traced->ends[i++])
        lines[i] = (luxel_silhouette_line){(const double(*)[2])places + begin, traced->ends[i] - begin};
    *made = (luxel_silhouette){.lines = lines, .count = traced->line_count};
    if (made->count == 0) /* the first line holds the places of all */
        free(places);
    return made;
}

/* ---- outlines ---- */

/* The plane that is drawn on, and what is drawn. */
struct drawing {
    const double *right, *up;
    struct lx_silhouette *drawn;
    double last_mm[3]; /* where the line that is being drawn has come to */
    double side;       /* the sine of the angle from it to the surface: above 0 on its left */
    bool failed;
};

static void add_place(struct drawing *drawing, const double place_mm[3])
{
    struct lx_silhouette *drawn = drawing->drawn;
    if (drawing->failed ||
        lx_reserve(&drawn->places, &drawn->place_room, drawn->place_count + 1, sizeof *drawn->places)) {
        drawing->failed = true;
        return;
    }
    drawn->places[drawn->place_count][0] = lx_dot(place_mm, drawing->right);
    drawn->places[drawn->place_count++][1] = lx_dot(place_mm, drawing->up);
    memcpy(drawing->last_mm, place_mm, sizeof drawing->last_mm);
}

static size_t first_of_last(const struct lx_silhouette *drawn)
{
    return drawn->line_count > 0 ? drawn->ends[drawn->line_count - 1] : 0;
}

static double area_of(const struct lx_silhouette *drawn, size_t from, size_t to)
{
    double area = 0;
    for (size_t i = from; i < to; i++) {
        const double *a = drawn->places[i], *b = drawn->places[i + 1 < to ? i + 1 : from], *o = drawn->places[from];
        area += ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])) / 2;
    }
    return area;
}

/* Ends a line, if there is one, turned so that the surface is on its left, or counter-clockwise where it is behind. */
static void end_line(struct drawing *drawing)
{
    struct lx_silhouette *drawn = drawing->drawn;
    size_t from = first_of_last(drawn), to = drawn->place_count;
    if (drawing->failed || from == to)
        return;
    const double *first = drawn->places[from], *last = drawn->places[to - 1];
    if (to - from > 2 &&
        hypot(last[0] - first[0], last[1] - first[1]) < 1e-12 * (hypot(first[0], first[1]) + hypot(last[0], last[1])))
        to = --drawn->place_count; /* it is closed */
    if (lx_reserve(&drawn->ends, &drawn->line_room, drawn->line_count + 1, sizeof *drawn->ends)) {
        drawing->failed = true;
        return;
    }
    drawn->ends[drawn->line_count++] = to;
    const bool is_turned = fabs(drawing->side) > SLACK ? drawing->side < 0 : area_of(drawn, from, to) < 0;
    for (; is_turned && from + 1 < to; from++, to--)
        for (int axis = 0; axis < 2; axis++) {
            const double kept = drawn->places[from][axis];
            drawn->places[from][axis] = drawn->places[to - 1][axis];
            drawn->places[to - 1][axis] = kept;
        }
}

/* The sine of the angle from a way to a place aside, as they are drawn. */
static double side_of(const struct drawing *drawing, const double from_mm[3], const double to_mm[3],
                      const double place_mm[3])
{
    double way[2], aside[2];
    for (int axis = 0; axis < 2; axis++) {
        const double *along = axis ? drawing->up : drawing->right;
        way[axis] = lx_dot(to_mm, along) - lx_dot(from_mm, along);
        aside[axis] = lx_dot(place_mm, along) - lx_dot(from_mm, along);
    }
    const double lengths = hypot(way[0], way[1]) * hypot(aside[0], aside[1]);
    return lengths > 0 ? (way[0] * aside[1] - way[1] * aside[0]) / lengths : 0;
}

/* Pieces of a rim, one beginning where the one before ends: a line goes on as far as they do. */
static bool add_piece(void *data, const double from_mm[3], const double to_mm[3], const double inside_mm[3])
{
    struct drawing *drawing = data;
    if (first_of_last(drawing->drawn) == drawing->drawn->place_count ||
        memcmp(from_mm, drawing->last_mm, sizeof drawing->last_mm) != 0) {
        end_line(drawing);
        add_place(drawing, from_mm);
        drawing->side = side_of(drawing, from_mm, to_mm, inside_mm);
    }
    add_place(drawing, to_mm);
    return !drawing->failed;
}

/* The rims of its sides, or what a kind without sides outlines. */
static void draw_shape(struct drawing *drawing, const struct lx_shape *shape, const struct lx_origin *eye)
{
    enum { STEPS = 96 };
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    double before[3], place[3], inside[3];
    if (lx_shape_sheets(shape, sheets) > 0 && sheets[0].type->rim) {
        sheets[0].type->rim(&sheets[0], eye, STEPS, add_piece, drawing);
        end_line(drawing);
        return;
    }
    for (int i = 0; i <= STEPS && shape->kind->outline; i++) {
        shape->kind->outline(shape, eye, i, STEPS, place, inside);
        if (i > 0)
            add_piece(drawing, before, place, inside);
        memcpy(before, place, sizeof before);
    }
    end_line(drawing);
}

/* Each part by itself. */
static int draw_surface(const struct lx_item *item, const double right[3], const double up[3],
                        struct lx_silhouette *drawn)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    struct drawing drawing = {.right = right, .up = up, .drawn = drawn};
    struct lx_origin eye = {.endless = true};
    lx_cross(right, up, eye.at);
    for (unsigned i = 0; i < lx_part_count(kind); i++) {
        struct lx_part part;
        lx_part_make(kind, item->parameters, i, &part);
        draw_shape(&drawing, &part.shape, &eye);
    }
    return drawing.failed ? -1 : 0;
}

/* ---- meshes ---- */

static int trace_mesh(const struct lx_shape *mesh, const double right[3], const double up[3],
                      struct lx_silhouette *traced)
{
    const struct lx_mesh_body *body = mesh->body;
    const double size = lx_mesh_size_of(mesh);
    double axes[2][3];
    for (int axis = 0; axis < 2; axis++) {
        lx_mesh_enter(mesh, axis ? up : right, axes[axis]); /* which divides by the size */
        for (int k = 0; k < 3; k++)
            axes[axis][k] *= size;
    }
    return body->tree ? lx_trace_silhouette(body->tree, axes[0], axes[1], traced) : 0;
}

luxel_status luxel_find_silhouette(const luxel_scene *scene, size_t i, const double right[3], const double up[3],
                                   luxel_silhouette **silhouette)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    struct lx_mesh_use use;
    if (!parameters || i >= parameters->surfaces.count || !right || !up || !silhouette || !are_axes(right, up))
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_item *item = &parameters->surfaces.items[i];
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    const bool is_mesh = kind->mesh && kind->mesh(item->parameters, &use);
    const struct lx_shape shape = lx_surface_shape(kind, item->parameters);
    const double size = is_mesh ? lx_mesh_size_of(&shape) : 1;
    const double anchor[2] = {is_mesh ? lx_dot(shape.anchor_mm, right) : 0, is_mesh ? lx_dot(shape.anchor_mm, up) : 0};
    struct lx_silhouette traced = {0};
    if (is_mesh ? trace_mesh(&shape, right, up, &traced) : draw_surface(item, right, up, &traced)) {
        lx_clear_silhouette(&traced);
        return LUXEL_ERROR_MEMORY;
    }
    luxel_silhouette *made = make(&traced, size, anchor);
    lx_clear_silhouette(&traced);
    if (!made)
        return LUXEL_ERROR_MEMORY;
    *silhouette = made;
    return LUXEL_OK;
}

void luxel_silhouette_free(luxel_silhouette *silhouette)
{
    if (!silhouette)
        return;
    if (silhouette->count > 0)
        free((void *)silhouette->lines[0].places_mm);
    free((void *)silhouette->lines);
    free(silhouette);
}
