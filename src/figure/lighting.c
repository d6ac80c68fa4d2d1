/* SPDX-License-Identifier: MIT */
/*
 * The report that a lighting designer hands over: whether the limits are kept, the plan, the luminaires, each measuring
 * grid as table and figure, the glare of observers, the light on surfaces, and by what conventions all is computed.
 */
#include "lighting.h"

#include <luxel/conventions.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../parameter/decode.h"
#include "../scene/observer.h"
#include "figure.h"

enum { FIGURE_MM = 150, FIGURE_DPI = 150, MOST_COLUMNS = 12, DIGITS = 5 };

const char *lx_lighting_amount(const struct lx_report *report, luxel_bounded amount, char cell[LX_LIGHTING_CELL])
{
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE];
    lx_report_bounded(report, amount.value, amount.error, DIGITS, value);
    snprintf(cell, LX_LIGHTING_CELL, "%s ± %s", value,
             lx_write_bound(lx_error_of_shown(value, amount.value, amount.error), 2, error));
    return cell;
}

const double *lx_lighting_up(const struct lx_design_report *lighting)
{
    static const double z[3] = {0, 0, 1};
    const double *up = lx_scene_up(lighting->report->parameters);
    return up ? up : z;
}

/* ---- what is computed ---- */

static luxel_status measure_grids(struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    const size_t count = luxel_scene_grid_count(report->scene);
    luxel_status status = LUXEL_OK;
    lighting->grids = lx_new_array(count + 1, sizeof *lighting->grids);
    lighting->of_grids = lx_new_array(count + 1, sizeof *lighting->of_grids);
    lighting->lines = lx_new_array(count + 1, sizeof *lighting->lines);
    if (!lighting->grids || !lighting->of_grids || !lighting->lines)
        return lx_out_of_memory(report->diagnostics);
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        status = luxel_find_grid_values(report->scene, report->settings, i, report->diagnostics, &lighting->grids[i]);
        if (status != LUXEL_OK)
            break;
        lighting->grid_count++;
        struct lx_judged *judged = &lighting->of_grids[i];
        status = luxel_judge_grid_and_areas(report->scene, i, lighting->grids[i], judged->limits, &judged->count);
    }
    return status;
}

/* The area of the floors of all rooms. */
static double find_floor(const struct lx_scene_parameters *parameters)
{
    double area = 0;
    for (size_t i = 0; i < parameters->surfaces.count; i++) {
        const struct lx_item *item = &parameters->surfaces.items[i];
        const struct lx_parameter *size = lx_find_parameter(item->variant->table, "size");
        if (strcmp(item->variant->name, "room") != 0 || !size)
            continue;
        const double *mm = lx_const_member(size, item->parameters);
        const double *up = lx_scene_up(parameters);
        area += mm[0] * (up && up[2] > 0 ? mm[1] : mm[2]) / 1e6;
    }
    return area;
}

static luxel_status compute(struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    luxel_status status = measure_grids(lighting);
    if (status == LUXEL_OK)
        status = lx_lighting_rate(lighting);
    if (status == LUXEL_OK)
        status = luxel_find_balance(report->scene, report->settings, report->diagnostics, &report->balance);
    lighting->floor_m2 = find_floor(report->parameters);
    return status;
}

static void clear(struct lx_design_report *lighting)
{
    for (size_t i = 0; i < lighting->grid_count; i++)
        luxel_grid_free(lighting->grids[i]);
    for (size_t i = 0; i < lighting->observer_count; i++)
        luxel_glare_free(lighting->glares[i]);
    free(lighting->grids);
    free(lighting->of_grids);
    free(lighting->lines);
    free(lighting->glares);
    free(lighting->of_observers);
}

/* ---- the summary ---- */

const char *lx_lighting_name(const struct lx_report *report, const char *name, const char *english, size_t i,
                             char buffer[LX_LIGHTING_NAME])
{
    if (name)
        return name;
    snprintf(buffer, LX_LIGHTING_NAME, "%s %zu", lx_document_word(report->document, english), i + 1);
    return buffer;
}

