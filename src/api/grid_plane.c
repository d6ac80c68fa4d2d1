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
#include "../world/integral/adaptive.h"
#include "grid_measuring.h"
#include "reflecting.h"

/* From this share of the mean on the sampling error is said to be one. */
static const double COARSE = 0.01;

/* Light of luminous openings is an integral at each place: that over a plane would take a million of them.  Nor is
 * light over mirrors integrated. */
static bool has_openings(const struct lx_emitters *emitters)
{
    for (size_t i = 0; i < lx_item_count(emitters); i++)
        if (lx_is_opening(&emitters->items[i]))
            return true;
    return false;
}

/* ---- what is reflected ---- */

/* The integral of reflected light over the plane, along lines and across them: places that are asked, at most, panels
 * of a line and of the lines, and the share of the bound wanted of values that the rules may add. */
enum { MOST_PLACES = 1500, MOST_PANELS = 16 };
static const double RULES_SHARE = 0.25;

struct reflection {
    const struct lx_measuring *measuring;
    const struct lx_asking *asking;
    double target; /* of the mean */
    double v;      /* of the line */
    size_t asked;
};

static struct lx_point_value reflected_at(void *data, size_t interval, double u)
{
    struct reflection *reflection = data;
    const struct lx_measuring *measuring = reflection->measuring;
    const struct lx_cells *cells = &measuring->made->cells;
    double place_mm[3];
    struct lx_elements elements;
    struct lx_received received;
    (void)interval;
    lx_place_on_cells(cells, (const double[]){u * cells->size_mm[0], reflection->v * cells->size_mm[1]}, place_mm);
    lx_elements_begin(&elements, &measuring->measure.lobe, true);
    lx_elements_append_place(&elements, lx_exact3(place_mm), cells->normal, NULL);
    lx_elements_end(&elements);
    lx_world_settle(&measuring->world, &(struct lx_settling){.has_normals = true}, &elements);
    lx_world_light(&measuring->world, &elements, LX_WANT_REFLECTED, reflection->asking, &received);
    reflection->asked++;
    const lx_bounded light = lx_column_get(&received.reflected, 0);
    return (struct lx_point_value){.value = fmax(light.value, 0), .error = light.error};
}

static double target(void *data, const struct lx_integral *integral)
{
    const struct reflection *reflection = data;
    (void)integral;
    return reflection->asked < MOST_PLACES && lx_asking_goes_on(reflection->asking) ? reflection->target : HUGE_VAL;
}

/* The mean along a line, twice as exact as that of the lines is wanted. */
static double target_of_line(void *data, const struct lx_integral *integral)
{
    return target(data, integral) / 2;
}

static struct lx_integral integrate(struct lx_integrand *integrand)
{
    struct lx_panel items[MOST_PANELS] = {{.from = -0.5, .to = 0.5}};
    struct lx_panels panels = {.items = items, .count = 1, .capacity = MOST_PANELS};
    integrand->is_coarse = true;
    return lx_integrate_panels(integrand, &panels);
}

static struct lx_point_value along_line(void *data, size_t interval, double v)
{
    struct reflection *reflection = data;
    struct lx_integrand integrand = {.at = reflected_at, .target = target_of_line, .data = data};
    (void)interval;
    reflection->v = v;
    const struct lx_integral line = integrate(&integrand);
    return (struct lx_point_value){.value = line.value, .error = line.error + line.inherited};
}

/* The mean of what is reflected to the plane. */
static lx_bounded reflected_mean(const struct lx_measuring *measuring, const struct lx_asking *asking)
{
    struct reflection reflection = {.measuring = measuring,
                                    .asking = asking,
                                    .target = RULES_SHARE * lx_reflected_error_of(measuring->settings) *
                                              measuring->made->grid.average.value};
    struct lx_integrand integrand = {.at = along_line, .target = target, .data = &reflection};
    const struct lx_integral mean = integrate(&integrand);
    return (lx_bounded){mean.value, mean.error + mean.inherited};
}

/* ---- the whole light ---- */

void lx_integrate_plane(const struct lx_measuring *measuring)
{
    luxel_grid *grid = &measuring->made->grid;
    const struct lx_asking asking = {.control = measuring->control, .is_caller = true};
    const bool photometric = strcmp(grid->unit, "lx") == 0, radiometric = strcmp(grid->unit, "W/m²") == 0;
    if ((!photometric && !radiometric) || grid->measured + grid->enclosed != (size_t)grid->columns * grid->rows ||
        measuring->world.prepared->mirrors.count > 0 || has_openings(&measuring->world.prepared->emitters))
        return;
    struct lx_flux flux =
        lx_plane_flux(measuring->world.prepared, &measuring->made->cells, grid->average.value, &asking);
    const lx_bounded area =
        lx_mul(lx_div(lx_exact(grid->size_mm[0]), lx_exact(1000)), lx_div(lx_exact(grid->size_mm[1]), lx_exact(1000)));
    if (flux.is_known && measuring->world.reflected)
        flux.value = lx_add(flux.value, lx_mul(reflected_mean(measuring, &asking), area));
    const lx_bounded mean = lx_div(flux.value, area);
    grid->has_mean = flux.is_known && isfinite(mean.value) && isfinite(mean.error);
    if (!grid->has_mean)
        return;
    grid->mean = mean;
    grid->flux_unit = photometric ? "lm" : "W";
    grid->flux = flux.value;
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
                                  .measure = measuring->measure,
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
        grid->sampling_error = fabs(grid->average.value - grid->mean.value) + grid->mean.error;
    } else {
        grid->sampling_error = fabs(grid->average.value - other_average(measuring));
        grid->has_sampling_error = isfinite(grid->sampling_error);
        grid->sampling_error = grid->has_sampling_error ? grid->sampling_error : 0;
    }
    const double size = fmax(fabs(grid->average.value), grid->has_mean ? fabs(grid->mean.value) : 0);
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
    const unsigned cells = measuring->ring || measuring->bodies.are_bodies ? grid->columns * grid->rows : 0;
    for (unsigned cell = 0; cell < cells; cell++) {
        if (measuring->ring &&
            lx_ring_leaves_out(measuring->ring, &measuring->made->cells, cell % grid->columns, cell / grid->columns)) {
            measuring->inside[cell] = 1;
            continue;
        }
        const struct lx_prepared_surface *around =
            lx_body_around_cell(measuring, cell % grid->columns, cell / grid->columns);
        measuring->inside[cell] = around != NULL;
        if (around && grid->enclosed++ == 0)
            grid->enclosing_surface = around->authored;
    }
}
