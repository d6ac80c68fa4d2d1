/* SPDX-License-Identifier: MIT */
/* What the parts of finding isophotes share: nodes between which values are looked at, and segments of lines. */
#ifndef LX_FIELD_ISOPHOTES_H
#define LX_FIELD_ISOPHOTES_H

#include <luxel/isophotes.h>

#include "../shade/evaluate.h"
#include "field.h"

/*
 * A grid of nodes: the pixels' samples and, with an evaluator, the edges of the screen around them.
 *
 * `surface` is that which is seen at a node, from 1; 0: none, or no value.  With an evaluator the values of nodes near
 * the edge of a surface are exact, the others those of the picture.
 */
struct lx_nodes {
    unsigned columns, rows;
    double *x_mm, *y_mm;
    double *values;
    uint32_t *surface;
    uint8_t *exact;                          /* whether the value is the evaluator's */
    double doubt;                            /* how far a value that is not exact may be off */
    double scale;                            /* the greatest magnitude of a value */
    const struct luxel_evaluator *evaluator; /* NULL: the picture alone */
};

/* A piece of a line within a cell, the greater values at its left.  Equal keys are the same place. */
struct lx_segment {
    uint64_t from_key, to_key;
    double from[2], to[2];
};

struct lx_segments {
    struct lx_segment *items;
    size_t count, capacity;
    bool failed; /* memory ran out */
};

/*
 * Adds the segments of a row of cells, that between the nodes of `row` and of row + 1: for each of `count` levels to the
 * segments of its own.
 */
void lx_march_row(const struct lx_nodes *nodes, const double *levels, size_t count, unsigned row,
                  struct lx_segments *segments);

/* Lines made of segments, in their order; 0, or -1 when memory ran out. */
struct lx_lines {
    luxel_isophote *items;
    size_t count, capacity;
};
int lx_chain_segments(const struct lx_segments *segments, double level, struct lx_lines *lines);

#endif
