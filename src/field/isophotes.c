/* SPDX-License-Identifier: MIT */
/* Isophotes: the nodes, the cells in parallel, and the lines put together level by level. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/rows.h"
#include "../light/extended.h"
#include "../shade/camera.h"
#include "isophotes.h"

void luxel_isophotes_free(luxel_isophotes *isophotes)
{
    if (!isophotes)
        return;
    for (size_t i = 0; i < isophotes->count; i++) {
        free((double *)isophotes->lines[i].x_mm);
        free((double *)isophotes->lines[i].y_mm);
    }
    free((luxel_isophote *)isophotes->lines);
    free(isophotes);
}

/* One search under way. */
struct search {
    const struct luxel_field *field;
    struct lx_nodes nodes;
    unsigned margin; /* nodes of the screen's edge around the pixels: 0 or 1 */
    const double *levels;
    size_t level_count;
    struct lx_segments *segments; /* rows of cells x levels */
    struct lx_control *control;
};

static void clear(struct search *search)
{
    struct lx_nodes *nodes = &search->nodes;
    for (size_t i = 0; search->segments && i < nodes->rows * search->level_count; i++)
        free(search->segments[i].items);
    free(search->segments);
    free(nodes->x_mm);
    free(nodes->y_mm);
    free(nodes->values);
    free(nodes->surface);
    free(nodes->exact);
}

/* ---- nodes ---- */

/* The pixels' places and, where these do not reach so far, the edges of the screen; falling where `down`. */
static double *new_places(const double *places, unsigned count, double half_mm, unsigned margin, bool down)
{
    double *made = lx_new_array((size_t)count + 2 * margin, sizeof *made);
    if (!made)
        return NULL;
    memcpy(made + margin, places, count * sizeof *made);
    if (margin) {
        made[0] = down ? half_mm : -half_mm;
        made[count + 1] = -made[0];
    }
    return made;
}

/* How far a value of the picture may be from the exact one; more where highlights of extended sources are sampled. */
static double doubt_of(const struct luxel_field *field, const struct luxel_evaluator *evaluator, double scale)
{
    bool sampled = false;
    for (size_t i = 0; evaluator && i < evaluator->prepared.emitters.count; i++)
        sampled = sampled || lx_is_extended(&evaluator->prepared.emitters.items[i]);
    double share = field->tolerance > 0 ? field->tolerance : 1e-3;
    return evaluator ? (sampled ? 2 * share : field->precision == LUXEL_DOUBLE ? 1e-10 : 4e-6) * scale : 0;
}

static luxel_status make_nodes(struct search *search, const struct luxel_evaluator *evaluator,
                               luxel_diagnostics *diagnostics)
{
    const struct luxel_field *field = search->field;
    struct lx_nodes *nodes = &search->nodes;
    const struct lx_screen *screen = evaluator ? &evaluator->prepared.scene->screen : NULL;
    search->margin = screen && screen->sampling == LX_CENTERS;
    nodes->evaluator = evaluator;
    nodes->columns = field->columns + 2 * search->margin;
    nodes->rows = field->rows + 2 * search->margin;
    size_t count = (size_t)nodes->columns * nodes->rows;
    nodes->x_mm = new_places(field->x_mm, field->columns, screen ? screen->width_mm / 2 : 0, search->margin, false);
    nodes->y_mm = new_places(field->y_mm, field->rows, screen ? screen->height_mm / 2 : 0, search->margin, true);
    nodes->values = lx_new_array(count, sizeof *nodes->values);
    nodes->surface = lx_new_array(count, sizeof *nodes->surface);
    nodes->exact = lx_new_array(count, sizeof *nodes->exact);
    search->segments = lx_new_array(nodes->rows * search->level_count + 1, sizeof *search->segments);
    if (!nodes->x_mm || !nodes->y_mm || !nodes->values || !nodes->surface || !nodes->exact || !search->segments)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < (size_t)field->columns * field->rows; i++)
        if (field->mask[i])
            nodes->scale = fmax(nodes->scale, fabs(lx_field_value(field, i)));
    nodes->doubt = doubt_of(field, evaluator, nodes->scale);
    return LUXEL_OK;
}

