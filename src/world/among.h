/* SPDX-License-Identifier: MIT */
/*
 * Which of the surfaces of a prepared scene a line of sight may meet, or may stand in the way of light: by the tree
 * over boxes around them (boxes.h), which hold all that `hit`, `blocks`, `gather` and the balls around shapes speak of.
 * What is found is ascending; false: each has to be asked.
 */
#ifndef LX_WORLD_AMONG_H
#define LX_WORLD_AMONG_H

#include "prepared.h"

struct lx_ball;

/* Makes the tree; 0, or -1 when memory ran out. */
int lx_among_make(struct lx_prepared *prepared);

/* On a line of sight, from its origin on. */
bool lx_among_ray(const struct lx_prepared *prepared, const struct lx_ray *ray, struct lx_found *found);

/* On an open way, as `blocks` has it. */
bool lx_among_way(const struct lx_prepared *prepared, const lx_bounded3 *place_mm, const lx_bounded3 *towards,
                  bool endless, struct lx_found *found);

/* On, or around, a place. */
bool lx_among_place(const struct lx_prepared *prepared, const double place_mm[3], struct lx_found *found);

/* In a shaft. */
bool lx_among_shaft(const struct lx_prepared *prepared, const struct lx_shaft *shaft, struct lx_found *found);

/* Between two balls, or from one in a direction, both as offsets from an anchor: as lx_may_block() tells. */
bool lx_among_balls(const struct lx_prepared *prepared, const double anchor_mm[3], const struct lx_ball *from,
                    const struct lx_ball *towards, bool endless, struct lx_found *found);

#endif
