/* SPDX-License-Identifier: MIT */
/* Goals of a layout: limits of a scene's grids and observers, written as "desk:average>=500". */
#ifndef LX_INVERSE_GOALS_H
#define LX_INVERSE_GOALS_H

#include <luxel/arrange.h>

#include "../scene/limits.h"

enum { LX_MOST_TUNED = 60 };                       /* numbers of keys that are tuned to goals */
enum { LX_GOALS_OF_GRID = 2 * LUXEL_MOST_LIMITS }; /* at most, with those of the areas around it */

/* A grid, and the areas around it that EN 12464-1 knows. */
enum lx_grid_part { LX_PART_TASK, LX_PART_SURROUND, LX_PART_BACKGROUND, LX_GRID_PARTS };

/* A limit of a grid, as the search judges it. */
struct lx_goal {
    size_t first, count; /* its cells among those of all grids that have limits, and of the areas around them */
    enum lx_grid_limit which;
    double wanted, above; /* above: of a share, what its cells are to have */
};

/*
 * A committed copy of the scene whose limits are these goals, too.  LUXEL_ERROR_ARGUMENT: goals that are none, all of
 * them reported, or no limit at all.  LUXEL_ERROR_SCENE: one is no legal limit.
 */
luxel_status lx_goals_set(const luxel_scene *scene, const luxel_arranging *arranging, luxel_diagnostics *diagnostics,
                          luxel_scene **goals);

/* The least of the values by what is wanted, where the cells have these values: 1 or more where no goal is missed. */
double lx_goals_reserve(const struct lx_goal *goals, size_t count, const double *values);

/*
 * What must reach 1 for the goals to be reached, and its slopes by `numbers` of which cells have slopes[k x cells + i]:
 * rows of numbers + 1, the slopes and the value behind them, no more than lx_goals_most_rows().  A share is that of the
 * cell that decides it.  Returns how many rows there are.
 */
size_t lx_goals_most_rows(const struct lx_goal *goals, size_t count);
size_t lx_goals_rows(const struct lx_goal *goals, size_t count, const double *values, const double *slopes,
                     size_t cells, size_t numbers, double *rows);

/* How near a limit is: its value by what is wanted, the other way round where that is the most; of a rating, which goes
 * with the logarithm of light, as the light goes.  Infinite where there is no value and the limit is kept. */
double lx_goal_reserve_of(const luxel_limit *limit);

#endif
