/* SPDX-License-Identifier: MIT */
/*
 * Shafts: which surfaces may stand between any place of a cell and any of a face, told once for all places of the cell.
 * A shaft is what holds two boxes along the axes and all ways between them (Haines and Wallace 1991).
 */
#ifndef LX_REFLECT_SHAFT_H
#define LX_REFLECT_SHAFT_H

#include "tile.h"

struct lx_shafts {
    struct lx_shaft_list {
        size_t first, last; /* among the surfaces */
        bool is_none;       /* nothing of it is seen */
    } * of;                 /* each face; NULL: all surfaces may stand anywhere */
    uint32_t *surfaces;
    size_t face_capacity, capacity;
};

struct lx_radiosity;

/* From a cell to all faces; 0, or -1 when memory ran out. */
int lx_shafts_set(const struct lx_radiosity *reflected, const struct lx_tile_cell *cell, struct lx_shafts *shafts);
void lx_shafts_clear(struct lx_shafts *shafts);

#endif
