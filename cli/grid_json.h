/* SPDX-License-Identifier: MIT */
/* A measuring grid as JSON. */
#ifndef LUXEL_CLI_GRID_JSON_H
#define LUXEL_CLI_GRID_JSON_H

#include <luxel/luxel.h>

#include "json.h"
#include "grid_limits.h"

/* An object of an array: the values with their bounds, what is read off them, and the verdicts. */
void grid_write_json(struct json *json, const luxel_grid *grid, const luxel_grid_extrema *extrema,
                     const struct judged *judged);

#endif
