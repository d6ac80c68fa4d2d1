/* SPDX-License-Identifier: MIT */
/* Regions: parts of the screen that statistics and extrema are taken over. */
#ifndef LX_FIELD_REGION_H
#define LX_FIELD_REGION_H

#include <luxel/statistics.h>

/* LUXEL_ERROR_ARGUMENT, reported: the region (NULL: the whole) is not finite or of no size. */
luxel_status lx_region_check(const luxel_region *region, luxel_diagnostics *diagnostics);

#endif
