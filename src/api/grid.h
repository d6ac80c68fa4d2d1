/* SPDX-License-Identifier: MIT */
/* A measured grid as the library holds it: what its users see, and where its cells are. */
#ifndef LX_API_GRID_H
#define LX_API_GRID_H

#include <luxel/grid.h>

#include "../material/measure.h"
#include "../scene/scene.h"
#include "../world/cells.h"

struct lx_measured {
    luxel_grid grid; /* first, so that its address is that of the whole */
    struct lx_cells cells;
};

/* What of the cells of an area around a plane is measured: what is outside of a hole, from the middle of their own
 * rectangle across and up, and in the room, as far as that is known. */
struct lx_ring {
    double hole_mm[2][2];
    double low_mm[3], high_mm[3];
};

/* Whether the centre of a cell is none of those. */
bool lx_ring_leaves_out(const struct lx_ring *ring, const struct lx_cells *cells, unsigned column, unsigned row);

/* An area around a plane: the plane with other places and cells. */
struct lx_area {
    struct lx_grid grid;
    struct lx_ring ring;
};

/* Which cells are measured instead of the grid's own. */
struct lx_wanted_cells {
    unsigned n[2];              /* columns and rows of its plane */
    const struct lx_area *area; /* instead of these; NULL: they count */
};

/* Measures a plane; lx_measure_with_areas() has the areas around it that its grid asks for measured too. */
typedef luxel_status lx_measure_plane(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                      luxel_diagnostics *diagnostics, luxel_grid **grid);
luxel_status lx_measure_with_areas(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                   lx_measure_plane *measure, luxel_diagnostics *diagnostics, luxel_grid **grid);

/* The scene's i-th grid, for a call with an answer of this name; NULL, and reported: there is none, or no answer. */
const struct lx_grid *lx_asked_grid(const luxel_scene *scene, size_t i, const void *answer, const char *name,
                                    luxel_diagnostics *diagnostics);

/* luxel_find_grid() of the plane, or where other cells are wanted the values of these alone: without flux, mean and
 * sampling error. */
luxel_status lx_measure_cells(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                              const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics, luxel_grid **grid);

/* The cells in grey, by a measure other than the grid's; NULL: by that. */
luxel_status lx_measure_as(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                           const struct lx_wanted_cells *cells, const enum lx_measure *measure,
                           luxel_diagnostics *diagnostics, luxel_grid **grid);

#endif