/* Whether a node is one of the screen's edge, or a pixel that has one of another kind, surface or none, around it. */
static bool is_at_edge(const struct search *search, unsigned column, unsigned row)
{
    const struct luxel_field *field = search->field;
    unsigned margin = search->margin;
    if (column < margin || row < margin || column >= field->columns + margin || row >= field->rows + margin)
        return true;
    unsigned u = column - margin, v = row - margin;
    uint8_t own = field->mask[(size_t)v * field->columns + u];
    for (unsigned b = v > 0 ? v - 1 : 0; b <= v + 1 && b < field->rows; b++)
        for (unsigned a = u > 0 ? u - 1 : 0; a <= u + 1 && a < field->columns; a++)
            if (field->mask[(size_t)b * field->columns + a] != own)
                return true;
    return false;
}

static void look_closely(struct search *search, size_t node)
{
    struct lx_nodes *nodes = &search->nodes;
    luxel_value found =
        luxel_evaluate(nodes->evaluator, nodes->x_mm[node % nodes->columns], nodes->y_mm[node / nodes->columns], NULL);
    nodes->surface[node] = found.has_value ? (uint32_t)found.surface + 1 : 0;
    nodes->values[node] = found.has_value ? found.value : 0;
    nodes->exact[node] = 1;
}

/* Which of several surfaces a pixel shows. */
static uint32_t surface_at(const struct lx_nodes *nodes, size_t node)
{
    const struct lx_prepared *prepared = &nodes->evaluator->prepared;
    struct lx_element element;
    if (!lx_element_seen(prepared, nodes->x_mm[node % nodes->columns], nodes->y_mm[node / nodes->columns], &element))
        return 0;
    return (uint32_t)(element.own - prepared->surfaces) + 1;
}

static void fill_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct search *search = data;
    const struct luxel_field *field = search->field;
    struct lx_nodes *nodes = &search->nodes;
    bool several = nodes->evaluator && nodes->evaluator->prepared.surface_count > 1;
    (void)worker;
    for (unsigned row = first; row < last && lx_control_goes_on(search->control, is_caller); row++)
        for (unsigned column = 0; column < nodes->columns; column++) {
            size_t node = (size_t)row * nodes->columns + column;
            if (nodes->evaluator && is_at_edge(search, column, row)) {
                look_closely(search, node);
                continue;
            }
            size_t pixel = (size_t)(row - search->margin) * field->columns + column - search->margin;
            nodes->values[node] = lx_field_value(field, pixel);
            nodes->surface[node] = !field->mask[pixel] ? 0 : several ? surface_at(nodes, node) : 1;
        }
}

/* Where two surfaces meet, the picture's values stand for neither side exactly enough. */
static void sharpen_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct search *search = data;
    struct lx_nodes *nodes = &search->nodes;
    (void)worker;
    for (unsigned row = first; row < last && lx_control_goes_on(search->control, is_caller); row++)
        for (unsigned column = 0; column < nodes->columns; column++) {
            size_t node = (size_t)row * nodes->columns + column;
            bool differs = false;
            for (unsigned b = row > 0 ? row - 1 : 0; b <= row + 1 && b < nodes->rows; b++)
                for (unsigned a = column > 0 ? column - 1 : 0; a <= column + 1 && a < nodes->columns; a++)
                    differs = differs || nodes->surface[(size_t)b * nodes->columns + a] != nodes->surface[node];
            if (differs && nodes->surface[node] && !nodes->exact[node]) {
                double value = luxel_evaluate(nodes->evaluator, nodes->x_mm[column], nodes->y_mm[row], NULL).value;
                nodes->values[node] = value;
                nodes->exact[node] = 1;
            }
        }
}

/* ---- cells and lines ---- */

static void march_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct search *search = data;
    (void)worker;
    for (unsigned row = first; row < last && lx_control_goes_on(search->control, is_caller); row++)
        lx_march_row(&search->nodes, search->levels, search->level_count, row,
                     &search->segments[row * search->level_count]);
}

static bool run(struct search *search, const luxel_settings *settings, unsigned rows, lx_rows_work *work)
{
    struct lx_control control = {.rows = rows, .progress = settings->progress, .data = settings->progress_data};
    search->control = &control;
    return rows == 0 || lx_rows_run(&control, lx_thread_count(settings->threads, rows / 16 + 1), work, search);
}

