/* SPDX-License-Identifier: MIT */
/* Pictures in colour: the sums of grey ones, pixel by pixel. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "../field/gather.h"
#include "coloring.h"
#include "reflecting.h"
#include "render_tints.h"
#include "rendering.h"

static bool tell(double done, void *data)
{
    const struct lx_part_progress *part = data;
    return part->progress(part->before + part->share * done, part->data);
}

static bool tell_bound(double bound, void *data)
{
    const struct lx_part_progress *part = data;
    return part->enough(bound, part->data);
}

void lx_part_progress_begin(struct lx_part_progress *part, size_t i, size_t count, const luxel_settings *asked,
                            luxel_settings *settings)
{
    if (asked)
        settings->within = asked->within / (double)count;
    if (!asked || !(asked->progress || asked->enough))
        return;
    *part = (struct lx_part_progress){asked->progress, asked->enough, asked->progress_data, (double)i / (double)count,
                                      1 / (double)count};
    settings->progress = asked->progress ? tell : NULL;
    settings->enough = asked->enough ? tell_bound : NULL;
    settings->progress_data = part;
}

static double get(const struct luxel_field *field, const void *values, size_t i)
{
    return field->precision == LUXEL_DOUBLE ? ((const double *)values)[i] : (double)((const float *)values)[i];
}

static void put(const struct luxel_field *field, void *values, size_t i, double value)
{
    if (field->precision == LUXEL_DOUBLE)
        ((double *)values)[i] = value;
    else
        ((float *)values)[i] = (float)value;
}

/* Makes room for the channels of a field, all 0. */
static luxel_status add_channels(struct luxel_field *field, luxel_diagnostics *diagnostics)
{
    const size_t size = field->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float);
    field->rgb = lx_new_array((size_t)field->columns * field->rows * LX_CHANNELS, size);
    return field->rgb ? LUXEL_OK : lx_out_of_memory(diagnostics);
}

/* What a picture is the sum of: parts of channels, of lobes, which take their colours pixel by pixel, or of lights. */
enum sum { OF_CHANNELS, OF_LOBES, OF_LIGHTS };

/* How large a part's channels are, in white light: by the greatest value and factor, and what they come to. */
struct size {
    double most[LX_CHANNELS], shown[LX_CHANNELS];
    double greatest; /* of the part's values */
};

/* Adds values with weights to channels and, unless NULL, to a sum. */
static void add_single(float *restrict rgb, float *restrict sum, const float *restrict values, size_t pixels,
                       const struct lx_color_part *part)
{
    const double red = part->rgb[0], green = part->rgb[1], blue = part->rgb[2], luminance = part->luminance;
    for (size_t i = 0; i < pixels; i++) {
        const double value = (double)values[i];
        rgb[LX_CHANNELS * i] = (float)((double)rgb[LX_CHANNELS * i] + red * value);
        rgb[LX_CHANNELS * i + 1] = (float)((double)rgb[LX_CHANNELS * i + 1] + green * value);
        rgb[LX_CHANNELS * i + 2] = (float)((double)rgb[LX_CHANNELS * i + 2] + blue * value);
    }
    for (size_t i = 0; i < pixels && sum; i++)
        sum[i] = (float)((double)sum[i] + luminance * (double)values[i]);
}

/* Adds a part's picture to the channels of a field and, where that is the sum, to its values.  `tints`, unless NULL,
 * are factors of the pixels. */
