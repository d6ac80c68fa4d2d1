/* SPDX-License-Identifier: MIT */
/* Scales and axes: from values to places on a canvas, with round ticks and their labels. */
#ifndef LX_FIGURE_AXES_H
#define LX_FIGURE_AXES_H

#include "canvas.h"

enum { LX_MOST_TICKS = 64, LX_TICK_TEXT = 40 };

/* A range of values along a length. */
struct lx_scale {
    double low, high; /* low < high; along the axes of a plot also the other way round, if not logarithmic */
    bool logarithmic; /* then both are above 0 */
};

/* Where a value lies: 0 at low, 1 at high; beyond them outside. */
double lx_scale_place(const struct lx_scale *scale, double value);

struct lx_ticks {
    double values[LX_MOST_TICKS];
    char texts[LX_MOST_TICKS][LX_TICK_TEXT];
    size_t count;
};

/* About `wanted` round values of a scale, its ends included where they are round. */
struct lx_ticks lx_ticks_of(const struct lx_scale *scale, size_t wanted);

/* At most so many of them, fewer where their labels would not stand apart on a length; `upright`: along y. */
struct lx_ticks lx_ticks_along(const struct lx_canvas *canvas, const struct lx_scale *scale, double length, double size,
                               bool upright, size_t most);

/* A value as bars and isophotes write it. */
const char *lx_tick_text(double value, char buffer[LX_TICK_TEXT]);

/* A rectangle with two scales. */
struct lx_plot {
    struct lx_pane box;
    struct lx_scale x, y;
    double size; /* of the letters */
};

double lx_plot_x(const struct lx_plot *plot, double value);
double lx_plot_y(const struct lx_plot *plot, double value);

/* What stands around a plot's box: the room that ticks and labels (NULL: none) need; a long label is wrapped along its
 * axis. */
struct lx_margins {
    double left, right, above, below;
};
struct lx_margins lx_plot_margins(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *x_label,
                                  const char *y_label);

/* Draws frame, ticks and labels (NULL: none); `grid`: faint lines at the ticks. */
void lx_draw_axes(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *x_label, const char *y_label,
                  bool grid);

#endif
