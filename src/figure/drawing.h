/* SPDX-License-Identifier: MIT */
/* What the functions of luxel/drawing.h share: their arguments checked, a canvas of the caller's context. */
#ifndef LX_FIGURE_DRAWING_H
#define LX_FIGURE_DRAWING_H

#include <luxel/drawing.h>

#include "parts.h"

/* Whether a context can be drawn on in this style, on a rectangle that has a size. */
bool lx_can_draw(cairo_t *cairo, const luxel_drawing_style *style, double width, double height);

/* Whether the scale is one: finite, rising, above 0 where it is logarithmic. */
bool lx_scale_goes(const struct lx_scale *scale);
/* Whether the bar has a palette and a range. */
bool lx_bar_goes(const luxel_color_bar *bar);
struct lx_scale lx_bar_scale(const luxel_color_bar *bar);

/* Begins to draw, on the rectangle alone; ends it with what came of it. */
struct lx_canvas lx_drawing_begin(cairo_t *cairo, const luxel_drawing_style *style, double width, double height);
luxel_status lx_drawing_end(struct lx_canvas *canvas);

/* A canvas to measure on, on which nothing is drawn, and its end. */
struct lx_canvas lx_measuring_begin(const luxel_drawing_style *style, double width, double height);
luxel_status lx_measuring_end(struct lx_canvas *canvas);
/* Whether something of that size can be measured in this style. */
bool lx_can_measure(const luxel_drawing_style *style, double width, double height);
/* The frame of a plot that was fitted; `fits` false: there is no room for it. */
luxel_plot_frame lx_frame_of(const struct lx_plot *plot, bool fits);

/* Makes room for a plot's ticks and labels in its box; false: there is none left for the plot. */
bool lx_fit_plot(const struct lx_canvas *canvas, struct lx_plot *plot, const char *x_label, const char *y_label);

#endif
