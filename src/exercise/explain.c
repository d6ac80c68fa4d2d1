/* SPDX-License-Identifier: MIT */
/* luxel_explain(): the document about one value. */
#include "explain.h"

#include <stdlib.h>

#include "../api/coloring.h"
#include "../base/diagnostics.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../scene/colours.h"
#include "../scene/lit.h"
#include "alternatives.h"
#include "parameter_tables.h"

enum { MOST_LIGHTS = 12, RESULT_DIGITS = 15 };

/* One explanation under way. */
struct explaining {
    struct luxel_document *document;
    const luxel_scene *scene;
    const luxel_settings *settings;
    const luxel_probe *probe;
    const luxel_probe *white; /* by white light on materials without colours: the same in a grey scene */
    const char *unit;
    luxel_quantity quantity;
};

static const char *digits(double value, int count, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_digits(value == 0 ? 0 : value, count, buffer);
}

static void add_title(const struct explaining *explaining)
{
    static const char *const titles[] = {
        LX_N("The brightness seen at x = {0}, y = {1} mm"), LX_N("The luminance seen at x = {0}, y = {1} mm"),
        LX_N("The irradiance seen at x = {0}, y = {1} mm"), LX_N("The illuminance seen at x = {0}, y = {1} mm")};
    char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE];
    lx_document_title(
        explaining->document,
        lx_by_quantity(explaining->quantity, lx_scene_parameters(explaining->scene)->units == LX_PHOTOMETRIC, titles),
        LX_SPANS(LX_PLAIN(digits(explaining->probe->x_mm, 9, x)), LX_PLAIN(digits(explaining->probe->y_mm, 9, y))));
}

static void add_result(const struct explaining *explaining)
{
    const luxel_probe *probe = explaining->probe;
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE], pixel[LX_NUMBER_SIZE];
    digits(probe->value, RESULT_DIGITS, value);
    lx_write_bound(lx_error_of_shown(value, probe->value, probe->error), 2, error);
    lx_document_paragraph(explaining->document, LX_N("The value is {0} {1}, with an error of at most {2}."),
                          LX_SPANS(LX_PLAIN(value), LX_PLAIN(explaining->unit), LX_PLAIN(error)));
    if (!probe->has_pixel)
        lx_document_paragraph(explaining->document, LX_N("The point lies off the screen: no pixel shows it."), NULL);
    else if (probe->has_pixel_value)
        lx_document_paragraph(explaining->document,
                              LX_N("The pixel that the point falls in has the value {0}, taken at its own sample."),
                              LX_SPANS(LX_PLAIN(digits(probe->pixel_value, 7, pixel))));
}

/* ---- lights ---- */

static double share_value(const struct explaining *explaining, const luxel_light_share *share)
{
    return explaining->quantity == LUXEL_IRRADIANCE ? share->irradiance : share->diffuse + share->specular;
}

/* Whether a light is among the MOST_LIGHTS that give most; ties: the first ones. */
static bool is_told(const struct explaining *explaining, size_t i)
{
    const luxel_probe *probe = explaining->probe;
    double own = share_value(explaining, &probe->shares[i]);
    size_t before = 0;
    for (size_t k = 0; k < probe->share_count; k++) {
        double other = share_value(explaining, &probe->shares[k]);
        before += other > own || (other == own && k < i);
    }
    return before < MOST_LIGHTS;
}

static void add_lights(const struct explaining *explaining, const struct lx_steps *steps)
{
    const luxel_probe *probe = explaining->probe;
    double rest = 0;
    size_t left = 0;
    lx_document_heading(explaining->document, 1, LX_N("What the lights give"), NULL);
    if (probe->share_count == 0)
        lx_document_paragraph(explaining->document, LX_N("The scene has no lights that are on."), NULL);
    if (explaining->quantity == LUXEL_BRIGHTNESS && probe->share_count > 0)
        lx_document_paragraph(
            explaining->document,
            LX_N("The factors {0} of the material stand as one number each, {1} being 1, or 1/π where "
                 "the scene says over_pi, and {2} being 1 unless the highlight is normalized."),
            LX_SPANS(LX_MATH("p\\, k_d,\\; p\\, k_s\\, c,\\; p\\, k_a"), LX_MATH("p"), LX_MATH("c")));
    if (probe->color.exists && probe->share_count > 0)
        lx_explain_color_rule(steps);
    for (size_t i = 0; i < probe->share_count; i++) {
        if (is_told(explaining, i)) {
            lx_explain_light(steps, &explaining->white->shares[i]);
            if (probe->color.exists)
                lx_explain_light_color(steps, &explaining->white->shares[i], &probe->shares[i]);
        } else {
            rest += share_value(explaining, &probe->shares[i]);
            left++;
        }
    }
    if (left > 0) {
        char count[LX_NUMBER_SIZE], sum[LX_NUMBER_SIZE];
        lx_document_paragraph(explaining->document, LX_N("The other {0} lights, which give less, add up to {1}."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)left, count)), LX_PLAIN(digits(rest, 7, sum))));
    }
}

