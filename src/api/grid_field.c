/* SPDX-License-Identifier: MIT */
/*
 * The values of a measuring plane alone: of its own cells, and as a field of as many as are wanted, with places on the
 * plane.
 */
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../field/field.h"
#include "grid.h"

luxel_status luxel_find_grid_values(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                    luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    unsigned n[2] = {0, 0};
    luxel_scene_grid_resolution(scene, i, &n[0], &n[1]);
    return lx_measure_cells(scene, settings, i, n, diagnostics, grid);
}

/* The centres of cells along a side, from its middle. */
static double *new_places(double size_mm, unsigned count, double sign)
{
    double *places = lx_new_array(count, sizeof *places);
    for (unsigned i = 0; places && i < count; i++)
        places[i] = sign * size_mm * ((2.0 * i + 1) / count - 1) / 2;
    return places;
}

/* The field, which takes the grid's values and mask over; NULL when memory is short. */
static struct luxel_field *field_of(luxel_grid *grid, const struct lx_scene_parameters *scene)
{
    struct luxel_field *field = lx_new_array(1, sizeof *field);
    if (!field)
        return NULL;
    *field = (struct luxel_field){
        .columns = grid->columns,
        .rows = grid->rows,
        .quantity = LUXEL_IRRADIANCE,
        .quantity_word = lx_quantity_word(LUXEL_IRRADIANCE, scene->units == LX_PHOTOMETRIC),
        .precision = LUXEL_DOUBLE,
        .unit = lx_copy_text(grid->unit, strlen(grid->unit)),
        .instruction_set = "",
        .values = (double *)grid->values,
        .mask = (uint8_t *)grid->mask,
        .x_mm = new_places(grid->size_mm[0], grid->columns, 1),
        .y_mm = new_places(grid->size_mm[1], grid->rows, -1),
        .picture = scene->picture,
    };
    grid->values = NULL;
    grid->mask = NULL;
    if (field->unit && field->x_mm && field->y_mm && lx_gather_statistics(field) == 0)
        return field;
    luxel_field_free(field);
    return NULL;
}

luxel_status luxel_find_grid_field(const luxel_scene *scene, const luxel_settings *settings, size_t i, unsigned columns,
                                   unsigned rows, luxel_diagnostics *diagnostics, luxel_field **field)
{
    const unsigned n[2] = {columns, rows};
    luxel_grid *grid = NULL;
    char number[LX_NUMBER_SIZE];
    if (!field)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS("field"));
    for (int k = 0; k < 2; k++)
        if (n[k] < 1 || n[k] > 65536)
            return lx_refuse(diagnostics, LX_MSG_SETTING_OUT_OF_RANGE,
                             LX_ARGS(k == 0 ? "columns" : "rows", lx_write_number(n[k], number), "1–65536"));
    luxel_status status = lx_measure_cells(scene, settings, i, n, diagnostics, &grid);
    if (status != LUXEL_OK)
        return status;
    *field = field_of(grid, lx_scene_parameters(scene));
    luxel_grid_free(grid);
    return *field ? LUXEL_OK : lx_out_of_memory(diagnostics);
}
