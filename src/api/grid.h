/* SPDX-License-Identifier: MIT */
/* A measured grid as the library holds it: what its users see, and where its cells are. */
#ifndef LX_API_GRID_H
#define LX_API_GRID_H

#include <luxel/grid.h>

#include "../shade/cells.h"

struct lx_measured {
    luxel_grid grid; /* first, so that its address is that of the whole */
    struct lx_cells cells;
};

#endif
