/* SPDX-License-Identifier: MIT */
/* What a report is made of: the numbers that its sections tell, computed once. */
#ifndef LX_FIGURE_REPORT_H
#define LX_FIGURE_REPORT_H

#include <luxel/balance.h>
#include <luxel/compare.h>
#include <luxel/figure.h>
#include <luxel/light.h>
#include <luxel/probe.h>
#include <luxel/version.h>

#include "../document/document.h"
#include "../scene/scene.h"
#include "figure.h"

/* How far from the maximum the value falls to half of it, along a line. */
struct lx_report_width {
    bool exists[2]; /* to both sides; false where it does not fall so far on the surface */
    double mm[2];
};

struct lx_report {
    const luxel_scene *scene;
    const struct lx_scene_parameters *parameters;
    const luxel_settings *settings;
    const luxel_report_settings *texts;
    luxel_diagnostics *diagnostics;
    struct luxel_document *document;
    struct lx_rendered rendered;
    luxel_summary summary;
    luxel_statistics statistics;
    luxel_light_reach reach;
    luxel_probes *probes; /* of the scene's points */
    size_t probe_count;
    luxel_probe *peak;                /* at the maximum; NULL where there is none */
    struct lx_report_width widths[2]; /* along x, along y */
    luxel_balance *balance;           /* NULL: no light is reflected */
    const char *unit;                 /* in the document's language */
};

enum { LX_REPORT_DIGITS = 7, LX_REPORT_EXACT_DIGITS = 12 }; /* of values, and of those of points */

/* Computes everything but the document.  lx_report_clear() is due whatever it returns. */
luxel_status lx_report_compute(struct lx_report *report);
void lx_report_clear(struct lx_report *report);

/* Writes a document by the extension of its name: pages of a PDF, or as luxel_document_write() does. */
luxel_status lx_report_put(const struct luxel_document *document, const struct lx_destination *destination,
                           luxel_diagnostics *diagnostics);

/* The sections, each with its heading; the first has the aim, too. */
void lx_report_task(struct lx_report *report);
luxel_status lx_report_results(struct lx_report *report);
void lx_report_conclusions(struct lx_report *report);
void lx_report_repetition(struct lx_report *report);

/* A part of the results, where surfaces reflect light. */
void lx_report_balance(struct lx_report *report);

/* A part of the results, where there are luminaires of files. */
luxel_status lx_report_lamps(struct lx_report *report);

/* The pictures: grey, false colour with isophotes, sections. */
luxel_status lx_report_pictures(struct lx_report *report);

/* "brightness" or "irradiance", and whether it is the latter. */
const char *lx_report_quantity(const struct lx_report *report);
/* The sentence about it, of those that name brightness, luminance, irradiance and illuminance. */
const char *lx_report_choose(const struct lx_report *report, const char *const sentences[4]);
bool lx_report_is_irradiance(const struct lx_report *report);

/* Whether values above 0 lie where no light arrives: the tail of a highlight that is not gated. */
bool lx_report_has_tail(const struct lx_report *report);

/* Adds "(177.4828, 0)". */
void lx_report_add_place(struct lx_text *text, const double *values, size_t count);

/* A number with seven significant digits, as reports show places. */
const char *lx_report_number(double value, char *buffer);
/* A value with so many digits as were asked for, or by default. */
const char *lx_report_value(const struct lx_report *report, double value, int by_default, char *buffer);

/* A value with a bound of its error: in no more digits than that leaves, two of its own, unless a number of them was
 * asked for. */
const char *lx_report_bounded(const struct lx_report *report, double value, double error, int by_default, char *buffer);

#endif
