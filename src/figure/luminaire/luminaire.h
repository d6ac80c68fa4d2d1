/* SPDX-License-Identifier: MIT */
/* The sheet of a luminaire: what it is made of, computed once, and its parts. */
#ifndef LX_FIGURE_LUMINAIRE_H
#define LX_FIGURE_LUMINAIRE_H

#include <luxel/figure.h>
#include <luxel/glare.h>
#include <luxel/utilization.h>

#include "../../document/document.h"

enum {
    LX_SHEET_TRIPLE = 2, /* ceiling 70, walls 50, floor 20 % */
    LX_SHEET_ROOMS = 5   /* that are solved with reflections: larger ones take minutes */
};

struct lx_luminaire_sheet {
    const luxel_photometry *photometry;
    const luxel_sheet_settings *texts;
    luxel_diagnostics *diagnostics;
    struct luxel_document *document;
    luxel_photometry_figures figures;
    luxel_bug_rating bug;
    luxel_ugr_table glare;
    luxel_utilization_table utilization;
    luxel_room_utilization reflected[LX_SHEET_ROOMS]; /* of LX_SHEET_TRIPLE */
    bool has_reflected;
};

/* Sections, each with its heading, where there is something to tell. */
void lx_sheet_intensities(const struct lx_luminaire_sheet *sheet);
luxel_status lx_sheet_zones(const struct lx_luminaire_sheet *sheet);
void lx_sheet_luminances(const struct lx_luminaire_sheet *sheet);
void lx_sheet_utilization(const struct lx_luminaire_sheet *sheet);
void lx_sheet_glare(const struct lx_luminaire_sheet *sheet);
void lx_sheet_bug(const struct lx_luminaire_sheet *sheet);

#endif
