/* SPDX-License-Identifier: MIT */
/* The words of a report: aim, task, results, and how to repeat it. */
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../exercise/parameter_tables.h"
#include "../parameter/decode.h"
#include "../scene/observer.h"
#include "report.h"

const char *lx_report_quantity(const struct lx_report *report)
{
    return luxel_field_quantity_word(report->rendered.field);
}

const char *lx_report_choose(const struct lx_report *report, const char *const sentences[4])
{
    return lx_by_quantity(luxel_field_quantity(report->rendered.field), report->parameters->units == LX_PHOTOMETRIC,
                          sentences);
}

bool lx_report_is_irradiance(const struct lx_report *report)
{
    return luxel_field_quantity(report->rendered.field) == LUXEL_IRRADIANCE;
}

void lx_report_add_place(struct lx_text *text, const double *values, size_t count)
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

/* What the work is for: the author's own words, or what is computed. */
static void add_aim(struct lx_report *report)
{
    static const char *const aims[] = {
        LX_N("To learn how to compute the distribution of the brightness over lit surfaces, "
             "and how to show it as a picture."),
        LX_N("To learn how to compute the distribution of the luminance over lit surfaces, "
             "and how to show it as a picture."),
        LX_N("To learn how to compute the distribution of the irradiance over lit surfaces, "
             "and how to show it as a picture."),
        LX_N("To learn how to compute the distribution of the illuminance over lit surfaces, "
             "and how to show it as a picture.")};
    const char *aim = report->texts->aim;
    lx_document_heading(report->document, 1, LX_N("Aim of the work"), NULL);
    if (aim && *aim)
        lx_document_paragraph(report->document, "{0}", LX_SPANS(LX_PLAIN(aim)));
    else
        lx_document_paragraph(report->document, lx_report_choose(report, aims), NULL);
}

void lx_report_task(struct lx_report *report)
{
    static const char *const tasks[] = {LX_N("Compute how the brightness is distributed over the surfaces below, seen "
                                             "on a screen, and show it as a picture of grey levels 0 to 255."),
                                        LX_N("Compute how the luminance is distributed over the surfaces below, seen "
                                             "on a screen, and show it as a picture of grey levels 0 to 255."),
                                        LX_N("Compute how the irradiance is distributed over the surfaces below, seen "
                                             "on a screen, and show it as a picture of grey levels 0 to 255."),
                                        LX_N("Compute how the illuminance is distributed over the surfaces below, seen "
                                             "on a screen, and show it as a picture of grey levels 0 to 255.")};
    struct luxel_document *document = report->document;
    add_aim(report);
    lx_document_heading(document, 1, LX_N("Task"), NULL);
    lx_document_paragraph(document, lx_report_choose(report, tasks), NULL);
    if (report->probe_count > 0)
        lx_document_paragraph(
            document, LX_N("Give its values in the points asked for, and the greatest and the least value."), NULL);
    else
        lx_document_paragraph(document, LX_N("Give the greatest and the least value."), NULL);
    const bool is_placed = lx_observer_is_placed(&report->parameters->observer);
    lx_document_paragraph(document,
                          is_placed
                              ? LX_N("The screen stands with its centre at the target, at right angles to the way "
                                     "from there to the observer, its vertical along the up direction.")
                              : LX_N("The screen lies in the plane z = 0 with its centre in the origin, x to the "
                                     "right and y up. The observer looks along −z."),
                          NULL);
    lx_document_heading(document, 1, LX_N("Parameters"), NULL);
    lx_add_parameter_tables(document, report->parameters);
}

/* ---- results ---- */

static void add_probe(struct lx_report *report, size_t i)
{
    const luxel_probe *probe = luxel_probes_get(report->probes, i);
    char value[LX_NUMBER_SIZE], error[LX_NUMBER_SIZE], pixel[LX_NUMBER_SIZE];
    struct lx_text name = {0}, place = {0};
    lx_text_printf(&name, "P%zu", i + 1);
    lx_report_add_place(&place, (const double[]){probe->x_mm, probe->y_mm}, 2);
    const char *without = probe->on_surface ? LX_N("a source lies on it") : LX_N("off the surface");
    struct lx_span exact =
        LX_PLAIN(lx_report_bounded(report, probe->value, probe->error, LX_REPORT_EXACT_DIGITS, value));
    struct lx_span none = LX_TERM_SPAN(without), blank = LX_PLAIN("");
    struct lx_span bound = LX_PLAIN(lx_write_bound(lx_error_of_shown(value, probe->value, probe->error), 2, error));
    struct lx_span nearest = LX_PLAIN(lx_report_value(report, probe->pixel_value, LX_REPORT_DIGITS, pixel));
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
    /* with reflected light it is known to a bound alone */
    const bool is_exact = !report->statistics.has_reflected;
    lx_document_paragraph(document,
                          is_exact
                              ? LX_N("The exact value is that at the point itself; the picture's is that of the "
                                     "pixel in which the point lies. Values in {0}, places in mm.")
                              : LX_N("The value is that at the point itself, to the error beside it; the picture's "
                                     "is that of the pixel in which the point lies. Values in {0}, places in mm."),
                          LX_SPANS(LX_PLAIN(report->unit)));
    lx_document_table(document, "llrrr");
    lx_document_row(document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("point")), LX_MATH("(x,\\, y)"),
                             LX_TERM_SPAN(is_exact ? LX_N("exact value") : LX_N("value")),
                             LX_TERM_SPAN(LX_N("error at most")), LX_TERM_SPAN(LX_N("of the pixel"))),
                    false);
    for (size_t i = 0; i < report->probe_count; i++)
        add_probe(report, i);
}

