/* SPDX-License-Identifier: MIT */
/* Putting facets together; shared by the files that make them. */
#ifndef LX_LIGHT_FACETS_MAKE_H
#define LX_LIGHT_FACETS_MAKE_H

#include "facets.h"

/* Deviations from a plane and from convexity up to this share of the size are taken for roundings of the author. */
#define LX_SHAPE_TOLERANCE 1e-6

/* Facets with room for corners, faces, and the corners of all faces, all to be filled in; NULL: out of memory. */
struct lx_facets *lx_facets_new(size_t corner_count, size_t face_count, size_t loop_count);

/* Ends a face whose corners have been put into the loop behind those of the faces before it. */
void lx_facets_add_face(struct lx_facets *facets, unsigned count);

/* Finds normals, areas, edges and the sphere around it when corners and faces are there.  `closed`: every edge must
 * have one partner.  Work that is to stop ends as where memory ran out. */
struct lx_shape_report lx_facets_finish(struct lx_facets *facets, bool closed, const struct lx_asking *asking);

/* Says that corners are only what wide numbers can tell, some sixty operations of them; NULL is harmless. */
void lx_facets_were_rounded(struct lx_facets *facets);

/* The plane that some corners lie in, or nearly so. */
struct lx_plane {
    lx_wide3 normal, middle_mm;
    double size_mm;      /* twice the largest distance of a corner from the middle, whichever corner is the first */
    double deviation_mm; /* the largest distance of a corner from the plane */
    size_t farthest;     /* the corner that has it */
    bool is_line;        /* all corners lie on a line */
    bool has_area;       /* the areas to the left and to the right of the loop do not cancel */
};

struct lx_plane lx_best_plane(const lx_wide3 *corners_mm, const unsigned *loop, size_t count);

/* Brings corners into a plane by leaving out a coordinate: what was counter-clockwise about the normal still is. */
void lx_flatten(const lx_wide3 *corners_mm, const unsigned *loop, size_t count, lx_wide3 normal, lx_wide (*xy)[2]);

/* Looks for edges of a polygon that meet where they should not. */
struct lx_shape_report lx_find_crossing(const lx_wide (*xy)[2], size_t count);

/* Whether the polygon with the corners xy[loop[0]] ... turns to the left, or not at all, in every one. */
bool lx_turns_left(const lx_wide (*xy)[2], const unsigned *loop, size_t count);

/*
 * Cuts a simple polygon with the corners xy[loop[0]] ..., counter-clockwise, into triangles, or, `joined`, into
 * convex polygons.  They stand in
 * pieces[] one behind another, each as the numbers of its corners, and piece_counts[] tells how many each has; there
 * is room for 3 count numbers and count pieces.  The number of pieces; 0 when memory ran out.
 */
size_t lx_cut_outline(const lx_wide (*xy)[2], const unsigned *loop, size_t count, unsigned *pieces,
                      unsigned *piece_counts, bool joined);

#endif
