/* SPDX-License-Identifier: MIT */
/*
 * Doubt: what the direct light of a window is not sure of, and how much of it may arrive at a place.  The kernel counts
 * with the greatest value that it has anywhere on the window.
 */
#ifndef LX_REFLECT_DOUBT_H
#define LX_REFLECT_DOUBT_H

#include "receiver.h"
#include "tile.h"

/* The kernel between a receiver and a place, the greatest one between it and a cell that is not near, as its nodes tell
 * it, and the greatest one between it and any place of a cell with nodes. */
double lx_kernel_at(const struct lx_receiver *receiver, const double place_mm[3], const double normal[3]);
double lx_kernel_of_nodes(const struct lx_receiver *receiver, const struct lx_tile_cell *cell);
double lx_greatest_kernel(const struct lx_receiver *receiver, const struct lx_matte_face *face,
                          const struct lx_tile_cell *cell);

/* Whether a receiver has a flat face, or some of it, before it and is before that. */
bool lx_looks_at(const struct lx_receiver *receiver, const struct lx_matte_face *flat);

/* The irradiance that the doubt of a window's direct light may be where the kernel is no greater than this and the
 * window takes so much of the view; what the last samples differ by is left out, and is in the other one. */
double lx_doubt_at(const struct lx_doubt *doubt, double kernel, double view);
double lx_doubt_differs(const struct lx_doubt *doubt, double kernel, double view);

/* Adds the doubt of one window to that of another. */
void lx_doubt_add(struct lx_doubt *sum, const struct lx_doubt *doubt);

/* Receivers to which tiles are near. */
struct lx_near {
    struct lx_receiver receiver;
    double least; /* irradiance that does not count there */
};

/* Sets those of `all` to which a cell of a face is so near that the kernel changes on it; returns how many. */
size_t lx_near_find(const struct lx_near *all, size_t count, const struct lx_matte_face *face,
                    const struct lx_tile_cell *cell, struct lx_near *found);
/* Whether the doubt of a window counts at any of them. */
bool lx_near_counts(const struct lx_near *near, size_t count, const struct lx_matte_face *face,
                    const struct lx_tile_cell *cell, const struct lx_doubt *doubt);

#endif
