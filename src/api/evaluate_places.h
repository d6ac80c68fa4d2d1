/* SPDX-License-Identifier: MIT */
/* Values at many places together with their slopes. */
#ifndef LX_API_EVALUATE_PLACES_H
#define LX_API_EVALUATE_PLACES_H

#include <luxel/derive.h>
#include <luxel/evaluator.h>

#include "../world/slopes.h"

/* Where slopes go: those of a place side by side, a number after the other; those that are not known are left alone,
 * all of them at places that are in doubt or have no value. */
struct lx_slope_list {
    luxel_derivative *list;
    bool *in_doubt; /* of each place */
};

/* As luxel_evaluate_places(), with the slopes by an evaluator's numbers. */
luxel_status lx_evaluate_slopes(const luxel_evaluator *evaluator, const struct lx_slopes *slopes,
                                const luxel_place *places, size_t count, luxel_value *values, struct lx_slope_list to);

#endif
