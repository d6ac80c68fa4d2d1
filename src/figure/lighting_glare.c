/* SPDX-License-Identifier: MIT */
/* The glare of observers in a lighting report: rated, judged, and as tables. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "lighting.h"

enum { MOST_VIEWS = 4 };

luxel_status lx_lighting_rate(struct lx_design_report *lighting)
{
    struct lx_report *report = lighting->report;
    const size_t count = report->parameters->units == LX_PHOTOMETRIC ? luxel_scene_observer_count(report->scene) : 0;
    luxel_status status = LUXEL_OK;
    lighting->glares = lx_new_array(count + 1, sizeof *lighting->glares);
    lighting->of_observers = lx_new_array(count + 1, sizeof *lighting->of_observers);
    if (!lighting->glares || !lighting->of_observers)
        return lx_out_of_memory(report->diagnostics);
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        luxel_glare_sight sight;
        luxel_scene_observer(report->scene, i, NULL, &sight);
        status = luxel_find_glare(report->scene, report->settings, &sight, report->diagnostics, &lighting->glares[i]);
        if (status != LUXEL_OK)
            break;
        lighting->observer_count++;
        status = luxel_judge_glare(report->scene, i, lighting->glares[i], lighting->of_observers[i].limits,
                                   &lighting->of_observers[i].count);
    }
    return status;
}

struct lx_judged lx_lighting_judged(const struct lx_design_report *lighting, const luxel_observer_places *places)
{
    struct lx_judged judged = lighting->of_observers[places->first];
    for (size_t k = 0; k < judged.count; k++)
        for (size_t i = places->first + 1; i < places->first + places->count; i++)
            judged.limits[k] =
                luxel_worst_limit((const luxel_limit[]){judged.limits[k], lighting->of_observers[i].limits[k]}, 2);
    return judged;
}

static void add_place(struct lx_text *text, const double numbers[3])
{
    char number[LX_NUMBER_SIZE];
    for (int i = 0; i < 3; i++)
        lx_text_printf(text, "%s%s", i > 0 ? ", " : "", lx_report_number(numbers[i] + 0.0, number));
}

static const char *text_of(const struct lx_text *text)
{
    return text->bytes ? text->bytes : "";
}

/* ---- observers at one place ---- */

static void add_single(const struct lx_design_report *lighting, size_t i, size_t number)
{
    struct lx_report *report = lighting->report;
    const luxel_glare *glare = lighting->glares[i];
    struct lx_text eye = {0}, view = {0};
    luxel_glare_sight sight;
    const char *own = NULL;
    char name[LX_LIGHTING_NAME], rating[LX_LIGHTING_CELL], background[LX_LIGHTING_CELL];
    luxel_scene_observer(report->scene, i, &own, &sight);
    add_place(&eye, sight.eye_mm);
    add_place(&view, sight.view);
    lx_document_row(report->document,
                    LX_SPANS(LX_PLAIN(lx_lighting_name(report, own, LX_N("observer"), number, name)),
                             LX_PLAIN(text_of(&eye)), LX_PLAIN(text_of(&view)),
                             LX_PLAIN(glare->has_rating ? lx_lighting_amount(report, glare->rating, rating) : "–"),
                             LX_PLAIN(lx_lighting_amount(report, glare->background, background))),
                    false);
    lx_text_clear(&eye);
    lx_text_clear(&view);
}

static void add_singles(const struct lx_design_report *lighting)
{
    struct luxel_document *document = lighting->report->document;
    luxel_observer_places places;
    bool has_begun = false;
    for (size_t i = 0, number = 0; i < lighting->observer_count; i += places.count, number++) {
        luxel_scene_observer_places(lighting->report->scene, i, &places);
        if (places.count > 1)
            continue;
        if (!has_begun) {
            lx_document_table(document, "lllrr");
            lx_document_name_table(document, "glare", 0);
            lx_document_row(document,
                            LX_SPANS(LX_TERM_SPAN(LX_N("observer")), LX_TERM_SPAN(LX_N("eye, mm")),
                                     LX_TERM_SPAN(LX_N("view")), LX_PLAIN("UGR"),
                                     LX_TERM_SPAN(LX_N("background, cd/m²"))),
                            false);
        }
        has_begun = true;
        add_single(lighting, i, number);
    }
}

