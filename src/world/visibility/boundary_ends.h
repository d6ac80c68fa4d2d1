/* SPDX-License-Identifier: MIT */
/*
 * Ends of the pieces of a border: where each ends another one begins, or a piece is missing, or counts twice; and how
 * far the solid angle within may be off, as borders lie where they do but for roundings.
 */
#ifndef LX_WORLD_BOUNDARY_ENDS_H
#define LX_WORLD_BOUNDARY_ENDS_H

#include "boundary.h"

enum { LX_BOUNDARY_PIECES = 192 };

/* Large: set the counts and sums to 0. */
struct lx_boundary_ends {
    double at[LX_BOUNDARY_PIECES][2][3]; /* where each piece begins, and ends, on the way around what is seen */
    const struct lx_boundary_side *side; /* the last one, up to `to` */
    double to;
    unsigned count;
    bool is_full;
    double unsure; /* of the solid angle, by how far borders may lie aside */
};

/* Takes a piece; `error_mm` is how far its curve may be off. */
void lx_boundary_ends_add(struct lx_boundary_ends *ends, const struct lx_boundary_side *side, double from, double to,
                          int sign, double error_mm);

/* Adds what may be overlooked of a source beside a side of it, or between obstacles along that. */
void lx_boundary_ends_overlook(struct lx_boundary_ends *ends, const struct lx_boundary_side *side, double to);

/* Whether all pieces go on in each other; the gaps that are left are added to what is unsure. */
bool lx_boundary_ends_meet(struct lx_boundary_ends *ends);

#endif
