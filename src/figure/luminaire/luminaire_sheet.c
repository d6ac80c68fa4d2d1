/* SPDX-License-Identifier: MIT */
/*
 * The sheet of a luminaire, as makers hand it out with their files: what the file says and what follows from it, the
 * diagrams, and the tables that designs by hand are made with.
 */
#include <luxel/version.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/diagnostics.h"
#include "../../base/number.h"
#include "../../base/phrase.h"
#include "../diagram.h"
#include "../report.h"
#include "luminaire.h"

static const double SPACING = 0.25; /* of catalogues */

/* ---- what is computed ---- */

static luxel_status solve_rooms(struct lx_luminaire_sheet *sheet)
{
    luxel_status status = LUXEL_OK;
    sheet->has_reflected =
        sheet->texts->path && sheet->utilization.exists && 100 - sheet->figures.dff < LUXEL_ROOM_UPWARDS;
    for (size_t k = 0; k < LX_SHEET_ROOMS && sheet->has_reflected && status == LUXEL_OK; k++)
        status = luxel_find_room_utilization(sheet->texts->path, &sheet->utilization, k, LX_SHEET_TRIPLE,
                                             sheet->texts->settings, sheet->diagnostics, &sheet->reflected[k]);
    return status;
}

static luxel_status compute(struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry *photometry = sheet->photometry;
    const double spacing = sheet->texts->spacing > 0 ? sheet->texts->spacing : SPACING;
    luxel_status status = luxel_photometry_find_figures(photometry, &sheet->figures);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_ugr_table(photometry, spacing, &sheet->glare);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_utilization(photometry, &sheet->utilization);
    if (status == LUXEL_OK)
        status = luxel_photometry_find_bug_rating(photometry, &sheet->bug);
    if (status == LUXEL_ERROR_MEMORY)
        return lx_out_of_memory(sheet->diagnostics);
    return status == LUXEL_OK ? solve_rooms(sheet) : status;
}

/* ---- what the file says ---- */

static void add_row(const struct lx_luminaire_sheet *sheet, const char *name, const char *text)
{
    lx_document_row(sheet->document, LX_SPANS(LX_TERM_SPAN(name), LX_PLAIN(text)), false);
}

/* The first line of a text of the file. */
static void add_text(const struct lx_luminaire_sheet *sheet, const char *name, const char *text)
{
    char line[240];
    if (!text || !*text)
        return;
    size_t length = strcspn(text, "\n");
    if (length >= sizeof line)
        for (length = sizeof line - 1; length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80;)
            length--; /* no character is cut in half */
    snprintf(line, sizeof line, "%.*s", (int)length, text);
    add_row(sheet, name, line);
}

static void add_number(const struct lx_luminaire_sheet *sheet, const char *name, double value, int digits,
                       const char *unit)
{
    char number[LX_NUMBER_SIZE], text[LX_NUMBER_SIZE + 40];
    if (!isfinite(value))
        return;
    snprintf(text, sizeof text, "%s %s", lx_write_digits(value, digits, number),
             lx_document_word(sheet->document, unit));
    add_row(sheet, name, text);
}

static const char *symmetry_words(luxel_photometry_symmetry symmetry)
{
    static const char *const words[] = {
        [LUXEL_SYMMETRY_NONE] = LX_N("none"),
        [LUXEL_SYMMETRY_AXIAL] = LX_N("about the axis"),
        [LUXEL_SYMMETRY_QUADRANT] = LX_N("about C0-C180 and C90-C270"),
        [LUXEL_SYMMETRY_BILATERAL_0] = LX_N("about C0-C180"),
        [LUXEL_SYMMETRY_BILATERAL_90] = LX_N("about C90-C270"),
        [LUXEL_SYMMETRY_LATERAL] = LX_N("left and right"),
    };
    return words[symmetry];
}

static const char *opening_words(luxel_photometry_opening_shape shape)
{
    static const char *const words[] = {
        [LUXEL_OPENING_POINT] = LX_N("point"),
        [LUXEL_OPENING_RECTANGLE] = LX_N("rectangle"),
        [LUXEL_OPENING_BOX] = LX_N("box with luminous sides"),
        [LUXEL_OPENING_ELLIPSE] = LX_N("ellipse"),
        [LUXEL_OPENING_CYLINDER] = LX_N("upright cylinder"),
        [LUXEL_OPENING_ELLIPSOID] = LX_N("ellipsoid"),
        [LUXEL_OPENING_CYLINDER_LENGTH] = LX_N("cylinder along C0-C180"),
        [LUXEL_OPENING_CYLINDER_WIDTH] = LX_N("cylinder along C90-C270"),
        [LUXEL_OPENING_FACING_LENGTH] = LX_N("upright ellipse facing along C0-C180"),
        [LUXEL_OPENING_FACING_WIDTH] = LX_N("upright ellipse facing along C90-C270"),
    };
    return words[shape];
}

