/* SPDX-License-Identifier: MIT */
/* The plan of a lighting report: surfaces, luminaires, measuring grids and observers from above, to scale. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../base/vector.h"
#include "../light/array.h"
#include "../world/prepared.h"
#include "canvas.h"
#include "lighting.h"
#include "sheet.h"

enum { WIDTH_MM = 150, DPI = 150, MOST_NUMBERED = 99, CORNERS = 4 };
static const double POINTS = 72 / 25.4, TALLEST = 480, MARGIN = 12, LETTERS = 8;

/* A rectangle or, with two corners, a way; in mm from above. */
struct outline {
    double corners[CORNERS][2];
    int count;
    bool is_dashed;
};

struct mark {
    double at[2], ahead[2];
    bool is_observer;
};

struct plan {
    struct outline *outlines;
    struct mark *marks;
    size_t outline_count, mark_count;
    double low[2], high[2];
    char *metre; /* the words of the bar */
};

static void release(void *data)
{
    struct plan *plan = data;
    if (!plan)
        return;
    free(plan->outlines);
    free(plan->marks);
    free(plan->metre);
    free(plan);
}

/* ---- what is there ---- */

/* As somebody above sees it, x to the right where that is level. */
static void from_above(const struct lx_design_report *lighting, const double place[3], double at[2])
{
    const double *up = lx_lighting_up(lighting);
    double x[3] = {1, 0, 0}, y[3], above[3] = {up[0], up[1], up[2]};
    lx_normalize(above);
    if (fabs(above[0]) > 0.9)
        x[0] = 0, x[1] = 1;
    const double part = lx_dot(x, above);
    for (int i = 0; i < 3; i++)
        x[i] -= part * above[i];
    lx_normalize(x);
    lx_cross(above, x, y);
    at[0] = lx_dot(place, x);
    at[1] = lx_dot(place, y);
}

static void take_in(struct plan *plan, const double at[2])
{
    for (int i = 0; i < 2; i++) {
        plan->low[i] = fmin(plan->low[i], at[i]);
        plan->high[i] = fmax(plan->high[i], at[i]);
    }
}

/* The rectangle around the corners of a box. */
static void add_box(const struct lx_design_report *lighting, const double low[3], const double high[3],
                    struct plan *plan)
{
    double least[2] = {HUGE_VAL, HUGE_VAL}, most[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < 8; k++) {
        const double corner[3] = {k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]};
        double at[2];
        from_above(lighting, corner, at);
        for (int i = 0; i < 2; i++) {
            least[i] = fmin(least[i], at[i]);
            most[i] = fmax(most[i], at[i]);
        }
    }
    struct outline *outline = &plan->outlines[plan->outline_count++];
    *outline = (struct outline){
        {{least[0], least[1]}, {most[0], least[1]}, {most[0], most[1]}, {least[0], most[1]}}, CORNERS, false};
    take_in(plan, least);
    take_in(plan, most);
}

/* Each surface of the list: the box around its parts. */
static void add_surfaces(const struct lx_design_report *lighting, const struct lx_prepared *prepared, struct plan *plan)
{
    for (size_t i = 0; i < prepared->surface_count;) {
        double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        const size_t authored = prepared->surfaces[i].authored;
        for (; i < prepared->surface_count && prepared->surfaces[i].authored == authored; i++)
            for (int k = 0; k < 3; k++) {
                low[k] = fmin(low[k], prepared->surfaces[i].low_mm[k]);
                high[k] = fmax(high[k], prepared->surfaces[i].high_mm[k]);
            }
        add_box(lighting, low, high, plan);
    }
}

static void add_grids(const struct lx_design_report *lighting, struct plan *plan)
{
    for (size_t i = 0; i < lighting->grid_count; i++) {
        const luxel_grid *grid = lighting->grids[i];
        struct outline *outline = &plan->outlines[plan->outline_count++];
        *outline = (struct outline){.count = CORNERS, .is_dashed = true};
        for (int k = 0; k < CORNERS; k++) {
            const double across = grid->size_mm[0] / (k == 0 || k == 3 ? -2 : 2),
                         up = grid->size_mm[1] / (k < 2 ? -2 : 2);
            double corner[3];
            for (int c = 0; c < 3; c++)
                corner[c] = grid->center_mm[c] + across * grid->across[c] + up * grid->up[c];
            from_above(lighting, corner, outline->corners[k]);
            take_in(plan, outline->corners[k]);
        }
    }
}