/* `unit`: of the average, the minimum and the maximum. */
static void add_verdicts(const struct lx_report *report, const char *name, const struct lx_judged *judged,
                         const char *unit)
{
    for (size_t i = 0; i < judged->count; i++) {
        const luxel_limit *limit = &judged->limits[i];
        const bool has_unit = luxel_limit_has_unit(limit);
        const bool is_share = strcmp(limit->name, "share") == 0;
        char wanted[LX_NUMBER_SIZE + 40], number[LX_NUMBER_SIZE], cell[LX_LIGHTING_CELL];
        snprintf(wanted, sizeof wanted, "%s %s%s%s", limit->is_most ? "≤" : "≥",
                 lx_write_digits(limit->wanted, 6, number), has_unit ? " " : "",
                 has_unit ? lx_document_word(report->document, unit) : "");
        if (is_share)
            snprintf(wanted, sizeof wanted, "≥ %g %%: ≥ %g %s", limit->wanted, limit->above,
                     lx_document_word(report->document, unit));
        lx_document_row(report->document,
                        LX_SPANS(LX_PLAIN(name), LX_TERM_SPAN(luxel_limit_word(limit)), LX_PLAIN(wanted),
                                 LX_PLAIN(limit->has_value ? lx_lighting_amount(report, limit->value, cell) : "–"),
                                 {limit->verdict == LUXEL_PASS ? LX_SPAN_TERM : LX_SPAN_STRONG,
                                  luxel_verdict_word(limit->verdict)}),
                        limit->verdict != LUXEL_PASS);
    }
}

static void count_judged(const struct lx_judged *judged, size_t *count, size_t *missed)
{
    *count += judged->count;
    for (size_t k = 0; k < judged->count; k++)
        *missed += judged->limits[k].verdict != LUXEL_PASS;
}

/* How many limits there are, and how many are not kept for certain. */
static size_t count_limits(const struct lx_design_report *lighting, size_t *missed)
{
    luxel_observer_places places;
    size_t count = 0;
    *missed = 0;
    for (size_t i = 0; i < lighting->grid_count; i++)
        count_judged(&lighting->of_grids[i], &count, missed);
    for (size_t i = 0; i < lighting->observer_count; i += places.count) {
        luxel_scene_observer_places(lighting->report->scene, i, &places);
        const struct lx_judged judged = lx_lighting_judged(lighting, &places);
        count_judged(&judged, &count, missed);
    }
    return count;
}

static void add_summary(const struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    struct luxel_document *document = report->document;
    size_t missed;
    const size_t count = count_limits(lighting, &missed);
    char all[LX_NUMBER_SIZE], some[LX_NUMBER_SIZE];
    lx_document_heading(document, 1, LX_N("Summary"), NULL);
    if (count == 0) {
        lx_document_paragraph(document, LX_N("The scene has no limits, so that nothing is judged."), NULL);
        return;
    }
    if (missed == 0)
        lx_document_paragraph(document, LX_N("All {0} limits are kept."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)count, all))));
    else
        lx_document_paragraph(
            document, LX_N("Of {0} limits {1} are not kept, or not for certain."),
            LX_SPANS(LX_PLAIN(lx_write_number((double)count, all)), LX_PLAIN(lx_write_number((double)missed, some))));
    lx_document_table(document, "lllrl");
    lx_document_name_table(document, "limits", 0);
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("grid or observer")), LX_TERM_SPAN(LX_N("what")),
                             LX_TERM_SPAN(LX_N("limit")), LX_TERM_SPAN(LX_N("value")), LX_TERM_SPAN(LX_N("verdict"))),
                    false);
    for (size_t i = 0; i < lighting->grid_count; i++) {
        char name[LX_LIGHTING_NAME];
        add_verdicts(report, lx_lighting_name(report, lighting->grids[i]->name, LX_N("grid"), i, name),
                     &lighting->of_grids[i], lighting->grids[i]->unit);
    }
    luxel_observer_places places;
    for (size_t i = 0, number = 0; i < lighting->observer_count; i += places.count, number++) {
        const char *own = NULL;
        char name[LX_LIGHTING_NAME];
        luxel_scene_observer(report->scene, i, &own, NULL);
        luxel_scene_observer_places(report->scene, i, &places);
        const struct lx_judged judged = lx_lighting_judged(lighting, &places);
        add_verdicts(report, lx_lighting_name(report, own, LX_N("observer"), number, name), &judged, "");
    }
}

/* ---- grids ---- */

static const char *value_text(double value, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_digits(value, value >= 100 ? 1 + (int)floor(log10(value)) : 3, buffer);
}

