/* SPDX-License-Identifier: MIT */
/*
 * Drawings for programs of computer-aided design: lines and words in space on named layers, as DXF of release 12, which
 * all of them read.  That has no unit of lengths: a comment at its head may say which it is.
 */
#ifndef LX_FORMAT_DXF_H
#define LX_FORMAT_DXF_H

#include "../base/text.h"

enum { LX_DXF_NAME = 32 }; /* room for the name of a layer */

struct lx_dxf_layer {
    char name[LX_DXF_NAME];
    int color; /* 1 red, 2 yellow, 3 green, 4 cyan, 5 blue, 6 magenta, 7 black or white */
};

/* A drawing in the making; begin with {0}. */
struct lx_dxf {
    struct lx_text entities;
    struct lx_dxf_layer *layers;
    size_t layer_count, layer_capacity;
    double low[3], high[3]; /* around all that is drawn, once there is something */
    bool has_extent;
};

/* Makes a name one that layers may have: capitals, digits, $, - and _; a layer of this name is had from then on. */
void lx_dxf_add_layer(struct lx_dxf *dxf, struct lx_dxf_layer *layer);

/* A line from place to place, of three coordinates each; a closed one comes back to the first. */
void lx_dxf_add_line(struct lx_dxf *dxf, const struct lx_dxf_layer *layer, const double (*places)[3], size_t count,
                     bool is_closed);

/* Words that begin at a place, run along a unit vector and are read against another at right angles to it. */
struct lx_dxf_words {
    double place[3], along[3], normal[3];
    double height;
    const char *text;
};
void lx_dxf_add_words(struct lx_dxf *dxf, const struct lx_dxf_layer *layer, const struct lx_dxf_words *words);

/* Adds the whole drawing to a text, and clears it; the text has failed where memory ran out. */
void lx_dxf_finish(struct lx_dxf *dxf, const char *comment, struct lx_text *text);

#endif
