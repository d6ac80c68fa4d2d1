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
    return lx_write_digits(value, LX_REPORT_DIGITS, buffer);
}

static int digits_of(const struct lx_report *report, int by_default)
{
    return report->texts->digits > 0 ? (int)report->texts->digits : by_default;
}

const char *lx_report_value(const struct lx_report *report, double value, int by_default, char *buffer)
{
    return lx_write_digits(value, digits_of(report, by_default), buffer);
}

const char *lx_report_bounded(const struct lx_report *report, double value, double error, int by_default, char *buffer)
{
    const int most = digits_of(report, by_default);
    if (report->texts->digits > 0 || !(error > 0) || !isfinite(error) || value == 0)
        return lx_write_digits(value, most, buffer);
    const int digits = (int)floor(log10(fabs(value))) - (int)floor(log10(error)) + 2;
    return digits < 1 ? lx_write_digits(0, most, buffer)
                      : lx_write_digits(value, digits < most ? digits : most, buffer);
}

void lx_report_clear(struct lx_report *report)
{
    luxel_probes_free(report->probes);
    luxel_probe_free(report->peak);
    luxel_balance_free(report->balance);
    lx_rendered_clear(&report->rendered);
    luxel_document_free(report->document);
}

static luxel_status probe_points(struct lx_report *report)
{
    const size_t count = luxel_scene_point_count(report->scene);
    if (count == 0)
        return LUXEL_OK;
    luxel_place *places = lx_new_array(count, sizeof *places);
    if (!places)
        return lx_out_of_memory(report->diagnostics);
    for (size_t i = 0; i < count; i++)
        luxel_scene_point(report->scene, i, &places[i].screen_mm[0], &places[i].screen_mm[1]);
    luxel_status status =
        luxel_probe_places(report->scene, report->settings, places, count, report->diagnostics, &report->probes);
    report->probe_count = status == LUXEL_OK ? count : 0;
    free(places);
    return status;
}

/* A fall so near, in parts of the way, is the edge of what the maximum lies on, where something else is seen. */
#define AT_ITS_EDGE 1e-6

/* The way from the maximum along x or y to an edge of the screen. */
struct way {
    const luxel_evaluator *evaluator;
    double from_mm[2], to_mm[2];
};

static luxel_place place_on(const struct way *way, double share)
{
    luxel_place place = {0};
    for (int i = 0; i < 2; i++)
        place.screen_mm[i] = way->from_mm[i] + share * (way->to_mm[i] - way->from_mm[i]);
    return place;
}

static bool is_above(const luxel_value *value, double level)
{
    return value->has_value && value->value > level;
}

/* Where the values fall to a level between two shares of the way, of which the first is above it. */
static double find_fall(const struct way *way, double level, double low, double high)
{
    enum { HALVINGS = 32 }; /* of a step, which is far below what is printed */
    for (int i = 0; i < HALVINGS; i++) {
        const double middle = (low + high) / 2;
        const luxel_place place = place_on(way, middle);
        luxel_value value;
        luxel_evaluate_place(way->evaluator, &place, &value, NULL);
        if (is_above(&value, level))
            low = middle;
        else
            high = middle;
    }
    return high;
}

/*
 * How far it is to where the value is first no more than a level; nowhere where the surface ends before.  As most ways
 * are short, the steps are taken some at a time.
 */
static luxel_status measure_side(const struct way *way, double level, bool *exists, double *mm)
{
    enum { STEPS = 256, AT_ONCE = 16 };
    luxel_place places[AT_ONCE];
    luxel_value values[AT_ONCE];
    for (int first = 1; first <= STEPS; first += AT_ONCE) {
        for (int i = 0; i < AT_ONCE; i++)
            places[i] = place_on(way, (double)(first + i) / STEPS);
        luxel_status status = luxel_evaluate_places(way->evaluator, places, AT_ONCE, values, NULL);
        if (status != LUXEL_OK)
            return status;
        for (int i = 0; i < AT_ONCE; i++) {
            if (is_above(&values[i], level))
                continue;
            if (values[i].has_value) {
                const double share =
                    find_fall(way, level, (double)(first + i - 1) / STEPS, (double)(first + i) / STEPS);
                *exists = share > AT_ITS_EDGE;
                *mm = hypot(way->to_mm[0] - way->from_mm[0], way->to_mm[1] - way->from_mm[1]) * share;
            }
            return LUXEL_OK;
        }
    }
    return LUXEL_OK;
}

/* To both sides of the maximum, along x or y, as far as the screen goes. */
static luxel_status measure_width(const struct lx_report *report, int axis, struct lx_report_width *width)
{
    const struct lx_screen *screen = &report->parameters->screen;
    const luxel_peak *peak = &report->rendered.extrema.maximum;
    const double half = (axis == 0 ? screen->width_mm : screen->height_mm) / 2;
    luxel_status status = LUXEL_OK;
    for (int side = 0; side < 2 && status == LUXEL_OK; side++) {
        struct way way = {report->rendered.evaluator, {peak->x_mm, peak->y_mm}, {peak->x_mm, peak->y_mm}};
        way.to_mm[axis] = side == 0 ? -half : half;
        if (fabs(way.to_mm[axis] - way.from_mm[axis]) > 1e-9 * half)
            status = measure_side(&way, peak->value / 2, &width->exists[side], &width->mm[side]);
    }
    return status;
}

/* Shares of the lights at the maximum, and how quickly the value falls around it. */
static luxel_status look_at_maximum(struct lx_report *report)
{
    const luxel_peak *peak = &report->rendered.extrema.maximum;
    if (!peak->exists || !(peak->value > 0) || peak->place == LUXEL_PEAK_PLATEAU)
        return LUXEL_OK;
    luxel_status status =
        luxel_probe_screen(report->scene, report->settings, peak->x_mm, peak->y_mm, report->diagnostics, &report->peak);
    for (int axis = 0; axis < 2 && status == LUXEL_OK; axis++)
        status = measure_width(report, axis, &report->widths[axis]);
    return status;
}

luxel_status lx_report_compute(struct lx_report *report)
{
    luxel_settings whole = lx_whole_picture(report->settings);
    whole.minimum_reached = true;
    luxel_status status = lx_rendered_make(report->scene, &whole, true, report->diagnostics, &report->rendered);
    if (status == LUXEL_OK)
        status = luxel_field_summary(report->rendered.field, NULL, report->diagnostics, &report->summary);
    if (status == LUXEL_OK) {
        report->statistics = *luxel_field_statistics(report->rendered.field);
        status = luxel_find_light_reach(report->scene, report->settings, report->diagnostics, &report->reach);
    }
    if (status == LUXEL_OK)
        status = probe_points(report);
    if (status == LUXEL_OK)
        status = look_at_maximum(report);
    if (status == LUXEL_OK)
        status = luxel_find_balance(report->scene, report->settings, report->diagnostics, &report->balance);
    return status;
}
