/* SPDX-License-Identifier: MIT */
/* The words of a report: task, results, conclusions that follow from the numbers, and how to repeat it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "report.h"

enum { MOST_SHARES = 6 }; /* lights that are told one by one */

static const char *quantity_word(const struct lx_report *report)
{
    return luxel_field_quantity_word(report->field);
}

static bool is_irradiance(const struct lx_report *report)
{
    return luxel_field_quantity(report->field) == LUXEL_IRRADIANCE;
}

/* "(177.4828, 0)" */
static void add_place(struct lx_text *text, const double *values, size_t count)
{
    lx_text_puts(text, "(");
    for (size_t i = 0; i < count; i++) {
        char number[LX_NUMBER_SIZE];
        /* 0 rather than -0 or the rounding of a place on an axis */
        double value = fabs(values[i]) < 1e-9 ? 0 : values[i];
        lx_text_puts(text, i > 0 ? ", " : "");
        lx_text_puts(text, lx_report_number(value, number));
    }
    lx_text_puts(text, ")");
}

/* ---- task ---- */

void lx_report_task(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    lx_document_heading(document, 1, LX_N("Task"), NULL);
    lx_document_paragraph(document,
                          is_irradiance(report)
                              ? LX_N("Compute how the irradiance is distributed over the surfaces below, seen on a "
                                     "screen; show it as a picture of grey levels 0 to 255, and give its values in "
                                     "the points asked for.")
                              : LX_N("Compute how the brightness is distributed over the surfaces below, seen on a "
                                     "screen; show it as a picture of grey levels 0 to 255, and give its values in "
                                     "the points asked for."),
                          NULL);
    lx_document_paragraph(document,
                          LX_N("The screen lies in the plane z = 0 with its centre in the origin, x to the right and "
                               "y up. The observer looks along −z."),
                          NULL);
    lx_document_heading(document, 1, LX_N("Parameters"), NULL);
    lx_add_parameter_tables(document, report->parameters);
}

/* ---- results ---- */

static void add_probe(struct lx_report *report, size_t i)
{
    const luxel_probe *probe = report->probes[i];
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE], pixel[LX_NUMBER_SIZE];
    struct lx_text name = {0}, place = {0};
    lx_text_printf(&name, "P%zu", i + 1);
    add_place(&place, (const double[]){probe->x_mm, probe->y_mm}, 2);
    const char *without = probe->on_surface ? LX_N("a source lies on it") : LX_N("off the surface");
    struct lx_span exact = LX_PLAIN(lx_write_digits(probe->value, 12, value));
    struct lx_span none = LX_TERM_SPAN(without), blank = LX_PLAIN("");
    struct lx_span bound = LX_PLAIN(lx_write_digits(probe->error, 2, error));
    struct lx_span nearest = LX_PLAIN(lx_report_number(probe->pixel_value, pixel));
    lx_document_row(report->document,
                    LX_SPANS(LX_PLAIN(name.bytes), LX_PLAIN(place.bytes), probe->has_value ? exact : none,
                             probe->has_value ? bound : blank, probe->has_pixel_value ? nearest : blank),
                    false);
    lx_text_clear(&name);
    lx_text_clear(&place);
}

static void add_points(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    lx_document_heading(document, 2, LX_N("Points"), NULL);
    if (report->probe_count == 0) {
        lx_document_paragraph(document, LX_N("The scene asks for no points."), NULL);
        return;
    }
    lx_document_paragraph(document,
                          LX_N("The exact value is that at the point itself; the picture's is that of the pixel in "
                               "which the point lies. Values in {0}, places in mm."),
                          LX_SPANS(LX_PLAIN(report->unit)));
    lx_document_table(document, "llrrr");
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("point")), LX_MATH("(x,\\, y)"), LX_TERM_SPAN(LX_N("exact value")),
                             LX_TERM_SPAN(LX_N("error at most")), LX_TERM_SPAN(LX_N("of the pixel"))),
                    false);
    for (size_t i = 0; i < report->probe_count; i++)
        add_probe(report, i);
}

static void add_statistic(struct lx_report *report, const char *english, double value, const double *place)
{
    char number[LX_NUMBER_SIZE];
    struct lx_text text = {0};
    if (place)
        add_place(&text, place, 2);
    lx_document_row(report->document,
                    LX_SPANS(LX_TERM_SPAN(english), LX_PLAIN(lx_report_number(value, number)),
                             LX_PLAIN(text.bytes ? text.bytes : "")),
                    false);
    lx_text_clear(&text);
}