/* The values as the plane is seen from its front. */
static luxel_status add_values(const struct lx_report *report, const luxel_grid *grid)
{
    char letters[MOST_COLUMNS + 1] = "";
    char(*texts)[LX_NUMBER_SIZE] = lx_new_array(grid->columns, sizeof *texts);
    struct lx_span *cells = lx_new_array(grid->columns + 1, sizeof *cells);
    if (!texts || !cells) {
        free(texts);
        free(cells);
        return lx_out_of_memory(report->diagnostics);
    }
    memset(letters, 'r', grid->columns);
    lx_document_table(report->document, letters);
    for (unsigned row = 0; row <= grid->rows; row++) { /* the first is the heading, the columns' numbers */
        for (unsigned column = 0; column < grid->columns; column++) {
            const size_t cell = row == 0 ? 0 : (size_t)(row - 1) * grid->columns + column;
            const char *text = row == 0           ? lx_write_number(column + 1, texts[column])
                               : grid->mask[cell] ? value_text(grid->values[cell], texts[column])
                                                  : "–";
            cells[column] = (struct lx_span){LX_SPAN_PLAIN, text};
        }
        cells[grid->columns] = (struct lx_span){LX_SPAN_END, NULL};
        lx_document_row(report->document, cells, false);
    }
    free(texts);
    free(cells);
    return LUXEL_OK;
}

static luxel_status add_figure(const struct lx_design_report *lighting, size_t i)
{
    struct lx_report *report = lighting->report;
    luxel_figure_settings settings;
    struct lx_figure *figure = NULL;
    unsigned char *bytes = NULL;
    size_t length = 0;
    luxel_figure_settings_init(&settings);
    settings.language = report->texts->language;
    settings.width_mm = FIGURE_MM;
    settings.dots_per_inch = FIGURE_DPI;
    settings.small_print = false;
    settings.palette = report->texts->palette;
    settings.grid = (unsigned)i + 1;
    luxel_status status =
        lx_figure_make(report->scene, report->settings, &settings, NULL, report->diagnostics, &figure);
    if (status == LUXEL_OK)
        status = lx_figure_png(figure, report->diagnostics, &bytes, &length);
    if (status == LUXEL_OK) {
        const struct lx_drawing drawing = lx_figure_drawing(figure);
        lighting->lines[i] = figure->isophotes; /* which live as long as the document */
        lx_document_picture(report->document, bytes, length, &drawing,
                            LX_N("The plane in false colour with lines of equal value."), NULL);
    } else {
        lx_figure_free(figure);
    }
    free(bytes);
    return status;
}

/* An area around the plane, where there is room for one. */
static void add_area(const struct lx_report *report, const luxel_grid *area, const char *english)
{
    char numbers[3][LX_NUMBER_SIZE], average[LX_LIGHTING_CELL];
    if (!area || area->measured == 0)
        return;
    lx_document_paragraph(report->document, english,
                          LX_SPANS(LX_PLAIN(lx_lighting_amount(report, area->average, average)),
                                   LX_PLAIN(lx_document_word(report->document, area->unit)),
                                   LX_PLAIN(lx_write_number((double)area->measured, numbers[0])),
                                   LX_PLAIN(lx_write_digits(area->minimum.value, DIGITS, numbers[1])),
                                   LX_PLAIN(area->has_evenness ? lx_write_digits(area->u0, 4, numbers[2]) : "–")));
}

