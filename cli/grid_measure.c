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

/* An area around the plane as JSON, null where walls leave no room for it. */
static void write_area(struct json *json, const char *key, const luxel_grid *area)
{
    if (!area)
        return;
    json_open(json, key, '{');
    json_numbers(json, "center", area->center_mm, 3);
    json_numbers(json, "size", area->size_mm, 2);
    json_wholes(json, "n", (const unsigned[]){area->columns, area->rows}, 2);
    json_whole(json, "measured", area->measured);
    json_number_if(json, "average", area->measured > 0, area->average.value);
    json_number_if(json, "average_error", area->measured > 0, area->average.error);
    json_number_if(json, "minimum", area->measured > 0, area->minimum.value);
    json_number_if(json, "maximum", area->measured > 0, area->maximum.value);
    json_number_if(json, "error", area->measured > 0, area->error);
    json_number_if(json, "u0", area->has_evenness, area->u0);
    json_close(json, '}');
}

void grid_areas_write(struct json *json, const luxel_grid *grid)
{
    write_area(json, "surround", grid->surround);
    write_area(json, "background", grid->background);
}

static void add_area(struct text_table *table, const luxel_grid *area, const char *average, const char *evenness)
{
    char number[TEXT_SIZE], cells[TEXT_SIZE];

    if (!area)
        return;
    text_table_row(
        table, TEXT_CELLS(average, area->measured > 0 ? text_value(number, 6, area->average.value) : _("none"),
                          text_format(cells, ngettext("%zu cell", "%zu cells", area->measured), area->measured), ""));
    if (area->has_evenness)
        text_table_row(table, TEXT_CELLS(evenness, text_value(number, 6, area->u0), "", ""));
}

void grid_areas_add(struct text_table *table, const luxel_grid *grid)
{
    add_area(table, grid->surround, _("surrounding area: average"), _("surrounding area: U0"));
    add_area(table, grid->background, _("background area: average"), _("background area: U0"));
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
