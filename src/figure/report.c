/* SPDX-License-Identifier: MIT */
/* Reports: the numbers, the document made of them, its pictures, and the file. */
#include "report.h"

#include <stdlib.h>
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/ending.h"
#include "../base/phrase.h"
#include "../base/sink.h"
#include "../exercise/explain.h"
#include "../scene/lit.h"
#include "../world/prepared.h"
#include "figure.h"
#include "lighting.h"
#include "pages.h"

static const char *const endings[] = {".pdf", ".html", ".md", ".tex", ".csv"};
enum { PDF, HTML, MARKDOWN, LATEX, CSV };

enum { GREY_MM = 80, FALSE_COLOUR_MM = 120, PICTURE_DPI = 150 };

luxel_status luxel_check_report_name(const char *path, luxel_diagnostics *diagnostics)
{
    size_t found;
    return lx_find_ending(path, endings, sizeof endings / sizeof endings[0], diagnostics, &found);
}

static bool is_irradiance(const struct lx_report *report)
{
    return report->settings && report->settings->quantity == LUXEL_IRRADIANCE;
}

static bool is_given(const char *text)
{
    return text && *text;
}

static void add_cover_line(struct luxel_document *document, enum lx_cover_place place, const char *english,
                           const char *text)
{
    if (is_given(text))
        lx_document_cover(document, place, english, LX_SPANS(LX_PLAIN(text)));
}

/* The title page, of what was given. */
static void add_cover(struct luxel_document *document, const luxel_report_settings *texts)
{
    add_cover_line(document, LX_COVER_HEAD, "{0}", texts->institution);
    add_cover_line(document, LX_COVER_HEAD, "{0}", texts->faculty);
    add_cover_line(document, LX_COVER_ABOVE, LX_N("Report for the course “{0}”"), texts->course);
    add_cover_line(document, LX_COVER_SIDE, LX_N("Author: {0}"), texts->author);
    add_cover_line(document, LX_COVER_SIDE, LX_N("Group: {0}"), texts->group);
    add_cover_line(document, LX_COVER_SIDE, LX_N("Teacher: {0}"), texts->teacher);
    if (is_given(texts->place) && is_given(texts->date))
        lx_document_cover(document, LX_COVER_FOOT, "{0}, {1}", LX_SPANS(LX_PLAIN(texts->place), LX_PLAIN(texts->date)));
    else
        add_cover_line(document, LX_COVER_FOOT, "{0}", is_given(texts->place) ? texts->place : texts->date);
}

static bool is_for_lighting(const struct lx_report *report)
{
    return report->texts->purpose == LUXEL_REPORT_LIGHTING;
}

static void add_title(struct lx_report *report)
{
    const luxel_report_settings *texts = report->texts;
    if (texts->title)
        lx_document_title(report->document, "{0}", LX_SPANS(LX_PLAIN(texts->title)));
    else if (is_for_lighting(report))
        lx_document_title(report->document, LX_N("Lighting design"), NULL);
    else
        lx_document_title(
            report->document,
            lx_report_choose(report, (const char *const[]){LX_N("Distribution of the brightness over lit surfaces"),
                                                           LX_N("Distribution of the luminance over lit surfaces"),
                                                           LX_N("Distribution of the irradiance over lit surfaces"),
                                                           LX_N("Distribution of the illuminance over lit surfaces")}),
            NULL);
    const char *const lines[] = {texts->author, texts->group, texts->date};
    for (size_t i = 0; i < sizeof lines / sizeof lines[0]; i++)
        if (is_given(lines[i]))
            lx_document_byline(report->document, lines[i]);
    if (is_given(texts->institution) || is_given(texts->faculty) || is_given(texts->course) ||
        is_given(texts->teacher) || is_given(texts->place))
        add_cover(report->document, texts);
}

static luxel_status add_method(struct lx_report *report)
{
    struct lx_prepared prepared;
    luxel_status status = LUXEL_OK;
    lx_document_heading(report->document, 1, LX_N("Method"), NULL);
    if (lx_prepare(report->parameters, NULL, NULL, &prepared) == 0)
        lx_explain_model(report->document, &prepared, is_irradiance(report) ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS);
    else
        status = lx_out_of_memory(report->diagnostics);
    lx_prepared_clear(&prepared);
    return status;
}