static void add_part(struct luxel_field *field, const struct lx_color_part *part, const struct luxel_field *from,
                     bool is_sum, const struct lx_tints *tints, struct size *size)
{
    static const double white[LX_CHANNELS] = {1, 1, 1};
    const size_t pixels = (size_t)field->columns * field->rows;
    const bool is_highlight = lx_scene_parameters(part->scene)->channel == LX_CHANNEL_HIGHLIGHT;
    size->greatest = from->statistics.maximum.value;
    if (!tints && field->precision == LUXEL_SINGLE) {
        add_single(field->rgb, is_sum ? field->values : NULL, from->values, pixels, part);
        return;
    }
    for (size_t i = 0; i < pixels; i++) {
        const double *factors = tints ? tints->list[tints->of_pixels[i]].factors[is_highlight] : white;
        const double value = get(field, from->values, i);
        double shares[LX_CHANNELS];
        for (size_t c = 0; c < LX_CHANNELS; c++) {
            shares[c] = part->rgb[c] * factors[c] * value;
            size->shown[c] = fmax(size->shown[c], factors[c] * value);
            put(field, field->rgb, LX_CHANNELS * i + c, get(field, field->rgb, LX_CHANNELS * i + c) + shares[c]);
        }
        if (is_sum)
            put(field, field->values, i, get(field, field->values, i) + luxel_rgb_luminance(shares));
    }
    for (size_t c = 0; c < LX_CHANNELS && tints && from->statistics.maximum.exists; c++)
        size->most[c] = tints->greatest[is_highlight][c] * from->statistics.maximum.value;
}

/* Whether the parts of lights add up to a luminance that is as exact as pictures have to be. */
static bool lights_fit(const struct luxel_field *field, const struct size *sizes, size_t count)
{
    double most = 0, shown = 0;
    for (size_t i = 0; i < count; i++)
        most += sizes[i].greatest;
    for (size_t i = 0; i < (size_t)field->columns * field->rows && most > 0; i++)
        shown = fmax(shown, get(field, field->values, i));
    return most <= LX_LOBES_TO_CHANNEL * shown;
}

/*
 * Whether the parts of each group of lights add up to channels that are as exact as pictures have to be.  Parts are, by
 * their own greatest values, which may stand where a channel is dark.
 */
static bool do_fit(const struct lx_color_parts *parts, const struct size *sizes)
{
    for (size_t i = 0; i < parts->count; i++)
        for (size_t c = 0; c < LX_CHANNELS; c++) {
            double most = 0, shown = 0;
            for (size_t k = 0; k < parts->count; k++)
                if (parts->list[k].group == parts->list[i].group) {
                    most += sizes[k].most[c];
                    shown = fmax(shown, sizes[k].shown[c]);
                }
            if (most > LX_LOBES_TO_CHANNEL * shown)
                return false;
        }
    return true;
}

/* What is known of a sum: the errors of reflected light, and of what comes over more mirrors than are counted. */
struct errors {
    bool has_reflected;
    double reflected, mirrored;
};

static void note_errors(struct errors *errors, const struct lx_color_part *part, const struct luxel_field *from)
{
    const luxel_statistics *statistics = &from->statistics;
    const double share = fabs(part->luminance) * statistics->maximum.value;
    errors->has_reflected = statistics->has_reflected;
    errors->reflected += share * statistics->reflected_error;
    if (statistics->mirrored_error > 0)
        errors->mirrored += statistics->mirrored_error < HUGE_VAL ? share * statistics->mirrored_error : HUGE_VAL;
}

/* The least value where light arrives, which a session of the scene tells. */
static luxel_status find_reached(const struct lx_session *session, struct luxel_field *field,
                                 luxel_diagnostics *diagnostics)
{
    luxel_statistics *statistics = &field->statistics;
    const struct lx_strip all = lx_whole_strip(field);
    struct lx_reaching reaching = {.is_open = false};
    const luxel_status status =
        statistics->has_reflected ? LUXEL_OK : lx_reaching_open(&reaching, session, 1, diagnostics);
    /* what is reflected arrives wherever there is any */
    if (reaching.is_plain || (statistics->has_reflected && session->settings.minimum_reached))
        statistics->minimum_reached = statistics->minimum;
    for (unsigned row = 0; row < field->rows && reaching.is_open && status == LUXEL_OK; row++) {
        struct lx_row_statistics gathered = {.reached = HUGE_VAL};
        lx_reaching_row(&reaching, 0, field, &all, row, &gathered);
        const size_t pixel = (size_t)row * field->columns + gathered.reached_column;
        if (gathered.reached < HUGE_VAL &&
            !(statistics->minimum_reached.exists && gathered.reached >= statistics->minimum_reached.value))
            statistics->minimum_reached = lx_extremum_at(field, pixel, gathered.reached);
    }
    lx_reaching_clear(&reaching);
    return status;
}

