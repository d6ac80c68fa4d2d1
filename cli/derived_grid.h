/* SPDX-License-Identifier: MIT */
/* What luxel derive tells of a grid: how the values of its cells, and their average, change with keys of the scene. */
#ifndef LUXEL_CLI_DERIVED_GRID_H
#define LUXEL_CLI_DERIVED_GRID_H

#include "cli.h"
#include "load.h"

/* Derives the grid of --grid and prints it; returns an enum exit_code. */
int derived_grid(const struct options *options, const struct loaded *loaded);

#endif
