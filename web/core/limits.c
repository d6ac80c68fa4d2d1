/* SPDX-License-Identifier: MIT */
/* Limits of grids and observers, and whether they are kept. */
#include <math.h>
#include <string.h>

#include "answer.h"
#include "core.h"

static void answer_limit(const luxel_limit *limit)
{
    const double value = limit->has_value ? limit->value.value : (double)NAN;
    const double error = limit->has_value ? limit->value.error : (double)NAN;

    answer_open('{');
    answer_key("name");
    answer_string(limit->name);
    answer_key("word");
    answer_string(page_translate(luxel_limit_word(limit), NULL));
    answer_key("wanted");
    answer_number(limit->wanted);
    answer_key("is_most");
    answer_bool(limit->is_most);
    answer_key("has_unit");
    answer_bool(luxel_limit_has_unit(limit));
    if (strcmp(limit->name, "share") == 0) {
        answer_key("above");
        answer_number(limit->above);
    }
    answer_key("value");
    answer_number(value);
    answer_key("error");
    answer_number(error);
    answer_key("verdict");
    answer_string(luxel_verdict_word(limit->verdict));
    answer_close('}');
}

void answer_limits(const luxel_limit *limits, size_t count)
{
    answer_key("limits");
    answer_open('[');
    for (size_t i = 0; i < count; i++)
        answer_limit(&limits[i]);
    answer_close(']');
}

void answer_grid_limits(const luxel_scene *scene, size_t i, const luxel_grid *grid)
{
    luxel_limit limits[2 * LUXEL_MOST_LIMITS];
    size_t count = 0;

    (void)luxel_judge_grid_and_areas(scene, i, grid, limits, &count);
    answer_limits(limits, count);
}
