/* SPDX-License-Identifier: MIT */
/* What a report tells, computed: the picture, its statistics, points, true extrema, and how sharp the peak is. */
#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/number.h"
#include "figure.h"
#include "report.h"

const char *lx_report_number(double value, char *buffer)
{
    return lx_write_digits(value, 7, buffer);
}

void lx_report_clear(struct lx_report *report)
{
    for (size_t i = 0; i < report->probe_count; i++)
        luxel_probe_free(report->probes[i]);
    free(report->probes);
    luxel_probe_free(report->peak);
    luxel_balance_free(report->balance);
    luxel_field_free(report->field);
    luxel_document_free(report->document);
}

static luxel_status probe_points(struct lx_report *report)
{
    size_t count = luxel_scene_point_count(report->scene);
    luxel_status status = LUXEL_OK;
    report->probes = lx_new_array(count, sizeof *report->probes);
    if (!report->probes)
        return lx_out_of_memory(report->diagnostics);
    while (status == LUXEL_OK && report->probe_count < count) {
        double x, y;
        luxel_scene_point(report->scene, report->probe_count, &x, &y);
        status = luxel_probe_screen(report->scene, report->settings, x, y, report->diagnostics,
                                    &report->probes[report->probe_count]);
        report->probe_count += status == LUXEL_OK;
    }
    return status;
}

/* Where on the way between two of its samples, of which the first is above half the maximum, a profile falls to it. */
static double find_half(const luxel_evaluator *evaluator, const luxel_profile_sample *above,
                        const luxel_profile_sample *below, double half)
{
    double low = 0, high = 1; /* of the way */
    for (int i = 0; i < 50; i++) {
        const double middle = (low + high) / 2;
        const luxel_value value = luxel_evaluate(evaluator, above->x_mm + middle * (below->x_mm - above->x_mm),
                                                 above->y_mm + middle * (below->y_mm - above->y_mm), NULL);
        if (value.on_surface && value.has_value && value.value > half)
            low = middle;
        else
            high = middle;
    }
    return above->abscissa + high * (below->abscissa - above->abscissa);
}

/* Where a profile that begins at the maximum falls to half of it. */
static bool half_width(const luxel_evaluator *evaluator, const luxel_profile *profile, double maximum, double *width)
{
    for (size_t i = 1; i < profile->count; i++) {
        const luxel_profile_sample *before = &profile->samples[i - 1], *sample = &profile->samples[i];
        if (!before->has_value || !sample->has_value)
            return false;
        if (sample->value > maximum / 2)
            continue;
        *width = find_half(evaluator, before, sample, maximum / 2);
        return true;
    }
    return false;
}

/* To both sides of the maximum, along x or y, as far as the screen goes. */
static luxel_status measure_width(const struct lx_report *report, const luxel_evaluator *evaluator, int axis,
                                  struct lx_report_width *width)
{
    const struct lx_screen *screen = &report->parameters->screen;
    const luxel_peak *peak = &report->extrema.maximum;
    double half = (axis == 0 ? screen->width_mm : screen->height_mm) / 2;
    luxel_status status = LUXEL_OK;
    for (int side = 0; side < 2 && status == LUXEL_OK; side++) {
        luxel_path path = {.from_mm = {peak->x_mm, peak->y_mm}, .to_mm = {peak->x_mm, peak->y_mm}, .samples = 257};
        luxel_profile *profile = NULL;
        path.to_mm[axis] = side == 0 ? -half : half;
        if (fabs(path.to_mm[axis] - path.from_mm[axis]) <= 1e-9 * half)
            continue;
        status = luxel_find_profile(evaluator, &path, report->diagnostics, &profile);
        if (status == LUXEL_OK)
            width->exists[side] = half_width(evaluator, profile, peak->value, &width->mm[side]);
        luxel_profile_free(profile);
    }
    return status;
}

/* The true extrema, what the lights give at the maximum, and how quickly the value falls around it. */
static luxel_status find_extrema(struct lx_report *report)
{
    luxel_evaluator *evaluator = NULL;
    luxel_status status = luxel_evaluator_new(report->scene, report->settings, report->diagnostics, &evaluator);
    if (status == LUXEL_OK)
        status = luxel_find_extrema(evaluator, report->field, NULL, report->diagnostics, &report->extrema);
    const luxel_peak *peak = &report->extrema.maximum;
    bool has_peak = status == LUXEL_OK && peak->exists && peak->value > 0 && peak->place != LUXEL_PEAK_PLATEAU;
    if (has_peak)
        status = luxel_probe_screen(report->scene, report->settings, peak->x_mm, peak->y_mm, report->diagnostics,
                                    &report->peak);
    for (int axis = 0; axis < 2 && has_peak && status == LUXEL_OK; axis++)
        status = measure_width(report, evaluator, axis, &report->widths[axis]);
    luxel_evaluator_free(evaluator);
    return status;
}

luxel_status lx_report_compute(struct lx_report *report)
{
    luxel_settings whole = lx_whole_picture(report->settings);
    whole.minimum_reached = true;
    luxel_status status = luxel_render(report->scene, &whole, report->diagnostics, &report->field);
    if (status == LUXEL_OK)
        status = luxel_field_summary(report->field, NULL, report->diagnostics, &report->summary);
    if (status == LUXEL_OK) {
        report->statistics = *luxel_field_statistics(report->field);
        status = luxel_find_reach(report->scene, report->settings, report->diagnostics, &report->reach);
    }
    if (status == LUXEL_OK)
        status = probe_points(report);
    if (status == LUXEL_OK)
        status = find_extrema(report);
    if (status == LUXEL_OK)
        status = luxel_find_balance(report->scene, report->settings, report->diagnostics, &report->balance);
    return status;
}
