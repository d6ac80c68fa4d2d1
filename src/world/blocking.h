/* SPDX-License-Identifier: MIT */
/* Surfaces in the way of light: which ones may be, and where they are. */
#ifndef LX_WORLD_BLOCKING_H
#define LX_WORLD_BLOCKING_H

#include "../kernel/kernel.h"
#include "../surface/surface.h"

/* A ball, as an offset from a surface's anchor. */
struct lx_ball {
    double center[3], radius;
};

/* The ball around a surface, from the anchor of another; and from there what was asked for from the origin. */
struct lx_ball lx_shape_ball(const struct lx_shape *shape, const double low_mm[3], const double high_mm[3],
                             const double anchor_mm[3]);
struct lx_ball lx_ball_from(const struct lx_ball *ball, const double anchor_mm[3]);

/*
 * Whether what is in a ball may come near the ways between two others, which as a whole are a line as thick as the
 * larger one; `endless`: the second stands for a direction.
 */
bool lx_may_block(const struct lx_ball *blocker, const struct lx_ball *from, const struct lx_ball *towards,
                  bool endless);

/* The ball around the part of a surface that a square shows. */
static inline struct lx_ball lx_vicinity_ball(const struct lx_vicinity *at)
{
    return (struct lx_ball){.center = {at->place[0], at->place[1], at->place[2]}, .radius = at->place_deviation.tile};
}

/* Whether a shape may block; both balls are offsets from the anchor of another one. */
bool lx_shape_may_block(const struct lx_shape *shape, const double anchor_mm[3], const struct lx_ball *from,
                        const struct lx_ball *towards, bool endless);

/*
 * Whether a shape and a light, a place or a direction, are both before a wall of a room, which then does not stand
 * between them; false: it is not known.
 */
bool lx_are_before_wall(const struct lx_shape *wall, const struct lx_shape *lit, const struct lx_origin *light);

/* Sets open[i] to 0 for the elements of a block that a shape takes the light from, which may be their own; leaves the
 * others. */
void lx_block_one(const struct lx_kernels *kernels, const struct lx_shape *shape, bool is_own,
                  const double anchor_mm[3], const struct lx_light_double *light, const struct lx_block_double *block,
                  size_t count, float *open);

#endif
