/* SPDX-License-Identifier: MIT */
/* A measured grid as the library holds it: what its users see, and where its cells are. */
#ifndef LX_API_GRID_H
#define LX_API_GRID_H

#include <luxel/grid.h>

#include "../material/measure.h"
#include "../world/cells.h"

struct lx_measured {
    luxel_grid grid; /* first, so that its address is that of the whole */
    struct lx_cells cells;
};

/* The scene's i-th grid, for a call with an answer of this name; NULL, and reported: there is none, or no answer. */
const struct lx_grid *lx_asked_grid(const luxel_scene *scene, size_t i, const void *answer, const char *name,
                                    luxel_diagnostics *diagnostics);

/* Whether some light is no point, so that an exact value takes an integral, of which thousands take too long for a
 * figure. */
bool lx_has_extended_lights(const struct lx_scene_parameters *scene);

/*
 * luxel_find_grid(), or with `n` the values alone of that plane's cells if there were n[0] columns and n[1] rows:
 * without flux, mean and sampling error.
 */
luxel_status lx_measure_cells(const luxel_scene *scene, const luxel_settings *settings, size_t i, const unsigned n[2],
                              luxel_diagnostics *diagnostics, luxel_grid **grid);

/* The cells in grey, by a measure other than the grid's; NULL: by that. */
luxel_status lx_measure_as(const luxel_scene *scene, const luxel_settings *settings, size_t i, const unsigned n[2],
                           const enum lx_measure *measure, luxel_diagnostics *diagnostics, luxel_grid **grid);

#endif
