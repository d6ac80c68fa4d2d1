/* SPDX-License-Identifier: MIT */
/* Pictures in colour: the sums of grey ones, pixel by pixel. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "coloring.h"
#include "reflecting.h"
#include "rendering.h"

static bool tell(double done, void *data)
{
    const struct lx_part_progress *part = data;
    return part->progress(part->before + part->share * done, part->data);
}

void lx_part_progress_begin(struct lx_part_progress *part, size_t i, size_t count, const luxel_settings *asked,
                            luxel_settings *settings)
{
    if (!asked || !asked->progress)
        return;
    *part =
        (struct lx_part_progress){asked->progress, asked->progress_data, (double)i / (double)count, 1 / (double)count};
    settings->progress = tell;
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

/* Adds a part's picture to the channels of a field and, where that is the sum, to its values. */
static void add_part(struct luxel_field *field, const struct lx_color_part *part, const struct luxel_field *from,
                     bool is_sum)
{
    const size_t pixels = (size_t)field->columns * field->rows;
    for (size_t i = 0; i < pixels; i++) {
        const double value = get(field, from->values, i);
        for (size_t c = 0; c < LX_CHANNELS; c++)
            put(field, field->rgb, LX_CHANNELS * i + c,
                get(field, field->rgb, LX_CHANNELS * i + c) + part->rgb[c] * value);
        if (is_sum)
            put(field, field->values, i, get(field, field->values, i) + part->luminance * value);
    }
}

/* What is known of reflected light in a sum: its error as a share of the maximum. */
struct reflected {
    bool is_known, is_reached;
    double error;
};

static void note_reflected(struct reflected *reflected, const struct lx_color_part *part,
                           const struct luxel_field *from)
{
    const luxel_statistics *statistics = &from->statistics;
    reflected->is_known = statistics->has_reflected;
    reflected->error += fabs(part->luminance) * statistics->reflected_error * statistics->maximum.value;
}

static luxel_status finish_sum(struct luxel_field *field, const luxel_settings *settings, struct reflected *reflected,
                               luxel_diagnostics *diagnostics)
{
    if (lx_gather_statistics(field) < 0)
        return lx_out_of_memory(diagnostics);
    luxel_statistics *statistics = &field->statistics;
    statistics->reflected_reached = true;
    if (!reflected->is_known)
        return LUXEL_OK;
    statistics->has_reflected = true;
    statistics->reflected_error = statistics->maximum.exists ? reflected->error / statistics->maximum.value : 0;
    statistics->reflected_reached = statistics->reflected_error <= lx_pictured_error_of(settings);
    if (!statistics->reflected_reached) {
        char error[LX_NUMBER_SIZE];
        lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_REFLECTED_ERROR,
                  LX_ARGS(lx_write_bound(statistics->reflected_error, 2, error)));
    }
    return LUXEL_OK;
}

/* The field that a sum becomes: that of the scene itself, all 0. */
static luxel_status new_sum(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            struct luxel_field **field)
{
    struct lx_session session;
    luxel_status status = lx_session_open_world(scene, settings, diagnostics, &session);
    if (status == LUXEL_OK)
        status = luxel_scene_check_view(scene, diagnostics);
    if (status == LUXEL_OK)
        status = lx_new_frame(&session, scene, diagnostics, field);
    lx_session_clear(&session);
    if (status != LUXEL_OK)
        return status;
    struct lx_strip all = {.rows = (*field)->rows};
    const int failed = lx_strip_allocate(*field, &all);
    (*field)->values = all.values;
    (*field)->mask = all.mask;
    if (failed)
        return lx_out_of_memory(diagnostics);
    memset(all.values, 0,
           (size_t)(*field)->columns * (*field)->rows *
               ((*field)->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float)));
    return LUXEL_OK;
}

/* Renders the parts and adds them up. */
static luxel_status add_parts(const struct lx_color_parts *parts, const luxel_settings *settings,
                              luxel_diagnostics *diagnostics, struct luxel_field *field)
{
    const size_t before = parts->is_sum ? 0 : 1, all = parts->count + before;
    struct reflected reflected = {.is_known = false};
    if (parts->is_single)
        add_part(field, &parts->list[0], field, false);
    for (size_t i = 0; i < parts->count && !parts->is_single; i++) {
        luxel_settings own = parts->list[i].settings;
        struct lx_part_progress progress;
        struct luxel_field *from = NULL;
        lx_part_progress_begin(&progress, i + before, all, settings, &own);
        const luxel_status status = lx_render_grey(parts->list[i].scene, &own, i == 0 ? diagnostics : NULL, &from);
        if (status != LUXEL_OK)
            return status == LUXEL_ERROR_MEMORY && i > 0 ? lx_out_of_memory(diagnostics) : status;
        add_part(field, &parts->list[i], from, parts->is_sum);
        note_reflected(&reflected, &parts->list[i], from);
        memcpy(field->mask, from->mask, (size_t)field->columns * field->rows);
        luxel_field_free(from);
    }
    return parts->is_sum
               ? finish_sum(field, settings ? settings : &(luxel_settings){.stride = 1}, &reflected, diagnostics)
               : LUXEL_OK;
}

luxel_status lx_render_in_color(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, luxel_field **field)
{
    struct lx_color_parts parts = {.count = 0};
    struct luxel_field *made = NULL;
    luxel_settings own;
    struct lx_part_progress progress;
    luxel_status status = lx_settings_check(scene, settings, diagnostics, &own);
    if (status == LUXEL_OK)
        status = lx_color_parts_make(scene, settings, diagnostics, &parts);
    if (status == LUXEL_OK && !parts.is_single)
        lx_part_progress_begin(&progress, 0, parts.count + 1, settings, &own);
    if (status == LUXEL_OK)
        status = parts.is_sum ? new_sum(scene, settings, diagnostics, &made)
                              : lx_render_grey(scene, &own, diagnostics, &made);
    if (status == LUXEL_OK) {
        made->rgb = lx_new_array((size_t)made->columns * made->rows * LX_CHANNELS,
                                 made->precision == LUXEL_DOUBLE ? sizeof(double) : sizeof(float));
        status = made->rgb ? add_parts(&parts, settings, diagnostics, made) : lx_out_of_memory(diagnostics);
    }
    lx_color_parts_clear(&parts);
    if (status == LUXEL_OK)
        *field = made;
    else
        luxel_field_free(made);
    return status;
}
