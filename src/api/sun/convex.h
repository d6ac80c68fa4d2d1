/* SPDX-License-Identifier: MIT */
/* Convex polygons in a plane: cut by lines, cut out of each other. */
#ifndef LX_API_SUN_CONVEX_H
#define LX_API_SUN_CONVEX_H

#include <stdbool.h>
#include <stddef.h>

struct lx_convex {
    double (*corners)[2]; /* counter-clockwise */
    size_t count;         /* less than 3: it is empty */
};

/* A list, which stays as it was where memory runs out; zero-initialise, and clear. */
struct lx_convexes {
    struct lx_convex *items;
    size_t count, capacity;
};

void lx_convex_clear(struct lx_convex *polygon);
void lx_convexes_clear(struct lx_convexes *polygons);

double lx_convex_area(const struct lx_convex *polygon);

/*
 * Keeps of a polygon what lies where side[0] x + side[1] y + side[2] >= 0, side[0] and side[1] being a unit vector;
 * what is as near to that line as `near` lies on it.  0, or -1 when memory ran out.
 */
int lx_convex_cut(const struct lx_convex *polygon, const double side[3], double near, struct lx_convex *kept);

/* What two polygons share.  0, or -1 when memory ran out. */
int lx_convex_share(const struct lx_convex *one, const struct lx_convex *other, double near, struct lx_convex *shared);

/* Replaces polygons by convex pieces of what another leaves of them, dropping those of no more area than `least`.  0,
 * or -1 when memory ran out. */
int lx_convexes_subtract(struct lx_convexes *polygons, const struct lx_convex *taken, double near, double least);

/* Appends a polygon, which is the list's then, unless its area is no more than `least`; cleared in any other case.  0,
 * or -1 when memory ran out. */
int lx_convexes_take(struct lx_convexes *polygons, struct lx_convex *polygon, double least);

#endif
