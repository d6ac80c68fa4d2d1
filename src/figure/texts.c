/* SPDX-License-Identifier: MIT */
/* All that a figure says in words: title, label of the bar, names of lights, headings of sections, small print. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/conventions.h>
#include <luxel/version.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "../light/array.h"
#include "../parameter/decode.h"
#include "../parameter/words.h"
#include "figure.h"

enum { MOST_PRINTED_LIGHTS = 4 };

const char *lx_figure_word(const struct lx_figure *figure, const char *english)
{
    const luxel_language *language = figure->settings.language;
    return language && language->translate && *english ? language->translate(english, language->data) : english;
}

/* The text as the caller's, empty where nothing was added; NULL where out of memory. */
static char *take(struct lx_text *text)
{
    return text->bytes || text->failed ? lx_text_take(text) : lx_copy_text("", 0);
}

static char *render(const struct lx_figure *figure, struct lx_text *phrase)
{
    const luxel_language *language = figure->settings.language;
    return lx_text_render(phrase, language ? language->translate : NULL, language ? language->data : NULL);
}

/* Words of the user's, in lines, with nothing that a font cannot show. */
static char *show(const char *words)
{
    struct lx_text text = {0};
    while (words && *words) {
        size_t length = strcspn(words, "\n");
        lx_text_add_escaped(&text, words, length);
        lx_text_puts(&text, words[length] ? "\n" : "");
        words += length + (words[length] != '\0');
    }
    return take(&text);
}

/* ---- small print ---- */

static void add_vector(struct lx_text *text, const double *values)
{
    for (int i = 0; i < 3; i++) {
        char number[LX_TICK_TEXT];
        lx_text_puts(text, i == 0 ? " (" : ", ");
        lx_text_puts(text, lx_tick_text(values[i], number));
    }
    lx_text_puts(text, ")");
}

/* Where a light is, and of which shape: among its own parameters, or those of the shape that was given. */
static void print_place(const struct lx_figure *figure, const struct lx_table *table, const void *parameters,
                        struct lx_text *text)
{
    static const char *const places[] = {"position", "direction", "center"};
    for (size_t i = 0; i < LX_COUNT(places); i++) {
        const struct lx_parameter *place = lx_find_parameter(table, places[i]);
        if (!place || place->type != LX_REALS || !lx_is_given(table, parameters, places[i]))
            continue;
        add_vector(text, lx_const_member(place, parameters));
        lx_text_puts(text, place->unit == LX_UNIT_MM ? " " : "");
        lx_text_puts(text, place->unit == LX_UNIT_MM ? lx_figure_word(figure, LX_N("mm")) : "");
    }
    for (size_t i = 0; i < table->count; i++) {
        const struct lx_parameter *shape = &table->parameters[i];
        if (shape->type != LX_GROUP || shape->choices || shape->group == &lx_array_table ||
            !lx_is_given(table, parameters, shape->name))
            continue;
        lx_text_puts(text, " ");
        lx_text_puts(text, lx_figure_kind(figure, shape->name));
        print_place(figure, shape->group, lx_const_member(shape, parameters), text);
    }
}

/* "point source (2000, 0, 2000) mm, 10 W/sr": what a light is, where, and how strong. */
static void print_light(const struct lx_figure *figure, const struct lx_item *light, struct lx_text *text)
{
    static const char *const strengths[] = {"intensity", "irradiance", "radiance", "power"};
    const struct lx_table *table = light->variant->table;
    lx_text_puts(text, lx_figure_kind(figure, light->variant->name));
    print_place(figure, table, light->parameters, text);
    const struct lx_array *array = lx_array_of(light);
    if (array) {
        char columns[LX_NUMBER_SIZE], rows[LX_NUMBER_SIZE];
        struct lx_text places = {0};
        lx_add_phrase(&places, LX_N("{0} × {1} of them around"),
                      LX_ARGS(lx_write_number(array->n[0], columns), lx_write_number(array->n[1], rows)));
        char *words = render(figure, &places);
        text->failed = text->failed || !words;
        lx_text_puts(text, ", ");
        lx_text_puts(text, words ? words : "");
        free(words);
    }
    for (size_t i = 0; i < LX_COUNT(strengths); i++) {
        const struct lx_parameter *strength = lx_find_parameter(table, strengths[i]);
        char number[LX_TICK_TEXT];
        if (!strength || !lx_is_given(table, light->parameters, strengths[i]))
            continue;
        lx_text_puts(text, ", ");
        lx_text_puts(text, lx_tick_text(*(const double *)lx_const_member(strength, light->parameters), number));
        lx_text_puts(text, " ");
        lx_text_puts(text,
                     lx_figure_word(figure, lx_unit_word(strength->unit, figure->scene->units == LX_PHOTOMETRIC)));
    }
}

