/* SPDX-License-Identifier: MIT */
/*
 * The values of a measuring plane alone: of its own cells, and as a field of as many as are wanted, with places on the
 * plane.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../field/field.h"
#include "../scene/lit.h"
#include "grid.h"
#include "refuse.h"

static luxel_status find_values(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    struct lx_wanted_cells cells = {.area = NULL};
    luxel_scene_grid_resolution(scene, i, &cells.n[0], &cells.n[1]);
    return lx_measure_cells(scene, settings, i, &cells, diagnostics, grid);
}

luxel_status luxel_find_grid_values(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                    luxel_diagnostics *diagnostics, luxel_grid **grid)
{
    return lx_measure_with_areas(scene, settings, i, find_values, diagnostics, grid);
}

/* About so many cells show no corners in a figure and its lines, fewer where each takes integrals or a share of what is
 * reflected. */
enum { FINE_CELLS = 40000, FINE_CELLS_COSTLY = 2500, MOST_IN_A_ROW = 65536 };
/* Eyes tell no more of a colour. */
static const double FINE_TOLERANCE = 1e-4;

/* Into how many parts a side of a cell of the grid is cut: an odd number, so that its own centre is among theirs. */
static unsigned parts_of(double cell_mm, double wanted_mm)
{
    return 2 * (unsigned)fmin(fmax(round((cell_mm / wanted_mm - 1) / 2), 0), 1000) + 1;
}

/* Cells as many as a figure has. */
static void choose_cells(const luxel_scene *scene, size_t i, unsigned n[2])
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    const struct lx_grid *grid = (const struct lx_grid *)parameters->grids.items + i;
    const bool is_costly = lx_has_extended_lights(parameters) || lx_wants_reflections(parameters);
    const double cells = is_costly ? FINE_CELLS_COSTLY : FINE_CELLS;
    const double wanted_mm = sqrt(grid->size_mm[0] * grid->size_mm[1] / cells);
    for (int k = 0; k < 2; k++)
        n[k] = (unsigned)fmin(grid->n[k] * (double)parts_of(grid->size_mm[k] / grid->n[k], wanted_mm), MOST_IN_A_ROW);
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
    struct lx_wanted_cells cells = {.n = {columns, rows}};
    const unsigned *n = cells.n;
    luxel_grid *grid = NULL;
    luxel_settings fine;
    char number[LX_NUMBER_SIZE];
    luxel_settings_init(&fine);
    if (settings)
        fine = *settings;
    if (!lx_asked_grid(scene, i, field, "field", diagnostics))
        return LUXEL_ERROR_ARGUMENT;
    if (columns == 0 && rows == 0) {
        choose_cells(scene, i, cells.n);
        fine.tolerance = fmax(fine.tolerance, FINE_TOLERANCE);
    }
    for (int k = 0; k < 2; k++)
        if (n[k] < 1 || n[k] > MOST_IN_A_ROW)
            return lx_refuse(diagnostics, LX_MSG_SETTING_OUT_OF_RANGE,
                             LX_ARGS(k == 0 ? "columns" : "rows", lx_write_number(n[k], number), "1–65536"));
    luxel_status status = lx_measure_cells(scene, &fine, i, &cells, diagnostics, &grid);
    if (status != LUXEL_OK)
        return status;
    *field = field_of(grid, lx_scene_parameters(scene));
    luxel_grid_free(grid);
    return *field ? LUXEL_OK : lx_out_of_memory(diagnostics);
}
