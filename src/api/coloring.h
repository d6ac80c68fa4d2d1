/* SPDX-License-Identifier: MIT */
/* Computing in colour: each public computation as a sum of grey ones (scene/colours.h), which stand here as well. */
#ifndef LX_API_COLORING_H
#define LX_API_COLORING_H

#include <luxel/evaluator.h>
#include <luxel/grid.h>
#include <luxel/render.h>

#include "../scene/colours.h"

/* The progress of a part among others, which take as long each. */
struct lx_part_progress {
    luxel_progress progress;
    luxel_enough enough;
    void *data;
    double before, share;
};

/* Sets the progress of number i of `count` computations with these settings. */
void lx_part_progress_begin(struct lx_part_progress *part, size_t i, size_t count, const luxel_settings *asked,
                            luxel_settings *settings);

luxel_status lx_render_grey(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                            luxel_field **field);
luxel_status lx_render_in_color(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, luxel_field **field);

luxel_status lx_probe_grey(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                           size_t count, luxel_diagnostics *diagnostics, luxel_probes **probes);
luxel_status lx_probe_in_color(const luxel_scene *scene, const luxel_settings *settings, const luxel_place *places,
                               size_t count, luxel_diagnostics *diagnostics, luxel_probes **probes);

/* Probes that have nothing but their names and room for a share of each light that is on; the caller's, even where it
 * fails. */
luxel_status lx_probes_new(const luxel_scene *scene, const luxel_settings *settings, size_t count,
                           luxel_diagnostics *diagnostics, luxel_probes **probes);

/* Gives each share of such probes a colour, without light; false: memory ran out. */
bool lx_probes_add_colors(luxel_probes *probes);

/* The probes, to be filled. */
luxel_probe *lx_probes_list(luxel_probes *probes);
/* Takes all that a probe tells of its place over as number i of such probes, with room for the shares of all lights. */
void lx_probe_take_place(luxel_probes *probes, size_t i, const luxel_probe *from);

/* lx_measure_cells() of a grey computation, and of a scene in color. */
struct lx_wanted_cells;
luxel_status lx_measure_grey(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                             const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics, luxel_grid **grid);
luxel_status lx_measure_in_color(const luxel_scene *scene, const luxel_settings *settings, size_t i,
                                 const struct lx_wanted_cells *cells, luxel_diagnostics *diagnostics,
                                 luxel_grid **grid);

#endif
