/* SPDX-License-Identifier: MIT */
/* The maker of a picture's plan. */
#ifndef LX_PICTURE_PLAN_MAKE_H
#define LX_PICTURE_PLAN_MAKE_H

#include "../scene/colours.h"
#include "plan.h"

/* A plan that tells what is seen, but not how it is lit (seen.h), as lx_plan_make() does. */
luxel_status lx_plan_sight(const struct lx_prepared *prepared, const struct lx_kernels *kernels,
                           const luxel_settings *settings, struct lx_plan *plan);

/*
 * By quantity, precision, tolerance (0: the usual one), light_error and progress of the settings.  LUXEL_OK,
 * LUXEL_ERROR_MEMORY, or LUXEL_CANCELLED.  Release with lx_plan_clear() in any case.
 */
luxel_status lx_plan_make(const struct lx_prepared *prepared, const struct lx_kernels *kernels,
                          const luxel_settings *settings, struct lx_plan *plan);
void lx_plan_clear(struct lx_plan *plan);

#endif