static luxel_status finish_sum(struct luxel_field *field, const luxel_settings *settings, struct errors *errors,
                               luxel_diagnostics *diagnostics)
{
    if (lx_gather_statistics(field) < 0)
        return lx_out_of_memory(diagnostics);
    luxel_statistics *statistics = &field->statistics;
    statistics->reflected_reached = true;
    statistics->mirrored_error = lx_share_of_maximum(statistics, errors->mirrored);
    if (!errors->has_reflected)
        return LUXEL_OK;
    statistics->has_reflected = true;
    statistics->reflected_error = statistics->maximum.exists ? errors->reflected / statistics->maximum.value : 0;
    statistics->reflected_reached = statistics->reflected_error <= lx_pictured_error_of(settings);
    if (!statistics->reflected_reached) {
        char error[LX_NUMBER_SIZE];
        lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_REFLECTED_ERROR,
                  LX_ARGS(lx_write_bound(statistics->reflected_error, 2, error)));
    }
    return LUXEL_OK;
}

/* The field that a sum becomes, all 0, by a session of the scene with a plan. */
static luxel_status new_sum(const luxel_scene *scene, const struct lx_session *session, luxel_diagnostics *diagnostics,
                            struct luxel_field **field)
{
    const luxel_status status = lx_new_frame(session, scene, diagnostics, field);
    if (status != LUXEL_OK)
        return status;
    struct lx_strip all = {.rows = (*field)->rows};
    const int failed = lx_strip_allocate(*field, &all);
    (*field)->values = all.values;
    (*field)->mask = all.mask;
    if (failed)
        return lx_out_of_memory(diagnostics);
    const size_t size = (*field)->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float);
    memset(all.values, 0, (size_t)(*field)->columns * (*field)->rows * size);
    return LUXEL_OK;
}

/* Renders the parts and adds them up. */
static luxel_status add_parts(const struct lx_color_parts *parts, const luxel_settings *settings,
                              const struct lx_tints *tints, struct size *sizes, luxel_diagnostics *diagnostics,
                              struct luxel_field *field, struct errors *errors)
{
    const size_t before = parts->is_sum ? 0 : 1, all = parts->count + before;
    for (size_t i = 0; i < parts->count; i++) {
        luxel_settings own = parts->list[i].settings;
        struct lx_part_progress progress;
        struct luxel_field *from = NULL;
        lx_part_progress_begin(&progress, i + before, all, settings, &own);
        own.minimum_reached = false;
        const luxel_status status = lx_render_grey(parts->list[i].scene, &own, i == 0 ? diagnostics : NULL, &from);
        if (status != LUXEL_OK)
            return status == LUXEL_ERROR_MEMORY && i > 0 ? lx_out_of_memory(diagnostics) : status;
        add_part(field, &parts->list[i], from, parts->is_sum, tints, &sizes[i]);
        note_errors(errors, &parts->list[i], from);
        memcpy(field->mask, from->mask, (size_t)field->columns * field->rows);
        luxel_field_free(from);
    }
    return LUXEL_OK;
}

