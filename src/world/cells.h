/* SPDX-License-Identifier: MIT */
/*
 * The cells of a measuring grid as free surface elements.  Row 0 is the top one, farthest along up; column 0 is the
 * first along up x axis.
 */
#ifndef LX_WORLD_CELLS_H
#define LX_WORLD_CELLS_H

#include "../base/pose.h"
#include "reference.h"

struct lx_cells {
    struct lx_pose pose;
    lx_bounded3 normal;
    double center_mm[3];
    double size_mm[2]; /* across, upward */
    unsigned n[2];     /* columns, rows */
};

/* The cells of a grid of a committed scene. */
struct lx_cells lx_cells_of(const struct lx_grid *grid);

/* The centre of a cell. */
lx_bounded3 lx_cell_place(const struct lx_cells *cells, unsigned column, unsigned row);

/* The place of the plane that is so far from its middle, across and upward, in float64. */
void lx_place_on_cells(const struct lx_cells *cells, const double at_mm[2], double place_mm[3]);

/* The ways from the middle to one column or row, by coordinates, and where they lead by themselves. */
struct lx_lattice_line {
    lx_wide way[3];
    lx_bounded alone[3];
};

/* All columns and rows, for many cells: the same places, but quickly, above all where sides run along axes. */
struct lx_lattice {
    struct lx_cells cells;
    struct lx_lattice_line *lines[2];
    unsigned sides[3]; /* which sides each coordinate changes along: 1, across, and 2, upward, or both */
};

/* 0, or -1 when memory ran out; clear it in any case. */
int lx_lattice_make(const struct lx_cells *cells, struct lx_lattice *lattice);
void lx_lattice_clear(struct lx_lattice *lattice);

/* lx_cell_place(). */
lx_bounded3 lx_lattice_place(const struct lx_lattice *lattice, unsigned column, unsigned row);

#endif
