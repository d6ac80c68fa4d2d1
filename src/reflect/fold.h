/* SPDX-License-Identifier: MIT */
/*
 * Folds: lines at which the light of a point jumps or bends at once, the rims of cones and the lines of a luminaire's
 * table.  Nodes of a cell that one of them crosses tell nothing of what is beside it between them, and windows of which
 * no node is lit would stay dark along all of a rim: cells there are cut by what the nodes may be off by.
 */
#ifndef LX_REFLECT_FOLD_H
#define LX_REFLECT_FOLD_H

#include "../world/prepared.h"
#include "tile.h"

struct lx_fold {
    const struct lx_emitter *emitter;
    struct lx_break place;
};

struct lx_folds {
    struct lx_fold *items;
    size_t count, capacity;
};

/* Folds of emitters, which have to stay where they are; of a table only those that bend it by more than `share` of its
 * flux.  0, or -1 when memory ran out; to be freed by lx_folds_clear() in any case. */
int lx_folds_make(const struct lx_emitters *emitters, double share, struct lx_folds *folds);
void lx_folds_clear(struct lx_folds *folds);

/* Fluxes that the nodes of a cell are off by, about: at jumps, where they may be too much or too little, and at bends,
 * where errors along one line have one sign. */
struct lx_beside {
    double jumps, bends;
};

/* Folds on a cell of a surface; `shadows` is the scene where no shadow begins on the cell, so that its middle tells
 * whether a light reaches it, else NULL. */
struct lx_beside lx_folds_beside(const struct lx_folds *folds, const struct lx_tile_cell *cell,
                                 const struct lx_prepared *shadows, size_t surface);

#endif
