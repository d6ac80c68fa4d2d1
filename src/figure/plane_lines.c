/* SPDX-License-Identifier: MIT */
/*
 * Isolux lines of a measuring plane where light jumps.  Between two samples of the field a line stands where their
 * values, taken for a straight rise, reach its level; at the edge of a shadow that is nowhere near the edge, and lines
 * along it would have teeth.  Vertices whose exact value tells so are moved, between the same two samples, to where the
 * light really passes the level.
 */
#include <math.h>
#include <stdlib.h>

#include <luxel/evaluator.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "figure.h"

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

static luxel_status evaluate(const struct lx_figure *figure, const luxel_evaluator *evaluator,
                             struct vertices *vertices)
{
    const luxel_grid *grid = figure->plane->grid;
    for (size_t i = 0; i < vertices->count; i++) {
        luxel_place *place = &vertices->places[i];
        *place = (luxel_place){.is_element = true, .normal = {grid->axis[0], grid->axis[1], grid->axis[2]}};
        for (int k = 0; k < 3; k++)
            place->position_mm[k] = grid->center_mm[k] + *vertices->items[i].x_mm * grid->across[k] +
                                    *vertices->items[i].y_mm * grid->up[k];
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

static luxel_status move(const struct lx_figure *figure, const luxel_settings *settings, struct vertices *vertices,
                         luxel_diagnostics *diagnostics)
{
    luxel_evaluator *evaluator = NULL;
    luxel_settings of_plane = lx_whole_picture(settings);
    of_plane.quantity = LUXEL_IRRADIANCE;
    luxel_status status = luxel_evaluator_new(figure->copy, &of_plane, diagnostics, &evaluator);
    if (status == LUXEL_OK)
        status = evaluate(figure, evaluator, vertices);
    if (status == LUXEL_OK)
        keep_stray(vertices);
    for (int i = 0; i < HALVINGS && vertices->count > 0 && status == LUXEL_OK; i++) {
        halve(vertices);
        status = evaluate(figure, evaluator, vertices);
    }
    if (status == LUXEL_OK)
        halve(vertices);
    luxel_evaluator_free(evaluator);
    return status;
}

luxel_status lx_plane_move_lines(struct lx_figure *figure, const luxel_settings *settings,
                                 luxel_diagnostics *diagnostics)
{
    struct vertices vertices = {.count = 0};
    size_t most = 0;
    if (lx_figure_is_slow(figure) || figure->plane->grid->has_reflected)
        return LUXEL_OK; /* no light jumps there, or each value takes too long */
    for (size_t l = 0; l < figure->isophotes->count; l++)
        most += figure->isophotes->lines[l].count;
    vertices.items = lx_new_array(most, sizeof *vertices.items);
    vertices.places = lx_new_array(most, sizeof *vertices.places);
    vertices.values = lx_new_array(most, sizeof *vertices.values);
    luxel_status status = vertices.items && vertices.places && vertices.values ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    for (size_t l = 0; l < figure->isophotes->count && status == LUXEL_OK; l++) {
        const luxel_isophote *line = &figure->isophotes->lines[l];
        for (size_t i = 0; i < line->count; i++) { /* the lines are the figure's own */
            struct vertex vertex = {.x_mm = (double *)&line->x_mm[i], .y_mm = (double *)&line->y_mm[i]};
            vertex.level = line->level;
            if (find_samples(figure->field, &vertex))
                vertices.items[vertices.count++] = vertex;
        }
    }
    if (status == LUXEL_ERROR_MEMORY)
        lx_out_of_memory(diagnostics);
    else if (vertices.count > 0)
        status = move(figure, settings, &vertices, diagnostics);
    free(vertices.items);
    free(vertices.places);
    free(vertices.values);
    return status;
}