static void add_sum(const struct explaining *explaining)
{
    const luxel_probe *probe = explaining->probe;
    struct lx_text line = {0};
    char number[LX_NUMBER_SIZE];
    lx_document_heading(explaining->document, 1, LX_N("The sum"), NULL);
    lx_add_notation(&line, explaining->quantity == LUXEL_IRRADIANCE ? "E = " : "B = ");
    const size_t terms = probe->share_count + probe->has_reflected;
    const bool shows_terms = terms > 1 && probe->share_count <= MOST_LIGHTS;
    for (size_t i = 0; i < terms && shows_terms; i++)
        lx_add_notation(&line, i > 0 ? " + #" : "#",
                        i < probe->share_count ? share_value(explaining, &probe->shares[i]) : probe->reflected.value);
    lx_add_notation(&line, shows_terms ? " = #" : "#", probe->value);
    lx_end_formula(explaining->document, &line);
    lx_document_paragraph(explaining->document, LX_N("To all its digits: {0} {1}."),
                          LX_SPANS(LX_PLAIN(lx_write_number(probe->value, number)), LX_PLAIN(explaining->unit)));
}

/* ---- reflected light ---- */

/* How many bounces give how much, of the alternatives that a scene with reflections has. */
static void add_bounces(const struct explaining *explaining, const luxel_alternatives *alternatives)
{
    struct luxel_document *document = explaining->document;
    const luxel_probe *probe = explaining->probe;
    char value[LX_NUMBER_SIZE], adds[LX_NUMBER_SIZE], bound[LX_NUMBER_SIZE];
    lx_document_heading(document, 1, LX_N("What surfaces reflect"), NULL);
    lx_document_paragraph(document,
                          LX_N("From other surfaces the point receives {0}, which adds {1} to the value, with an error "
                               "of at most {2}."),
                          LX_SPANS(LX_MATH("E_r"), LX_PLAIN(digits(probe->reflected.value, 7, adds)),
                                   LX_PLAIN(digits(probe->reflected.error, 2, bound))));
    lx_show_formula(document, "E_r = #", probe->reflected_irradiance);
    lx_document_table(document, "llrr");
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("reflections")), LX_TERM_SPAN(LX_N("meaning")),
                             LX_TERM_SPAN(LX_N("value")), LX_TERM_SPAN(LX_N("error, at most"))),
                    false);
    for (size_t i = 0; i < alternatives->count; i++) {
        const luxel_alternative *bounces = &alternatives->list[i];
        lx_document_row(document,
                        LX_SPANS(LX_CODE(bounces->choice), LX_TERM_SPAN(bounces->meaning),
                                 LX_PLAIN(digits(bounces->value, 7, value)),
                                 LX_PLAIN(digits(bounces->error, 2, bound))),
                        bounces->is_present);
    }
}

/* ---- conventions ---- */

static void add_alternative(const struct explaining *explaining, const luxel_alternative *alternative, bool names)
{
    char value[LX_NUMBER_SIZE], difference[LX_NUMBER_SIZE + 2] = "";
    double away = alternative->value - explaining->probe->value;
    struct lx_span number = LX_PLAIN(digits(alternative->value, 7, value)), none = LX_PLAIN("–");
    struct lx_span name = LX_TERM_SPAN(alternative->convention), blank = LX_PLAIN("");
    struct lx_span choice = LX_CODE(alternative->choice), place = LX_TERM_SPAN(alternative->choice);
    if (!alternative->is_present && alternative->has_value)
        digits(away, 3, difference + (away > 0));
    if (!alternative->is_present && alternative->has_value && away > 0)
        difference[0] = '+';
    lx_document_row(explaining->document,
                    LX_SPANS(names ? name : blank, alternative->assignment ? choice : place,
                             LX_TERM_SPAN(alternative->meaning), alternative->has_value ? number : none,
                             LX_PLAIN(difference)),
                    alternative->is_present);
}

static void add_alternatives(const struct explaining *explaining, const luxel_alternatives *alternatives)
{
    const char *before = "";
    lx_document_heading(explaining->document, 1, LX_N("What other conventions give"), NULL);
    lx_document_paragraph(explaining->document,
                          LX_N("Each row changes one convention and leaves all else as it is. The marked rows are what "
                               "this scene says; find your number among the others to see what made it."),
                          NULL);
    lx_document_table(explaining->document, "lllrr");
    lx_document_row(explaining->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("convention")), LX_TERM_SPAN(LX_N("choice")),
                             LX_TERM_SPAN(LX_N("meaning")), LX_TERM_SPAN(LX_N("value")),
                             LX_TERM_SPAN(LX_N("difference"))),
                    false);
    for (size_t i = 0; i < alternatives->count; i++) {
        add_alternative(explaining, &alternatives->list[i], alternatives->list[i].convention != before);
        before = alternatives->list[i].convention;
    }
}

