/* SPDX-License-Identifier: MIT */
/* The report that a lighting designer hands over: what it is made of, computed once, and its parts. */
#ifndef LX_FIGURE_LIGHTING_H
#define LX_FIGURE_LIGHTING_H

#include <luxel/grid.h>
#include <luxel/isophotes.h>
#include <luxel/limits.h>

#include "report.h"

/* The verdicts of one grid or observer. */
struct lx_judged {
    luxel_limit limits[2 * LUXEL_MOST_LIMITS];
    size_t count;
};

struct lx_design_report {
    struct lx_report *report; /* the document, the scene, its balance; has no picture */
    luxel_grid **grids;
    struct lx_judged *of_grids;
    const luxel_isophotes **lines; /* on their planes; NULL: a grid has no figure */
    size_t grid_count;
    luxel_glare **glares; /* of the scene's observers */
    struct lx_judged *of_observers;
    size_t observer_count;
    double floor_m2; /* of the rooms; 0: there is none */
};

/* The direction that is up. */
const double *lx_lighting_up(const struct lx_design_report *lighting);

/* The name of a grid or observer, or its number behind a word. */
enum { LX_LIGHTING_NAME = 80 };
const char *lx_lighting_name(const struct lx_report *report, const char *name, const char *english, size_t i,
                             char buffer[LX_LIGHTING_NAME]);

/* Rates the observers; and the limits of those that are one entry of the scene, as one. */
luxel_status lx_lighting_rate(struct lx_design_report *lighting);
struct lx_judged lx_lighting_judged(const struct lx_design_report *lighting, const luxel_observer_places *places);

/* Sections, each with its heading. */
void lx_lighting_glare(const struct lx_design_report *lighting);
luxel_status lx_lighting_plan(struct lx_design_report *lighting);
luxel_status lx_lighting_lamps(struct lx_design_report *lighting);

/* Writes the tables of the finished document, and what they leave out, into the folder that is asked for. */
luxel_status lx_lighting_tables(const struct lx_design_report *lighting);

/* "609.91 ± 0.22" */
enum { LX_LIGHTING_CELL = 2 * 32 + 8 };
const char *lx_lighting_amount(const struct lx_report *report, luxel_bounded amount, char cell[LX_LIGHTING_CELL]);

/* Builds the document of the report, whose scene and texts are set. */
luxel_status lx_lighting_build(struct lx_report *report);

#endif