static void add_marks(const struct lx_design_report *lighting, struct plan *plan)
{
    const struct lx_list *lights = &lighting->report->parameters->lights;
    for (size_t i = 0; i < lights->count; i++) {
        double(*places_mm)[3] =
            luxel_scene_light_enabled(lighting->report->scene, i) ? lx_light_find_places(&lights->items[i]) : NULL;
        for (size_t k = 0; places_mm && k < lx_light_places(&lights->items[i]); k++) {
            struct mark *mark = &plan->marks[plan->mark_count++];
            from_above(lighting, places_mm[k], mark->at);
            take_in(plan, mark->at);
        }
        free(places_mm);
    }
    for (size_t i = 0; i < lighting->observer_count; i++) {
        struct mark *mark = &plan->marks[plan->mark_count++];
        luxel_glare_sight sight;
        luxel_scene_observer(lighting->report->scene, i, NULL, &sight);
        mark->is_observer = true;
        from_above(lighting, sight.eye_mm, mark->at);
        from_above(lighting, sight.view, mark->ahead);
        take_in(plan, mark->at);
    }
}

static struct plan *make(const struct lx_design_report *lighting, const struct lx_prepared *prepared)
{
    const struct lx_list *lights = &lighting->report->parameters->lights;
    struct plan *plan = lx_new_array(1, sizeof *plan);
    size_t marks = lighting->observer_count + 1;
    for (size_t i = 0; i < lights->count; i++)
        marks += lx_light_places(&lights->items[i]);
    if (!plan)
        return NULL;
    const char *metre = lx_document_word(lighting->report->document, LX_N("1 m"));
    plan->outlines = lx_new_array(prepared->surface_count + lighting->grid_count + 1, sizeof *plan->outlines);
    plan->marks = lx_new_array(marks, sizeof *plan->marks);
    plan->metre = lx_copy_text(metre, strlen(metre));
    for (int i = 0; i < 2; i++) {
        plan->low[i] = HUGE_VAL;
        plan->high[i] = -HUGE_VAL;
    }
    if (!plan->outlines || !plan->marks || !plan->metre) {
        release(plan);
        return NULL;
    }
    add_surfaces(lighting, prepared, plan);
    add_grids(lighting, plan);
    add_marks(lighting, plan);
    return plan;
}

/* ---- drawing ---- */

/* From mm to points of the sheet. */
struct fit {
    double scale, left, top, height;
};

static struct fit fit_plan(const struct plan *plan, double width)
{
    const double wide = fmax(plan->high[0] - plan->low[0], 1), deep = fmax(plan->high[1] - plan->low[1], 1);
    struct fit fit = {.scale = fmin((width - 2 * MARGIN) / wide, (TALLEST - 4 * MARGIN) / deep)};
    fit.left = (width - fit.scale * wide) / 2;
    fit.top = MARGIN;
    fit.height = fit.scale * deep + 4 * MARGIN;
    return fit;
}

static void place(const struct plan *plan, const struct fit *fit, const double at[2], double on[2])
{
    on[0] = fit->left + fit->scale * (at[0] - plan->low[0]);
    on[1] = fit->top + fit->scale * (plan->high[1] - at[1]);
}