/* "rectangle, 600 × 600 × 0 mm": along C0-C180, along C90-C270, high. */
static void add_opening(const struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry_opening *opening = &sheet->photometry->opening;
    char numbers[3][LX_NUMBER_SIZE], text[4 * LX_NUMBER_SIZE + 120];
    snprintf(text, sizeof text, "%s, %s × %s × %s %s", lx_document_word(sheet->document, opening_words(opening->shape)),
             lx_write_digits(opening->length_mm, 6, numbers[0]), lx_write_digits(opening->width_mm, 6, numbers[1]),
             lx_write_digits(opening->height_mm, 6, numbers[2]), lx_document_word(sheet->document, LX_N("mm")));
    add_row(sheet, LX_N("luminous opening: along C0-C180, along C90-C270, high"), text);
}

static void add_lamps(const struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry *photometry = sheet->photometry;
    if (photometry->lamp_set_count > 0) {
        const luxel_photometry_lamp_set *lamps = &photometry->lamp_sets[0];
        char number[LX_NUMBER_SIZE], text[200];
        snprintf(text, sizeof text, "%s × %.150s", lx_write_digits(fabs(lamps->count), 6, number),
                 *lamps->type ? lamps->type : lx_document_word(sheet->document, LX_N("lamp")));
        add_text(sheet, LX_N("lamps"), text);
        add_text(sheet, LX_N("colour temperature"), lamps->temperature);
        add_text(sheet, LX_N("colour rendering"), lamps->rendering);
    }
    add_number(sheet, LX_N("declared lumens"), photometry->declared_lumens, 7, LX_N("lm"));
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("photometry")),
                             LX_TERM_SPAN(photometry->is_absolute
                                              ? LX_N("absolute: the intensities are those of the luminaire as it was "
                                                     "measured")
                                              : LX_N("relative: the intensities belong to the declared lumens"))),
                    false);
    add_number(sheet, LX_N("input power"), photometry->watts > 0 ? photometry->watts : (double)NAN, 6, LX_N("W"));
}

static void add_file(const struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry *photometry = sheet->photometry;
    char format[80];
    snprintf(format, sizeof format, "%s, %s %c", luxel_photometry_format_name(photometry),
             lx_document_word(sheet->document, LX_N("type")), "ABC"[photometry->type]);
    lx_document_heading(sheet->document, 1, LX_N("Luminaire"), NULL);
    lx_document_table(sheet->document, "ll");
    lx_document_row(sheet->document, LX_SPANS(LX_TERM_SPAN(LX_N("what the file says")), LX_PLAIN("")), false);
    add_text(sheet, LX_N("file"), sheet->texts->file);
    add_row(sheet, LX_N("format"), format);
    add_text(sheet, LX_N("maker"), luxel_photometry_find_text(photometry, "MANUFAC"));
    add_text(sheet, LX_N("luminaire"), luxel_photometry_find_text(photometry, "LUMINAIRE"));
    add_text(sheet, LX_N("article number"), luxel_photometry_find_text(photometry, "LUMCAT"));
    add_text(sheet, LX_N("test"), luxel_photometry_find_text(photometry, "TEST"));
    add_text(sheet, LX_N("date"), luxel_photometry_find_text(photometry, "ISSUEDATE"));
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("symmetry")), LX_TERM_SPAN(symmetry_words(photometry->symmetry))),
                    false);
    add_opening(sheet);
    add_lamps(sheet);
}

/* ---- what follows from its table ---- */

static void add_angles(const struct lx_luminaire_sheet *sheet, const char *name, double widest,
                       const double sections[2])
{
    char numbers[3][LX_NUMBER_SIZE];
    if (!isfinite(widest))
        return;
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(name), LX_PLAIN(lx_write_digits(widest, 4, numbers[0])),
                             LX_PLAIN(lx_write_digits(sections[0], 4, numbers[1])),
                             LX_PLAIN(lx_write_digits(sections[1], 4, numbers[2]))),
                    false);
}

static void add_widths(const struct lx_luminaire_sheet *sheet)
{
    const bool is_turn = sheet->photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    const luxel_photometry_figures *figures = &sheet->figures;
    lx_document_table(sheet->document, "lrrr");
    lx_document_row(sheet->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("full angles, degrees")), LX_TERM_SPAN(LX_N("through the greatest")),
                             LX_TERM_SPAN(is_turn ? "C0–C180" : LX_N("horizontal")),
                             LX_TERM_SPAN(is_turn ? "C90–C270" : LX_N("vertical"))),
                    false);
    add_angles(sheet, LX_N("beam angle (50 %)"), figures->beam_deg, figures->beam_sections_deg);
    add_angles(sheet, LX_N("field angle (10 %)"), figures->field_deg, figures->field_sections_deg);
}

