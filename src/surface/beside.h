/* SPDX-License-Identifier: MIT */
/*
 * Free elements beside a surface: what it hides from one that lies on it, with a normal of its own, and whether a place
 * is inside the body that it bounds.
 */
#ifndef LX_SURFACE_BESIDE_H
#define LX_SURFACE_BESIDE_H

#include "surface.h"

/* An element whose normal is off by less than this (1 less the cosine, for about a milliradian) has the normal of the
 * surface that it lies on, as far as who typed it could tell. */
#define LX_SAME_NORMAL 5e-7

/*
 * Whether the shape takes light from an element that it holds, on the side that the element's unit normal looks to; it
 * takes none where that is the surface's own normal.  The way to the light and the answer are as of `blocks`.
 */
lx_bounded lx_shape_hides(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal, lx_bounded3 towards,
                          bool endless);

/* Whether an element that the shape holds has another normal than the shape there. */
bool lx_shape_is_turned(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 normal);

/* Whether an element that looks straight back from a shape is on a front, too, which takes nothing from it; at the back
 * of a room's wall it takes what comes from the room. */
static inline bool lx_is_other_front(const struct lx_shape *shape, double facing)
{
    return facing <= LX_SAME_NORMAL - 1 && !(shape->behind_mm > 0);
}

/* Whether a kind's `blocks` is asked for these, too: it hides itself, and `hides` does not tell all that it takes. */
static inline bool lx_asks_both(const struct lx_surface_kind *kind)
{
    return kind->hides_itself && !kind->hides;
}

/* Whether a place is inside the body that the shape bounds, and not on the surface; a plate bounds none. */
bool lx_shape_encloses(const struct lx_shape *shape, const double place_mm[3]);

#endif
