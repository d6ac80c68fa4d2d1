/* SPDX-License-Identifier: MIT */
/* The marks of a map and the texts beside marks and on lines: placed before anything is drawn, so that no text covers
 * another one, a mark, the frame, or more of the lines than it must. */
#ifndef LX_FIGURE_LABELS_H
#define LX_FIGURE_LABELS_H

#include "figure.h"

enum { LX_MOST_LABELS = 512, LX_LABEL_TEXT = 48, LX_LABEL_CELLS = 256 };

/* A rectangle turned around its middle, clockwise. */
struct lx_label_patch {
    double x, y, width, height, angle;
};

enum lx_mark_type { LX_MARK_NONE, LX_MARK_RING, LX_MARK_CROSS, LX_MARK_LAMP };

struct lx_label {
    enum lx_mark_type mark; /* what it marks, at `marked`; LX_MARK_NONE: a line, or the value at a point */
    double marked[2];
    char text[LX_LABEL_TEXT]; /* empty: there was no room for it */
    struct lx_label_patch patch;
    bool led; /* so far from the mark that a line leads to it */
    double mark_color[3], color[3], halo[3];
};

struct lx_labels {
    struct lx_label labels[LX_MOST_LABELS];
    size_t count;
    struct lx_label_patch marks[LX_MOST_LABELS]; /* the room that marks take */
    size_t mark_count;
    const struct lx_figure *figure;
    const struct lx_canvas *canvas;
    const struct lx_plot *plot;
    double size; /* of the letters */
    /* which line runs through each cell: 0 none, else 1 + its index; LX_CELL_SHARED several, or an outline */
    uint16_t cells[LX_LABEL_CELLS][LX_LABEL_CELLS];
    double (*track)[3]; /* of one line: where it goes, and its length so far; room for the longest one */
    size_t *order;      /* the lines, the longest first */
};

/* Room for the labels of a figure whose isophotes are known; 0, or -1 when memory ran out. */
int lx_labels_prepare(struct lx_figure *figure);
void lx_labels_free(struct lx_labels *labels);

/* Places all labels of the map. */
void lx_place_labels(struct lx_labels *labels, const struct lx_figure *figure, const struct lx_canvas *canvas,
                     const struct lx_plot *plot);

/* Leaves the labels out of what is drawn next. */
void lx_clip_labels(const struct lx_labels *labels);

void lx_draw_labels(const struct lx_labels *labels);

#endif
