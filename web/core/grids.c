/* SPDX-License-Identifier: MIT */
/* The measuring grids of the present scene: the irradiance in their cells, and what is read off it. */
#include "answer.h"
#include "core.h"

static void answer_extremum(const char *key, const luxel_grid_extremum *extremum)
{
    answer_key(key);
    answer_open('{');
    answer_key("value");
    answer_number(extremum->value);
    answer_key("position");
    answer_numbers(extremum->position_mm, 3);
    answer_close('}');
}

/* The values row by row, null where a cell has none. */
static void answer_cells(const luxel_grid *grid)
{
    answer_key("values");
    answer_open('[');
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows; i++)
        if (grid->mask[i])
            answer_number(grid->values[i]);
        else
            answer_string(NULL);
    answer_close(']');
}

static void answer_grid(const luxel_grid *grid)
{
    answer_open('{');
    answer_key("name");
    answer_string(grid->name);
    answer_key("columns");
    answer_number(grid->columns);
    answer_key("rows");
    answer_number(grid->rows);
    answer_key("center");
    answer_numbers(grid->center_mm, 3);
    answer_key("size");
    answer_numbers(grid->size_mm, 2);
    answer_key("across");
    answer_numbers(grid->across, 3);
    answer_key("up");
    answer_numbers(grid->up, 3);
    answer_key("unit");
    answer_string(page_translate(grid->unit, NULL));
    answer_cells(grid);
    answer_key("measured");
    answer_number((double)grid->measured);
    answer_amount("average", grid->average.value, grid->average.error);
    answer_extremum("minimum", &grid->minimum);
    answer_extremum("maximum", &grid->maximum);
    if (grid->has_evenness) {
        answer_key("u0");
        answer_number(grid->u0);
        answer_key("ud");
        answer_number(grid->ud);
    }
    answer_close('}');
}

/* All grids; NULL where one cannot be measured. */
PAGE_CALLS(page_grids) const char *page_grids(void)
{
    const luxel_settings settings = present_settings();
    const luxel_scene *scene = computed_scene();
    const size_t count = scene ? luxel_scene_grid_count(scene) : 0;
    luxel_status status = LUXEL_OK;
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        luxel_grid *grid = NULL;
        status = luxel_find_grid_values(scene, &settings, i, fresh_diagnostics(), &grid);
        if (status == LUXEL_OK)
            answer_grid(grid);
        luxel_grid_free(grid);
    }
    answer_close(']');
    return status == LUXEL_OK ? answer_text() : NULL;
}
