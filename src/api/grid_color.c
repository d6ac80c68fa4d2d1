/* SPDX-License-Identifier: MIT */
/* Measuring grids in colour: the sums of grey ones.  All that is read off a plane but its extrema is linear. */
#include <math.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../world/evaluate.h"
#include "color_worlds.h"
#include "coloring.h"
#include "grid.h"
#include "session.h"

static size_t cells_of(const luxel_grid *grid)
{
    return (size_t)grid->columns * grid->rows;
}

/* Adds a number with its bound to a sum, or begins that. */
static lx_bounded add_number(const struct lx_color_part *part, bool begins, lx_bounded from, lx_bounded sum)
{
    return lx_reported(lx_add_part(begins ? lx_exact(0) : sum, part->luminance, from.value, from.error));
}

/* Adds a part to the luminances of a grid, and to what is linear in them.  The first part is the grid itself. */
static void add_values(luxel_grid *grid, const struct lx_color_part *part, const luxel_grid *from)
{
    const bool begins = grid == from;
    const double size = fabs(part->luminance);
    double *values = (double *)grid->values, *errors = (double *)grid->errors;
    uint8_t *mask = (uint8_t *)grid->mask;
    for (size_t i = 0; i < cells_of(grid); i++) {
        const lx_bounded sum = add_number(part, begins, (lx_bounded){from->values[i], from->errors[i]},
                                          (lx_bounded){values[i], errors[i]});
        values[i] = sum.value;
        errors[i] = sum.error;
        mask[i] = mask[i] && from->mask[i];
    }
    grid->average = add_number(part, begins, from->average, grid->average);
    grid->mean = add_number(part, begins, from->mean, grid->mean);
    grid->flux = add_number(part, begins, from->flux, grid->flux);
    grid->sampling_error = (begins ? 0 : grid->sampling_error) + size * from->sampling_error;
    grid->reflected_average = (begins ? 0 : grid->reflected_average) + part->luminance * from->reflected_average;
    grid->reflected_error = (begins ? 0 : grid->reflected_error) + size * from->reflected_error;
    grid->has_mean = grid->has_mean && from->has_mean;
    grid->has_sampling_error = grid->has_sampling_error && from->has_sampling_error;
    grid->sampling_is_bound = grid->sampling_is_bound && from->sampling_is_bound;
    grid->reflected_reached = grid->reflected_reached && from->reflected_reached;
    grid->tolerance_reached = grid->tolerance_reached && from->tolerance_reached;
}

static luxel_grid_extremum extremum_at(const luxel_grid *grid, size_t cell)
{
    luxel_grid_extremum extremum = {.value = grid->values[cell],
                                    .column = (unsigned)(cell % grid->columns),
                                    .row = (unsigned)(cell / grid->columns)};
    luxel_grid_position(grid, extremum.column, extremum.row, extremum.position_mm);
    return extremum;
}

/* What is read off the values of a sum. */
static void finish_sum(luxel_grid *grid)
{
    size_t least = 0, greatest = 0;
    grid->measured = 0;
    grid->error = 0;
    for (size_t i = 0; i < cells_of(grid); i++) {
        if (!grid->mask[i])
            continue;
        const bool is_first = grid->measured++ == 0;
        least = is_first || grid->values[i] < grid->values[least] ? i : least;
        greatest = is_first || grid->values[i] > grid->values[greatest] ? i : greatest;
        grid->error = fmax(grid->error, grid->errors[i]);
    }
    if (grid->measured == 0)
        return;
    grid->minimum = extremum_at(grid, least);
    grid->maximum = extremum_at(grid, greatest);
    grid->has_evenness = grid->average.value > 0;
    grid->u0 = grid->has_evenness ? grid->minimum.value / grid->average.value : 0;
    grid->ud = grid->has_evenness ? grid->minimum.value / grid->maximum.value : 0;
    grid->is_coarse = grid->has_sampling_error && grid->sampling_error > 0.01 * grid->average.value;
}

/* Adds a part to the channels of the cells, before it is changed. */
static void add_channels(luxel_color *colors, const struct lx_color_part *part, const luxel_grid *from)
{
    for (size_t i = 0; i < cells_of(from); i++)
        lx_color_add(part, (lx_bounded){from->values[i], from->errors[i]}, &colors[i]);
}

/* A grid of one part, added to what is made; beside a grid that is known already the values alone count. */
static luxel_status add_part(const struct lx_color_parts *parts, size_t p, const luxel_settings *settings,
                             size_t number, const struct lx_wanted_cells *wanted, luxel_diagnostics *diagnostics,
                             luxel_grid **made, luxel_color **colors)
{
    luxel_grid *from = *made;
    const struct lx_wanted_cells cells = {.n = {*made ? (*made)->columns : 0, *made ? (*made)->rows : 0},
                                          .area = wanted ? wanted->area : NULL};
    luxel_status status = LUXEL_OK;
    if (!parts->is_single)
        status = lx_measure_grey(parts->list[p].scene, settings, number, parts->is_sum ? wanted : &cells, diagnostics,
                                 &from);
    if (status != LUXEL_OK)
        return status;
    if (!*colors)
        *colors = lx_new_array(cells_of(from), sizeof **colors);
    *made = *made ? *made : from;
    if (*colors)
        add_channels(*colors, &parts->list[p], from);
    if (parts->is_sum)
        add_values(*made, &parts->list[p], from);
    if (from != *made)
        luxel_grid_free(from);
    return *colors ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

luxel_status lx_measure_in_color(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                 const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    struct lx_color_parts parts = {.count = 0};
    struct lx_part_progress progress;
    luxel_settings own;
    luxel_grid *made = NULL;
    luxel_color *colors = NULL;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    own.quantity = LUXEL_IRRADIANCE; /* what falls on a plane, whatever else is asked for */
    if (status == LUXEL_OK)
        status = lx_color_parts_make(scene, &own, diagnostics, &parts);
    const size_t before = parts.is_sum ? 0 : 1, all = parts.is_single ? 1 : parts.count + before;
    lx_part_progress_begin(&progress, 0, all, settings, &own);
    if (status == LUXEL_OK && !parts.is_sum)
        status = lx_measure_grey(scene, &own, i, cells, diagnostics, &made);
    for (size_t p = 0; p < parts.count && status == LUXEL_OK; p++) {
        luxel_settings of_part = parts.list[p].settings;
        lx_part_progress_begin(&progress, p + before, all, settings, &of_part);
        status = add_part(&parts, p, &of_part, i, cells, diagnostics, &made, &colors);
    }
    if (made)
        made->colors = colors;
    if (status == LUXEL_OK && parts.is_sum)
        finish_sum(made);
    for (size_t cell = 0; status == LUXEL_OK && cell < cells_of(made); cell++)
        colors[cell].exists = made->mask[cell];
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        *grid = made;
    else
        luxel_grid_free(made);
    return status;
}