static void print_lights(const struct lx_figure *figure, struct lx_text *text)
{
    size_t printed = 0, left = 0;
    for (size_t i = 0; i < figure->scene->lights.count; i++) {
        const struct lx_item *light = &figure->scene->lights.items[i];
        const struct lx_light_common *common = light->common;
        if (!common->enabled)
            continue;
        if (printed == MOST_PRINTED_LIGHTS) {
            left++;
            continue;
        }
        lx_text_puts(text, printed++ > 0 ? "; " : "");
        print_light(figure, light, text);
    }
    if (left > 0) {
        char number[LX_NUMBER_SIZE];
        struct lx_text rest = {0};
        lx_add_phrase(&rest, LX_N("and {0} more"), LX_ARGS(lx_write_number((double)left, number)));
        char *words = render(figure, &rest);
        if (!words)
            text->failed = true;
        lx_text_puts(text, " ");
        lx_text_puts(text, words ? words : "");
        free(words);
    }
    lx_text_puts(text, printed > 0 ? "\n" : "");
}

/* The conventions of the picture and of the range of the figure's colours, unless that was given. */
static void print_conventions(const struct lx_figure *figure, struct lx_text *text)
{
    const luxel_conventions_use use = {
        .screen = !figure->plane,
        .pixels = !figure->plane,
        .range = isnan(figure->settings.low) && !figure->plane && !figure->settings.logarithmic,
        .brightness = luxel_field_quantity(figure->field) != LUXEL_IRRADIANCE,
    };
    luxel_conventions *conventions = NULL;
    text->failed |= luxel_find_conventions(figure->copy, &use, &conventions) != LUXEL_OK;
    for (size_t i = 0; conventions && i < conventions->count; i++) {
        lx_text_puts(text, i > 0 ? "; " : "");
        lx_figure_add_convention(figure, text, conventions->list[i].key, conventions->list[i].value);
    }
    luxel_conventions_free(conventions);
    if (figure->settings.logarithmic && isnan(figure->settings.low)) {
        lx_text_puts(text, "; ");
        lx_figure_add_convention(figure, text, "range", "log");
    }
}

/* The lights in a line, then the conventions, then the version, which stays with its name. */
static char *make_print(const struct lx_figure *figure)
{
    struct lx_text text = {0};
    if (!figure->settings.small_print)
        return take(&text);
    print_lights(figure, &text);
    print_conventions(figure, &text);
    lx_text_puts(&text, ". Luxel\u00a0");
    lx_text_puts(&text, luxel_version());
    return take(&text);
}

/* ---- the others ---- */

static char *make_label(const struct lx_figure *figure)
{
    struct lx_text text = {0};
    if (figure->settings.label)
        return show(figure->settings.label);
    if (figure->daylit)
        return show(lx_figure_word(figure, LX_N("daylight factor in %")));
    lx_text_puts(&text, lx_figure_word(figure, luxel_field_quantity_word(figure->field)));
    lx_text_puts(&text, ", ");
    lx_text_puts(&text, lx_figure_word(figure, luxel_field_unit(figure->field)));
    return take(&text);
}

static char *make_maximum(const struct lx_figure *figure)
{
    struct lx_text text = {0};
    char number[LX_TICK_TEXT];
    lx_text_puts(&text, lx_figure_word(figure, LX_N("max")));
    lx_text_puts(&text, " ");
    lx_text_puts(&text, figure->plane ? lx_value_text(figure->extrema.maximum.value, number)
                                      : lx_tick_text(figure->extrema.maximum.value, number));
    return take(&text);
}

const char *lx_value_text(double value, char buffer[LX_TICK_TEXT])
{
    char number[LX_NUMBER_SIZE];
    const double size = fabs(value);
    const int before = size >= 1 ? (int)floor(log10(size)) + 1 : 1;
    lx_write_digits(value, before > 3 ? (before < 9 ? before : 9) : 3, number);
    snprintf(buffer, LX_TICK_TEXT, "%s", number);
    return buffer;
}