/* ---- the whole ---- */

/* The steps of a value, by a scene prepared so that materials have no colours. */
static luxel_status explain_steps(const struct explaining *explaining, const struct lx_prepared *prepared,
                                  luxel_diagnostics *diagnostics)
{
    const luxel_probe *probe = explaining->probe;
    struct lx_element element;
    luxel_alternatives *alternatives = NULL;
    const luxel_status status = luxel_find_alternatives(explaining->scene, explaining->settings, probe->x_mm,
                                                        probe->y_mm, diagnostics, &alternatives);
    if (status == LUXEL_OK && lx_element_seen(prepared, probe->x_mm, probe->y_mm, &element)) {
        struct lx_steps steps = {explaining->document, prepared, &element, explaining->quantity, explaining->scene};
        add_result(explaining);
        lx_explain_place(&steps, probe->x_mm, probe->y_mm);
        add_lights(explaining, &steps);
        if (probe->has_reflected)
            add_bounces(explaining, alternatives);
        add_sum(explaining);
        if (probe->color.exists)
            lx_explain_color(&steps, probe, probe->share_count <= MOST_LIGHTS);
        if (!probe->has_reflected)
            add_alternatives(explaining, alternatives);
    }
    luxel_alternatives_free(alternatives);
    return status;
}

static luxel_status explain_value(struct explaining *explaining, luxel_diagnostics *diagnostics)
{
    const luxel_place place = {.screen_mm = {explaining->probe->x_mm, explaining->probe->y_mm}};
    const luxel_scene *scene = explaining->scene;
    struct lx_prepared prepared;
    luxel_scene *view = NULL;
    luxel_probes *white = NULL;
    luxel_status status = LUXEL_OK;
    if (lx_is_sum_of_channels(lx_scene_parameters(scene), explaining->quantity)) {
        view = lx_scene_without_colors(scene);
        status = view ? lx_probe_grey(view, explaining->settings, &place, 1, diagnostics, &white)
                      : lx_out_of_memory(diagnostics);
    }
    explaining->white = white ? luxel_probes_get(white, 0) : explaining->probe;
    if (status == LUXEL_OK) {
        if (lx_prepare(lx_scene_parameters(view ? view : scene), explaining->settings, NULL, &prepared))
            status = lx_out_of_memory(diagnostics);
        if (status == LUXEL_OK)
            status = explain_steps(explaining, &prepared, diagnostics);
        lx_prepared_clear(&prepared);
    }
    luxel_probes_free(white);
    free(view);
    return status;
}

/* Where there is no value there is a reason. */
static void explain_nothing(const struct explaining *explaining)
{
    const luxel_probe *probe = explaining->probe;
    char light[LX_NUMBER_SIZE];
    if (!probe->on_surface)
        lx_document_paragraph(explaining->document,
                              LX_N("The line of sight through this point meets no surface: there is no value."), NULL);
    else
        lx_document_paragraph(explaining->document,
                              LX_N("The source lights[{0}] lies on the very point of the surface that is seen here: "
                                   "there is no value."),
                              LX_SPANS(LX_PLAIN(lx_write_number((double)probe->blocking_light, light))));
}

luxel_status luxel_explain(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                           const luxel_language *language, luxel_diagnostics *diagnostics, luxel_document **document)
{
    luxel_probe *probe = NULL;
    luxel_scene *lit;
    luxel_status status = language ? LX_CHECK_RESERVE(language, diagnostics) : LUXEL_OK;
    if (status == LUXEL_OK)
        status = luxel_probe_screen(scene, settings, x_mm, y_mm, diagnostics, &probe);
    if (status != LUXEL_OK)
        return status;
    status = lx_scene_lit(scene, settings, diagnostics, &lit);
    if (status != LUXEL_OK) {
        luxel_probe_free(probe);
        return status;
    }
    struct explaining explaining = {.scene = lit ? lit : scene, .settings = settings, .probe = probe};
    explaining.quantity = settings ? settings->quantity : LUXEL_BRIGHTNESS;
    explaining.document = lx_document_new(language);
    if (explaining.document) {
        explaining.unit = lx_document_word(explaining.document, luxel_settings_unit(scene, settings));
        add_title(&explaining);
        if (probe->has_value)
            status = explain_value(&explaining, diagnostics);
        else
            explain_nothing(&explaining);
    }
    luxel_probe_free(probe);
    luxel_scene_free(lit);
    if (status == LUXEL_OK && (!explaining.document || lx_document_failed(explaining.document)))
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        *document = explaining.document;
    else
        luxel_document_free(explaining.document);
    return status;
}
