/* SPDX-License-Identifier: MIT */
/* Computing what a figure shows: the picture, its range and levels, isophotes, extrema, sections, and all its texts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/version.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "../parameter/decode.h"
#include "../parameter/words.h"
#include "figure.h"

enum { MOST_PRINTED_LIGHTS = 4, SECTION_SAMPLES = 401 };

void luxel_figure_settings_init(luxel_figure_settings *settings)
{
    *settings = (luxel_figure_settings){
        .low = (double)NAN,
        .high = (double)NAN,
        .bands = LUXEL_CONTOURS,
        .levels = 8,
        .extrema = true,
        .points = true,
        .width_mm = 160,
        .dots_per_inch = 200,
        .small_print = true,
    };
}

const char *lx_figure_word(const struct lx_figure *figure, const char *english)
{
    const luxel_language *language = figure->settings.language;
    return language && language->translate && *english ? language->translate(english, language->data) : english;
}

void lx_figure_color(const struct lx_figure *figure, double value, double color[3])
{
    luxel_palette_color(figure->settings.palette, lx_scale_place(&figure->scale, value), color);
}

void lx_figure_free(struct lx_figure *figure)
{
    if (!figure)
        return;
    for (size_t i = 0; i < figure->outline_count; i++)
        free(figure->outlines[i].places_mm);
    free(figure->outlines);
    for (size_t i = 0; i < figure->light_count; i++)
        free(figure->lights[i]);
    free(figure->lights);
    free(figure->light_places);
    for (int i = 0; i < 2; i++)
        luxel_profile_free(figure->sections[i]);
    free(figure->title);
    free(figure->label);
    free(figure->print);
    free(figure->unit);
    luxel_isophotes_free(figure->isophotes);
    luxel_field_free(figure->field);
    luxel_scene_free(figure->copy);
    free(figure);
}

/* ---- settings ---- */

static luxel_status refuse(luxel_diagnostics *diagnostics, const char *setting, double value, const char *range)
{
    char number[LX_NUMBER_SIZE];
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_SETTING_OUT_OF_RANGE,
              LX_ARGS(setting, lx_write_number(value, number), LX_TERM(range)));
    return LUXEL_ERROR_ARGUMENT;
}

static luxel_status check_settings(const luxel_figure_settings *settings, luxel_diagnostics *diagnostics)
{
    double color[3];
    if (!luxel_palette_color(settings->palette, 0, color)) {
        struct lx_text known = {0};
        struct lx_nearest nearest = {.word = settings->palette, .length = strlen(settings->palette)};
        for (size_t i = 0; luxel_palette_name(i); i++) {
            lx_text_puts(&known, i > 0 ? ", " : "");
            lx_text_puts(&known, luxel_palette_name(i));
            lx_nearest_offer(&nearest, luxel_palette_name(i));
        }
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_PALETTE, LX_ARGS(settings->palette));
        lx_hint(diagnostics, LX_MSG_PALETTES, LX_ARGS(known.bytes ? known.bytes : ""));
        lx_text_clear(&known);
        return LUXEL_ERROR_ARGUMENT;
    }
    if (!(settings->width_mm >= 40 && settings->width_mm <= 1000))
        return refuse(diagnostics, "width_mm", settings->width_mm, LX_N("40 to 1000 mm"));
    if (!(settings->dots_per_inch >= 30 && settings->dots_per_inch <= 2400))
        return refuse(diagnostics, "dots_per_inch", settings->dots_per_inch, LX_N("30 to 2400"));
    if (settings->levels < 1 || settings->levels > 50)
        return refuse(diagnostics, "levels", (double)settings->levels, LX_N("1 to 50"));
    if (settings->level_list_count > LX_MOST_LEVELS)
        return refuse(diagnostics, "level_list_count", (double)settings->level_list_count, LX_N("at most 64"));
    bool has_range = !isnan(settings->low) || !isnan(settings->high);
    if (has_range && !(settings->low < settings->high && isfinite(settings->low) && isfinite(settings->high))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_BAD_RANGE, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    if (has_range && settings->logarithmic && !(settings->low > 0)) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_BAD_LOG_RANGE, NULL);
        return LUXEL_ERROR_ARGUMENT;
    }
    return LUXEL_OK;
}

/* ---- range and levels ---- */

/* The range that was asked for, or the scene's own; four decades where it is logarithmic; never without a size. */
static void choose_scale(struct lx_figure *figure, const luxel_summary *summary)
{
    const luxel_figure_settings *settings = &figure->settings;
    const struct lx_choice_or_pair *range = &figure->scene->picture.range;
    double maximum = figure->extrema.maximum.exists ? fmax(figure->extrema.maximum.value, 0) : 0;
    struct lx_scale *scale = &figure->scale;
    *scale = (struct lx_scale){.low = 0, .high = fmax(maximum, summary->maximum.value)};
    scale->logarithmic = settings->logarithmic || (isnan(settings->low) && range->choice == LX_RANGE_LOG);
    if (!isnan(settings->low)) {
        scale->low = settings->low;
        scale->high = settings->high;
    } else if (range->choice == -1) {
        scale->low = range->low;
        scale->high = range->high;
    } else if (range->choice == LX_RANGE_MINMAX) {
        scale->low = summary->minimum.value;
    }
    if (!(scale->high > scale->low))
        scale->high = scale->low + fmax(1, fabs(scale->low));
    if (scale->logarithmic && !(scale->low > 0))
        scale->low = scale->high * 1e-4;
}

