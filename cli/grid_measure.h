/* SPDX-License-Identifier: MIT */
/* The measure of a grid and its modelling, where it is not the light on the plane; else nothing is told of either. */
#ifndef LUXEL_CLI_GRID_MEASURE_H
#define LUXEL_CLI_GRID_MEASURE_H

#include <luxel/grid.h>

#include "json.h"
#include "text.h"

/* Members of a grid's object: "measure", "modelling". */
void grid_measure_write(struct json *json, const luxel_grid *grid);
/* A line under the heading of a grid. */
void grid_measure_print(const luxel_grid *grid);
/* Rows of a table of four columns: the ratio of the averages, and the least and the greatest at a cell. */
void grid_measure_add(struct text_table *table, const luxel_grid *grid);

/* The areas around a grid's plane, where it has some: as JSON, and as rows of a table with its statistics. */
void grid_areas_write(struct json *json, const luxel_grid *grid);
void grid_areas_add(struct text_table *table, const luxel_grid *grid);

#endif