static void add_statistics(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_extrema *extrema = &report->extrema;
    const luxel_summary *summary = &report->summary;
    lx_document_heading(document, 2, LX_N("Extrema and means"), NULL);
    if (summary->pixels == 0) {
        lx_document_paragraph(document, LX_N("The screen shows no surface."), NULL);
        return;
    }
    lx_document_paragraph(document,
                          LX_N("The true extrema are found on the exact function between the pixels; everything else "
                               "is read off the {0} pixels that show a surface. Values in {1}."),
                          LX_SPANS(LX_PLAIN(lx_write_number((double)summary->pixels, (char[LX_NUMBER_SIZE]){0})),
                                   LX_PLAIN(report->unit)));
    lx_document_table(document, "lrl");
    lx_document_row(document, LX_SPANS(LX_PLAIN(""), LX_TERM_SPAN(LX_N("value")), LX_TERM_SPAN(LX_N("at x, y in mm"))),
                    false);
    if (extrema->maximum.exists)
        add_statistic(report, LX_N("true maximum"), extrema->maximum.value,
                      (const double[]){extrema->maximum.x_mm, extrema->maximum.y_mm});
    add_statistic(report, LX_N("maximum of the pixels"), summary->maximum.value,
                  (const double[]){summary->maximum.x_mm, summary->maximum.y_mm});
    if (extrema->minimum.exists)
        add_statistic(report, LX_N("true minimum"), extrema->minimum.value,
                      extrema->minimum.place == LUXEL_PEAK_PLATEAU
                          ? NULL
                          : (const double[]){extrema->minimum.x_mm, extrema->minimum.y_mm});
    add_statistic(report, LX_N("mean"), summary->mean, NULL);
    add_statistic(report, LX_N("median"), summary->median, NULL);
    add_statistic(report, LX_N("standard deviation"), summary->standard_deviation, NULL);
    add_statistic(report, LX_N("share of the surface that is lit"), summary->lit, NULL);
    if (summary->has_evenness)
        add_statistic(report, LX_N("uniformity U0 = minimum / mean"), summary->u0, NULL);
}

void lx_report_results(struct lx_report *report)
{
    lx_document_heading(report->document, 1, LX_N("Results"), NULL);
    add_points(report);
    add_statistics(report);
}

/* ---- conclusions ---- */

/* "66 %" */
static const char *percent(double share, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_digits(100 * share, 3, buffer);
}

static void conclude_peak(struct lx_report *report)
{
    static const char *const sentences[] = {
        [LUXEL_PEAK_INSIDE] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm of the "
                                   "surface."),
        [LUXEL_PEAK_LIMB] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is on "
                                 "the edge of what is seen of the surface, so its true peak lies beyond."),
        [LUXEL_PEAK_BORDER] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is "
                                   "on the edge of the screen, so its true peak lies outside the picture."),
        [LUXEL_PEAK_JUMP] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm, where it "
                                 "jumps or has a kink."),
    };
    const luxel_peak *peak = &report->extrema.maximum;
    char value[LX_NUMBER_SIZE];
    struct lx_text place = {0}, position = {0};
    add_place(&place, (const double[]){peak->x_mm, peak->y_mm}, 2);
    add_place(&position, peak->position_mm, 3);
    lx_document_item(report->document, sentences[peak->place],
                     LX_SPANS(LX_TERM_SPAN(quantity_word(report)), LX_PLAIN(lx_report_number(peak->value, value)),
                              LX_PLAIN(report->unit), LX_PLAIN(place.bytes), LX_PLAIN(position.bytes)));
    lx_text_clear(&place);
    lx_text_clear(&position);
}

/* What of the value at the maximum is highlight, and which light gives most of it. */
static void conclude_shares(struct lx_report *report)
{
    const luxel_probe *peak = report->peak;
    double specular = 0, most = 0;
    size_t first = 0, lights = 0;
    char share[LX_NUMBER_SIZE];
    for (size_t i = 0; i < peak->share_count; i++) {
        const luxel_light_share *light = &peak->shares[i];
        double value = is_irradiance(report) ? light->irradiance : light->diffuse + light->specular;
        specular += light->specular;
        lights += value > 0;
        if (value > most) {
            most = value;
            first = i;
        }
    }
    if (!is_irradiance(report))
        lx_document_item(report->document,
                         LX_N("There the highlight gives {0} % of the value, diffuse reflection the rest."),
                         LX_SPANS(LX_PLAIN(percent(specular / peak->value, share))));
    if (lights < 2)
        return;
    struct lx_text name = {0};
    lx_add_element_name(&name, "lights", peak->shares[first].light, peak->shares[first].name);
    lx_document_item(report->document, LX_N("Of the lights, {0} dominates there: it gives {1} % of the value."),
                     LX_SPANS(LX_PLAIN(name.bytes), LX_PLAIN(percent(most / peak->value, share))));
    lx_text_clear(&name);
}

