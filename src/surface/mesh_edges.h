/* SPDX-License-Identifier: MIT */
/* The edges of a mesh, and those of them that are outlines as a place sees it. */
#ifndef LX_SURFACE_MESH_EDGES_H
#define LX_SURFACE_MESH_EDGES_H

#include "mesh_tree.h"

/* Makes the edges of a tree that has its nodes and triangles; 0, or -1 when memory ran out. */
int lx_tree_make_edges(struct lx_mesh_tree *tree);
void lx_tree_free_edges(struct lx_mesh_tree *tree);

/* 1 where the corners of a triangle run counter-clockwise about the way to it, as its determinant with a place tells,
 * else -1. */
int lx_triangle_turn(const struct lx_tree_triangle *triangle, const double place[3]);

/*
 * A search for the outlines of a mesh that a place sees: for each edge in boxes that `meets` is true of, along which
 * faces do not go on behind it, `take_edge` is called with the number of faces that there are more on the left of the
 * way from one end to the other than on its right; faces that the place lies on, to `touch`, count for nothing.  All
 * triangles of boxes that `reaches_beyond` is true of, too, but for these, go to `take_triangle`.  All in the frame of
 * the tree.
 */
struct lx_tree_outline {
    double place[3], touch;
    bool (*meets)(const void *data, const double low[3], const double high[3]);
    bool (*reaches_beyond)(const void *data, const double low[3], const double high[3]);
    bool (*take_edge)(void *data, const double from[3], const double to[3], int change);
    bool (*take_triangle)(void *data, const struct lx_tree_triangle *triangle);
    void *data;
};

/* False: a call of these stopped it. */
bool lx_tree_outline(const struct lx_mesh_tree *tree, const struct lx_tree_outline *outline);

#endif
