/* SPDX-License-Identifier: MIT */
/* Computing what a figure shows: the picture, its range and levels, isophotes, extrema, sections, and all its texts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/colour.h>

#include "../api/sun/daylight.h"
#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "../parameter/decode.h"
#include "../parameter/words.h"
#include "../scene/lit.h"
#include "labels.h"

enum { SECTION_SAMPLES = 401, OUTLINE_STEPS = 360 };

void luxel_figure_settings_init(luxel_figure_settings *settings)
{
    *settings = (luxel_figure_settings){
        .low = (double)NAN,
        .high = (double)NAN,
        .bands = LUXEL_BANDS_CONTOURS,
        .levels = 8,
        .extrema = true,
        .points = true,
        .width_mm = 160,
        .dots_per_inch = 200,
        .small_print = true,
    };
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
    for (size_t i = 0; i < figure->contour_count; i++)
        free(figure->contours[i].places_mm);
    free(figure->contours);
    lx_labels_free(figure->labels);
    for (size_t i = 0; i < figure->light_count; i++)
        free(figure->lights[i]);
    free(figure->lights);
    free(figure->light_places);
    for (int i = 0; i < 2; i++)
        luxel_profile_free(figure->sections[i]);
    free(figure->title);
    free(figure->label);
    free(figure->print);
    free(figure->maximum);
    for (int i = 0; i < 2; i++)
        free(figure->section_titles[i]);
    lx_plane_free(figure->plane);
    luxel_isophotes_free(figure->isophotes);
    luxel_field_free(figure->view);
    lx_rendered_clear(&figure->own);
    luxel_scene_free(figure->daylit);
    luxel_scene_free(figure->copy);
    free(figure);
}

/* ---- settings ---- */

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
        return lx_setting_out_of_range(diagnostics, "width_mm", settings->width_mm, LX_N("40 to 1000 mm"));
    if (!(settings->dots_per_inch >= 30 && settings->dots_per_inch <= 2400))
        return lx_setting_out_of_range(diagnostics, "dots_per_inch", settings->dots_per_inch, LX_N("30 to 2400"));
    if (settings->daylight && settings->grid == 0)
        return lx_setting_out_of_range(diagnostics, "grid", 0, LX_N("the number of a grid, for daylight factors"));
    if (settings->levels < 1 || settings->levels > 50)
        return lx_setting_out_of_range(diagnostics, "levels", (double)settings->levels, LX_N("1 to 50"));
    if (settings->level_list_count > LX_MOST_LEVELS)
        return lx_setting_out_of_range(diagnostics, "level_list_count", (double)settings->level_list_count,
                                       LX_N("at most 64"));
    bool has_range = !isnan(settings->low) || !isnan(settings->high);
    if (has_range && !(settings->low < settings->high && isfinite(settings->low) && isfinite(settings->high)))
        return lx_refuse(diagnostics, LX_MSG_BAD_RANGE, NULL);
    if (has_range && settings->logarithmic && !(settings->low > 0))
        return lx_refuse(diagnostics, LX_MSG_BAD_LOG_RANGE, NULL);
    if (settings->language && LX_CHECK_RESERVE(settings->language, diagnostics) != LUXEL_OK)
        return LUXEL_ERROR_ARGUMENT;
    return LX_CHECK_RESERVE(settings, diagnostics);
}

/* Whether the scene has what the view shows, and no more is asked of it than it has. */
static luxel_status check_view(const struct lx_figure *figure, luxel_diagnostics *diagnostics)
{
    const luxel_figure_settings *settings = &figure->settings;
    const char *word = luxel_color_view_word(settings->view);
    if (!word)
        return lx_setting_out_of_range(diagnostics, "view", (double)settings->view, LX_N("0 to 4"));
    if (settings->view == LUXEL_VIEW_LUMINANCE)
        return LUXEL_OK;
    if (settings->grid > 0 || settings->section != LUXEL_SECTION_NONE)
        return lx_refuse(diagnostics, LX_MSG_VIEW_OF_PICTURE, LX_ARGS(word));
    if (luxel_scene_has_color(figure->copy))
        return LUXEL_OK;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_CHANNELS, LX_ARGS(word));
    lx_hint(diagnostics, LX_MSG_HINT_CHANNELS_RGB, NULL);
    return LUXEL_ERROR_ARGUMENT;
}

