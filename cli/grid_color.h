/* SPDX-License-Identifier: MIT */
/* The colours of a measured grid in a scene with channels: rgb. */
#ifndef LUXEL_CLI_GRID_COLOR_H
#define LUXEL_CLI_GRID_COLOR_H

#include <luxel/grid.h>

#include "json.h"

/* The colour of an extremum; 0 in a grey scene. */
luxel_color grid_color_of_peak(const luxel_grid_peak *peak);

/* Writes the members `average_color` and `rgb`, cell by cell; prints the colours of average and extrema. */
void grid_color_write(struct json *json, const luxel_grid *grid);
void grid_color_print(const luxel_grid *grid, const luxel_grid_extrema *extrema);

#endif