static void add_code(const struct lx_luminaire_sheet *sheet)
{
    char text[80] = "";
    if (!isfinite(sheet->figures.flux_code[0]))
        return;
    for (size_t i = 0, used = 0; i < 5; i++)
        used +=
            (size_t)snprintf(text + used, sizeof text - used, isfinite(sheet->figures.flux_code[i]) ? "%s%.0f" : "%s–",
                             i > 0 ? " " : "", sheet->figures.flux_code[i]);
    add_row(sheet, LX_N("CIE flux code"), text);
}

static void add_spacing(const struct lx_luminaire_sheet *sheet)
{
    char numbers[3][LX_NUMBER_SIZE], text[3 * LX_NUMBER_SIZE + 8];
    const double *spacing = sheet->figures.spacing;
    if (!isfinite(spacing[0]) || !isfinite(spacing[1]) || !isfinite(spacing[2]))
        return;
    snprintf(text, sizeof text, "%s, %s, %s", lx_write_digits(spacing[0], 3, numbers[0]),
             lx_write_digits(spacing[1], 3, numbers[1]), lx_write_digits(spacing[2], 3, numbers[2]));
    add_row(sheet, LX_N("spacing criterion: along C0-C180, along C90-C270, diagonally"), text);
}

static void add_greatest(const struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry_figures *figures = &sheet->figures;
    char numbers[3][LX_NUMBER_SIZE], text[3 * LX_NUMBER_SIZE + 80];
    snprintf(text, sizeof text, "%s %s (C = %s°, γ = %s°)", lx_write_digits(figures->greatest_cd, 6, numbers[0]),
             lx_document_word(sheet->document, LX_N("cd")), lx_write_digits(figures->greatest_c_deg, 5, numbers[1]),
             lx_write_digits(figures->greatest_gamma_deg, 5, numbers[2]));
    add_row(sheet, LX_N("greatest intensity"), text);
}

static void add_figures(const struct lx_luminaire_sheet *sheet)
{
    const luxel_photometry_figures *figures = &sheet->figures;
    const double watts = sheet->photometry->watts;
    lx_document_table(sheet->document, "ll");
    lx_document_row(sheet->document, LX_SPANS(LX_TERM_SPAN(LX_N("what follows from its table")), LX_PLAIN("")), false);
    add_number(sheet, LX_N("flux, zone rule"), figures->zone_lumens, 6, LX_N("lm"));
    add_number(sheet, LX_N("flux, linear rule"), figures->linear_lumens, 6, LX_N("lm"));
    add_number(sheet, LX_N("efficacy"), watts > 0 ? figures->zone_lumens / watts : (double)NAN, 4, LX_N("lm/W"));
    add_number(sheet, LX_N("light output ratio (LORL)"), figures->lorl, 4, "%");
    add_number(sheet, LX_N("downward flux fraction (DFF)"), figures->dff, 4, "%");
    add_greatest(sheet);
    add_code(sheet);
    add_spacing(sheet);
    if (figures->greatest_cd > 0)
        add_widths(sheet);
}

static void add_warnings(const struct lx_luminaire_sheet *sheet)
{
    bool has_begun = false;
    for (size_t i = 0; i < luxel_diagnostics_count(sheet->texts->warnings); i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(sheet->texts->warnings, i);
        const luxel_language *language = sheet->texts->language;
        if (entry->severity != LUXEL_SEVERITY_ADVICE)
            continue;
        char *message = luxel_diagnostics_message(sheet->texts->warnings, i, language ? language->translate : NULL,
                                                  language ? language->data : NULL);
        if (!has_begun)
            lx_document_paragraph(sheet->document, LX_N("What is odd in the file:"), NULL);
        has_begun = true;
        lx_document_item(sheet->document, "{0}", LX_SPANS(LX_PLAIN(message ? message : entry->id)));
        luxel_text_free(message);
    }
}

/* ---- the document ---- */

static void add_title(const struct lx_luminaire_sheet *sheet)
{
    static const char *const keywords[] = {"LUMINAIRE", "LUMCAT"};
    const char *title = sheet->texts->title;
    char line[120];
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords && !title; i++) {
        const char *text = luxel_photometry_find_text(sheet->photometry, keywords[i]);
        title = text && *text ? text : NULL;
    }
    title = title ? title : sheet->texts->file;
    if (!title) {
        lx_document_title(sheet->document, LX_N("Luminaire"), NULL);
        return;
    }
    size_t length = strcspn(title, "\n");
    if (length >= sizeof line)
        for (length = sizeof line - 1; length > 0 && ((unsigned char)title[length] & 0xc0) == 0x80;)
            length--; /* no character is cut in half */
    snprintf(line, sizeof line, "%.*s", (int)length, title);
    lx_document_title(sheet->document, "{0}", LX_SPANS(LX_PLAIN(line)));
}