/* `error`: of the value, 0 where its digits hold. */
static void add_bounded(struct lx_report *report, const char *english, double value, double error, const double *place)
{
    char number[LX_NUMBER_SIZE];
    struct lx_text text = {0};
    if (place)
        lx_report_add_place(&text, place, 2);
    lx_document_row(report->document,
                    LX_SPANS(LX_TERM_SPAN(english),
                             LX_PLAIN(lx_report_bounded(report, value, error, LX_REPORT_DIGITS, number)),
                             LX_PLAIN(text.bytes ? text.bytes : "")),
                    false);
    lx_text_clear(&text);
}

static void add_statistic(struct lx_report *report, const char *english, double value, const double *place)
{
    add_bounded(report, english, value, 0, place);
}

/* The extrema of the exact function. */
static void add_true_extrema(struct lx_report *report)
{
    const luxel_peak *greatest = &report->rendered.extrema.maximum, *least = &report->rendered.extrema.minimum;
    if (greatest->exists)
        add_bounded(report, LX_N("true maximum"), greatest->value, greatest->error,
                    greatest->place == LUXEL_PEAK_PLATEAU ? NULL : (const double[]){greatest->x_mm, greatest->y_mm});
    if (least->exists)
        add_bounded(report, LX_N("true minimum"), least->value, least->error,
                    least->place == LUXEL_PEAK_PLATEAU ? NULL : (const double[]){least->x_mm, least->y_mm});
}

static void add_pixel(struct lx_report *report, const char *english, const luxel_extremum *pixel)
{
    if (pixel->exists)
        add_statistic(report, english, pixel->value, (const double[]){pixel->x_mm, pixel->y_mm});
}

/* What the least value above 0 is where no light arrives. */
static void explain_minimum(struct lx_report *report)
{
    const luxel_extremum *least = &report->statistics.minimum, *reached = &report->statistics.minimum_reached;
    if (!lx_report_has_tail(report))
        return;
    if (reached->exists)
        lx_document_paragraph(
            report->document,
            LX_N("The minimum above 0 lies where no source shines on the surface: it is the tail of "
                 "a highlight that counts there, too. Numbers below 1.2e-38 are taken for 0. Where "
                 "light arrives, N·L > 0, no pixel is below {0} {1}."),
            LX_SPANS(LX_PLAIN(lx_report_value(report, reached->value, LX_REPORT_DIGITS, (char[LX_NUMBER_SIZE]){0})),
                     LX_PLAIN(report->unit)));
    else if (least->exists)
        lx_document_paragraph(report->document,
                              LX_N("The minimum above 0 lies where no source shines on the surface: it is the tail of "
                                   "a highlight that counts there, too. Numbers below 1.2e-38 are taken for 0."),
                              NULL);
}

bool lx_report_has_tail(const struct lx_report *report)
{
    const luxel_statistics *statistics = &report->statistics;
    const bool was_sought = statistics->minimum_reached.exists || report->reach.share == 0;
    return was_sought && !report->reach.has_ambient && statistics->minimum.exists &&
           (!statistics->minimum_reached.exists || statistics->minimum.value < statistics->minimum_reached.value);
}

