/* SPDX-License-Identifier: MIT */
/*
 * The flat faces of an extended emitter: a convex polygon, or the surface of a convex polyhedron.  facets.h makes them.
 *
 * Corners are wide because a corner made of centre, size and axis is no float64 number, and an element next to it
 * would see the difference.
 */
#ifndef LX_LIGHT_AREA_LIGHT_FACETS_H
#define LX_LIGHT_AREA_LIGHT_FACETS_H

#include <stddef.h>

#include "../../base/wide.h"
#include "../../format/kept.h"

enum { LX_NO_FACE = -1 };

/* A convex face: the corners loop[first] ... in counter-clockwise order as seen from the side that it shines to. */
struct lx_face {
    unsigned first, count;
    lx_wide3 normal; /* unit */
    double area_mm2;
};

/* An edge runs from one corner to another along the loop of the face `left`; `right`, the face beyond it, runs along
 * it the other way; LX_NO_FACE where there is none. */
struct lx_edge {
    unsigned from, to;
    int left, right;
};

struct lx_facets {
    struct lx_kept kept; /* several emitters may use them */
    lx_wide3 *corners_mm;
    size_t corner_count;
    unsigned *loop;
    struct lx_face *faces;
    size_t face_count;
    struct lx_edge *edges;
    size_t edge_count;
    double center_mm[3];    /* of a sphere around it, near to the centroid */
    double radius_mm;       /* of that sphere */
    double area_mm2;        /* of all faces */
    double corner_error_mm; /* how far the corners may be from where they should be: 0 where nothing was rounded */
};

/* Takes one user away, the last with all of it; NULL is harmless. */
void lx_facets_free(struct lx_facets *facets);

#endif
