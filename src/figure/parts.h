/* SPDX-License-Identifier: MIT */
/* The parts of figures that can stand alone: a colour bar, curves, their legend.  They know nothing of the figure. */
#ifndef LX_FIGURE_PARTS_H
#define LX_FIGURE_PARTS_H

#include <luxel/profile.h>

#include "axes.h"

/* A scale in the colours of a palette. */
struct lx_bar {
    const char *palette;
    struct lx_scale scale;
    const char *label;    /* NULL: none */
    const double *levels; /* rising */
    size_t level_count;
    bool stepped;              /* one colour from each level to the next */
    bool lined;                /* a line across it at each level */
    bool has_below, has_above; /* values beyond it: pointed there */
    bool lying;                /* from left to right, ticks and label below; else upright, with them at its right */
};

/* How much room a bar of this length takes across, with its ticks and label. */
double lx_bar_room(const struct lx_bar *bar, const struct lx_canvas *canvas, double length, double size);
void lx_draw_bar(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *place, double size);

/* What curves are drawn along. */
enum lx_along { LX_ALONG_X, LX_ALONG_Y, LX_ALONG_WAY };

/* A profile: the whole, and the shares of some lights where these are more than one. */
struct lx_curves {
    const luxel_profile *profile;
    enum lx_along along;
    const size_t *lights; /* which of the profile's, in this order */
    size_t light_count;
    bool stacked; /* the shares on top of each other, else as lines */
};

/* Where a sample lies along them. */
double lx_curves_place(const struct lx_curves *curves, size_t i);
/* Draws the curves into a plot, whose axes are drawn before. */
void lx_draw_curves(const struct lx_curves *curves, const struct lx_canvas *canvas, const struct lx_plot *plot);

/* The colour of a light on a ground, by which it is known wherever it is drawn. */
void lx_light_color(const double ground[3], size_t light, double color[3]);
/* The colour of a light's shares; sets the line's dashes, too, which tell those apart whose colours are the same. */
void lx_light_line(const struct lx_canvas *canvas, size_t light, bool stacked, double size, double color[3]);

/* The names of the curves. */
struct lx_legend {
    const char *const *names; /* of the lights */
    size_t count;
    const char *whole; /* of the sum */
    bool stacked;
};

/* Draws it, or only measures, from the place's top on and within its width; returns where it ends.  A single light has
 * none. */
double lx_draw_legend(const struct lx_legend *legend, const struct lx_canvas *canvas, const struct lx_pane *place,
                      double size, bool drawn);

/* From 0 (black) to 1 (white). */
double lx_lightness(const double color[3]);

#endif