/* What a figure in false colour shows beside its colours. */
static const char *caption_of(const struct lx_figure *figure)
{
    const bool has_lines = figure->isophotes && figure->isophotes->count > 0, has_sections = figure->sections[0];
    const luxel_peak *peak = &figure->extrema.maximum;
    const bool at_maximum = peak->exists && peak->place != LUXEL_PEAK_PLATEAU;
    if (figure->settings.bands == LUXEL_BANDS_SMOOTH)
        return LX_N("The picture in grey levels.");
    if (!has_sections)
        return has_lines ? LX_N("False colour with lines of equal value.") : LX_N("False colour.");
    if (at_maximum)
        return has_lines ? LX_N("False colour with lines of equal value, and the sections through the maximum.")
                         : LX_N("False colour, and the sections through the maximum.");
    return has_lines ? LX_N("False colour with lines of equal value, and the sections through the centre.")
                     : LX_N("False colour, and the sections through the centre.");
}

/* One picture, as bytes and as a drawing. */
static luxel_status add_picture(struct lx_report *report, const luxel_figure_settings *settings)
{
    struct lx_figure *figure = NULL;
    unsigned char *bytes = NULL;
    size_t length = 0;
    luxel_status status =
        lx_figure_make(report->scene, report->settings, settings, &report->rendered, report->diagnostics, &figure);
    if (status == LUXEL_OK)
        status = lx_figure_png(figure, report->diagnostics, &bytes, &length);
    if (status == LUXEL_OK) {
        struct lx_drawing drawing = lx_figure_drawing(figure);
        const char *caption = caption_of(figure);
        lx_document_picture(report->document, bytes, length, &drawing, caption, NULL);
    } else {
        lx_figure_free(figure);
    }
    free(bytes);
    return status;
}

luxel_status lx_report_pictures(struct lx_report *report)
{
    luxel_figure_settings settings;
    luxel_figure_settings_init(&settings);
    settings.language = report->texts->language;
    settings.width_mm = GREY_MM;
    settings.dots_per_inch = PICTURE_DPI;
    settings.small_print = false;
    lx_document_heading(report->document, 1, LX_N("Pictures"), NULL);
    settings.palette = "grey";
    settings.bands = LUXEL_BANDS_SMOOTH;
    settings.points = settings.extrema = false;
    luxel_status status = add_picture(report, &settings);
    settings.width_mm = FALSE_COLOUR_MM;
    settings.palette = report->texts->palette;
    settings.bands = LUXEL_BANDS_CONTOURS;
    settings.points = settings.extrema = true;
    settings.section = report->rendered.extrema.maximum.exists ? LUXEL_SECTION_MAXIMUM : LUXEL_SECTION_NONE;
    if (status == LUXEL_OK)
        status = add_picture(report, &settings);
    return status;
}

/* The report of a lighting designer. */
static luxel_status build_lighting(struct lx_report *report)
{
    report->document = lx_document_new(report->texts->language);
    if (!report->document)
        return lx_out_of_memory(report->diagnostics);
    add_title(report);
    lx_document_number(report->document);
    const luxel_status status = lx_lighting_build(report);
    if (status != LUXEL_OK)
        return status;
    return lx_document_failed(report->document) ? lx_out_of_memory(report->diagnostics) : LUXEL_OK;
}

static luxel_status build(struct lx_report *report)
{
    if (is_for_lighting(report))
        return build_lighting(report);
    luxel_status status = lx_report_compute(report);
    if (status != LUXEL_OK)
        return status;
    report->document = lx_document_new(report->texts->language);
    if (!report->document)
        return lx_out_of_memory(report->diagnostics);
    report->unit = lx_document_word(report->document, luxel_field_unit(report->rendered.field));
    add_title(report);
    lx_document_number(report->document);
    lx_report_task(report);
    status = add_method(report);
    if (status == LUXEL_OK)
        status = lx_report_pictures(report);
    if (status == LUXEL_OK)
        status = lx_report_results(report);
    if (status != LUXEL_OK)
        return status;
    lx_report_conclusions(report);
    lx_report_repetition(report);
    return lx_document_failed(report->document) ? lx_out_of_memory(report->diagnostics) : LUXEL_OK;
}

