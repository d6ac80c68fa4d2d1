/* SPDX-License-Identifier: MIT */
/* Daylight factors of the measuring grids of the present scene, in percent of what falls under its open sky. */
#include "answer.h"
#include "core.h"

static void answer_cells(const luxel_daylight_grid *grid)
{
    answer_key("values");
    answer_open('[');
    for (size_t i = 0; i < (size_t)grid->columns * grid->rows; i++)
        if (grid->cells[i].has_value)
            answer_number(grid->cells[i].value.value);
        else
            answer_string(NULL);
    answer_close(']');
}

static void answer_grid(const luxel_daylight_grid *grid)
{
    answer_open('{');
    answer_cells(grid);
    answer_key("measured");
    answer_number((double)grid->measured);
    answer_amount("mean", grid->mean.value, grid->mean.error);
    answer_amount("median", grid->median.value, grid->median.error);
    answer_key("shares");
    answer_numbers(grid->shares, LUXEL_DAYLIGHT_LEVELS);
    answer_close('}');
}

/* Those of all grids; NULL where the scene has no sky that shines, or one cannot be found. */
PAGE_CALLS(page_daylight) const char *page_daylight(void)
{
    const luxel_settings settings = present_settings();
    luxel_daylight *found = NULL;

    if (!core.scene ||
        luxel_find_daylight(computed_scene(), &settings, NULL, 0, 0, fresh_diagnostics(), &found) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('{');
    answer_amount("horizontal", found->horizontal.value, found->horizontal.error);
    answer_key("levels");
    answer_open('[');
    for (size_t i = 0; i < LUXEL_DAYLIGHT_LEVELS; i++)
        answer_number(luxel_daylight_level(i));
    answer_close(']');
    answer_key("grids");
    answer_open('[');
    for (size_t i = 0; i < found->grid_count; i++)
        answer_grid(&found->grids[i]);
    answer_close(']');
    answer_close('}');
    luxel_daylight_free(found);
    return answer_text();
}
