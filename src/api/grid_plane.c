/* SPDX-License-Identifier: MIT */
/*
 * The plane of a measuring grid as a whole: its mean and the flux through it, how far the average of the values may be
 * from the mean, and which cells lie inside of bodies.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../flux/flux.h"
#include "../light/solid/extended.h"
#include "../world/evaluate.h"
#include "grid_measuring.h"

/* From this share of the mean on the sampling error is said to be one. */
static const double COARSE = 0.01;

/* Light of luminous openings is an integral at each place: that over a plane would take a million of them. */
static bool has_openings(const struct lx_emitters *emitters)
{
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_opening(&emitters->items[i]))
            return true;
    return false;
}

void lx_integrate_plane(const struct lx_measuring *measuring)
{
    luxel_grid *grid = &measuring->made->grid;
    const struct lx_asking asking = {.control = measuring->control, .is_caller = true};
    const bool photometric = strcmp(grid->unit, "lx") == 0, radiometric = strcmp(grid->unit, "W/m²") == 0;
    if ((!photometric && !radiometric) || grid->measured + grid->enclosed != (size_t)grid->columns * grid->rows ||
        has_openings(&measuring->world.prepared->emitters))
        return;
    const struct lx_flux flux =
        lx_plane_flux(measuring->world.prepared, &measuring->made->cells, grid->average, &asking);
    lx_bounded area =
        lx_mul(lx_div(lx_exact(grid->size_mm[0]), lx_exact(1000)), lx_div(lx_exact(grid->size_mm[1]), lx_exact(1000)));
    lx_bounded mean = lx_div(flux.value, area);
    grid->has_mean = flux.is_known && isfinite(mean.value) && isfinite(mean.error);
    if (!grid->has_mean)
        return;
    grid->mean = mean.value;
    grid->mean_error = mean.error;
    grid->flux_unit = photometric ? "lm" : "W";
    grid->flux = flux.value.value;
    grid->flux_error = flux.value.error;
}

/* The sum of the values of a grid of half as many cells each way, of twice as many of a single one; NaN where a cell
 * has none, or memory is short. */
static double sum_of_other(const struct lx_measuring *measuring, struct lx_measured *other)
{
    const size_t cells = (size_t)other->grid.columns * other->grid.rows;
    struct lx_prepared hasty = *measuring->world.prepared; /* more digits than an estimate needs */
    hasty.tolerance = fmax(hasty.tolerance, 1e-6);
    struct lx_measuring coarse = {.world = measuring->world,
                                  .control = measuring->control,
                                  .threads = measuring->threads,
                                  .lobe = measuring->lobe,
                                  .bodies = measuring->bodies,
                                  .made = other,
                                  .values = lx_new_array(cells, sizeof *coarse.values),
                                  .errors = lx_new_array(cells, sizeof *coarse.errors),
                                  .mask = lx_new_array(cells, sizeof *coarse.mask)};
    coarse.world.prepared = &hasty;
    bool is_whole = lx_lattice_make(&other->cells, &coarse.lattice) == 0 && coarse.values && coarse.errors &&
                    coarse.mask && lx_measure_lattice(&coarse, true);
    lx_wide sum = lx_wide_of(0);
    for (size_t cell = 0; cell < cells && is_whole; cell++) {
        is_whole = coarse.mask[cell];
        sum = lx_wide_add(sum, lx_wide_of(coarse.values[cell]));
    }
    lx_lattice_clear(&coarse.lattice);
    free(coarse.values);
    free(coarse.errors);
    free(coarse.mask);
    return is_whole ? lx_wide_value(sum) : (double)NAN;
}

/* The average of that grid. */
static double other_average(const struct lx_measuring *measuring)
{
    struct lx_measured other = {.cells = measuring->made->cells};
    for (int i = 0; i < 2; i++)
        other.cells.n[i] = other.cells.n[i] > 1 ? (other.cells.n[i] + 1) / 2 : 2;
    other.grid.columns = other.cells.n[0];
    other.grid.rows = other.cells.n[1];
    return sum_of_other(measuring, &other) / ((double)other.cells.n[0] * other.cells.n[1]);
}

void lx_judge_sampling(const struct lx_measuring *measuring)
{
    luxel_grid *grid = &measuring->made->grid;
    if (grid->measured != (size_t)grid->columns * grid->rows)
        return;
    if (grid->has_mean) {
        grid->has_sampling_error = grid->sampling_is_bound = true;
        grid->sampling_error = fabs(grid->average - grid->mean) + grid->mean_error;
    } else {
        grid->sampling_error = fabs(grid->average - other_average(measuring));
        grid->has_sampling_error = isfinite(grid->sampling_error);
        grid->sampling_error = grid->has_sampling_error ? grid->sampling_error : 0;
    }
    const double size = fmax(fabs(grid->average), grid->has_mean ? fabs(grid->mean) : 0);
    grid->is_coarse = grid->has_sampling_error && grid->sampling_error > COARSE * size;
}

const struct lx_prepared_surface *lx_body_around_cell(const struct lx_measuring *measuring, unsigned column,
                                                      unsigned row)
{
    const lx_bounded3 place = lx_lattice_place(&measuring->lattice, column, row);
    return lx_body_around(&measuring->bodies, (const double[]){place.x.value, place.y.value, place.z.value});
}

void lx_find_enclosed_cells(const struct lx_measuring *measuring)
{
    luxel_grid *grid = &measuring->made->grid;
    for (unsigned cell = 0; measuring->bodies.are_bodies && cell < grid->columns * grid->rows; cell++) {
        const struct lx_prepared_surface *around =
            lx_body_around_cell(measuring, cell % grid->columns, cell / grid->columns);
        measuring->inside[cell] = around != NULL;
        if (around && grid->enclosed++ == 0)
            grid->enclosing_surface = around->authored;
    }
}
