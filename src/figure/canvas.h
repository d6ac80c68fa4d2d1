/* SPDX-License-Identifier: MIT */
/* A canvas: a cairo context with texts by pango, measured before they are placed.  Lengths are points. */
#ifndef LX_FIGURE_CANVAS_H
#define LX_FIGURE_CANVAS_H

#include <cairo.h>
#include <stdbool.h>
#include <stddef.h>

struct lx_canvas {
    cairo_t *cairo;
    void *fonts; /* a PangoContext; made and freed with the canvas */
    double ink[3], ground[3], faint[3];
    char decimal_mark; /* of ticks */
};

struct lx_pane {
    double x, y, width, height;
};

/* `dark`: light ink on a dark ground. */
struct lx_canvas lx_canvas_of(cairo_t *cairo, bool dark);
/* With colours of one's own. */
struct lx_canvas lx_canvas_in(cairo_t *cairo, const double ink[3], const double ground[3]);
void lx_canvas_clear(struct lx_canvas *canvas);

/* How a text stands: its size, weight, its colour (NULL: ink), and where it is wrapped (0: not). */
struct lx_type {
    double size;
    bool bold;
    const double *color;
    double wrap;
    const double *halo; /* the colour of a seam around the letters; NULL: none */
    bool centered;      /* wrapped lines around their middle */
};

/* Width and height of a text. */
struct lx_pane lx_measure(const struct lx_canvas *canvas, const char *text, const struct lx_type *type);

/*
 * Draws a text so that the point of it at (across, down), shares of its width and height, stands at (x, y); turned
 * around that point by an angle in radians, clockwise.
 */
void lx_write(const struct lx_canvas *canvas, const char *text, const struct lx_type *type, double x, double y,
              double across, double down, double turned);

void lx_color(const struct lx_canvas *canvas, const double color[3], double opacity);

#endif
