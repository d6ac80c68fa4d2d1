/* SPDX-License-Identifier: MIT */
/* The section of a report about luminaires: what the files of those that shine say, each file once. */
#include <luxel/glare.h>
#include <luxel/photometry.h>
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "../light/array.h"
#include "report.h"

static const double SPACING = 0.25; /* of catalogues */

/* A file and its luminaires. */
struct lamp {
    const luxel_photometry *photometry;
    const char *file;
    size_t count;
};

/* The i-th light as a luminaire of a file; false: it is none, or is switched off. */
static bool find_lamp(const struct lx_report *report, size_t i, struct lamp *lamp)
{
    const struct lx_item *item = &report->parameters->lights.items[i];
    const struct lx_light_common *common = item->common;
    const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
    *lamp = (struct lamp){.count = lx_light_places(item)};
    if (common->enabled && kind->photometry)
        lamp->photometry = kind->photometry(item->parameters, &lamp->file);
    return lamp->photometry != NULL;
}

/* Counts the luminaires of the i-th light's file; 0 where an earlier light has named it. */
static size_t count_lamps(const struct lx_report *report, size_t i, struct lamp *lamp)
{
    struct lamp other;
    if (!find_lamp(report, i, lamp))
        return 0;
    for (size_t k = 0; k < report->parameters->lights.count; k++)
        if (k != i && find_lamp(report, k, &other) && strcmp(other.file, lamp->file) == 0) {
            if (k < i)
                return 0;
            lamp->count += other.count;
        }
    return lamp->count;
}

static const char *rating_text(const luxel_ugr_table *table, int way, char *text, size_t size)
{
    size_t room = 0;
    while (luxel_ugr_room(room, 0) != 4 || luxel_ugr_room(room, 1) != 8)
        room++;
    const double rating = table->ratings[room][way][0];
    if (!table->exists || rating != rating)
        return "–";
    snprintf(text, size, "%.1f", rating);
    return text;
}

static luxel_status add_lamp(struct lx_report *report, const struct lamp *lamp)
{
    luxel_photometry_figures figures;
    luxel_ugr_table glare;
    char count[LX_NUMBER_SIZE], flux[LX_NUMBER_SIZE], greatest[LX_NUMBER_SIZE], across[16], along[16];
    if (luxel_photometry_find_figures(lamp->photometry, &figures) != LUXEL_OK ||
        luxel_photometry_find_ugr_table(lamp->photometry, SPACING, &glare) != LUXEL_OK)
        return LUXEL_ERROR_MEMORY;
    lx_document_row(report->document,
                    LX_SPANS(LX_CODE(lamp->file), LX_PLAIN(lx_write_number((double)lamp->count, count)),
                             LX_PLAIN(lx_write_digits(figures.zone_lumens, 5, flux)),
                             LX_PLAIN(lx_write_digits(figures.greatest_cd, 5, greatest)),
                             LX_PLAIN(rating_text(&glare, 0, across, sizeof across)),
                             LX_PLAIN(rating_text(&glare, 1, along, sizeof along))),
                    false);
    return LUXEL_OK;
}

static void begin(struct lx_report *report)
{
    lx_document_heading(report->document, 2, LX_N("Luminaires"), NULL);
    lx_document_paragraph(
        report->document,
        LX_N("What the files of the luminaires say, without the factors of the scene. UGR is the unified glare rating "
             "by the tabular method of CIE 190 that catalogues quote: of a room of 4 by 8 heights of the luminaires "
             "above the eye, a quarter of that height apart, with reflectances of 70, 50 and 20 %, crosswise (C0-C180 "
             "along the line of sight) and endwise."),
        NULL);
    lx_document_table(report->document, "lrrrrr");
    lx_document_row(report->document,
                    LX_SPANS(LX_TERM_SPAN(LX_N("file")), LX_TERM_SPAN(LX_N("luminaires")),
                             LX_TERM_SPAN(LX_N("flux, lm")), LX_TERM_SPAN(LX_N("greatest intensity, cd")),
                             LX_TERM_SPAN(LX_N("UGR crosswise")), LX_TERM_SPAN(LX_N("UGR endwise"))),
                    false);
}

luxel_status lx_report_lamps(struct lx_report *report)
{
    luxel_status status = LUXEL_OK;
    struct lamp lamp;
    bool has_begun = false;
    for (size_t i = 0; i < report->parameters->lights.count && status == LUXEL_OK; i++) {
        if (count_lamps(report, i, &lamp) == 0)
            continue;
        if (!has_begun)
            begin(report);
        has_begun = true;
        status = add_lamp(report, &lamp);
    }
    return status == LUXEL_OK ? status : lx_out_of_memory(report->diagnostics);
}
