/* SPDX-License-Identifier: MIT */
/* Several starts of a fit, where they end, and what it means where they end apart. */
#ifndef LX_INVERSE_STARTS_H
#define LX_INVERSE_STARTS_H

#include "conclude.h"

enum { LX_MOST_STARTS = 128 };

/* The ends of several starts; start with {0}, and clear it in any case. */
struct lx_starts {
    struct lx_reading_set some;
    struct lx_trial ends[LX_MOST_STARTS];
    bool exists[LX_MOST_STARTS];
    size_t count, best;
};

/* Searches from every start; the scene's own is best where none is better by more than the noise tells. */
luxel_status lx_starts_try(struct lx_fit_problem *problem, struct lx_starts *starts);

/* Which ends are as good as the one found: the same one, or others that fit all readings as well. */
luxel_status lx_starts_compare(struct lx_fit_problem *problem, struct lx_starts *starts, const struct lx_trial *found,
                               luxel_fit *fit, struct lx_conclusion *conclusion);

void lx_starts_clear(struct lx_starts *starts);

#endif
