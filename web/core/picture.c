/* SPDX-License-Identifier: MIT */
/* Pictures of the present scene: their samples, files of them, exact values, explanations, lines. */
#include <stdlib.h>

#include "answer.h"
#include "core.h"

/* Computes the picture, or a quick look at it; returns a luxel_status.  The one before stays where it fails. */
PAGE_CALLS(page_render) int page_render(unsigned stride)
{
    luxel_settings settings = present_settings();
    luxel_field *field = NULL;
    settings.stride = stride;
    const luxel_status status = luxel_render(computed_scene(), &settings, fresh_diagnostics(), &field);
    if (status == LUXEL_OK) {
        luxel_field_free(core.field);
        core.field = viewed(field);
    }
    return (int)status;
}

PAGE_CALLS(page_values) const float *page_values(void)
{
    return core.field ? luxel_field_single(core.field) : NULL;
}

PAGE_CALLS(page_mask) const uint8_t *page_mask(void)
{
    return core.field ? luxel_field_mask(core.field) : NULL;
}

PAGE_CALLS(page_grey) int page_grey(uint8_t *grey)
{
    if (core.field)
        luxel_field_grey(core.field, grey);
    return core.field != NULL;
}

static void answer_extremum(const char *key, const luxel_extremum *extremum)
{
    answer_key(key);
    answer_open('{');
    answer_key("exists");
    answer_bool(extremum->exists);
    answer_key("value");
    answer_number(extremum->value);
    answer_key("x");
    answer_number(extremum->x_mm);
    answer_key("y");
    answer_number(extremum->y_mm);
    answer_close('}');
}

/* What the picture is: its size, places, unit and statistics. */
PAGE_CALLS(page_picture) const char *page_picture(void)
{
    if (!core.field)
        return NULL;
    const luxel_statistics *statistics = luxel_field_statistics(core.field);
    answer_begin();
    answer_open('{');
    answer_key("columns");
    answer_number(luxel_field_columns(core.field));
    answer_key("rows");
    answer_number(luxel_field_rows(core.field));
    answer_key("unit");
    answer_string(page_translate(luxel_field_unit(core.field), NULL));
    answer_key("word");
    answer_string(luxel_field_quantity_word(core.field));
    answer_extremum("maximum", &statistics->maximum);
    answer_extremum("minimum", &statistics->minimum);
    answer_key("mean");
    answer_number(statistics->mean);
    answer_key("lit");
    answer_number(statistics->lit);
    answer_key("reflected");
    if (statistics->has_reflected)
        answer_number(statistics->reflected_error);
    else
        answer_string(NULL);
    answer_key("colour");
    answer_bool(luxel_scene_has_color(core.scene));
    answer_key("reached");
    answer_bool(statistics->reflected_reached);
    answer_key("mirrored");
    answer_number(statistics->mirrored_error);
    answer_close('}');
    return answer_text();
}

/* The bytes of the file that the tool would write: a whole picture, not a quick look. */
PAGE_CALLS(page_file) unsigned char *page_file(const char *name, size_t *length)
{
    const luxel_settings settings = present_settings();
    luxel_field *field = NULL;
    unsigned char *bytes = NULL;
    if (luxel_render(computed_scene(), &settings, fresh_diagnostics(), &field) == LUXEL_OK)
        (void)luxel_field_write_memory(field, name, NULL, core.diagnostics, &bytes, length);
    luxel_field_free(field);
    return bytes;
}

static void answer_value(const luxel_value *value, const double *shares, size_t lights)
{
    answer_open('{');
    answer_key("surface");
    if (value->on_surface)
        answer_number((double)value->surface);
    else
        answer_string(NULL);
    answer_key("part");
    answer_string(value->on_surface ? luxel_scene_part_name(core.scene, value->surface, value->part) : NULL);
    answer_key("value");
    if (value->has_value)
        answer_number(value->value);
    else
        answer_string(NULL);
    answer_key("error");
    answer_number(value->error);
    answer_key("position");
    answer_numbers(value->position_mm, value->on_surface ? 3 : 0);
    answer_key("normal");
    answer_numbers(value->normal, value->on_surface ? 3 : 0);
    answer_key("shares");
    answer_numbers(shares, lights);
    answer_close('}');
}

const char *answer_probe(const luxel_evaluator *evaluator, double x_mm, double y_mm)
{
    const size_t lights = evaluator ? luxel_evaluator_light_count(evaluator) : 0;
    double *shares = calloc(lights + 1, sizeof *shares);
    if (!evaluator || !shares) {
        free(shares);
        return NULL;
    }
    luxel_value value;
    luxel_evaluate_screen(evaluator, x_mm, y_mm, &value, shares);
    answer_begin();
    answer_value(&value, shares, lights);
    free(shares);
    return answer_text();
}

/* The exact value seen through a point of the screen, and what each light gives of it. */
PAGE_CALLS(page_probe) const char *page_probe(double x_mm, double y_mm)
{
    return answer_probe(present_evaluator(), x_mm, y_mm);
}

