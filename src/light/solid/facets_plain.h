/* SPDX-License-Identifier: MIT */
/*
 * The area that a contour encloses as an element sees it (facets_contour.h), in float64 with running bounds: a tenth of
 * the work of wide numbers, for contours that are wholly above the horizon and whose terms do not cancel.  Whoever asks
 * looks at the bound of the sum and takes wide numbers where it is not good enough.
 */
#ifndef LX_LIGHT_FACETS_PLAIN_H
#define LX_LIGHT_FACETS_PLAIN_H

#include "area_light_facets.h"

/* A corner that is seen. */
struct lx_plain_vertex {
    lx_bounded3 a;       /* from the element, scaled */
    lx_bounded distance; /* |a| */
    lx_bounded inverse;
    lx_bounded3 d; /* its direction minus that of the base */
};

struct lx_plain_contour {
    const lx_wide3 *corners_mm;
    double corner_error_mm;
    double place_mm[3];
    lx_bounded3 normal;
    double scale; /* a power of two */
    bool begun;
    unsigned base, known; /* the first corner, and the one that the last edge led from */
    struct lx_plain_vertex base_vertex, known_vertex;
    lx_bounded sum; /* twice the area; an infinite bound where this way does not lead to it */
};

struct lx_plain_contour lx_plain_start(const struct lx_facets *facets, const double place_mm[3], const double normal[3],
                                       double scale);

/* Adds the edge from one corner to another. */
void lx_plain_add(struct lx_plain_contour *contour, unsigned from, unsigned to);

#endif