static void choose_levels(struct lx_figure *figure)
{
    const luxel_figure_settings *settings = &figure->settings;
    figure->level_count = settings->level_list_count;
    for (size_t i = 0; i < settings->level_list_count; i++)
        figure->levels[i] = settings->level_list[i];
    if (figure->level_count == 0)
        figure->level_count = luxel_round_levels(figure->scale.low, figure->scale.high, figure->scale.logarithmic,
                                                 settings->levels, figure->levels, LX_MOST_LEVELS);
}

/* Whether an exact value takes an integral, of which thousands would take too long for a figure. */
static bool is_slow(const struct lx_figure *figure)
{
    for (size_t i = 0; i < figure->scene->lights.count; i++) {
        const struct lx_item *light = &figure->scene->lights.items[i];
        const struct lx_light_common *common = light->common;
        bool extended = strcmp(light->variant->name, "planar") == 0 || strcmp(light->variant->name, "volume") == 0;
        if (common->enabled && extended)
            return true;
    }
    return false;
}

/* ---- texts ---- */

static char *take(struct lx_text *text)
{
    return text->bytes || text->failed ? lx_text_take(text) : lx_copy_text("", 0);
}

static void add_vector(struct lx_text *text, const double *values)
{
    for (int i = 0; i < 3; i++) {
        char number[LX_NUMBER_SIZE];
        lx_text_puts(text, i == 0 ? "(" : ", ");
        lx_text_puts(text, lx_write_digits(values[i], 6, number));
    }
    lx_text_puts(text, ")");
}

/* "point (2000, 0, 2000) mm, 10 W/sr": what a light is, where, and how strong. */
static void print_light(const struct lx_figure *figure, const struct lx_item *light, struct lx_text *text)
{
    static const char *const places[] = {"position", "direction"};
    static const char *const strengths[] = {"intensity", "irradiance", "radiance", "power"};
    const struct lx_table *table = light->variant->table;
    lx_text_puts(text, light->variant->name);
    for (size_t i = 0; i < LX_COUNT(places); i++) {
        const struct lx_parameter *place = lx_find_parameter(table, places[i]);
        if (!place)
            continue;
        lx_text_puts(text, " ");
        add_vector(text, lx_const_member(place, light->parameters));
        lx_text_puts(text, i == 0 ? " " : "");
        lx_text_puts(text, i == 0 ? lx_figure_word(figure, "mm") : "");
    }
    for (size_t i = 0; i < LX_COUNT(strengths); i++) {
        const struct lx_parameter *strength = lx_find_parameter(table, strengths[i]);
        char number[LX_NUMBER_SIZE];
        if (!strength || !lx_is_given(table, light->parameters, strengths[i]))
            continue;
        lx_text_puts(text, ", ");
        lx_text_puts(text, lx_write_digits(*(const double *)lx_const_member(strength, light->parameters), 6, number));
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
        const luxel_language *language = figure->settings.language;
        char *words = lx_text_render(&rest, language ? language->translate : NULL, language ? language->data : NULL);
        lx_text_puts(text, " ");
        lx_text_puts(text, words ? words : "");
        free(words);
    }
    lx_text_puts(text, printed > 0 ? ". " : "");
}

static char *make_print(const struct lx_figure *figure)
{
    struct lx_text text = {0};
    print_lights(figure, &text);
    for (size_t i = 0; i < luxel_scene_convention_count(figure->copy); i++) {
        lx_text_puts(&text, i > 0 ? "; " : "");
        lx_text_puts(&text, luxel_scene_convention_key(figure->copy, i));
        lx_text_puts(&text, " ");
        lx_text_puts(&text, luxel_scene_convention_value(figure->copy, i));
    }
    lx_text_puts(&text, ". Luxel ");
    lx_text_puts(&text, luxel_version());
    return take(&text);
}

static char *make_label(const struct lx_figure *figure)
{
    struct lx_text text = {0};
    bool irradiance = luxel_field_quantity(figure->field) == LUXEL_IRRADIANCE;
    if (figure->settings.label)
        return lx_copy_text(figure->settings.label, strlen(figure->settings.label));
    lx_text_puts(&text, lx_figure_word(figure, irradiance ? LX_N("irradiance") : LX_N("brightness")));
    lx_text_puts(&text, ", ");
    lx_text_puts(&text, figure->unit);
    return take(&text);
}

