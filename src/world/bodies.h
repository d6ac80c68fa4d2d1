/* SPDX-License-Identifier: MIT */
/*
 * Bodies: which places of a measuring plane no eye or meter can be at, since a surface closes around them: a sphere, a
 * closed mesh, or a tube whose ends others cover.  What a light shines in is a room, whatever it is made of, and no
 * body.
 */
#ifndef LX_WORLD_BODIES_H
#define LX_WORLD_BODIES_H

#include "cells.h"

/* The surface that closes around a place, alone or with others, the first of them; NULL: none does. */
const struct lx_prepared_surface *lx_surface_around(const struct lx_prepared *prepared, const double place_mm[3]);

/* Zero-initialise, and clear. */
struct lx_bodies {
    const struct lx_prepared *prepared;
    bool *are_bodies; /* of its surfaces; NULL: none of them meets the plane */
};

/* Finds the bodies that a plane meets; 0, or -1 when memory ran out. */
int lx_bodies_find(const struct lx_prepared *prepared, const struct lx_cells *plane, struct lx_bodies *bodies);
void lx_bodies_clear(struct lx_bodies *bodies);

/* The surface of the body that a place is inside of, the first of them; NULL: it is in none. */
const struct lx_prepared_surface *lx_body_around(const struct lx_bodies *bodies, const double place_mm[3]);

#endif
