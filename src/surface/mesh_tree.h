/* SPDX-License-Identifier: MIT */
/*
 * The tree of a mesh: a bounding volume hierarchy over its triangles, binary, built by the surface area heuristic over
 * bins (Wald 2007), in a frame of its own: the middle of the mesh is its origin, and a power of two brings its size
 * near 1, so that one tree serves whatever the scale and the place of a mesh are.
 *
 * A ray and a triangle are compared as by Woop, Benthin, Wald (Watertight ray/triangle intersection, JCGT 2, 2013), in
 * float64: corners are sheared so that the ray is the third axis, and the signs of three determinants tell.  A corner
 * is sheared in the same way for all its triangles, and where rounding leaves a sign in doubt it is found without
 * rounding, so that neighbours never disagree: no ray passes between two triangles of a closed mesh, and every machine
 * gets the same answer.
 */
#ifndef LX_SURFACE_MESH_TREE_H
#define LX_SURFACE_MESH_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../format/kept.h"

/* Two branches: the low ends of both along an axis, then the high ones, rounded outwards with LX_TREE_ROOM. */
struct lx_tree_node {
    float ends[3][4];
    uint32_t child[2]; /* a node, or the first triangle of a leaf */
    uint32_t count[2]; /* of triangles in a leaf; LX_TREE_BRANCH: a node */
};
#define LX_TREE_BRANCH UINT32_MAX

/* A triangle of the tree: its corners, and which of the mesh it is. */
struct lx_tree_triangle {
    double corners[3][3];
    uint32_t number;
    uint32_t names[3]; /* of the corners: the same place has one name */
};

/* An edge: its ends, each a triangle times 4 and one of its corners, and the faces along it. */
struct lx_tree_edge {
    uint32_t ends[2], first, count;
};

/* Around normals of faces, on both sides of which the cosine and the sine are those of its half angle. */
struct lx_tree_cone {
    float axis[3], sine, cosine;
    bool is_known;
};

/* The edges (mesh_edges.h), by the triangles that own them: those of triangle t from owned[t] to owned[t + 1]. */
struct lx_tree_edges {
    struct lx_tree_edge *items;
    uint32_t *faces, *owned;    /* a face: the triangle times 2, and 1 if it runs from the first end to the second */
    struct lx_tree_cone *cones; /* of both sides of each node */
};

struct lx_mesh_tree {
    struct lx_kept kept;
    struct lx_tree_node *nodes;
    struct lx_tree_triangle *triangles; /* leaf by leaf */
    uint32_t *places;                   /* where each triangle of the mesh is among them */
    size_t node_count, triangle_count;
    struct lx_tree_edges edges;
    double middle[3], unit;           /* a place p of the file is (p - middle)/unit in the tree */
    double low[3], high[3], farthest; /* the box around it and the greatest distance from the origin, in the tree */
};

/* Boxes are that much larger than what they hold: more than float32 loses of rays that pass through the tree. */
#define LX_TREE_ROOM 2e-6F

/* NULL: memory ran out.  The triangles, by the numbers of their corners, of which there is at least one. */
struct lx_mesh_tree *lx_mesh_tree_new(const double (*corners)[3], const unsigned (*triangles)[3], size_t count);

/* A line in the tree's frame, from origin + from direction to origin + to direction (HUGE_VAL: without end). */
struct lx_tree_ray {
    double origin[3], direction[3], from, to;
};

/* A triangle that a line meets, and where. */
struct lx_tree_hit {
    const struct lx_tree_triangle *triangle; /* NULL: none */
    double t, place[3];
    bool is_front; /* its corners run counter-clockwise as seen from where the ray comes from */
};

/* The first that a line meets, of the fronts only or of all. */
struct lx_tree_hit lx_tree_first(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, bool fronts_only);

/* Whether a line meets any that is farther from its origin than `touch`, and from its end. */
bool lx_tree_is_met(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, double touch);

/* How many of them it meets. */
unsigned lx_tree_count(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, double touch);

/* Triangles that a line may meet, all whose box it passes, one a call: the next one, or NULL in the end. */
enum { LX_TREE_DEPTH = 96 };
struct lx_tree_walk {
    const struct lx_mesh_tree *tree;
    float origin[3], inverse[3], from, to;
    uint32_t stack[LX_TREE_DEPTH];
    float entries[LX_TREE_DEPTH]; /* where the ray enters what waits there */
    unsigned depth;
    uint32_t next, last; /* of the leaf that is walked through */
};
void lx_tree_begin(struct lx_tree_walk *walk, const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray);
const struct lx_tree_triangle *lx_tree_next(struct lx_tree_walk *walk);

/* The triangle nearest to a place, no farther than `most`; of some equally near the first one.  NULL: none is. */
const struct lx_tree_triangle *lx_tree_nearest(const struct lx_mesh_tree *tree, const double place[3], double most,
                                               double *distance);

/* The square of the distance from a place to a triangle. */
double lx_triangle_square(const struct lx_tree_triangle *triangle, const double place[3]);

/* Whether a closed mesh has a place inside, by a ray from it: the number of fronts and backs that it passes. */
bool lx_tree_is_inside(const struct lx_mesh_tree *tree, const double place[3]);

#endif
