/* SPDX-License-Identifier: MIT */
/* The conclusions of a report: each sentence stands only where the numbers make it true. */
#include <math.h>
#include <stdlib.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "../scene/observer.h"
#include "report.h"

/* "66 %" */
static const char *percent(double share, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_digits(100 * share, 3, buffer);
}

/* A length of three digits as people write it: 1310, not 1.31e+03. */
static const char *length(double mm, char buffer[LX_NUMBER_SIZE])
{
    return lx_write_number(strtod(lx_write_digits(mm, 3, buffer), NULL), buffer);
}

static void conclude_peak(struct lx_report *report)
{
    static const char *const sentences[] = {
        [LUXEL_PEAK_INSIDE] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm of the "
                                   "surface."),
        [LUXEL_PEAK_LIMB] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is on "
                                 "the edge of what is seen of the surface."),
        [LUXEL_PEAK_BORDER] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is "
                                   "on the edge of the screen; outside the picture it may be greater."),
        [LUXEL_PEAK_JUMP] = LX_N("The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm, where it "
                                 "jumps or has a kink."),
    };
    const luxel_peak *peak = &report->rendered.extrema.maximum;
    char value[LX_NUMBER_SIZE];
    struct lx_text place = {0}, position = {0};
    lx_report_add_place(&place, (const double[]){peak->x_mm, peak->y_mm}, 2);
    lx_report_add_place(&position, peak->position_mm, 3);
    lx_document_item(report->document, sentences[peak->place],
                     LX_SPANS(LX_TERM_SPAN(lx_report_quantity(report)),
                              LX_PLAIN(lx_report_bounded(report, peak->value, peak->error, LX_REPORT_DIGITS, value)),
                              LX_PLAIN(report->unit), LX_PLAIN(place.bytes), LX_PLAIN(position.bytes)));
    lx_text_clear(&place);
    lx_text_clear(&position);
}

/* What of the value at the maximum is highlight. */
static void conclude_highlight(struct lx_report *report, double specular)
{
    char share[LX_NUMBER_SIZE];
    const double value = report->peak->value;
    if (!(specular > 0))
        lx_document_item(report->document, LX_N("There all of the value is diffuse reflection."), NULL);
    else if (specular >= value * (1 - 1e-9))
        lx_document_item(report->document, LX_N("There all of the value is the highlight."), NULL);
    else
        lx_document_item(report->document,
                         LX_N("There the highlight gives {0} % of the value, diffuse reflection the rest."),
                         LX_SPANS(LX_PLAIN(percent(specular / value, share))));
}

/* Which light gives most of the value at the maximum, if others give less. */
static void conclude_shares(struct lx_report *report)
{
    const luxel_probe *peak = report->peak;
    double specular = 0, most = 0, next = 0;
    size_t first = 0;
    char share[LX_NUMBER_SIZE];
    for (size_t i = 0; i < peak->share_count; i++) {
        const luxel_light_share *light = &peak->shares[i];
        double value = lx_report_is_irradiance(report) ? light->irradiance : light->diffuse + light->specular;
        specular += light->specular;
        if (value > most) {
            next = most;
            most = value;
            first = i;
        } else {
            next = fmax(next, value);
        }
    }
    if (!lx_report_is_irradiance(report))
        conclude_highlight(report, specular);
    if (peak->has_reflected)
        lx_document_item(report->document,
                         LX_N("Light that surfaces reflect to each other gives {0} % of the value there."),
                         LX_SPANS(LX_PLAIN(percent(peak->reflected.value / peak->value, share))));
    if (!(next > 0) || next >= most * (1 - 1e-9))
        return;
    struct lx_text name = {0};
    lx_add_element_name(&name, "lights", peak->shares[first].light, peak->shares[first].name);
    lx_document_item(report->document,
                     peak->has_reflected ? LX_N("Of the lights, {0} gives the most there directly: {1} % of the value.")
                                         : LX_N("Of the lights, {0} has the greatest share there: {1} % of the value."),
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
                         LX_SPANS(LX_PLAIN(length(x->mm[0], numbers[0])), LX_PLAIN(length(x->mm[1], numbers[1]))));
    if (y->exists[0] && y->exists[1])
        lx_document_item(report->document,
                         LX_N("Along y the value falls to half of the maximum within {0} mm downwards and {1} mm "
                              "upwards."),
                         LX_SPANS(LX_PLAIN(length(y->mm[0], numbers[0])), LX_PLAIN(length(y->mm[1], numbers[1]))));
}