static void draw_outline(const struct plan *plan, const struct fit *fit, const struct outline *outline, cairo_t *cairo)
{
    static const double dashes[] = {4, 3};
    for (int k = 0; k < outline->count; k++) {
        double on[2];
        place(plan, fit, outline->corners[k], on);
        if (k == 0)
            cairo_move_to(cairo, on[0], on[1]);
        else
            cairo_line_to(cairo, on[0], on[1]);
    }
    cairo_close_path(cairo);
    cairo_set_line_width(cairo, outline->is_dashed ? 0.6 : 1);
    cairo_set_dash(cairo, dashes, outline->is_dashed ? 2 : 0, 0);
    cairo_stroke(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
}

/* A luminaire is a disk with its number, an observer a wedge that points where he looks. */
static void draw_mark(const struct plan *plan, const struct fit *fit, size_t i, const struct lx_canvas *canvas)
{
    const struct mark *mark = &plan->marks[i];
    const struct lx_type type = {.size = LETTERS};
    cairo_t *cairo = canvas->cairo;
    double on[2];
    char number[24];
    place(plan, fit, mark->at, on);
    if (mark->is_observer) {
        const double way = atan2(-mark->ahead[1], mark->ahead[0]);
        cairo_move_to(cairo, on[0], on[1]);
        cairo_arc(cairo, on[0], on[1], 12, way - 0.5, way + 0.5);
        cairo_close_path(cairo);
        cairo_set_line_width(cairo, 0.8);
        cairo_stroke(cairo);
        return;
    }
    cairo_arc(cairo, on[0], on[1], 3, 0, 2 * M_PI);
    cairo_fill(cairo);
    snprintf(number, sizeof number, "%zu", i + 1);
    if (plan->mark_count <= MOST_NUMBERED)
        lx_write(canvas, number, &type, on[0] + 5, on[1], 0, 0.5, 0);
}

static void draw_bar(const struct plan *plan, const struct fit *fit, const struct lx_canvas *canvas)
{
    const struct lx_type type = {.size = LETTERS};
    const double y = fit->height - MARGIN, length = fit->scale * 1000;
    cairo_move_to(canvas->cairo, fit->left, y - 3);
    cairo_line_to(canvas->cairo, fit->left, y);
    cairo_line_to(canvas->cairo, fit->left + length, y);
    cairo_line_to(canvas->cairo, fit->left + length, y - 3);
    cairo_set_line_width(canvas->cairo, 0.8);
    cairo_stroke(canvas->cairo);
    lx_write(canvas, plan->metre, &type, fit->left + length + 4, y, 0, 0.8, 0);
}

static double draw(const void *what, cairo_t *cairo, double width)
{
    const struct plan *plan = what;
    const struct fit fit = fit_plan(plan, width);
    if (!cairo)
        return fit.height;
    struct lx_canvas canvas = lx_canvas_of(cairo, false);
    lx_color(&canvas, canvas.ink, 1);
    for (size_t i = 0; i < plan->outline_count; i++)
        draw_outline(plan, &fit, &plan->outlines[i], cairo);
    for (size_t i = 0; i < plan->mark_count; i++)
        draw_mark(plan, &fit, i, &canvas);
    draw_bar(plan, &fit, &canvas);
    lx_canvas_clear(&canvas);
    return fit.height;
}

static void draw_part(void *cairo, void *data)
{
    draw(data, cairo, WIDTH_MM * POINTS);
}

static luxel_status add_plan(struct lx_report *report, struct plan *plan)
{
    const struct lx_page_sheet sheet = {
        .title = "", .width_mm = WIDTH_MM, .dots_per_inch = DPI, .draw = draw, .what = plan};
    const struct lx_drawing drawing = {.width_pt = WIDTH_MM * POINTS,
                                       .height_pt = draw(plan, NULL, WIDTH_MM * POINTS),
                                       .draw = draw_part,
                                       .release = release,
                                       .data = plan};
    unsigned char *bytes = NULL;
    size_t length = 0;
    const luxel_status status = lx_sheet_png(&sheet, report->diagnostics, &bytes, &length);
    if (status == LUXEL_OK)
        lx_document_picture(report->document, bytes, length, &drawing,
                            LX_N("From above: surfaces, measuring grids (dashed), the numbered places of the "
                                 "luminaires, and observers, who look along their wedges."),
                            NULL);
    else
        release(plan);
    free(bytes);
    return status;
}

luxel_status lx_lighting_plan(struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    struct lx_prepared prepared;
    struct plan *plan = NULL;
    luxel_status status = LUXEL_OK;
    lx_document_heading(report->document, 1, LX_N("Plan"), NULL);
    if (lx_prepare(report->parameters, NULL, NULL, &prepared) == 0)
        plan = make(lighting, &prepared);
    lx_prepared_clear(&prepared);
    if (!plan)
        return lx_out_of_memory(report->diagnostics);
    if (plan->low[0] <= plan->high[0])
        return add_plan(report, plan);
    release(plan);
    lx_document_paragraph(report->document, LX_N("There is nothing that stands anywhere."), NULL);
    return status;
}
