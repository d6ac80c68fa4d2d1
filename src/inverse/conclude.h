/* SPDX-License-Identifier: MIT */
/* What readings tell of the numbers that fit best: error bars, and what is not determined. */
#ifndef LX_INVERSE_CONCLUDE_H
#define LX_INVERSE_CONCLUDE_H

#include "search.h"

enum { LX_MOST_ENDS = 4 };

/* What a fit has to say beside the public numbers; a text for each thing that is not determined is made of it. */
struct lx_conclusion {
    size_t *block; /* of each unknown: 0, it is determined; else the block of those that go together, from 1 */
    size_t *known; /* of each block: how many combinations of its numbers are determined */
    size_t blocks;
    double (*ends)[LX_MOST_ENDS]; /* of each unknown: values that fit as well as each other, `several` of them; or 0 */
    size_t *several;
};

/* Fills everything of the fit that the end of the search tells; what memory it needs is there already. */
luxel_status lx_conclude(struct lx_fit_problem *problem, const struct lx_trial *found, const luxel_scene *fitted,
                         luxel_fit *fit, luxel_fit_parameter *parameters, double *correlation,
                         struct lx_conclusion *conclusion);

/* The name of an unknown, "lights[0].position[2]" or "factor"; the caller's. */
char *lx_unknown_name(const struct lx_keys *keys, size_t unknown);

#endif