/* ---- observers at several ---- */

/* The eye, and the ratings of all ways that it looks. */
static void add_ratings(const struct lx_design_report *lighting, size_t first, unsigned views)
{
    struct lx_text eye = {0};
    luxel_glare_sight sight;
    char texts[MOST_VIEWS][LX_LIGHTING_CELL];
    struct lx_span cells[MOST_VIEWS + 2];
    luxel_scene_observer(lighting->report->scene, first, NULL, &sight);
    add_place(&eye, sight.eye_mm);
    cells[0] = (struct lx_span){LX_SPAN_PLAIN, text_of(&eye)};
    for (unsigned k = 0; k < views; k++) {
        const luxel_glare *glare = lighting->glares[first + k];
        cells[k + 1] = (struct lx_span){
            LX_SPAN_PLAIN, glare->has_rating ? lx_lighting_amount(lighting->report, glare->rating, texts[k]) : "–"};
    }
    cells[views + 1] = (struct lx_span){LX_SPAN_END, NULL};
    lx_document_row(lighting->report->document, cells, false);
    lx_text_clear(&eye);
}

static void head_ratings(const struct lx_design_report *lighting, const luxel_observer_places *places)
{
    struct lx_text views[MOST_VIEWS] = {{0}};
    struct lx_span cells[MOST_VIEWS + 2] = {LX_TERM_SPAN(LX_N("eye, mm"))};
    for (unsigned k = 0; k < places->views; k++) {
        luxel_glare_sight sight;
        luxel_scene_observer(lighting->report->scene, places->first + k, NULL, &sight);
        lx_text_puts(&views[k], "(");
        add_place(&views[k], sight.view);
        lx_text_puts(&views[k], ")");
        cells[k + 1] = (struct lx_span){LX_SPAN_PLAIN, text_of(&views[k])};
    }
    cells[places->views + 1] = (struct lx_span){LX_SPAN_END, NULL};
    lx_document_table(lighting->report->document, places->views > 1 ? "lrrrr" : "lr");
    lx_document_row(lighting->report->document, cells, false);
    for (unsigned k = 0; k < places->views; k++)
        lx_text_clear(&views[k]);
}

static void add_several(const struct lx_design_report *lighting, const luxel_observer_places *places, size_t number)
{
    struct lx_report *report = lighting->report;
    const char *own = NULL;
    char name[LX_LIGHTING_NAME];
    luxel_scene_observer(report->scene, places->first, &own, NULL);
    lx_document_paragraph(report->document, LX_N("{0}: UGR by the place of the eye and the way it looks."),
                          LX_SPANS(LX_PLAIN(lx_lighting_name(report, own, LX_N("observer"), number, name))));
    head_ratings(lighting, places);
    lx_document_name_table(report->document, "glare", number + 1);
    for (size_t i = places->first; i < places->first + places->count; i += places->views)
        add_ratings(lighting, i, places->views);
}

void lx_lighting_glare(const struct lx_design_report *lighting)
{
    luxel_observer_places places;
    if (lighting->observer_count == 0)
        return;
    lx_document_heading(lighting->report->document, 1, LX_N("Glare"), NULL);
    lx_document_paragraph(lighting->report->document,
                          LX_N("The unified glare rating (UGR, CIE 117) of each observer, and the luminance of the "
                               "background. Lights without a luminous area are left out of it."),
                          NULL);
    add_singles(lighting);
    for (size_t i = 0, number = 0; i < lighting->observer_count; i += places.count, number++) {
        luxel_scene_observer_places(lighting->report->scene, i, &places);
        if (places.count > 1)
            add_several(lighting, &places, number);
    }
}