static void add_definitions(const struct lx_luminaire_sheet *sheet)
{
    struct luxel_document *document = sheet->document;
    lx_document_heading(document, 1, LX_N("Definitions"), NULL);
    lx_document_item(document,
                     LX_N("Fluxes are by the zone rule: the mean intensity of two angles times the difference of their "
                          "cosines. Between the places of the table intensities are linear in the angles."),
                     NULL);
    lx_document_item(
        document,
        LX_N("The spacing criterion is the greatest ratio of spacing to mounting height at which two "
             "luminaires give midway between them what one gives right below it; diagonally four give that "
             "in the middle of their square. Programs that round up to even hundredths tell up to 0.04 "
             "more."),
        NULL);
    if (sheet->utilization.exists)
        lx_document_item(
            document,
            LX_N("The room index is k = x·y / (h·(x + y)) with the height h of the luminaires above the "
                 "work plane. Utilization factors are related to {0} lm; the tabular method shares out the "
                 "light by the direct ratios of LiTG 3.5, for a spacing to height ratio of 1, between a "
                 "floor, walls and a ceiling that are each evenly lit."),
            LX_SPANS(LX_PLAIN(lx_write_digits(sheet->utilization.lumens, 6, (char[LX_NUMBER_SIZE]){0}))));
}

static luxel_status build(struct lx_luminaire_sheet *sheet)
{
    const char *maker = luxel_photometry_find_text(sheet->photometry, "MANUFAC");
    sheet->document = lx_document_new(sheet->texts->language);
    if (!sheet->document)
        return lx_out_of_memory(sheet->diagnostics);
    add_title(sheet);
    if (maker && *maker)
        lx_document_byline(sheet->document, maker);
    lx_document_number(sheet->document);
    add_file(sheet);
    add_figures(sheet);
    add_warnings(sheet);
    lx_document_paragraph(sheet->document, LX_N("Made by Luxel {0}."), LX_SPANS(LX_PLAIN(luxel_version())));
    luxel_status status = LUXEL_OK;
    if (sheet->figures.greatest_cd > 0) {
        lx_document_heading(sheet->document, 1, LX_N("Intensities"), NULL);
        status = lx_diagram_add(sheet->photometry, sheet->texts->language, sheet->document, sheet->diagnostics);
    }
    if (status == LUXEL_OK)
        lx_sheet_intensities(sheet);
    if (status == LUXEL_OK)
        status = lx_sheet_zones(sheet);
    if (status != LUXEL_OK)
        return status;
    lx_sheet_luminances(sheet);
    lx_sheet_utilization(sheet);
    lx_sheet_glare(sheet);
    lx_sheet_bug(sheet);
    add_definitions(sheet);
    return lx_document_failed(sheet->document) ? lx_out_of_memory(sheet->diagnostics) : LUXEL_OK;
}

static luxel_status write_to(const struct lx_destination *destination, const luxel_photometry *photometry,
                             const luxel_sheet_settings *settings, luxel_diagnostics *diagnostics)
{
    const luxel_sheet_settings none = {0};
    struct lx_luminaire_sheet sheet = {
        .photometry = photometry, .texts = settings ? settings : &none, .diagnostics = diagnostics};
    if (!photometry || !destination->path)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = luxel_check_report_name(destination->path, diagnostics);
    if (status == LUXEL_OK)
        status = LX_CHECK_RESERVE(sheet.texts, diagnostics);
    if (status == LUXEL_OK && sheet.texts->language)
        status = LX_CHECK_RESERVE(sheet.texts->language, diagnostics);
    if (status == LUXEL_OK)
        status = compute(&sheet);
    if (status == LUXEL_OK)
        status = build(&sheet);
    if (status == LUXEL_OK)
        status = lx_report_put(sheet.document, destination, diagnostics);
    luxel_document_free(sheet.document);
    return status;
}

luxel_status luxel_sheet_write(const luxel_photometry *photometry, const luxel_sheet_settings *settings,
                               const char *path, luxel_diagnostics *diagnostics)
{
    return write_to(&(struct lx_destination){.path = path}, photometry, settings, diagnostics);
}

luxel_status luxel_sheet_write_memory(const luxel_photometry *photometry, const luxel_sheet_settings *settings,
                                      const char *name, luxel_diagnostics *diagnostics, unsigned char **bytes,
                                      size_t *length)
{
    return write_to(&(struct lx_destination){name, bytes, length}, photometry, settings, diagnostics);
}
