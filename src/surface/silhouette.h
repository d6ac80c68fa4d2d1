/* SPDX-License-Identifier: MIT */
/*
 * The silhouette of a mesh seen from afar: what of a plane it covers, as closed lines, for drawings.  It is traced on
 * a square of LX_SILHOUETTE_CELLS cells, of which every one is covered that a triangle touches, so it is up to one
 * cell larger than the mesh, and its lines leave the borders of the cells by at most 1.25 of them.
 */
#ifndef LX_SURFACE_SILHOUETTE_H
#define LX_SURFACE_SILHOUETTE_H

#include "mesh_tree.h"

enum { LX_SILHOUETTE_CELLS = 1024 }; /* along the longer side */

/* Closed lines one after the other: counter-clockwise around what is covered, clockwise around what is not. */
struct lx_silhouette {
    double (*places)[2];
    size_t place_count, place_room;
    size_t *ends; /* of each line: where the next one begins */
    size_t line_count, line_room;
};

/* Fills an empty silhouette, seen with `right` and `up` (any vectors in the tree's frame) along its axes; 0, or -1 when
 * memory ran out. */
int lx_trace_silhouette(const struct lx_mesh_tree *tree, const double right[3], const double up[3],
                        struct lx_silhouette *silhouette);

void lx_clear_silhouette(struct lx_silhouette *silhouette);

#endif