/* All rows' segments of one level, in order. */
static int join_rows(const struct search *search, size_t level, struct lx_segments *all)
{
    all->count = 0;
    for (unsigned row = 0; row + 1 < search->nodes.rows; row++) {
        const struct lx_segments *segments = &search->segments[row * search->level_count + level];
        if (segments->failed ||
            lx_reserve((void **)&all->items, &all->capacity, all->count + segments->count, sizeof *all->items) < 0)
            return -1;
        if (segments->count > 0)
            memcpy(all->items + all->count, segments->items, segments->count * sizeof *all->items);
        all->count += segments->count;
    }
    return 0;
}

static int make_lines(const struct search *search, struct lx_lines *lines)
{
    struct lx_segments all = {0};
    int failed = 0;
    for (size_t i = 0; failed == 0 && i < search->level_count; i++) {
        failed = join_rows(search, i, &all);
        if (failed == 0)
            failed = lx_chain_segments(&all, search->levels[i], lines);
    }
    free(all.items);
    return failed;
}

/* Whether a picture's pixels are those of the screen that the evaluator looks through, and its quantity the same. */
static bool is_of_scene(const luxel_field *field, const struct luxel_evaluator *evaluator)
{
    const struct lx_screen *screen = &evaluator->prepared.scene->screen;
    bool fits = field->columns == screen->resolution[0] && field->rows == screen->resolution[1] &&
                field->quantity == evaluator->settings.quantity;
    for (unsigned i = 0; fits && i < field->columns; i++)
        fits = field->x_mm[i] == lx_column_x_mm(screen, i);
    for (unsigned i = 0; fits && i < field->rows; i++)
        fits = field->y_mm[i] == lx_row_y_mm(screen, i);
    return fits;
}

static luxel_status check(const luxel_field *field, const struct luxel_evaluator *evaluator, const double *levels,
                          size_t count, luxel_isophotes **isophotes, luxel_diagnostics *diagnostics)
{
    const char *missing = !field ? "field" : !isophotes ? "isophotes" : !levels && count > 0 ? "levels" : NULL;
    if (missing) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_MISSING_ARGUMENT, LX_ARGS(missing));
        return LUXEL_ERROR_ARGUMENT;
    }
    enum lx_message message = LX_MSG_BAD_LEVEL;
    bool ok = true;
    for (size_t i = 0; i < count; i++)
        ok = ok && isfinite(levels[i]);
    if (ok && (!field->x_mm || !field->y_mm)) {
        message = LX_MSG_FIELD_WITHOUT_PLACES;
        ok = false;
    }
    if (ok && evaluator && !is_of_scene(field, evaluator)) {
        message = LX_MSG_OTHER_SCENE;
        ok = false;
    }
    if (!ok)
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, message, NULL);
    return ok ? LUXEL_OK : LUXEL_ERROR_ARGUMENT;
}

static luxel_status find_lines(struct search *search, const struct luxel_evaluator *evaluator,
                               luxel_diagnostics *diagnostics, struct lx_lines *lines)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    if (evaluator)
        settings = evaluator->settings;
    luxel_status status = make_nodes(search, evaluator, diagnostics);
    if (status != LUXEL_OK)
        return status;
    unsigned rows = search->nodes.rows;
    bool several = evaluator && evaluator->prepared.surface_count > 1;
    if (!run(search, &settings, rows, fill_rows) || (several && !run(search, &settings, rows, sharpen_rows)) ||
        !run(search, &settings, rows - 1, march_rows))
        return LUXEL_CANCELLED;
    return make_lines(search, lines) == 0 ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

luxel_status luxel_find_isophotes(const luxel_field *field, const luxel_evaluator *evaluator, const double *levels,
                                  size_t count, luxel_diagnostics *diagnostics, luxel_isophotes **isophotes)
{
    struct search search = {.field = field, .levels = levels, .level_count = count};
    struct lx_lines lines = {0};
    luxel_status status = check(field, evaluator, levels, count, isophotes, diagnostics);
    if (status != LUXEL_OK)
        return status;
    luxel_isophotes *made = lx_new_array(1, sizeof *made);
    status = made ? find_lines(&search, evaluator, diagnostics, &lines) : lx_out_of_memory(diagnostics);
    clear(&search);
    if (made)
        *made = (luxel_isophotes){.count = lines.count, .lines = lines.items};
    if (status == LUXEL_OK)
        *isophotes = made;
    else
        luxel_isophotes_free(made);
    return status;
}
