/* SPDX-License-Identifier: MIT */
/* A measuring grid as JSON. */
#include "grid_json.h"

#include "grid_color.h"
#include "grid_measure.h"
#include "progress.h"
#include "result.h"

static void write_extremum(struct json *json, const char *key, const luxel_grid *grid,
                           const luxel_grid_extremum *extremum)
{
    if (grid->measured == 0) {
        json_null(json, key);
        return;
    }
    json_open(json, key, '{');
    json_number(json, "value", extremum->value);
    json_wholes(json, "cell", (const unsigned[]){extremum->column, extremum->row}, 2);
    json_numbers(json, "position", extremum->position_mm, 3);
    if (grid->colors)
        result_write_color(json, &grid->colors[(size_t)extremum->row * grid->columns + extremum->column]);
    json_close(json, '}');
}

/* The values or their bounds, row by row, null where there is none. */
static void write_cells(struct json *json, const char *key, const luxel_grid *grid, const double *numbers)
{
    json_open(json, key, '[');
    for (unsigned row = 0; row < grid->rows; row++) {
        json_open(json, NULL, '[');
        for (unsigned column = 0; column < grid->columns; column++) {
            const size_t cell = (size_t)row * grid->columns + column;

            if (grid->mask[cell])
                json_number(json, NULL, numbers[cell]);
            else
                json_null(json, NULL);
        }
        json_close(json, ']');
    }
    json_close(json, ']');
}

/* The cells inside of bodies, each as its column and row, where there are some. */
static void write_inside(struct json *json, const luxel_grid *grid)
{
    if (grid->enclosed == 0)
        return;
    json_open(json, "inside_cells", '[');
    for (unsigned row = 0; row < grid->rows; row++)
        for (unsigned column = 0; column < grid->columns; column++)
            if (grid->inside[(size_t)row * grid->columns + column])
                json_wholes(json, NULL, (const unsigned[]){column, row}, 2);
    json_close(json, ']');
}

static void write_peak(struct json *json, const char *key, const luxel_grid_peak *peak, bool in_color)
{
    if (!peak->exists) {
        json_null(json, key);
        return;
    }
    json_open(json, key, '{');
    json_number(json, "value", peak->value);
    json_number(json, "error", peak->error);
    json_numbers(json, "position", peak->position_mm, 3);
    if (in_color) {
        const luxel_color color = grid_color_of_peak(peak);
        result_write_color(json, &color);
    }
    json_close(json, '}');
}

void grid_write_json(struct json *json, const luxel_grid *grid, const luxel_grid_extrema *extrema,
                     const struct judged *judged)
{
    const bool measured = grid->measured > 0;

    json_open(json, NULL, '{');
    json_text(json, "name", grid->name);
    json_numbers(json, "center", grid->center_mm, 3);
    json_numbers(json, "size", grid->size_mm, 2);
    json_numbers(json, "axis", grid->axis, 3);
    json_numbers(json, "up", grid->up, 3);
    json_wholes(json, "n", (const unsigned[]){grid->columns, grid->rows}, 2);
    grid_measure_write(json, grid);
    json_number_if(json, "average", measured, grid->average.value);
    write_extremum(json, "minimum", grid, &grid->minimum);
    write_extremum(json, "maximum", grid, &grid->maximum);
    json_open(json, "extrema", '{');
    write_peak(json, "minimum", &extrema->minimum, grid->colors);
    write_peak(json, "maximum", &extrema->maximum, grid->colors);
    json_close(json, '}');
    json_number_if(json, "u0", grid->has_evenness, grid->u0);
    json_number_if(json, "ud", grid->has_evenness, grid->ud);
    json_number_if(json, "flux", grid->flux_unit != NULL, grid->flux.value);
    json_text(json, "flux_unit", grid->flux_unit);
    json_number_if(json, "flux_error", grid->flux_unit != NULL, grid->flux.error);
    json_number_if(json, "mean", grid->has_mean, grid->mean.value);
    json_number_if(json, "mean_error", grid->has_mean, grid->mean.error);
    json_number_if(json, "error", measured, grid->error);
    if (grid->has_reflected) {
        json_open(json, "reflected", '{');
        json_number(json, "average", grid->reflected_average);
        json_number(json, "error", grid->reflected_error);
        json_text(json, "ended", progress_end_word(grid->reflected_reached));
        json_close(json, '}');
    }
    json_number_if(json, "average_error", measured, grid->average.error);
    json_number_if(json, "sampling_error", grid->has_sampling_error, grid->sampling_error);
    json_text(json, "sampling_error_is",
              !grid->has_sampling_error ? NULL
              : grid->sampling_is_bound ? "bound"
                                        : "estimate");
    json_bool(json, "coarse", grid->is_coarse);
    grid_areas_write(json, grid);
    limits_write(json, judged);
    json_whole(json, "measured", grid->measured);
    json_whole(json, "inside", grid->enclosed);
    write_inside(json, grid);
    write_cells(json, "values", grid, grid->values);
    write_cells(json, "errors", grid, grid->errors);
    if (grid->colors)
        grid_color_write(json, grid);
    json_close(json, '}');
}
