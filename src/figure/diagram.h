/* SPDX-License-Identifier: MIT */
/* Diagrams of luminaires: what is drawn, and the parts that draw each kind. */
#ifndef LX_FIGURE_DIAGRAM_H
#define LX_FIGURE_DIAGRAM_H

#include <luxel/figure.h>

#include "../document/document.h"
#include "../format/lamp/photometry_section.h"
#include "canvas.h"

struct lx_diagram {
    luxel_diagram_settings settings;
    const luxel_photometry *photometry;
    luxel_photometry_figures figures;
    struct lx_section sections[2]; /* C0-C180 and C90-C270, or horizontal and vertical, in the unit shown */
    bool is_axial;                 /* both are the same */
    double greatest;               /* of both */
    const char *unit;
};

/* A text in the diagram's language. */
const char *lx_diagram_word(const struct lx_diagram *diagram, const char *english);

/* The name of a section. */
const char *lx_section_name(const struct lx_diagram *diagram, int which);

/* The colour of a curve alone, for areas; opacity from 0 to 1. */
void lx_curve_color(const struct lx_canvas *canvas, size_t curve, double opacity);

/* The colour and the dashes of a curve; the dashes stay until they are taken away. */
void lx_curve_line(const struct lx_canvas *canvas, size_t curve, double size);

/* Names of curves with their lines, from a place on within a width; returns where they end. */
double lx_draw_names(const struct lx_canvas *canvas, const struct lx_pane *place, double size, const char *const *names,
                     const size_t *curves, size_t count, bool drawn);

/* Each draws from the top of the place on within its width, or only measures; returns where it ends. */
double lx_draw_polar(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                     double size, bool drawn);
double lx_draw_cartesian(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                         double size, bool drawn);
double lx_draw_cone(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                    double size, bool drawn);

/* Adds the polar and the Cartesian diagram to a document, side by side. */
luxel_status lx_diagram_add(const luxel_photometry *photometry, const luxel_language *language,
                            struct luxel_document *document, luxel_diagnostics *diagnostics);

#endif
