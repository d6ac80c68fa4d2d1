/* SPDX-License-Identifier: MIT */
/* Rates at which the constants of a prepared scene change with the numbers of keys. */
#ifndef LX_INVERSE_RATES_H
#define LX_INVERSE_RATES_H

#include <luxel/settings.h>

#include "../world/slopes.h"
#include "keys.h"

/*
 * Finds how the constants change by all numbers of the keys, from scenes in which these are others, by the same
 * extrapolated differences as of values.  Numbers for which that is not all that changes, all numbers of scenes whose
 * values are not known by slopes, and all where they are not to be tried, are left unknown.  Clear them in any case.
 * Else LUXEL_ERROR_MEMORY.
 */
luxel_status lx_rates_find(const luxel_scene *scene, const luxel_settings *settings, const struct lx_keys *keys,
                           luxel_diagnostics *diagnostics, bool is_tried, struct lx_slopes *slopes);

#endif