static luxel_status make_texts(struct lx_figure *figure, luxel_diagnostics *diagnostics)
{
    const char *unit = lx_figure_word(figure, luxel_field_unit(figure->field));
    const char *title = figure->settings.title ? figure->settings.title : "";
    figure->unit = lx_copy_text(unit, strlen(unit));
    figure->title = lx_copy_text(title, strlen(title));
    if (figure->unit)
        figure->label = make_label(figure);
    figure->print = figure->settings.small_print ? make_print(figure) : lx_copy_text("", 0);
    return figure->unit && figure->title && figure->label && figure->print ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

/* ---- sections ---- */

static luxel_status name_lights(struct lx_figure *figure, luxel_diagnostics *diagnostics)
{
    const struct lx_list *lights = &figure->scene->lights;
    figure->lights = lx_new_array(lights->count + 1, sizeof *figure->lights);
    figure->light_places = lx_new_array(lights->count + 1, sizeof *figure->light_places);
    if (!figure->lights || !figure->light_places)
        return lx_out_of_memory(diagnostics);
    for (size_t i = 0; i < lights->count; i++) {
        const struct lx_light_common *common = lights->items[i].common;
        struct lx_text name = {0};
        if (!common->enabled)
            continue;
        if (common->name)
            lx_text_add_escaped(&name, common->name, strlen(common->name));
        else
            lx_add_element_name(&name, "lights", i, NULL);
        figure->light_places[figure->light_count] = i;
        figure->lights[figure->light_count] = take(&name);
        if (!figure->lights[figure->light_count])
            return lx_out_of_memory(diagnostics);
        figure->light_count++;
    }
    return LUXEL_OK;
}

static luxel_status make_sections(struct lx_figure *figure, const luxel_evaluator *evaluator,
                                  luxel_diagnostics *diagnostics)
{
    luxel_status status = name_lights(figure, diagnostics);
    if (figure->settings.section == LUXEL_SECTION_MAXIMUM && figure->extrema.maximum.exists) {
        figure->section_mm[0] = figure->extrema.maximum.x_mm;
        figure->section_mm[1] = figure->extrema.maximum.y_mm;
    } else if (figure->settings.section == LUXEL_SECTION_POINT) {
        memcpy(figure->section_mm, figure->settings.section_mm, sizeof figure->section_mm);
    }
    for (int i = 0; i < 2 && status == LUXEL_OK; i++) {
        luxel_path path = {.type = LUXEL_PATH_LINE, .samples = SECTION_SAMPLES};
        status = luxel_line_across_screen(figure->copy, figure->section_mm, i == 0 ? 0 : 90, diagnostics, path.from_mm,
                                          path.to_mm);
        if (status == LUXEL_OK)
            status = luxel_find_profile(evaluator, &path, diagnostics, &figure->sections[i]);
    }
    return status;
}

/* ---- all of it ---- */

static luxel_status compute(struct lx_figure *figure, const luxel_settings *settings, luxel_diagnostics *diagnostics)
{
    luxel_evaluator *evaluator = NULL;
    luxel_summary summary;
    bool lines = figure->settings.bands == LUXEL_CONTOURS || figure->settings.bands == LUXEL_LINES;
    luxel_status status = luxel_render(figure->copy, settings, diagnostics, &figure->field);
    if (status == LUXEL_OK)
        status = luxel_evaluator_new(figure->copy, settings, diagnostics, &evaluator);
    if (status == LUXEL_OK)
        status = luxel_field_summary(figure->field, NULL, diagnostics, &summary);
    if (status == LUXEL_OK)
        status = luxel_find_extrema(evaluator, figure->field, NULL, diagnostics, &figure->extrema);
    if (status == LUXEL_OK) {
        choose_scale(figure, &summary);
        choose_levels(figure);
    }
    if (status == LUXEL_OK && lines)
        status = luxel_find_isophotes(figure->field, is_slow(figure) ? NULL : evaluator, figure->levels,
                                      figure->level_count, diagnostics, &figure->isophotes);
    if (status == LUXEL_OK && lx_figure_outline(figure, evaluator) < 0)
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = make_texts(figure, diagnostics);
    if (status == LUXEL_OK && figure->settings.section != LUXEL_SECTION_NONE)
        status = make_sections(figure, evaluator, diagnostics);
    luxel_evaluator_free(evaluator);
    return status;
}

luxel_status lx_figure_make(const luxel_scene *scene, const luxel_settings *settings,
                            const luxel_figure_settings *wanted, luxel_diagnostics *diagnostics,
                            struct lx_figure **figure)
{
    struct lx_figure *made = lx_new_array(1, sizeof *made);
    *figure = made;
    if (!made)
        return lx_out_of_memory(diagnostics);
    luxel_figure_settings_init(&made->settings);
    if (wanted)
        made->settings = *wanted;
    luxel_status status = check_settings(&made->settings, diagnostics);
    if (status == LUXEL_OK && (!scene || !luxel_scene_is_committed(scene))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NOT_COMMITTED, NULL);
        status = LUXEL_ERROR_ARGUMENT;
    }
    if (status != LUXEL_OK)
        return status;
    made->copy = luxel_scene_copy(scene);
    if (!made->copy)
        return lx_out_of_memory(diagnostics);
    made->scene = lx_scene_parameters(made->copy);
    return compute(made, settings, diagnostics);
}