/* ---- range and levels ---- */

/* The range that was asked for, or the scene's own; where it is logarithmic four decades, fewer where the smallest
 * value lies within them; never without a size. */
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
    } else if (range->choice == -1 && !figure->plane) {
        scale->low = range->low;
        scale->high = range->high;
    } else if (range->choice == LX_RANGE_MINMAX || settings->view == LUXEL_VIEW_CCT) {
        scale->low = summary->minimum.value;
    } else if (settings->view != LUXEL_VIEW_LUMINANCE) {
        scale->low = fmin(0, summary->minimum.value);
    }
    if (!(scale->high > scale->low))
        scale->high = scale->low + fmax(1, fabs(scale->low));
    if (scale->logarithmic && !(scale->low > 0)) {
        scale->low = scale->high * 1e-4;
        if (summary->minimum.value > scale->low && summary->minimum.value < scale->high)
            scale->low = summary->minimum.value;
    }
    figure->has_below = summary->minimum.value < scale->low;
    figure->has_above = summary->maximum.value > scale->high;
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

/* ---- sections ---- */

static luxel_status make_sections(struct lx_figure *figure, const luxel_evaluator *evaluator,
                                  luxel_diagnostics *diagnostics)
{
    const luxel_peak *peak = &figure->extrema.maximum;
    luxel_status status = LUXEL_OK;
    /* a plateau has no place of its own: its sections go through the centre */
    if (figure->settings.section == LUXEL_SECTION_MAXIMUM && peak->exists && peak->place != LUXEL_PEAK_PLATEAU) {
        figure->section_mm[0] = peak->x_mm;
        figure->section_mm[1] = peak->y_mm;
    } else if (figure->settings.section == LUXEL_SECTION_POINT) {
        memcpy(figure->section_mm, figure->settings.section_mm, sizeof figure->section_mm);
    }
    for (int i = 0; i < 2 && status == LUXEL_OK; i++) {
        luxel_profile_path path = {.type = LUXEL_PATH_LINE, .samples = SECTION_SAMPLES};
        status = luxel_profile_line(figure->copy, figure->section_mm, i == 0 ? 0 : 90, diagnostics, path.from_mm,
                                    path.to_mm);
        if (status == LUXEL_OK)
            status = luxel_find_profile(evaluator, &path, diagnostics, &figure->sections[i]);
    }
    return status;
}

/* ---- all of it ---- */

/* Whether the true maximum is wanted: to be marked, or for its sections. */
static bool wants_extrema(const luxel_figure_settings *settings)
{
    return settings->view == LUXEL_VIEW_LUMINANCE && (settings->extrema || settings->section == LUXEL_SECTION_MAXIMUM);
}

luxel_settings lx_whole_picture(const luxel_settings *settings)
{
    luxel_settings whole;
    luxel_settings_init(&whole);
    if (settings)
        whole = *settings;
    whole.stride = 1;
    return whole;
}

luxel_status lx_rendered_make(const luxel_scene *scene, const luxel_settings *settings, bool wants_extrema,
                              luxel_diagnostics *diagnostics, struct lx_rendered *rendered)
{
    const luxel_settings whole = lx_whole_picture(settings);
    luxel_status status = luxel_render(scene, &whole, diagnostics, &rendered->field);
    if (status == LUXEL_OK)
        status = luxel_evaluator_new(scene, settings, diagnostics, &rendered->evaluator);
    if (status == LUXEL_OK && wants_extrema)
        status = luxel_find_extrema(rendered->evaluator, rendered->field, NULL, diagnostics, &rendered->extrema);
    return status;
}

void lx_rendered_clear(struct lx_rendered *rendered)
{
    luxel_evaluator_free(rendered->evaluator);
    luxel_field_free(rendered->field);
}

/* The lines of equal value, those of the picture by exact values where these take no integrals; none: of its field. */
static luxel_status find_lines(struct lx_figure *figure, const luxel_settings *settings,
                               const luxel_evaluator *evaluator, luxel_diagnostics *diagnostics)
{
    const luxel_settings whole = lx_whole_picture(settings);
    if (figure->plane)
        return luxel_find_grid_isophotes(lx_figure_measured(figure), &whole, figure->settings.grid - 1, figure->field,
                                         figure->levels, figure->level_count, diagnostics, &figure->isophotes);
    return luxel_find_isophotes(figure->field, lx_has_extended_lights(figure->scene) ? NULL : evaluator, figure->levels,
                                figure->level_count, diagnostics, &figure->isophotes);
}

