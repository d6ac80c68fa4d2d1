/* SPDX-License-Identifier: MIT */
/*
 * Work within what effort is left, and what is told of tiles for which there is none.  The values are the best
 * that is known: direct light as its first samples are, or else half of what would arrive if nothing hid the sources,
 * and what they receive from others as in a sphere of as much area and light.  The errors reach from there to nothing,
 * and to all that would arrive so, or to a ceiling of what others can send.
 */
#ifndef LX_REFLECT_WITHIN_H
#define LX_REFLECT_WITHIN_H

#include "links.h"
#include "solution.h"

/*
 * Pieces of work first to last - 1, as in lx_rows_work; the effort of piece i is counted in, and bounded by,
 * reflected->efforts[i].  A piece with no effort left is to end at once.
 */
struct lx_within {
    size_t count;
    double share; /* of the effort that is left, which all pieces together may take */
    lx_rows_work *work;
    void *data;
};

/* Does the pieces in blocks, after each of which it is counted what they took, so that which ones have effort does not
 * depend on threads.  LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_within_run(struct lx_radiosity *reflected, const struct lx_within *within);

/* Whether the work goes on, as the calling thread asks: nobody wishes it to stop, nor is its end reached. */
bool lx_within_goes_on(const struct lx_radiosity *reflected);

/* Tells the control what share of a solution is done: by effort, of which less than all may be taken. */
void lx_within_tell(const struct lx_radiosity *reflected, double done);

/* Sets the order in which tiles are worked on: the largest ones first.  0, or -1 when memory ran out. */
int lx_within_order(struct lx_radiosity *reflected);

/* Rows of a cell of a face; false: there was no effort left for them, or memory ran out, which the cones then tell. */
bool lx_within_rows(const struct lx_radiosity *reflected, struct lx_effort *effort, uint32_t face,
                    const struct lx_window *window, const struct lx_tile_cell *cell, struct lx_occluder_cones *cones,
                    struct lx_rows **rows);

/* Direct light of a tile by what would arrive if nothing hid it, and by what its first samples told at the nodes; NULL:
 * there are none.  0, or -1. */
int lx_within_guess(const struct lx_radiosity *reflected, const struct lx_asking *asking, const double *told,
                    struct lx_tile *tile);

/* Sets what is known of the tiles that are blind, where nothing is yet.  0, or -1 when memory ran out. */
int lx_within_ceilings(struct lx_radiosity *reflected);

#endif
