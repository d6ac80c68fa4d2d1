/* SPDX-License-Identifier: MIT */
/*
 * A grid with all that is told of it: one of cylindrical illuminance has the modelling, its ratio to the illuminance on
 * the plane at the same places (EN 12464-1).
 */
#include <luxel/grid.h>

#include <math.h>

#include "../scene/scene.h"
#include "coloring.h"
#include "grid.h"

/* The ratio of the averages, and the least and greatest of the cells; there is none where the plane is dark. */
static void set_modelling(luxel_grid *grid, const luxel_grid *horizontal)
{
    lx_bounded least = {HUGE_VAL, 0}, greatest = {-HUGE_VAL, 0};
    grid->has_modelling = grid->measured > 0;
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows && grid->has_modelling; i++) {
        const lx_bounded on_plane = {horizontal->values[i], horizontal->errors[i]};
        if (!grid->mask[i])
            continue;
        grid->has_modelling = horizontal->mask[i] && on_plane.value > on_plane.error;
        const lx_bounded ratio = lx_div((lx_bounded){grid->values[i], grid->errors[i]}, on_plane);
        least = ratio.value < least.value ? ratio : least;
        greatest = ratio.value > greatest.value ? ratio : greatest;
    }
    if (!grid->has_modelling)
        return;
    grid->modelling = lx_div(grid->average, horizontal->average);
    grid->least_modelling = least;
    grid->greatest_modelling = greatest;
}

static luxel_status find_plane(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                               luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    static const enum lx_measure plane = LX_MEASURE_PLANE;
    const bool exists = grid && i < luxel_scene_grid_count(scene);
    const struct lx_scene_parameters *parameters = exists ? lx_scene_parameters(scene) : NULL;
    const struct lx_grid *asked = exists ? (const struct lx_grid *)parameters->grids.items + i : NULL;
    if (!exists || asked->measure != LX_MEASURE_CYLINDRICAL || lx_is_sum_of_channels(parameters, LUXEL_IRRADIANCE))
        return lx_measure_cells(scene, settings, i, NULL, diagnostics, grid);
    struct lx_part_progress progress;
    luxel_settings own;
    luxel_grid *horizontal = NULL;
    luxel_settings_init(&own);
    own = settings ? *settings : own;
    lx_part_progress_begin(&progress, 0, 2, settings, &own);
    luxel_status status = lx_measure_cells(scene, &own, i, NULL, diagnostics, grid);
    if (status != LUXEL_OK)
        return status;
    lx_part_progress_begin(&progress, 1, 2, settings, &own);
    const struct lx_wanted_cells cells = {.n = {asked->n[0], asked->n[1]}};
    status = lx_measure_as(scene, &own, i, &cells, &plane, diagnostics, &horizontal);
    if (status == LUXEL_OK)
        set_modelling(*grid, horizontal);
    else
        luxel_grid_free(*grid);
    luxel_grid_free(horizontal);
    return status;
}

luxel_status luxel_find_grid(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                             luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    return lx_measure_with_areas(scene, settings, i, find_plane, diagnostics, grid);
}
