/* SPDX-License-Identifier: MIT */
/*
 * The measuring grids of the present scene, the irradiance in their cells and what is read off it, and its observers,
 * whom the lights dazzle; both with their limits and whether these are kept.
 */
#include <stdlib.h>

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

/* The size of the rectangle around the grid that a strip of it reaches to; null where there is none. */
static void answer_area(const char *key, const luxel_grid *area)
{
    answer_key(key);
    if (!area) {
        answer_string(NULL);
        return;
    }
    answer_open('{');
    answer_key("center");
    answer_numbers(area->center_mm, 3);
    answer_key("size");
    answer_numbers(area->size_mm, 2);
    answer_amount("average", area->average.value, area->average.error);
    answer_close('}');
}

static void answer_grid(const luxel_scene *scene, size_t i, const luxel_grid *grid)
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
    answer_area("surround", grid->surround);
    answer_area("background", grid->background);
    answer_grid_limits(scene, i, grid);
    answer_close('}');
}

static luxel_status answer_grids(const luxel_scene *scene, const luxel_settings *settings)
{
    luxel_status status = LUXEL_OK;

    answer_key("grids");
    answer_open('[');
    for (size_t i = 0; i < luxel_scene_grid_count(scene) && status == LUXEL_OK; i++) {
        luxel_grid *grid = NULL;

        status = luxel_find_grid_values(scene, settings, i, fresh_diagnostics(), &grid);
        if (status == LUXEL_OK)
            answer_grid(scene, i, grid);
        luxel_grid_free(grid);
    }
    answer_close(']');
    return status;
}

/* ---- observers ---- */

/* Observers that are one entry of the scene: the greatest of their ratings, and their limits as one. */
struct rated {
    luxel_bounded worst;
    bool has_rating;
    size_t limit_count;
    luxel_limit limits[LUXEL_MOST_LIMITS];
};

static luxel_status rate(const luxel_scene *scene, const luxel_settings *settings, const luxel_observer_places *places,
                         struct rated *rated)
{
    luxel_limit(*judged)[LUXEL_MOST_LIMITS] = calloc(places->count, sizeof *judged);
    luxel_limit *of_one = calloc(places->count, sizeof *of_one);
    luxel_status status = judged && of_one ? LUXEL_OK : LUXEL_ERROR_MEMORY;

    *rated = (struct rated){.has_rating = false};
    for (size_t k = 0; k < places->count && status == LUXEL_OK; k++) {
        luxel_glare_sight sight;
        luxel_glare *glare = NULL;

        luxel_scene_observer(scene, places->first + k, NULL, &sight);
        status = luxel_find_glare(scene, settings, &sight, fresh_diagnostics(), &glare);
        if (status != LUXEL_OK)
            break;
        luxel_judge_glare(scene, places->first + k, glare, judged[k], &rated->limit_count);
        if (glare->has_rating && (!rated->has_rating || glare->rating.value > rated->worst.value))
            rated->worst = glare->rating;
        rated->has_rating |= glare->has_rating;
        luxel_glare_free(glare);
    }
    for (size_t i = 0; i < rated->limit_count && status == LUXEL_OK; i++) {
        for (size_t k = 0; k < places->count; k++)
            of_one[k] = judged[k][i];
        rated->limits[i] = luxel_worst_limit(of_one, places->count);
    }
    free(judged);
    free(of_one);
    return status;
}

static void answer_observer(const luxel_scene *scene, const luxel_observer_places *places, const struct rated *rated)
{
    const char *name = NULL;
    luxel_glare_sight sight;

    luxel_scene_observer(scene, places->first, &name, &sight);
    answer_open('{');
    answer_key("name");
    answer_string(name);
    answer_key("eye");
    answer_numbers(sight.eye_mm, 3);
    answer_key("view");
    answer_numbers(sight.view, 3);
    answer_key("places");
    answer_number((double)places->count);
    if (rated->has_rating)
        answer_amount("ugr", rated->worst.value, rated->worst.error);
    answer_limits(rated->limits, rated->limit_count);
    answer_close('}');
}

static luxel_status answer_observers(const luxel_scene *scene, const luxel_settings *settings)
{
    luxel_status status = LUXEL_OK;
    luxel_observer_places places;

    answer_key("observers");
    answer_open('[');
    for (size_t i = 0; i < luxel_scene_observer_count(scene) && status == LUXEL_OK; i += places.count) {
        struct rated rated;

        luxel_scene_observer_places(scene, i, &places);
        status = rate(scene, settings, &places, &rated);
        if (status == LUXEL_OK)
            answer_observer(scene, &places, &rated);
    }
    answer_close(']');
    return status;
}

/* All grids and observers; NULL where one cannot be measured. */
PAGE_CALLS(page_grids) const char *page_grids(void)
{
    const luxel_settings settings = present_settings();
    const luxel_scene *scene = computed_scene();

    if (!scene)
        return NULL;
    answer_begin();
    answer_open('{');
    luxel_status status = answer_grids(scene, &settings);
    if (status == LUXEL_OK)
        status = answer_observers(scene, &settings);
    answer_close('}');
    return status == LUXEL_OK ? answer_text() : NULL;
}
