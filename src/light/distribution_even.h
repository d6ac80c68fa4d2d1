/* SPDX-License-Identifier: MIT */
/*
 * The table of a distribution on lines that are all equally far apart, where each of its own lines is one of them: then
 * the cell that two angles lie in is counted and need not be searched.  Between lines that were there before the new
 * ones change nothing, as the function is linear there.  Pictures look up cells so (picture/polynomial/tabled.h).
 */
#ifndef LX_LIGHT_DISTRIBUTION_EVEN_H
#define LX_LIGHT_DISTRIBUTION_EVEN_H

#include <stdbool.h>
#include <stddef.h>

/* Equal cells along one angle. */
struct lx_even_lines {
    size_t cells;
    double start, per_radian; /* where the first one begins, in radians; cells a radian */
    bool is_closed[2];        /* there is no dark before the first, or beyond the last: a pole, or the seam of a turn */
};

/* In a cell the function is cell[0] + s cell[1] + t (cell[2] + s cell[3]), s the share of the polar step that is behind
 * a direction and t that of the azimuth. */
typedef float lx_even_cell[4];

struct lx_distribution;
struct lx_even_table {
    struct lx_even_lines azimuth, polar; /* azimuth: one cell where it does not matter */
    bool is_turn;                        /* behind the last cell of the azimuth comes the first one again */
    double *cosines;                     /* of the polar lines */
    lx_even_cell *cells;                 /* by azimuth, then by polar angle; NULL: there is no such table */
};

/* The extent of a function in some cells: its greatest value, and by how much it changes in a cell along each angle. */
struct lx_even_extent {
    double greatest, along, across;
};

/* Makes it of the lines and values of a distribution.  False: memory ran out.  What has steps with no common measure,
 * or would be too large, has no such table. */
bool lx_even_table_make(const struct lx_distribution *distribution, struct lx_even_table *even);
void lx_even_table_clear(struct lx_even_table *even);

/* The extent of the function in `count` cells from a first one on, [0] of the azimuth and [1] of the polar angle. */
struct lx_even_extent lx_even_extent_of(const struct lx_even_table *even, const size_t first[2], const size_t count[2]);

#endif