/* The outlines, extrema and axes of the scene's picture. */
static luxel_status show_picture(struct lx_figure *figure, const struct lx_rendered *rendered,
                                 luxel_diagnostics *diagnostics)
{
    const struct lx_screen *screen = &figure->scene->screen;
    if (wants_extrema(&figure->settings))
        figure->extrema = rendered->extrema;
    if (lx_figure_outline(figure, rendered->evaluator, OUTLINE_STEPS) < 0)
        return lx_out_of_memory(diagnostics);
    figure->size_mm[0] = screen->width_mm, figure->size_mm[1] = screen->height_mm;
    for (int i = 0; i < 2; i++)
        figure->axes[i] = (struct lx_scale){.low = -figure->size_mm[i] / 2, .high = figure->size_mm[i] / 2};
    figure->axis_names[0] = LX_N("x, mm"), figure->axis_names[1] = LX_N("y, mm");
    return LUXEL_OK;
}

static luxel_status compute(struct lx_figure *figure, const luxel_settings *settings,
                            const struct lx_rendered *rendered, luxel_diagnostics *diagnostics)
{
    const bool is_plane = figure->settings.grid > 0, is_view = figure->settings.view != LUXEL_VIEW_LUMINANCE;
    const struct lx_rendered *shown = rendered && !is_plane ? rendered : &figure->own;
    luxel_summary summary;
    luxel_status status = LUXEL_OK;
    if (!is_plane && !rendered)
        status = lx_rendered_make(figure->copy, settings, wants_extrema(&figure->settings), diagnostics, &figure->own);
    if (status == LUXEL_OK)
        status = is_plane ? lx_figure_plane(figure, settings, diagnostics) : show_picture(figure, shown, diagnostics);
    figure->field = shown->field;
    if (status == LUXEL_OK && is_view) {
        status = luxel_field_of_view(shown->field, figure->settings.view, diagnostics, &figure->view);
        figure->field = figure->view;
    }
    if (status == LUXEL_OK)
        status = luxel_field_summary(figure->field, NULL, diagnostics, &summary);
    if (status == LUXEL_OK) {
        choose_scale(figure, &summary);
        choose_levels(figure);
    }
    if (status == LUXEL_OK && figure->settings.bands != LUXEL_BANDS_SMOOTH)
        status = find_lines(figure, settings, is_view ? NULL : shown->evaluator, diagnostics);
    if (status == LUXEL_OK && lx_labels_prepare(figure) < 0)
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK && figure->settings.section != LUXEL_SECTION_NONE)
        status = make_sections(figure, shown->evaluator, diagnostics);
    if (status == LUXEL_OK)
        status = lx_figure_texts(figure, diagnostics);
    return status;
}

luxel_status lx_figure_make(const luxel_scene *scene, const luxel_settings *settings,
                            const luxel_figure_settings *wanted, const struct lx_rendered *rendered,
                            luxel_diagnostics *diagnostics, struct lx_figure **figure)
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
    status = lx_scene_lit(scene, settings, diagnostics, &made->copy);
    if (status == LUXEL_OK && !made->copy && !(made->copy = luxel_scene_copy(scene)))
        status = lx_out_of_memory(diagnostics);
    if (status != LUXEL_OK)
        return status;
    made->scene = lx_scene_parameters(made->copy);
    status = check_view(made, diagnostics);
    if (status != LUXEL_OK || !made->settings.daylight)
        return status == LUXEL_OK ? compute(made, settings, rendered, diagnostics) : status;
    luxel_settings skies;
    luxel_settings_init(&skies);
    skies = settings ? *settings : skies;
    skies.lights = NULL; /* the group is that of the copy already */
    skies.light_count = 0;
    status = lx_daylit_scene(made->copy, diagnostics, &made->daylit);
    return status == LUXEL_OK ? compute(made, &skies, rendered, diagnostics) : status;
}
