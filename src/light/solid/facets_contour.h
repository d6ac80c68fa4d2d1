/* SPDX-License-Identifier: MIT */
/*
 * The area that a contour encloses as an element sees it: of the contour's image on the unit sphere around the
 * element, projected into the element's plane (Nusselt's analogy), what lies above the horizon.
 */
#ifndef LX_LIGHT_FACETS_CONTOUR_H
#define LX_LIGHT_FACETS_CONTOUR_H

#include "area_light_facets.h"

/* A place on the contour. */
struct lx_contour_vertex {
    lx_wide3 a;       /* from the element, scaled */
    lx_wide3 w;       /* from the base, scaled */
    lx_wide distance; /* |a| */
    lx_wide height;   /* above the horizon */
    lx_wide3 d;       /* its direction minus that of the base */
    double extent;    /* bounds what w was summed of */
    double spread;    /* bounds |d|, and what d was made of */
    double lambda;    /* bounds what a was made of, relative to |a| */
};

/* A contour in work.  One base is common to all edges: a corner above the horizon. */
struct lx_contour {
    const lx_wide3 *corners_mm;
    lx_wide3 place_mm, normal;
    double scale, nearest; /* lengths are scaled to be near to 1; bounds the distance from below */
    lx_wide normal_length;
    unsigned base;
    struct lx_contour_vertex base_vertex;
    unsigned known; /* a corner, and where it is seen: edges follow each other */
    struct lx_contour_vertex known_vertex;
    lx_wide sum;          /* twice the area */
    double error;         /* bounds its error, but for that of corners, places, normals */
    double corners_error; /* bounds what rounded corners add to it */
    bool crossed;         /* the contour was seen to cross the horizon, the first time here: */
    bool exited;          /* it was leaving then */
    struct lx_contour_vertex crossing;
};

/* The scale is a power of two; no part of the contour is nearer than so much. */
struct lx_contour lx_contour_start(const lx_wide3 *corners_mm, lx_wide3 place_mm, lx_wide3 normal, double scale,
                                   double nearest_mm);

/* How high a corner is above the horizon. */
lx_wide lx_contour_height(const struct lx_contour *contour, unsigned corner);

void lx_contour_set_base(struct lx_contour *contour, unsigned corner);

/* Adds the edge from one corner to another, which may be wrong by so much. */
void lx_contour_add(struct lx_contour *contour, unsigned from, unsigned to, double corner_error_mm);

/* The ways from the element to a corner, and from one corner to another, scaled. */
lx_wide3 lx_contour_way(const struct lx_contour *contour, unsigned corner);
lx_wide3 lx_contour_between(const struct lx_contour *contour, unsigned from, unsigned to);

/* The area within a contour that is low above the horizon and does not go round the normal, by an integral. */
struct lx_low_area {
    lx_wide sum; /* twice the area */
    double error;
    bool failed; /* it is not low, or is touched */
};

void lx_contour_add_low(const struct lx_contour *contour, unsigned from, unsigned to, struct lx_low_area *low);

#endif
