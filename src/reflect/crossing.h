/* SPDX-License-Identifier: MIT */
/*
 * Crossings: outlines whose shadows begin on a cell.  Light between two of them, as from the sun through a gap between
 * boards, the shadow of something thin, and what is beside a single one at the border of a cell may fall between its
 * nodes.  Here it is told from geometry how much light the nodes are off by; where one shadow begins on a cell, or both
 * of a strip, they are put right.
 */
#ifndef LX_REFLECT_CROSSING_H
#define LX_REFLECT_CROSSING_H

#include "outline.h"
#include "tile.h"

struct lx_crossings {
    uint32_t *items; /* which outlines, of all */
    size_t count;
    double irradiance; /* that the nodes are off by, once they are put right: about, of lights without size, */
    double share;      /* and the share of the cell, for those of some size */
    double correction[LX_RULE_NODES]; /* of the irradiance at the nodes */
};

/* Finds the crossings on a cell of a face among those on a larger one, or among all outlines (NULL); in items of *found
 * there is room for as many. */
void lx_crossings_find(const struct lx_outlines *outlines, const struct lx_matte_face *face,
                       const struct lx_tile_cell *cell, const struct lx_crossings *larger, struct lx_crossings *found);

#endif