static luxel_status write_pages(const struct luxel_document *document, const struct lx_destination *destination,
                                luxel_diagnostics *diagnostics)
{
    struct lx_sink *sink;
    luxel_status status = lx_sink_open_at(destination, diagnostics, &sink);
    if (status != LUXEL_OK)
        return status;
    status = lx_pages_write(document, sink, diagnostics);
    if (status == LUXEL_OK)
        return lx_sink_commit(sink);
    lx_sink_abort(sink);
    return status;
}

static luxel_status check(const struct lx_destination *destinations, size_t count, const luxel_scene *scene,
                          luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_OK;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        status = luxel_check_report_name(destinations[i].path, diagnostics);
    if (status == LUXEL_OK && (!scene || !luxel_scene_is_committed(scene))) {
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NOT_COMMITTED, NULL);
        status = LUXEL_ERROR_ARGUMENT;
    }
    return status;
}

static luxel_status write_tables(const struct luxel_document *document, const struct lx_destination *destination,
                                 luxel_diagnostics *diagnostics)
{
    struct lx_text text = {0};
    lx_document_write_csv(document, &text);
    const luxel_status status = text.failed
                                    ? lx_out_of_memory(diagnostics)
                                    : lx_sink_put(destination, text.bytes ? text.bytes : "", text.length, diagnostics);
    lx_text_clear(&text);
    return status;
}

luxel_status lx_report_put(const struct luxel_document *document, const struct lx_destination *destination,
                           luxel_diagnostics *diagnostics)
{
    size_t format;
    const luxel_status status =
        lx_find_ending(destination->path, endings, sizeof endings / sizeof endings[0], diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    return format == PDF   ? write_pages(document, destination, diagnostics)
           : format == CSV ? write_tables(document, destination, diagnostics)
                           : lx_document_put(document, destination, diagnostics);
}

static luxel_status write_to(const struct lx_destination *destinations, size_t count, const luxel_scene *scene,
                             const luxel_settings *settings, const luxel_report_settings *texts,
                             luxel_diagnostics *diagnostics, bool *written)
{
    const luxel_report_settings none = {0};
    struct lx_report report = {
        .scene = scene, .settings = settings, .texts = texts ? texts : &none, .diagnostics = diagnostics};
    luxel_scene *lit = NULL;
    luxel_status status = check(destinations, count, scene, diagnostics);
    if (status == LUXEL_OK)
        status = LX_CHECK_RESERVE(report.texts, diagnostics);
    if (status == LUXEL_OK && report.texts->language)
        status = LX_CHECK_RESERVE(report.texts->language, diagnostics);
    if (status == LUXEL_OK)
        status = lx_scene_lit(scene, settings, diagnostics, &lit);
    if (status != LUXEL_OK)
        return status;
    if (lit)
        report.scene = lit;
    report.parameters = lx_scene_parameters(report.scene);
    status = build(&report);
    for (size_t i = 0, built = status == LUXEL_OK; i < count && built; i++) {
        const luxel_status one = lx_report_put(report.document, &destinations[i], diagnostics);
        written[i] = one == LUXEL_OK;
        status = one == LUXEL_OK ? status : one;
    }
    lx_report_clear(&report);
    luxel_scene_free(lit);
    return status;
}

luxel_status luxel_report_write(const luxel_scene *scene, const luxel_settings *settings,
                                const luxel_report_settings *report, const char *path, luxel_diagnostics *diagnostics)
{
    bool written;
    return write_to(&(struct lx_destination){.path = path}, 1, scene, settings, report, diagnostics, &written);
}

luxel_status luxel_report_write_files(const luxel_scene *scene, const luxel_settings *settings,
                                      const luxel_report_settings *report, const char *const *paths, size_t count,
                                      luxel_diagnostics *diagnostics, bool *written)
{
    struct lx_destination *destinations = lx_destinations_of(paths, count);
    memset(written, 0, count * sizeof *written);
    const luxel_status status = destinations
                                    ? write_to(destinations, count, scene, settings, report, diagnostics, written)
                                    : lx_out_of_memory(diagnostics);
    free(destinations);
    return status;
}

luxel_status luxel_report_write_memory(const luxel_scene *scene, const luxel_settings *settings,
                                       const luxel_report_settings *report, const char *name,
                                       luxel_diagnostics *diagnostics, unsigned char **bytes, size_t *length)
{
    bool written;
    return write_to(&(struct lx_destination){name, bytes, length}, 1, scene, settings, report, diagnostics, &written);
}
