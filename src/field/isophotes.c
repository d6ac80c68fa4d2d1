/* SPDX-License-Identifier: MIT */
/* Isophotes: checks what is asked for, runs the passes over the grid, and has their segments chained. */
#include "isophotes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/larger.h"
#include "../base/memory.h"
#include "../world/camera.h"
#include "gather.h"

/* How far the values of a picture may be from the exact ones, relative to its maximum; more than any precision. */
static const double PICTURE_ERROR = 1e-4;

void *lx_iso_append(struct lx_iso_search *search, struct lx_iso_list *list, size_t size)
{
    if (lx_reserve(&list->items, &list->capacity, list->count + 1, size)) {
        atomic_store(&search->short_of_memory, true);
        atomic_store(&search->control.stop, true);
        return NULL;
    }
    return (char *)list->items + size * list->count++;
}

size_t lx_iso_first_level(const struct lx_iso_search *search, double value)
{
    size_t first = 0, last = search->level_count;
    while (first < last) {
        size_t middle = first + (last - first) / 2;
        if (search->levels[middle] > value)
            last = middle;
        else
            first = middle + 1;
    }
    return first;
}

/* -- what is asked for -- */

static double picture_margin(const struct luxel_field *field)
{
    const luxel_extremum *maximum = &field->statistics.maximum;
    return maximum->exists ? (PICTURE_ERROR + field->light_error) * fabs(maximum->value) : 0;
}

/* Whether the field shows the evaluator's scene: its places are the screen's, and its maximum is found there. */
static bool is_of_scene(const struct luxel_field *field, const struct luxel_evaluator *evaluator)
{
    const struct lx_screen *screen = &evaluator->prepared.scene->screen;
    if (field->columns != screen->resolution[0] || field->rows != screen->resolution[1] ||
        field->quantity != evaluator->settings.quantity)
        return false;
    for (unsigned i = 0; i < field->columns; i++)
        if (field->x_mm[i] != lx_column_x_mm(screen, i))
            return false;
    for (unsigned i = 0; i < field->rows; i++)
        if (field->y_mm[i] != lx_row_y_mm(screen, i))
            return false;
    const luxel_extremum *maximum = &field->statistics.maximum;
    if (!maximum->exists)
        return true;
    luxel_value exact;
    luxel_evaluate_screen(evaluator, maximum->x_mm, maximum->y_mm, &exact, NULL);
    /* at a shadow's edge or the very rim the picture and the exact value may well differ */
    return !exact.has_value || exact.error > picture_margin(field) ||
           fabs(exact.value - maximum->value) <= picture_margin(field);
}

static luxel_status check(const struct luxel_field *field, const struct luxel_evaluator *evaluator,
                          const double *levels, size_t count, struct luxel_isophotes **isophotes,
                          luxel_diagnostics *diagnostics)
{
    const char *missing = !field ? "field" : !isophotes ? "isophotes" : !levels && count > 0 ? "levels" : NULL;
    if (missing)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(missing));
    for (size_t i = 0; i < count; i++)
        if (!isfinite(levels[i]))
            return lx_refuse(diagnostics, LX_MSG_BAD_LEVEL, NULL);
    if (!field->x_mm || !field->y_mm)
        return lx_no_places(diagnostics);
    if (evaluator && !is_of_scene(field, evaluator))
        return lx_refuse(diagnostics, LX_MSG_OTHER_SCENE, NULL);
    return LUXEL_OK;
}

/* The levels in rising order, each once; NULL: memory is short. */
static double *sort_levels(const double *levels, size_t *count)
{
    double *sorted = lx_new_array(*count + 1, sizeof *sorted);
    size_t kept = 0;
    if (!sorted)
        return NULL;
    if (*count > 0)
        memcpy(sorted, levels, *count * sizeof *sorted);
    qsort(sorted, *count, sizeof *sorted, lx_by_value);
    for (size_t i = 0; i < *count; i++)
        if (kept == 0 || sorted[i] != sorted[kept - 1])
            sorted[kept++] = sorted[i];
    *count = kept;
    return sorted;
}