/* How sharp the peak is: where the value has fallen to half. */
static void conclude_width(struct lx_report *report)
{
    const struct lx_report_width *x = &report->widths[0], *y = &report->widths[1];
    char numbers[2][LX_NUMBER_SIZE];
    if (x->exists[0] && x->exists[1])
        lx_document_item(report->document,
                         LX_N("Along x the value falls to half of the maximum within {0} mm to the left and {1} mm to "
                              "the right."),
                         LX_SPANS(LX_PLAIN(lx_write_digits(x->mm[0], 3, numbers[0])),
                                  LX_PLAIN(lx_write_digits(x->mm[1], 3, numbers[1]))));
    if (y->exists[0] && y->exists[1])
        lx_document_item(report->document,
                         LX_N("Along y the value falls to half of the maximum within {0} mm downwards and {1} mm "
                              "upwards."),
                         LX_SPANS(LX_PLAIN(lx_write_digits(y->mm[0], 3, numbers[0])),
                                  LX_PLAIN(lx_write_digits(y->mm[1], 3, numbers[1]))));
}

/* How far the pixels' values are from the exact ones. */
static void conclude_pixels(struct lx_report *report)
{
    double largest = 0;
    size_t compared = 0, point = 0;
    for (size_t i = 0; i < report->probe_count; i++) {
        const luxel_probe *probe = report->probes[i];
        if (!probe->has_value || !probe->has_pixel_value)
            continue;
        compared++;
        if (fabs(probe->pixel_value - probe->value) > largest) {
            largest = fabs(probe->pixel_value - probe->value);
            point = i;
        }
    }
    if (compared == 0)
        return;
    char difference[LX_NUMBER_SIZE], share[LX_NUMBER_SIZE], maximum[LX_NUMBER_SIZE];
    struct lx_text name = {0};
    lx_text_printf(&name, "P%zu", point + 1);
    lx_document_item(
        report->document,
        LX_N("A value taken from the pixel instead of the point itself is off by up to {0} {1} (at {2}): {3} % of the "
             "maximum. The pixels' own maximum is {4} % below the true one."),
        LX_SPANS(
            LX_PLAIN(lx_write_digits(largest, 3, difference)), LX_PLAIN(report->unit), LX_PLAIN(name.bytes),
            LX_PLAIN(percent(largest / report->extrema.maximum.value, share)),
            LX_PLAIN(percent(fmax(0, 1 - report->summary.maximum.value / report->extrema.maximum.value), maximum))));
    lx_text_clear(&name);
}

void lx_report_conclusions(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_summary *summary = &report->summary;
    char numbers[3][LX_NUMBER_SIZE];
    lx_document_heading(document, 1, LX_N("Conclusions"), NULL);
    if (summary->pixels == 0) {
        lx_document_paragraph(document, LX_N("The screen shows no surface, so there is nothing to conclude."), NULL);
        return;
    }
    if (report->peak) {
        conclude_peak(report);
        conclude_shares(report);
        conclude_width(report);
        conclude_pixels(report);
    } else {
        lx_document_item(document, LX_N("The {0} has no peak: it is {1} {2} in a whole part of the surface."),
                         LX_SPANS(LX_TERM_SPAN(quantity_word(report)),
                                  LX_PLAIN(lx_report_number(report->extrema.maximum.value, numbers[0])),
                                  LX_PLAIN(report->unit)));
    }
    lx_document_item(
        document,
        LX_N("Light reaches {0} % of the surface that is seen; the mean is {1} {2}, {3} % of the "
             "greatest value of a pixel."),
        LX_SPANS(
            LX_PLAIN(percent(summary->lit, numbers[0])), LX_PLAIN(lx_report_number(summary->mean, numbers[1])),
            LX_PLAIN(report->unit),
            LX_PLAIN(summary->maximum.value > 0 ? percent(summary->mean / summary->maximum.value, numbers[2]) : "0")));
}

/* ---- repetition ---- */

void lx_report_repetition(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    char *scene = NULL;
    lx_document_heading(document, 1, LX_N("Repetition"), NULL);
    lx_document_paragraph(document,
                          LX_N("Computed by Luxel {0} from the scene below. Saved as {1}, it gives the same numbers by "
                               "{2}, the same picture by {3}, and the calculation of each point step by step by {4}."),
                          LX_SPANS(LX_PLAIN(luxel_version()), LX_CODE("scene.yaml"), LX_CODE("luxel render scene.yaml"),
                                   LX_CODE("luxel render scene.yaml -o scene.png"),
                                   LX_CODE("luxel explain scene.yaml")));
    if (luxel_scene_write_text(report->scene, &scene) == LUXEL_OK)
        lx_document_code(document, scene);
    luxel_text_free(scene);
}
