/* SPDX-License-Identifier: MIT */
/* Colours of grids: their averages, with bounds, and what is printed of them. */
#include "grid_color.h"

#include <float.h>
#include <math.h>

#include "cli.h"
#include "result.h"
#include "text.h"

/* The channels of the average; the bounds are those of the cells, averaged, with room for the roundings of the sum. */
static luxel_color average_color(const luxel_grid *grid)
{
    luxel_color average = {.exists = grid->measured > 0};
    const size_t cells = (size_t)grid->columns * grid->rows;

    for (int c = 0; c < 3 && average.exists; c++) {
        double sum = 0.0, errors = 0.0, sizes = 0.0;

        for (size_t i = 0; i < cells; i++) {
            sum += grid->colors[i].rgb[c];
            errors += grid->colors[i].error[c];
            sizes += fabs(grid->colors[i].rgb[c]);
        }
        average.rgb[c] = sum / (double)grid->measured;
        average.error[c] = 1.01 * (errors + (double)(cells + 2) * DBL_EPSILON * sizes) / (double)grid->measured;
    }
    return average;
}

luxel_color grid_color_of_peak(const luxel_grid_peak *peak)
{
    return (luxel_color){.exists = peak->exists,
                         .rgb = {peak->rgb[0], peak->rgb[1], peak->rgb[2]},
                         .error = {peak->rgb_error, peak->rgb_error, peak->rgb_error}};
}

/* The channels of the average and, cell by cell, of the values, null where there is none. */
void grid_color_write(struct json *json, const luxel_grid *grid)
{
    const luxel_color average = average_color(grid);

    json_open(json, "average_color", '{');
    result_write_color(json, &average);
    json_close(json, '}');
    json_open(json, "rgb", '[');
    for (unsigned row = 0; row < grid->rows; row++) {
        json_open(json, NULL, '[');
        for (unsigned column = 0; column < grid->columns; column++) {
            const luxel_color *color = &grid->colors[(size_t)row * grid->columns + column];

            if (color->exists) {
                json_open(json, NULL, '{');
                json_numbers(json, "value", color->rgb, 3);
                json_numbers(json, "error", color->error, 3);
                json_close(json, '}');
            } else {
                json_null(json, NULL);
            }
        }
        json_close(json, ']');
    }
    json_close(json, ']');
}

void grid_color_print(const luxel_grid *grid, const luxel_grid_extrema *extrema)
{
    const luxel_color average = average_color(grid), least = grid_color_of_peak(&extrema->minimum);
    const luxel_color greatest = grid_color_of_peak(&extrema->maximum);
    char words[TEXT_SIZE];

    printf(_("  colour of the average: %s\n"), result_color_text(&average, words));
    if (least.exists)
        printf(_("  colour of the minimum: %s\n"), result_color_text(&least, words));
    if (greatest.exists)
        printf(_("  colour of the maximum: %s\n"), result_color_text(&greatest, words));
}