/* "average 512 lx, minimum 300 lx, maximum 800 lx; U0 = 0.586": what is read off a grid's values. */
static char *make_caption(const struct lx_figure *figure)
{
    const luxel_grid *grid = figure->plane->grid;
    const luxel_grid_extrema *extrema = &figure->plane->extrema;
    const char *unit = figure->daylit ? "%" : lx_figure_word(figure, grid->unit);
    char average[LX_TICK_TEXT], minimum[LX_TICK_TEXT], maximum[LX_TICK_TEXT], evenness[LX_NUMBER_SIZE];
    struct lx_text phrase = {0};
    if (grid->measured == 0)
        return take(&phrase);
    lx_value_text(grid->average.value, average);
    lx_value_text(grid->minimum.value, minimum);
    lx_value_text(grid->maximum.value, maximum);
    lx_write_digits(grid->u0, 3, evenness);
    lx_add_phrase(&phrase,
                  grid->has_evenness
                      ? LX_N("at the points: average {0} {3}, minimum {1} {3}, maximum {2} {3}, U0 = {4}")
                      : LX_N("at the points: average {0} {3}, minimum {1} {3}, maximum {2} {3}"),
                  LX_ARGS(average, minimum, maximum, unit, evenness));
    char *points = render(figure, &phrase);
    if (!points || !extrema->maximum.exists)
        return points;
    struct lx_text whole = {0}, caption = {0};
    lx_value_text(extrema->minimum.value, minimum);
    lx_value_text(extrema->maximum.value, maximum);
    lx_add_phrase(&whole, LX_N("on the whole plane: minimum {0} {2}, maximum {1} {2}"),
                  LX_ARGS(minimum, maximum, unit));
    char *plane = render(figure, &whole);
    lx_text_puts(&caption, points);
    lx_text_puts(&caption, "\n");
    lx_text_puts(&caption, plane ? plane : "");
    caption.failed |= !plane;
    free(points);
    free(plane);
    return take(&caption);
}

static char *make_section_title(const struct lx_figure *figure, int which)
{
    char number[LX_TICK_TEXT];
    struct lx_text phrase = {0};
    double at = figure->section_mm[1 - which];
    lx_tick_text(fabs(at) < 1e-6 ? 0 : at, number);
    lx_add_phrase(&phrase, which == 0 ? LX_N("section along x at y = {0} mm") : LX_N("section along y at x = {0} mm"),
                  LX_ARGS(number));
    return render(figure, &phrase);
}

static int name_lights(struct lx_figure *figure)
{
    const struct lx_list *lights = &figure->scene->lights;
    figure->lights = lx_new_array(lights->count + 1, sizeof *figure->lights);
    figure->light_places = lx_new_array(lights->count + 1, sizeof *figure->light_places);
    if (!figure->lights || !figure->light_places)
        return -1;
    for (size_t i = 0; i < lights->count; i++) {
        const struct lx_light_common *common = lights->items[i].common;
        struct lx_text name = {0};
        if (!common->enabled)
            continue;
        if (!common->name)
            lx_add_element_name(&name, "lights", i, NULL);
        figure->light_places[figure->light_count] = i;
        figure->lights[figure->light_count] = common->name ? show(common->name) : take(&name);
        if (!figure->lights[figure->light_count])
            return -1;
        figure->light_count++;
    }
    return 0;
}

luxel_status lx_figure_texts(struct lx_figure *figure, luxel_diagnostics *diagnostics)
{
    figure->title = show(figure->settings.title);
    figure->label = make_label(figure);
    figure->maximum = make_maximum(figure);
    figure->print = make_print(figure);
    for (int i = 0; i < 2; i++) {
        figure->section_titles[i] = make_section_title(figure, i);
        if (!figure->section_titles[i])
            return lx_out_of_memory(diagnostics);
    }
    if (figure->plane)
        figure->plane->caption = make_caption(figure);
    if (figure->plane && !figure->plane->caption)
        return lx_out_of_memory(diagnostics);
    return figure->title && figure->label && figure->maximum && figure->print && name_lights(figure) == 0
               ? LUXEL_OK
               : lx_out_of_memory(diagnostics);
}
