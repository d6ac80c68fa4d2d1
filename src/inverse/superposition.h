/* SPDX-License-Identifier: MIT */
/*
 * The light of arrays by superposition: what one luminaire gives to the cells of the grids that have limits, from
 * places all over the field where luminaires may stand, and sums of that.
 *
 * An array lies evenly around its middle, so for each luminaire at (x, y) there are those at (-x, y), (x, -y) and
 * (-x, -y), and a quarter of the field will do: the table holds the mean of the four, at even steps of |x| and |y|, and
 * is read between them by cubic polynomials through four of its places.
 */
#ifndef LX_INVERSE_SUPERPOSITION_H
#define LX_INVERSE_SUPERPOSITION_H

#include "goals.h"

struct lx_superposition {
    const luxel_scene *scene; /* with the goals, committed */
    const luxel_settings *settings;
    luxel_diagnostics *diagnostics;
    size_t light;
    double axes[2][3];                   /* along which columns and rows follow each other, unit */
    double half_mm[2];                   /* how far from the middle of the array luminaires may stand */
    double wall_mm[2];                   /* and how far walls are, half_mm where there are none */
    double least_mm[2];                  /* spacings in which they do not overlap */
    size_t goal_count, cells, observers; /* cells: the last are those of observers that count, one for each limit */
    struct lx_goal *goals;
    unsigned nodes[2];  /* places of the table along x and y */
    double *table;      /* nodes[1] x nodes[0] x cells */
    double *base;       /* of the other lights */
    double *correction; /* that one luminaire of an array that was computed gives beside the sums: reflected light */
    double *sums;       /* room for values */
};

/* Numbers of columns and rows, and spacings. */
struct lx_array_try {
    unsigned n[2];
    double spacing_mm[2];
};

/* Lists the goals and their cells alone, of any light.  `observe`: those of observers, too, whose cell has what their
 * rating is the logarithm of, or where nothing is known of the background what is in proportion to it. */
luxel_status lx_superposition_list(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, bool observe,
                                   struct lx_superposition *superposition);

/* Finds all of it.  LUXEL_ERROR_ARGUMENT: no light arrives.  Clear it in any case. */
luxel_status lx_superposition_make(const luxel_scene *scene, const luxel_settings *settings, size_t light,
                                   luxel_diagnostics *diagnostics, struct lx_superposition *superposition);
void lx_superposition_clear(struct lx_superposition *superposition);

/* Commits a scene in which the light has these numbers and spacings. */
luxel_status lx_array_set(luxel_scene *scene, size_t light, const struct lx_array_try *array,
                          luxel_diagnostics *diagnostics);

/* What an array gives to each cell, with reflected light as far as that is known. */
void lx_superpose(const struct lx_superposition *superposition, const struct lx_array_try *array, double *values);

/* The values of a scene at all cells, NaN where there is none; the limits of its grids are judged where `limits` is not
 * NULL. */
luxel_status lx_measure_goals(const struct lx_superposition *superposition, const luxel_scene *scene,
                              const luxel_settings *settings, double *values, luxel_layout_limit *limits,
                              size_t *limit_count);

/* Learns from the values of an array that was computed, each luminaire dimmed to a share. */
void lx_superposition_learn(struct lx_superposition *superposition, const struct lx_array_try *array, double dimming,
                            const double *values);

/* How many luminaires it takes for the means of grids, if each stood at the best place; infinite: none lights one. */
double lx_fewest_luminaires(const struct lx_superposition *superposition);

#endif
