/* SPDX-License-Identifier: MIT */
/* luxel daylight's options, and its questions to the sun: when that shines on grids and elements, and on what. */
#ifndef LUXEL_CLI_SUN_H
#define LUXEL_CLI_SUN_H

#include "load.h"
#include "options.h"
#include "places.h"

/* What their options take. */
bool sun_take_outdoor(struct options *options, const char *argument);
bool sun_take_location(struct options *options, const char *argument);
bool sun_take_least_altitude(struct options *options, const char *argument);

/* Refuses options that count for nothing.  Returns an enum exit_code. */
int sun_check_options(const struct options *options);

/* Finds and prints the hours of sun at the scene's grids and at places.  Returns an enum exit_code. */
int sun_print_hours(const struct options *options, const struct loaded *loaded, const struct places *places);

/* Finds and prints the patches of sun (sun_patches.c).  Returns an enum exit_code. */
int sun_print_patches(const struct options *options, const struct loaded *loaded);

#endif
