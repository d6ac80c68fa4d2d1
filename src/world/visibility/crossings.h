/* SPDX-License-Identifier: MIT */
/*
 * Crossings: directions in which the borders of obstacles, and of a source, cross each other as an element sees them.
 * Between the longitudes of these the arcs of a sweep (occlusion.h) keep their form.
 */
#ifndef LX_WORLD_CROSSINGS_H
#define LX_WORLD_CROSSINGS_H

#include "occlusion.h"

/* A list; zero-initialise, free `items` with free(). */
struct lx_directions {
    double (*items)[3]; /* of any length */
    size_t count, capacity;
};

/* Appends the directions; none where there are too many borders for it.  0, or -1 when memory ran out. */
int lx_find_crossings(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                      struct lx_directions *directions);

#endif
