/* SPDX-License-Identifier: MIT */
/* Keys of a scene tuned to goals: aims, dimming, spacings and places of lights whose numbers stay. */
#ifndef LX_INVERSE_TUNING_H
#define LX_INVERSE_TUNING_H

#include "arranging.h"

/* Looks for the numbers of the keys that are wanted, from several starts; what is found is kept among the computed
 * layouts, with its numbers.  LUXEL_ERROR_PATH: keys that take no numbers.  LUXEL_ERROR_ARGUMENT: too many of them. */
luxel_status lx_tune(struct lx_arranging *arranging);

#endif
