/* SPDX-License-Identifier: MIT */
/* How exact a light would be in float32, and which lights of a plan are therefore computed in float64. */
#ifndef LX_SHADE_PRECISION_H
#define LX_SHADE_PRECISION_H

#include "plan.h"

/* Sets `bound` and `relative` of a planned light. */
void lx_bound_light(const struct lx_prepared *prepared, const struct lx_shape *shape, const struct lx_lobe *lobe,
                    const struct lx_emitter *emitter, struct lx_planned_light *light);

/*
 * Of lights that are all in float64, leaves as many to float32 as the picture's accuracy allows, given a lower bound
 * of its maximum.
 */
void lx_choose_precision(struct lx_planned_surface *surface, double least_maximum);

/* Whether float32 samples of a shell are good enough for a tolerance. */
bool lx_samples_fit_single(const struct lx_shape *shape, const struct lx_lobe_double *lobe,
                           const struct lx_shell *shell, double tolerance);

#endif
