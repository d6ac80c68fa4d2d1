/* SPDX-License-Identifier: MIT */
/* One solution on the tiles as they are: matrix, light, residual and slack; and which tiles to cut next. */
#ifndef LX_REFLECT_REFINE_H
#define LX_REFLECT_REFINE_H

#include "solution.h"

/* Solves on the tiles as they are.  LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED. */
luxel_status lx_reflected_solve(struct lx_radiosity *reflected);

#endif
