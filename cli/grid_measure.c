/* SPDX-License-Identifier: MIT */
/* Grids that measure something else than the light on their planes, as luxel grid tells of them. */
#include "grid_measure.h"

#include <string.h>

#include "cli.h"

static bool is_of_plane(const luxel_grid *grid)
{
    return strcmp(grid->measure, "plane") == 0;
}

void grid_measure_write(struct json *json, const luxel_grid *grid)
{
    if (is_of_plane(grid))
        return;
    json_text(json, "measure", grid->measure);
    if (!grid->has_modelling)
        return;
    json_open(json, "modelling", '{');
    json_number(json, "value", grid->modelling.value);
    json_number(json, "error", grid->modelling.error);
    json_number(json, "minimum", grid->least_modelling.value);
    json_number(json, "maximum", grid->greatest_modelling.value);
    json_close(json, '}');
}

void grid_measure_print(const luxel_grid *grid)
{
    if (!is_of_plane(grid))
        printf(_("  measure: %s, about the normal as its axis\n\n"), grid->measure);
}

void grid_measure_add(struct text_table *table, const luxel_grid *grid)
{
    const luxel_bounded *ratio = &grid->modelling;
    char number[TEXT_SIZE], bound[TEXT_SIZE], cell[TEXT_SIZE];

    if (!grid->has_modelling)
        return;
    text_table_row(table, TEXT_CELLS(_("modelling: the average by that on the plane"),
                                     text_bounded(number, 9, ratio->value, ratio->error),
                                     text_format(cell, "± %s", text_bound(bound, 9, ratio->value, ratio->error)), ""));
    text_table_row(table, TEXT_CELLS(_("modelling at the cells"),
                                     text_format(number, "%.4g – %.4g", grid->least_modelling.value,
                                                 grid->greatest_modelling.value),
                                     "", ""));
}
