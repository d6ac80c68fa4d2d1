/* SPDX-License-Identifier: MIT */
/*
 * Edges of light on a plane: where a cone ends, a source sets, or a surface begins to hide one.  On a plane each is a
 * conic, q(u, v) = 0 with a polynomial of the second degree in the coordinates along its sides; so the places where a
 * line crosses it, and the lines between which it lies, are known, and an integral can begin and end there.
 */
#ifndef LX_SHADE_FLUX_EDGES_H
#define LX_SHADE_FLUX_EDGES_H

#include "cells.h"

enum { LX_MOST_EDGES = 96 };

/* q(u, v) = c[0] + c[1] u + c[2] v + c[3] u^2 + c[4] u v + c[5] v^2, u and v from -1/2 to 1/2 on the plane. */
struct lx_edge_conic {
    double c[6];
};

struct lx_edges {
    struct lx_edge_conic conics[LX_MOST_EDGES];
    size_t count; /* more are left out */
};

/* Adds the edges of an emitter on the plane, and of the surfaces that may stand before it where it `may_be_hidden`. */
void lx_edges_add(const struct lx_prepared *prepared, const struct lx_cells *plane, const struct lx_emitter *emitter,
                  bool may_be_hidden, struct lx_edges *edges);

/* Where the edges cross the line v across the plane: writes up to `most` of u within it, and returns how many. */
size_t lx_edges_across(const struct lx_edges *edges, double v, double *u, size_t most);

/* The v at which what they cross changes: at their tops and bottoms, where two of them meet, at the plane's sides. */
size_t lx_edges_turn(const struct lx_edges *edges, double *v, size_t most);

#endif
