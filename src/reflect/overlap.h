/* SPDX-License-Identifier: MIT */
/*
 * Flat faces that lie on one another in the very same plane and face the same way, such as a plate on a floor without a
 * gap, or triangles of a mesh that overlap.  One of them is hidden, but nothing says which, and light falls on both: so
 * whatever such tiles send is an error, too, and bounds hold whichever is seen.
 */
#ifndef LX_REFLECT_OVERLAP_H
#define LX_REFLECT_OVERLAP_H

#include "solution.h"

/* Finds the faces that others lie on. */
void lx_overlap_find(struct lx_radiosity *reflected);

/* The face that lies on a tile; NULL: none does. */
const struct lx_matte_face *lx_overlap_on(const struct lx_radiosity *reflected, const struct lx_tile *tile);

#endif