/* How far the pixels' values are from the exact ones. */
static void conclude_pixels(struct lx_report *report)
{
    double largest = 0;
    size_t compared = 0, point = 0;
    for (size_t i = 0; i < report->probe_count; i++) {
        const luxel_probe *probe = luxel_probes_get(report->probes, i);
        if (!probe->has_value || !probe->has_pixel_value)
            continue;
        compared++;
        if (fabs(probe->pixel_value - probe->value) > largest) {
            largest = fabs(probe->pixel_value - probe->value);
            point = i;
        }
    }
    if (compared == 0 || !(largest > 0))
        return;
    char difference[LX_NUMBER_SIZE], share[LX_NUMBER_SIZE], maximum[LX_NUMBER_SIZE];
    struct lx_text name = {0};
    lx_text_printf(&name, "P%zu", point + 1);
    lx_document_item(
        report->document,
        LX_N("In these points, a value taken from the pixel instead of the point itself is off by up to {0} {1} (at "
             "{2}): {3} % of the maximum. The pixels' own maximum is {4} % below the true one."),
        LX_SPANS(LX_PLAIN(lx_write_digits(largest, 3, difference)), LX_PLAIN(report->unit), LX_PLAIN(name.bytes),
                 LX_PLAIN(percent(largest / report->rendered.extrema.maximum.value, share)),
                 LX_PLAIN(percent(fmax(0, 1 - report->summary.maximum.value / report->rendered.extrema.maximum.value),
                                  maximum))));
    lx_text_clear(&name);
}

/* Where there is no peak: one value in a whole part, or none. */
static void conclude_plateau(struct lx_report *report)
{
    const luxel_peak *greatest = &report->rendered.extrema.maximum;
    if (!greatest->exists)
        return;
    if (!(greatest->value > 0))
        lx_document_item(report->document, LX_N("The {0} is 0 everywhere: the surface is dark."),
                         LX_SPANS(LX_TERM_SPAN(lx_report_quantity(report))));
    else
        lx_document_item(report->document, LX_N("The {0} has no peak: it is {1} {2} in a whole part of the surface."),
                         LX_SPANS(LX_TERM_SPAN(lx_report_quantity(report)),
                                  LX_PLAIN(lx_report_bounded(report, greatest->value, greatest->error, LX_REPORT_DIGITS,
                                                             (char[LX_NUMBER_SIZE]){0})),
                                  LX_PLAIN(report->unit)));
}

/* How much of the surface light arrives at. */
static void conclude_reach(struct lx_report *report)
{
    char share[LX_NUMBER_SIZE];
    const struct lx_span reached = LX_PLAIN(percent(report->reach.share, share));
    if (report->reach.has_direct && report->reach.has_ambient)
        lx_document_item(
            report->document,
            LX_N("Ambient light is everywhere; that of the other sources reaches {0} % of the picture where it shows a "
                 "surface."),
            LX_SPANS(reached));
    else if (report->reach.has_direct && report->statistics.has_reflected)
        lx_document_item(
            report->document,
            LX_N("Light comes straight from a source to {0} % of the picture where it shows a surface; what surfaces "
                 "reflect arrives elsewhere, too."),
            LX_SPANS(reached));
    else if (report->reach.has_direct)
        lx_document_item(report->document, LX_N("Light reaches {0} % of the picture where it shows a surface."),
                         LX_SPANS(reached));
    else if (report->reach.has_ambient)
        lx_document_item(report->document, LX_N("All light is ambient: it is everywhere."), NULL);
    else
        lx_document_item(report->document, LX_N("No source shines."), NULL);
    if (lx_report_has_tail(report))
        lx_document_item(report->document,
                         LX_N("Where no light reaches it, part of the surface is not quite dark all the same: the tail "
                              "of the highlight counts there, too."),
                         NULL);
}

/* Which surfaces the screen cuts off. */
static void conclude_view(struct lx_report *report)
{
    const struct lx_list *surfaces = &report->parameters->surfaces;
    for (size_t i = 0; i < surfaces->count && i < LX_MOST_PARAMETER_TABLES; i++) {
        const struct lx_surface_common *common = surfaces->items[i].common;
        struct lx_text sides = {0}, name = {0};
        lx_add_sides_beyond(report->parameters, i, &sides);
        lx_add_element_name(&name, "surfaces", i, common->name);
        char *words = sides.length > 0 ? lx_document_rendered(report->document, &sides) : NULL;
        if (words && name.bytes)
            lx_document_item(report->document,
                             LX_N("{0} is not wholly in view: it reaches beyond the screen on these sides: {1}."),
                             LX_SPANS(LX_PLAIN(name.bytes), LX_PLAIN(words)));
        free(words);
        lx_text_clear(&sides);
        lx_text_clear(&name);
    }
}

void lx_report_conclusions(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_summary *summary = &report->summary;
    char mean[LX_NUMBER_SIZE], share[LX_NUMBER_SIZE];
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
        conclude_plateau(report);
    }
    conclude_view(report);
    conclude_reach(report);
    if (summary->maximum.value > 0)
        lx_document_item(document, LX_N("The mean is {0} {1}, {2} % of the greatest value of a pixel."),
                         LX_SPANS(LX_PLAIN(lx_report_value(report, summary->mean, LX_REPORT_DIGITS, mean)),
                                  LX_PLAIN(report->unit),
                                  LX_PLAIN(percent(summary->mean / summary->maximum.value, share))));
}