/* Adds the parts of one kind up; those of lobes and of lights may turn out not to fit. */
static luxel_status add_up(const luxel_scene *scene, const struct lx_session *session, enum sum sum,
                           luxel_diagnostics *diagnostics, struct luxel_field *field, struct errors *errors, bool *fits)
{
    const bool by_lobes = sum == OF_LOBES;
    struct lx_color_parts parts;
    struct lx_tints tints = {.list = NULL};
    luxel_status status = (by_lobes           ? lx_color_lobes_make
                           : sum == OF_LIGHTS ? lx_color_lights_make
                                              : lx_color_parts_make)(scene, &session->settings, diagnostics, &parts);
    struct size *sizes = lx_new_array(parts.count, sizeof *sizes);
    if (status == LUXEL_OK && (!sizes || (by_lobes && lx_tints_make(session, field, &tints))))
        status = lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = add_parts(&parts, &session->settings, by_lobes ? &tints : NULL, sizes, diagnostics, field, errors);
    *fits = status != LUXEL_OK || (sum == OF_LIGHTS ? lights_fit(field, sizes, parts.count) : do_fit(&parts, sizes));
    lx_tints_clear(&tints);
    free(sizes);
    lx_color_parts_clear(&parts);
    return status;
}

/* Renders a picture that is a sum; false in *fits: it would not be exact enough. */
static luxel_status render_sum(const luxel_scene *scene, const luxel_settings *settings, enum sum sum,
                               luxel_diagnostics *diagnostics, luxel_field **made, bool *fits)
{
    struct lx_session session;
    struct errors errors = {.has_reflected = false};
    luxel_status status = lx_session_open(scene, settings, diagnostics, &session);
    *fits = true;
    if (status == LUXEL_OK)
        status = new_sum(scene, &session, diagnostics, made);
    if (status == LUXEL_OK)
        status = add_channels(*made, diagnostics);
    if (status == LUXEL_OK)
        status = add_up(scene, &session, sum, diagnostics, *made, &errors, fits);
    if (status == LUXEL_OK && *fits)
        status = finish_sum(*made, &session.settings, &errors, diagnostics);
    if (status == LUXEL_OK && *fits)
        status = find_reached(&session, *made, diagnostics);
    if (!*fits) {
        luxel_field_free(*made);
        *made = NULL;
    }
    lx_session_clear(&session);
    return status;
}

/* Renders a picture whose materials are grey: its values are those of the grey scene. */
static luxel_status render_lights(const luxel_scene *scene, const luxel_settings *settings,
                                  const struct lx_color_parts *parts, luxel_diagnostics *diagnostics,
                                  luxel_field **made)
{
    luxel_settings own = *settings;
    struct lx_part_progress progress;
    struct errors unused = {.has_reflected = false};
    struct size *sizes = lx_new_array(parts->count, sizeof *sizes);
    if (!parts->is_single)
        lx_part_progress_begin(&progress, 0, parts->count + 1, settings, &own);
    luxel_status status = sizes ? lx_render_grey(scene, &own, diagnostics, made) : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = add_channels(*made, diagnostics);
    if (status == LUXEL_OK && parts->is_single)
        add_part(*made, &parts->list[0], *made, false, NULL, sizes);
    else if (status == LUXEL_OK)
        status = add_parts(parts, settings, NULL, sizes, diagnostics, *made, &unused);
    free(sizes);
    return status;
}

/* The ways to make a picture, the quicker ones first; the last one always fits. */
luxel_status lx_render_in_color(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, luxel_field **field)
{
    struct lx_color_parts parts = {.count = 0};
    struct luxel_field *made = NULL;
    luxel_settings own;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    if (status == LUXEL_OK)
        status = lx_color_parts_make(scene, settings, diagnostics, &parts);
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    const bool is_direct = parameters->reflections.choice == LX_REFLECTIONS_NONE;
    bool fits = false;
    if (status == LUXEL_OK && parts.is_sum && lx_is_sum_of_lobes(parameters, own.quantity))
        status = render_sum(scene, &own, OF_LOBES, diagnostics, &made, &fits);
    else if (status == LUXEL_OK && !parts.is_sum && !parts.is_single && is_direct && own.light_error == 0)
        status = render_sum(scene, &own, OF_LIGHTS, diagnostics, &made, &fits);
    if (status == LUXEL_OK && !fits)
        status = parts.is_sum ? render_sum(scene, &own, OF_CHANNELS, diagnostics, &made, &fits)
                              : render_lights(scene, &own, &parts, diagnostics, &made);
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        *field = made;
    else
        luxel_field_free(made);
    return status;
}