/* -- the passes -- */

enum pass { SURFACES, CORNERS, EDGES, CELLS, PASSES };

/* How much of the time each takes, about. */
static const double pass_share[PASSES] = {0.05, 0.15, 0.7, 0.1};

struct job {
    struct lx_iso_search *search;
    enum pass pass;
};

static void run_lines(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct job *job = data;
    struct lx_iso_search *search = job->search;
    struct lx_iso_worker *own = &search->workers[worker];
    for (unsigned line = first; line < last && lx_control_goes_on(&search->control, is_caller); line++)
        switch (job->pass) {
        case SURFACES: lx_iso_surfaces(search, own, line); break;
        case CORNERS: lx_iso_corners(search, own, line); break;
        case EDGES: lx_iso_edges(search, own, line, is_caller); break;
        case CELLS: lx_iso_cells(search, own, line); break;
        case PASSES: break;
        }
}

/* The progress of one pass as that of the whole. */
static bool report_progress(double done, void *data)
{
    const struct lx_iso_search *search = data;
    const luxel_settings *settings = &search->evaluator->settings;
    return settings->progress(search->done + search->share * done, settings->progress_data);
}

static bool run_passes(struct lx_iso_search *search, unsigned threads)
{
    const struct luxel_evaluator *evaluator = search->evaluator;
    for (enum pass pass = evaluator ? SURFACES : EDGES; pass < PASSES; pass++) {
        double last = search->control.last;
        search->control = (struct lx_control){.rows = search->rows, .last = last, .data = search};
        search->control.progress = evaluator && evaluator->settings.progress ? report_progress : NULL;
        search->share = pass_share[pass];
        for (unsigned i = 0; i < threads; i++)
            search->workers[i].line = -1;
        struct job job = {.search = search, .pass = pass};
        if (!lx_rows_run(&search->control, threads, run_lines, &job))
            return false;
        search->done += search->share;
    }
    return true;
}

static void set_precision(struct lx_iso_search *search)
{
    const struct lx_screen *screen = &search->evaluator->prepared.scene->screen;
    /* integrals are only as good as the tolerance */
    bool integrated = luxel_evaluator_integrates(search->evaluator);
    search->near = picture_margin(search->field);
    search->accept = integrated ? fmax(1e-9, search->evaluator->prepared.tolerance) : 1e-9;
    search->goal = integrated ? search->accept / 10 : 1e-12;
    search->pull_mm = 1e-10 * fmax(screen->width_mm, screen->height_mm);
}

luxel_status luxel_find_isophotes(const luxel_field *field, const luxel_evaluator *evaluator, const double *levels,
                                  size_t count, luxel_diagnostics *diagnostics, luxel_isophotes **isophotes)
{
    luxel_status status = check(field, evaluator, levels, count, isophotes, diagnostics);
    if (status != LUXEL_OK)
        return status;
    struct lx_iso_search search = {.field = field, .evaluator = evaluator, .level_count = count};
    double *sorted = sort_levels(levels, &search.level_count);
    search.levels = sorted;
    unsigned threads = evaluator ? lx_thread_count(evaluator->settings.threads, field->rows / 8 + 1) : 1;
    struct luxel_isophotes *made = NULL;
    bool stopped = false;
    if (evaluator)
        set_precision(&search);
    if (sorted && lx_iso_grid_new(&search, threads) == 0) {
        stopped = !run_passes(&search, threads);
        if (!stopped)
            made = lx_iso_chain(&search, levels, count);
    }
    lx_iso_grid_clear(&search);
    free(sorted);
    if (stopped && !atomic_load(&search.short_of_memory))
        return LUXEL_CANCELLED;
    if (!made)
        return lx_out_of_memory(diagnostics);
    *isophotes = made;
    return LUXEL_OK;
}
