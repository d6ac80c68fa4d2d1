/* SPDX-License-Identifier: MIT */
/* The search for the numbers that fit best: Levenberg and Marquardt's steps, from one start or several. */
#ifndef LX_INVERSE_SEARCH_H
#define LX_INVERSE_SEARCH_H

#include "least_squares.h"
#include "problem.h"

/* Where a search is. */
struct lx_trial {
    double *unknowns;
    double *models;    /* of each reading of the set: what the scene gives there */
    double sd;         /* of the readings, where it is estimated; 0: it is told */
    double cost;       /* in squares of standard deviations */
    bool has_ended;    /* nothing changes any more */
    bool *is_at_limit; /* of each unknown: it is at the end of what is legal, and would go on */
};

/* Room for a place in a search; false: memory ran out.  Clear it in any case. */
bool lx_trial_make(const struct lx_fit_problem *problem, size_t readings, struct lx_trial *found);
void lx_trial_clear(struct lx_trial *found);

/*
 * Searches from found->unknowns on, with at most so many steps.  LUXEL_ERROR_SCENE: there is no such scene.
 */
luxel_status lx_search(struct lx_fit_problem *problem, const struct lx_reading_set *set, unsigned most_steps,
                       struct lx_trial *found);

/* The i-th start, from 1: numbers around those of the scene, always the same. */
void lx_other_start(const struct lx_keys *keys, const double *lows, const double *highs, const double *scale,
                    unsigned i, double *numbers);

/* The factor that fits best where the rest stays as it is. */
void lx_fit_factor(const struct lx_fit_problem *problem, const struct lx_reading_set *set, struct lx_trial *found);

/* Fills the rows of the linear problem, of slopes by the unknowns: they are weighted in place.  Columns that are held
 * become 0; `held` NULL: none is. */
void lx_weigh_rows(const struct lx_counting *counting, const double *models, const bool *held, double *slopes,
                   double *right);

#endif
