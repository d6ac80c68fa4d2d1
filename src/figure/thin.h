/* SPDX-License-Identifier: MIT */
/*
 * Thinning of isophotes: where lines of several levels run nearer to each other than a reader can tell apart, those of
 * the lower levels are left out, so that a bundle of lines does not become a band.
 */
#ifndef LX_FIGURE_THIN_H
#define LX_FIGURE_THIN_H

#include "figure.h"

/* What was drawn so far of a map; zero-initialise, release with lx_thinning_clear(). */
struct lx_thinning {
    uint16_t *cells; /* 1 + the number of the level that runs through each; NULL: nothing is left out */
    size_t columns, rows;
    double x, y, cell;
};

/* For a rectangle of the map; without memory for it nothing is left out. */
void lx_thinning_begin(struct lx_thinning *thinning, const struct lx_pane *box);
void lx_thinning_clear(struct lx_thinning *thinning);

/* Adds what is to be drawn of a line of this level to the path of `cairo`, and takes it for drawn. */
void lx_thinning_add_line(struct lx_thinning *thinning, cairo_t *cairo, const struct lx_plot *plot,
                          const luxel_isophote *line, uint16_t level);

#endif
