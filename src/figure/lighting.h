/* SPDX-License-Identifier: MIT */
/* The report that a lighting designer hands over: what it is made of, computed once, and its parts. */
#ifndef LX_FIGURE_LIGHTING_H
#define LX_FIGURE_LIGHTING_H

#include <luxel/grid.h>
#include <luxel/limits.h>

#include "report.h"

/* The verdicts of one grid or observer. */
struct lx_judged {
    luxel_limit limits[LUXEL_MOST_LIMITS];
    size_t count;
};

struct lx_design_report {
    struct lx_report *report; /* the document, the scene, its balance; has no picture */
    luxel_grid **grids;
    struct lx_judged *of_grids;
    size_t grid_count;
    luxel_glare **glares; /* of the scene's observers */
    struct lx_judged *of_observers;
    size_t observer_count;
    double floor_m2; /* of the rooms; 0: there is none */
};

/* The direction that is up. */
const double *lx_lighting_up(const struct lx_design_report *lighting);

/* Sections, each with its heading. */
luxel_status lx_lighting_plan(struct lx_design_report *lighting);
luxel_status lx_lighting_lamps(struct lx_design_report *lighting);

/* "609.91 ± 0.22" */
enum { LX_LIGHTING_CELL = 2 * 32 + 8 };
const char *lx_lighting_amount(const struct lx_report *report, luxel_bounded amount, char cell[LX_LIGHTING_CELL]);

/* Builds the document of the report, whose scene and texts are set. */
luxel_status lx_lighting_build(struct lx_report *report);

#endif