/* What each light brings to the place that is seen through a point of the screen: its irradiance there. */
PAGE_CALLS(page_lit) const char *page_lit(double x_mm, double y_mm)
{
    luxel_settings settings = present_settings();
    const luxel_scene *scene = computed_scene();
    settings.quantity = LUXEL_IRRADIANCE;
    if (!core.lit && scene)
        (void)luxel_evaluator_new(scene, &settings, fresh_diagnostics(), &core.lit);
    return answer_probe(core.lit, x_mm, y_mm);
}

/* How the value at a point comes about: a page of HTML (3), Markdown (1), LaTeX (2) or text (0). */
PAGE_CALLS(page_explain)
const char *page_explain(double x_mm, double y_mm, int format, const char *language_code)
{
    static char *text;
    const luxel_settings settings = present_settings();
    const luxel_language language = {.translate = page_translate, .code = language_code};
    luxel_document *document = NULL;
    luxel_text_free(text);
    text = NULL;
    if (core.scene &&
        luxel_explain(computed_scene(), &settings, x_mm, y_mm, &language, fresh_diagnostics(), &document) == 0)
        text = luxel_document_write_text(document, (luxel_document_format)format);
    luxel_document_free(document);
    return text;
}

/* The true extrema on what the screen shows, between the pixels. */
PAGE_CALLS(page_extrema) const char *page_extrema(void)
{
    const luxel_settings settings = present_settings();
    luxel_field *field = NULL;
    luxel_extrema extrema;
    const luxel_evaluator *evaluator = present_evaluator();
    if (!evaluator || luxel_render(computed_scene(), &settings, fresh_diagnostics(), &field) != LUXEL_OK)
        return NULL;
    const luxel_status status = luxel_find_extrema(evaluator, field, NULL, core.diagnostics, &extrema);
    luxel_field_free(field);
    if (status != LUXEL_OK || !extrema.maximum.exists)
        return NULL;
    const luxel_peak *const peaks[2] = {&extrema.maximum, &extrema.minimum};
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < 2; i++) {
        answer_open('{');
        answer_key("value");
        answer_number(peaks[i]->value);
        answer_key("x");
        answer_number(peaks[i]->x_mm);
        answer_key("y");
        answer_number(peaks[i]->y_mm);
        answer_key("position");
        answer_numbers(peaks[i]->position_mm, 3);
        answer_key("place");
        answer_number(peaks[i]->place);
        answer_close('}');
    }
    answer_close(']');
    return answer_text();
}

/* What is read off all pixels of the whole picture. */
PAGE_CALLS(page_summary) const char *page_summary(void)
{
    const luxel_settings settings = present_settings();
    luxel_field *field = NULL;
    luxel_summary summary;
    if (!core.scene || luxel_render(computed_scene(), &settings, fresh_diagnostics(), &field) != LUXEL_OK)
        return NULL;
    field = viewed(field);
    const luxel_status status = luxel_field_summary(field, NULL, core.diagnostics, &summary);
    luxel_field_free(field);
    if (status != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('{');
    answer_key("pixels");
    answer_number((double)summary.pixels);
    answer_extremum("maximum", &summary.maximum);
    answer_extremum("minimum", &summary.minimum);
    answer_key("mean");
    answer_number(summary.mean);
    answer_key("median");
    answer_number(summary.median);
    answer_key("deviation");
    answer_number(summary.standard_deviation);
    answer_key("u0");
    if (summary.has_evenness)
        answer_number(summary.u0);
    else
        answer_string(NULL);
    answer_close('}');
    return answer_text();
}

/* The ends of the line across the whole screen through a point, at an angle to the x axis. */
PAGE_CALLS(page_line) const char *page_line(double x_mm, double y_mm, double degrees)
{
    const double through_mm[2] = {x_mm, y_mm};
    double from_mm[2], to_mm[2];
    if (!core.scene ||
        luxel_profile_line(core.scene, through_mm, degrees, fresh_diagnostics(), from_mm, to_mm) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('[');
    answer_numbers(from_mm, 2);
    answer_numbers(to_mm, 2);
    answer_close(']');
    return answer_text();
}

/* Lines of equal value on the last picture, at about so many round levels. */
PAGE_CALLS(page_isophotes) const char *page_isophotes(unsigned wanted, int logarithmic)
{
    enum { ROOM = 32 };
    double levels[ROOM];
    luxel_isophotes *found = NULL;
    if (!core.field)
        return NULL;
    const luxel_statistics *statistics = luxel_field_statistics(core.field);
    const double high = statistics->maximum.value;
    const double low = logarithmic ? high * 1e-3 : 0;
    const size_t count = luxel_round_levels(low, high, logarithmic != 0, wanted, levels, ROOM);
    if (luxel_find_isophotes(core.field, NULL, levels, count, fresh_diagnostics(), &found) != LUXEL_OK)
        return NULL;
    answer_begin();
    answer_open('[');
    for (size_t i = 0; i < found->count; i++) {
        const luxel_isophote *line = &found->lines[i];
        answer_open('{');
        answer_key("level");
        answer_number(line->level);
        answer_key("closed");
        answer_bool(line->closed);
        answer_key("x");
        answer_numbers(line->x_mm, line->count);
        answer_key("y");
        answer_numbers(line->y_mm, line->count);
        answer_close('}');
    }
    answer_close(']');
    luxel_isophotes_free(found);
    return answer_text();
}
