/* SPDX-License-Identifier: MIT */
/*
 * The problem of a fit: numbers of free keys, the readings that a scene with these numbers should give, and how much a
 * reading that is off counts.  A last unknown is the factor of readings that are known only up to one.
 */
#ifndef LX_INVERSE_PROBLEM_H
#define LX_INVERSE_PROBLEM_H

#include <luxel/fit.h>

#include "keys.h"
#include "prober.h"

/* Readings in a row. */
struct lx_reading_set {
    luxel_place *places;
    double *values;
    size_t *pixels; /* of a picture that is drawn as a whole: which each of them is; NULL: they are probed */
    size_t count;
};

struct lx_fit_problem {
    const luxel_scene *scene;
    luxel_settings settings;
    const luxel_readings *readings; /* how they were taken; the lists are in `set` */
    struct lx_reading_set set;
    struct lx_keys keys;
    struct lx_changer changer;
    size_t numbers;     /* of the keys */
    size_t unknowns;    /* the factor, too */
    double *scale;      /* of each unknown: how large it is */
    double *low, *high; /* what is legal for it */
    double precision;   /* of values: the greatest bound of their errors by the greatest of them */
    double step;        /* of differences, as a share of the scale */
    bool is_slow;       /* values take integrals, or a solution of reflected light */
    double greatest;    /* the greatest absolute reading */
    luxel_diagnostics *diagnostics;
    luxel_progress progress;
    void *progress_data;
    size_t evaluations;
};

/* How readings count around some values: residuals and weights in standard deviations of the noise. */
struct lx_counting {
    const struct lx_fit_problem *problem;
    const struct lx_reading_set *set;
    double sd; /* where it is estimated: of each reading; 0: it is told */
};

/* What one reading is, beside the value that the scene gives there. */
struct lx_counted {
    double sd;       /* of its noise */
    double residual; /* in these: positive where the reading is higher */
    double weight;   /* of the square of the residual in the linear problem, */
    double cost;     /* and what it adds to the cost */
    bool is_saturated;
};

/* Whether noise is told; else all readings are taken for equally noisy. */
bool lx_noise_is_told(const luxel_readings *readings);
bool lx_is_saturated(const luxel_readings *readings, double value);

/* Counts reading i, of which the scene gives `model` (times the factor); its noise is that of the value `usual`. */
struct lx_counted lx_count_reading(const struct lx_counting *counting, size_t i, double model, double usual);

/* The standard deviation that readings show: by their median where outliers are to be borne, else by their squares. */
double lx_estimate_noise(const struct lx_counting *counting, const double *models, size_t unknowns);

/*
 * What the scene with these numbers gives at readings, times the factor; 0 where it shows no surface.
 * LUXEL_ERROR_SCENE: there is no such scene.
 */
luxel_status lx_problem_models(struct lx_fit_problem *problem, const struct lx_reading_set *set, const double *unknowns,
                               double *models);

/*
 * Differences of what the scene gives by the unknowns, per scale, column by column: rows of `set`.  Where a reading
 * jumps it has NaN.
 */
luxel_status lx_problem_slopes(struct lx_fit_problem *problem, const struct lx_reading_set *set, const double *unknowns,
                               const double *models, double *slopes);

#endif