static void add_statistics(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    const luxel_summary *summary = &report->summary;
    lx_document_heading(document, 2, LX_N("Extrema and means"), NULL);
    if (summary->pixels == 0) {
        lx_document_paragraph(document, LX_N("The screen shows no surface."), NULL);
        return;
    }
    lx_document_paragraph(document,
                          LX_N("True extrema are those of the exact function between the pixels; everything else is "
                               "read off the {0} pixels that show a surface. Values in {1}."),
                          LX_SPANS(LX_PLAIN(lx_write_number((double)summary->pixels, (char[LX_NUMBER_SIZE]){0})),
                                   LX_PLAIN(report->unit)));
    lx_document_table(document, "lrl");
    lx_document_row(document, LX_SPANS(LX_PLAIN(""), LX_TERM_SPAN(LX_N("value")), LX_TERM_SPAN(LX_N("at x, y in mm"))),
                    false);
    add_true_extrema(report);
    add_pixel(report, LX_N("maximum of the pixels"), &summary->maximum);
    add_pixel(report, LX_N("minimum of the pixels"), &summary->minimum);
    add_pixel(report, LX_N("minimum above 0"), &report->statistics.minimum);
    add_pixel(report, LX_N("minimum where light arrives"), &report->statistics.minimum_reached);
    add_statistic(report, LX_N("mean"), summary->mean, NULL);
    add_statistic(report, LX_N("median"), summary->median, NULL);
    add_statistic(report, LX_N("standard deviation"), summary->standard_deviation, NULL);
    if (report->reach.has_direct)
        add_statistic(report,
                      report->reach.has_ambient ? LX_N("share of the picture that light other than ambient reaches")
                      : report->statistics.has_reflected
                          ? LX_N("share of the picture that light reaches straight from a source")
                          : LX_N("share of the picture that light reaches"),
                      report->reach.share, NULL);
    if (summary->has_evenness)
        add_statistic(report, LX_N("uniformity U0 = minimum of the pixels / mean"), summary->u0, NULL);
    explain_minimum(report);
}

luxel_status lx_report_results(struct lx_report *report)
{
    lx_document_heading(report->document, 1, LX_N("Results"), NULL);
    add_points(report);
    add_statistics(report);
    lx_report_balance(report);
    return lx_report_lamps(report);
}

/* ---- reproducing ---- */

/* "luxel render scene.yaml --quantity irradiance": with the settings that the report was made with. */
static void add_command(const struct lx_report *report, struct lx_text *text, const char *command, const char *more)
{
    char number[LX_NUMBER_SIZE];
    lx_text_printf(text, "luxel %s scene.yaml%s", command, more);
    if (lx_report_is_irradiance(report))
        lx_text_puts(text, " --quantity irradiance");
    if (report->settings && report->settings->precision == LUXEL_DOUBLE)
        lx_text_puts(text, " --precision double");
    if (report->settings && report->settings->tolerance > 0)
        lx_text_printf(text, " --tolerance %s", lx_write_number(report->settings->tolerance, number));
    if (report->settings && report->settings->light_error > 0)
        lx_text_printf(text, " --light-error %s", lx_write_number(report->settings->light_error, number));
    if (report->settings && report->settings->reflected_error > 0)
        lx_text_printf(text, " --reflected-error %s", lx_write_number(report->settings->reflected_error, number));
}

/* Whether the scene is more than its text. */
static bool names_files(const struct lx_scene_parameters *scene)
{
    for (size_t i = 0; i < scene->lights.count; i++) {
        const struct lx_item *light = &scene->lights.items[i];
        for (size_t k = 0; k < light->variant->table->count; k++) {
            const struct lx_parameter *parameter = &light->variant->table->parameters[k];
            if (parameter->type == LX_TEXT && lx_is_given(light->variant->table, light->parameters, parameter->name))
                return true;
        }
    }
    return false;
}

void lx_report_repetition(struct lx_report *report)
{
    struct luxel_document *document = report->document;
    struct lx_text numbers = {0}, picture = {0}, steps = {0};
    char *scene = NULL;
    lx_document_heading(document, 1, LX_N("Reproducing these results"), NULL);
    add_command(report, &numbers, "render", "");
    add_command(report, &picture, "render", " -o scene.png");
    add_command(report, &steps, "explain", "");
    lx_document_paragraph(document,
                          LX_N("Computed by Luxel {0} from the scene below. Saved as {1}, it gives the same numbers by "
                               "{2}, the same picture by {3}, and the calculation of each point step by step by {4}."),
                          LX_SPANS(LX_PLAIN(luxel_version()), LX_CODE("scene.yaml"), LX_CODE(numbers.bytes),
                                   LX_CODE(picture.bytes), LX_CODE(steps.bytes)));
    if (names_files(report->parameters))
        lx_document_paragraph(document, LX_N("The files that it names are looked for from its own folder."), NULL);
    if (luxel_scene_write_text(report->scene, &scene) == LUXEL_OK)
        lx_document_code(document, scene);
    luxel_text_free(scene);
    lx_text_clear(&numbers);
    lx_text_clear(&picture);
    lx_text_clear(&steps);
}