static luxel_status add_grid(const struct lx_design_report *lighting, size_t i)
{
    struct lx_report *report = lighting->report;
    struct luxel_document *document = report->document;
    const luxel_grid *grid = lighting->grids[i];
    char name[LX_LIGHTING_NAME], numbers[7][LX_NUMBER_SIZE], average[LX_LIGHTING_CELL];
    lx_document_heading(document, 2, "{0}",
                        LX_SPANS(LX_PLAIN(lx_lighting_name(report, grid->name, LX_N("grid"), i, name))));
    if (grid->measured == 0) {
        lx_document_paragraph(document, LX_N("No cell has a value: all lie inside of bodies or on sources."), NULL);
        return LUXEL_OK;
    }
    lx_document_paragraph(document, LX_N("{0} × {1} values on {2} × {3} mm around ({4}, {5}, {6})."),
                          LX_SPANS(LX_PLAIN(lx_write_number(grid->columns, numbers[0])),
                                   LX_PLAIN(lx_write_number(grid->rows, numbers[1])),
                                   LX_PLAIN(lx_report_number(grid->size_mm[0], numbers[2])),
                                   LX_PLAIN(lx_report_number(grid->size_mm[1], numbers[3])),
                                   LX_PLAIN(lx_report_number(grid->center_mm[0] + 0.0, numbers[4])),
                                   LX_PLAIN(lx_report_number(grid->center_mm[1] + 0.0, numbers[5])),
                                   LX_PLAIN(lx_report_number(grid->center_mm[2] + 0.0, numbers[6]))));
    lx_document_paragraph(document, LX_N("Average {0} {1}, minimum {2}, maximum {3}."),
                          LX_SPANS(LX_PLAIN(lx_lighting_amount(report, grid->average, average)),
                                   LX_PLAIN(lx_document_word(document, grid->unit)),
                                   LX_PLAIN(lx_write_digits(grid->minimum.value, DIGITS, numbers[0])),
                                   LX_PLAIN(lx_write_digits(grid->maximum.value, DIGITS, numbers[1]))));
    if (grid->has_evenness)
        lx_document_paragraph(document, LX_N("Minimum by average U0 = {0}, minimum by maximum Ud = {1}."),
                              LX_SPANS(LX_PLAIN(lx_write_digits(grid->u0, 4, numbers[0])),
                                       LX_PLAIN(lx_write_digits(grid->ud, 4, numbers[1]))));
    add_area(report, grid->surround, LX_N("Surrounding area: average {0} {1} of {2} values, minimum {3}, U0 = {4}."));
    add_area(report, grid->background, LX_N("Background area: average {0} {1} of {2} values, minimum {3}, U0 = {4}."));
    luxel_status status = add_figure(lighting, i);
    if (status == LUXEL_OK && grid->columns <= MOST_COLUMNS)
        status = add_values(report, grid);
    return status;
}

static luxel_status add_grids(const struct lx_design_report *lighting)
{
    luxel_status status = LUXEL_OK;
    if (lighting->grid_count == 0)
        return LUXEL_OK;
    lx_document_heading(lighting->report->document, 1, LX_N("Measuring grids"), NULL);
    for (size_t i = 0; i < lighting->grid_count && status == LUXEL_OK; i++)
        status = add_grid(lighting, i);
    return status;
}

/* ---- conventions ---- */

static luxel_status add_conventions(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_conventions_use use = {.screen = false};
    luxel_conventions *conventions = NULL;
    lx_document_heading(document, 1, LX_N("Conventions and bounds"), NULL);
    lx_document_paragraph(document,
                          LX_N("What follows ± bounds the error of the calculation; a verdict is undecided where that "
                               "spans the limit. Grids are judged by the values at the centres of their cells; cells "
                               "inside of bodies are left out."),
                          NULL);
    if (luxel_find_conventions(report->scene, &use, &conventions) != LUXEL_OK)
        return lx_out_of_memory(report->diagnostics);
    for (size_t i = 0; i < conventions->count; i++)
        lx_document_item(document, "{0}: {1}",
                         LX_SPANS(LX_CODE(conventions->list[i].key), LX_CODE(conventions->list[i].value)));
    luxel_conventions_free(conventions);
    return LUXEL_OK;
}

static void add_source(struct lx_report *report)
{
    char *scene = NULL;
    lx_document_heading(report->document, 1, LX_N("The scene"), NULL);
    lx_document_paragraph(
        report->document,
        LX_N("Computed by Luxel {0} from this scene; saved as {1}, it gives the same numbers by {2}."),
        LX_SPANS(LX_PLAIN(luxel_version()), LX_CODE("scene.yaml"), LX_CODE("luxel grid scene.yaml --limits")));
    if (luxel_scene_write_text(report->scene, &scene) == LUXEL_OK)
        lx_document_code(report->document, scene);
    luxel_text_free(scene);
}

static luxel_status build(struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    add_summary(lighting);
    luxel_status status = lx_lighting_plan(lighting);
    if (status == LUXEL_OK)
        status = lx_lighting_lamps(lighting);
    if (status == LUXEL_OK)
        status = add_grids(lighting);
    if (status != LUXEL_OK)
        return status;
    lx_lighting_glare(lighting);
    if (report->balance)
        lx_document_heading(report->document, 1, LX_N("Surfaces"), NULL);
    lx_report_balance(report);
    status = add_conventions(report);
    add_source(report);
    return status;
}

luxel_status lx_lighting_build(struct lx_report *report)
{
    struct lx_design_report lighting = {.report = report};
    luxel_status status = compute(&lighting);
    if (status == LUXEL_OK)
        status = build(&lighting);
    if (status == LUXEL_OK && report->texts->tables)
        status = lx_lighting_tables(&lighting);
    clear(&lighting);
    return status;
}
