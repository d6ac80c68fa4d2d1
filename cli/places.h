/* SPDX-License-Identifier: MIT */
/* The places that probes are asked for: those of -p, --at and --points, or else the scene's own points. */
#ifndef LUXEL_CLI_PLACES_H
#define LUXEL_CLI_PLACES_H

#include <luxel/luxel.h>

#include "options.h"

struct places {
    luxel_place *list;
    size_t count, capacity;
};

/*
 * Collects them, with --view and --material.  Returns an enum exit_code; errors are printed here, all of a file's at
 * once.  places_clear() is due in every case.
 */
int places_collect(const struct options *options, const luxel_scene *scene, luxel_diagnostics *diagnostics,
                   struct places *places);
void places_clear(struct places *places);

/* Room for one more, set to zero; without memory the tool ends. */
luxel_place *places_add(struct places *places);
void places_set_element(luxel_place *place, const double numbers[6]);

/*
 * Adds the places of a table.  `quiet`: columns that are passed over are not told.  Returns an enum exit_code; all that
 * is wrong is told at once, up to so many rows.
 */
int places_read(const char *file, luxel_diagnostics *diagnostics, bool quiet, struct places *places);

/* What was used of the scene to probe them, for its conventions: `surfaces` has room for one bool for each surface. */
luxel_conventions_use places_use(const struct options *options, const luxel_scene *scene, const luxel_probes *probes,
                                 bool *surfaces);

#endif
