/* SPDX-License-Identifier: MIT */
/*
 * Isolux lines of a measuring plane where light jumps.  Between two samples of the field a line stands where their
 * values, taken for a straight rise, reach its level; at the edge of a shadow that is nowhere near the edge, and lines
 * along it would have teeth.  Vertices whose exact value tells so are moved, between the same two samples, to where the
 * light really passes the level.
 */
#include <luxel/evaluator.h>
#include <luxel/isophotes.h>
#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../scene/lit.h"
#include "grid.h"
#include "refuse.h"

/* A vertex stays where its value is off the level by no more than a share of what its samples differ by; others are
 * looked for by so many halvings of the way between these. */
static const double OFF_LEVEL = 1e-3;
enum { HALVINGS = 8 };

/* A vertex between two samples, along one of the coordinates. */
struct vertex {
    double *x_mm, *y_mm;
    double *moves;   /* one of these */
    double below_mm; /* where that is at the sample below the level, and at the one above it */
    double above_mm;
    double level, step; /* step: by how much the samples differ */
};

/* Vertices that are looked at together, and what is asked of them. */
struct vertices {
    struct vertex *items;
    luxel_place *places;
    luxel_value *values;
    size_t count;
};

/* The last of rising or falling places that is not beyond `at`; the other end of the cell follows it. */
static size_t cell_of(const double *places, size_t count, double at)
{
    const double sign = places[count - 1] > places[0] ? 1 : -1;
    size_t first = 0, last = count - 1;
    while (last - first > 1) {
        const size_t middle = first + (last - first) / 2;
        if (sign * places[middle] > sign * at)
            last = middle;
        else
            first = middle;
    }
    return places[last] == at ? last : first;
}

/* False: the vertex stands on a sample, or there is no value beside it. */
static bool find_samples(const luxel_field *field, struct vertex *vertex)
{
    const double *x = luxel_field_x_mm(field), *y = luxel_field_y_mm(field);
    const size_t columns = luxel_field_columns(field), rows = luxel_field_rows(field);
    const size_t column = cell_of(x, columns, *vertex->x_mm), row = cell_of(y, rows, *vertex->y_mm);
    const bool along_y = x[column] == *vertex->x_mm;
    if (along_y == (y[row] == *vertex->y_mm) || (along_y ? row + 1 == rows : column + 1 == columns))
        return false;
    const size_t first = row * columns + column, second = first + (along_y ? columns : 1);
    const double *values = luxel_field_double(field), *places = along_y ? y + row : x + column;
    const bool rises = values[first] < values[second];
    if (!luxel_field_mask(field)[first] || !luxel_field_mask(field)[second])
        return false;
    vertex->moves = along_y ? vertex->y_mm : vertex->x_mm;
    vertex->below_mm = places[!rises];
    vertex->above_mm = places[rises];
    vertex->step = fabs(values[second] - values[first]);
    return true;
}

static luxel_status evaluate(const struct lx_cells *cells, const luxel_evaluator *evaluator, struct vertices *vertices)
{
    for (size_t i = 0; i < vertices->count; i++) {
        luxel_place *place = &vertices->places[i];
        *place = (luxel_place){.is_element = true};
        lx_values3(cells->normal, place->normal);
        lx_place_on_cells(cells, (const double[]){*vertices->items[i].x_mm, *vertices->items[i].y_mm},
                          place->position_mm);
    }
    return luxel_evaluate_places(evaluator, vertices->places, vertices->count, vertices->values, NULL);
}

/* Keeps the vertices that do not stand where the light passes their level. */
static void keep_stray(struct vertices *vertices)
{
    size_t kept = 0;
    for (size_t i = 0; i < vertices->count; i++) {
        const struct vertex *vertex = &vertices->items[i];
        const luxel_value *value = &vertices->values[i];
        if (!value->has_value || fabs(value->value - vertex->level) <= OFF_LEVEL * vertex->step)
            continue;
        vertices->values[kept] = *value;
        vertices->items[kept++] = *vertex;
    }
    vertices->count = kept;
}

