/* SPDX-License-Identifier: MIT */
/* The spacings, and the dimming, with which an array of so many columns and rows comes nearest to its goals. */
#ifndef LX_INVERSE_LAYOUTS_H
#define LX_INVERSE_LAYOUTS_H

#include "superposition.h"

/* An array with the best spacings. */
struct lx_lamp_layout {
    struct lx_array_try array;
    double dimming; /* 1: they give all their light */
    double reserve; /* by the sums: 1 or more where all goals of grids are reached */
    double score;   /* what is made as great as can be: the reserve, or of what can be dimmed and reaches them 1 by the
                     * dimming */
};

/* Whether columns and rows fit into the field. */
bool lx_layout_fits(const struct lx_superposition *superposition, unsigned columns, unsigned rows);

/* Finds them; `room` is for a value of each cell. */
struct lx_lamp_layout lx_layout_find(const struct lx_superposition *superposition, const luxel_arranging *arranging,
                                     unsigned columns, unsigned rows, double *room);

#endif