/* Narrows the way to each vertex by what was found at it, and puts it into the middle of the rest. */
static void halve(struct vertices *vertices)
{
    for (size_t i = 0; i < vertices->count; i++) {
        struct vertex *vertex = &vertices->items[i];
        if (vertices->values[i].has_value)
            *(vertices->values[i].value < vertex->level ? &vertex->below_mm : &vertex->above_mm) = *vertex->moves;
        *vertex->moves = (vertex->below_mm + vertex->above_mm) / 2;
    }
}

static luxel_status move(const luxel_scene *scene, const struct lx_cells *cells, const luxel_settings *settings,
                         struct vertices *vertices, luxel_diagnostics *diagnostics)
{
    luxel_evaluator *evaluator = NULL;
    luxel_settings of_plane;
    luxel_settings_init(&of_plane);
    if (settings)
        of_plane = *settings;
    of_plane.quantity = LUXEL_IRRADIANCE;
    luxel_status status = luxel_evaluator_new(scene, &of_plane, diagnostics, &evaluator);
    if (status == LUXEL_OK)
        status = evaluate(cells, evaluator, vertices);
    if (status == LUXEL_OK)
        keep_stray(vertices);
    for (int i = 0; i < HALVINGS && vertices->count > 0 && status == LUXEL_OK; i++) {
        halve(vertices);
        status = evaluate(cells, evaluator, vertices);
    }
    if (status == LUXEL_OK)
        halve(vertices);
    luxel_evaluator_free(evaluator);
    return status;
}

/* The vertices of all lines, which are the caller's, that stand between two samples of the field. */
static luxel_status take_vertices(const luxel_field *field, const luxel_isophotes *lines, struct vertices *vertices)
{
    size_t most = 0;
    for (size_t l = 0; l < lines->count; l++)
        most += lines->lines[l].count;
    vertices->items = lx_new_array(most, sizeof *vertices->items);
    vertices->places = lx_new_array(most, sizeof *vertices->places);
    vertices->values = lx_new_array(most, sizeof *vertices->values);
    if (!vertices->items || !vertices->places || !vertices->values)
        return LUXEL_ERROR_MEMORY;
    for (size_t l = 0; l < lines->count; l++) {
        const luxel_isophote *line = &lines->lines[l];
        for (size_t i = 0; i < line->count; i++) {
            struct vertex vertex = {.x_mm = (double *)&line->x_mm[i], .y_mm = (double *)&line->y_mm[i]};
            vertex.level = line->level;
            if (find_samples(field, &vertex))
                vertices->items[vertices->count++] = vertex;
        }
    }
    return LUXEL_OK;
}

/* Whether light may jump on the plane, where it is asked for quickly. */
static bool has_edges(const struct lx_scene_parameters *scene, const struct lx_grid *grid)
{
    return grid->measure == LX_MEASURE_PLANE && !lx_has_extended_lights(scene) && !lx_wants_reflections(scene);
}

luxel_status luxel_find_grid_isophotes(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                       const luxel_field *field, const double *levels, size_t count,
                                       luxel_diagnostics *diagnostics, luxel_isophotes **isophotes)
{
    const struct lx_grid *grid = lx_asked_grid(scene, i, field, "field", diagnostics);
    struct vertices vertices = {.count = 0};
    if (!grid)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = luxel_find_isophotes(field, NULL, levels, count, diagnostics, isophotes);
    if (status != LUXEL_OK || !has_edges(lx_scene_parameters(scene), grid))
        return status;
    const struct lx_cells cells = lx_cells_of(grid);
    status = take_vertices(field, *isophotes, &vertices);
    if (status == LUXEL_ERROR_MEMORY)
        lx_out_of_memory(diagnostics);
    else if (vertices.count > 0)
        status = move(scene, &cells, settings, &vertices, diagnostics);
    free(vertices.items);
    free(vertices.places);
    free(vertices.values);
    if (status != LUXEL_OK) {
        luxel_isophotes_free(*isophotes);
        *isophotes = NULL;
    }
    return status;
}
