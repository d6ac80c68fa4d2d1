/* SPDX-License-Identifier: MIT */
/*
 * Close views: places of faces that a place sees from close by, as the foot of a wall from the floor beside it.  There
 * the kernel changes on single tiles and windows of direct light, so that errors in the mean, or that cancel over a
 * window, do not tell what arrives: what these places receive is asked of each of them.
 */
#ifndef LX_REFLECT_CLOSE_H
#define LX_REFLECT_CLOSE_H

#include "occluder_cone.h"
#include "receiver.h"

struct lx_radiosity;
struct lx_prepared;

enum { LX_MOST_CLOSE = 64 };

/* A place that is seen: with the receiver there, and the share of the view that it stands for. */
struct lx_close_place {
    struct lx_receiver receiver;
    uint32_t face;
    double at[2]; /* coordinates of the face */
    double share;
};

/* What a tile is off by there, times that share: irradiance, as far as no bound of the tile's own has it. */
struct lx_close_error {
    size_t tile;
    double error;
};

/* Sets the places that a receiver sees from close by; returns how many. */
size_t lx_close_find(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                     const struct lx_receiver *receiver, struct lx_occluder_cones *cones,
                     struct lx_close_place found[LX_MOST_CLOSE]);

/* Asks them; returns how many. */
size_t lx_close_ask(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                    const struct lx_receiver *receiver, struct lx_occluder_cones *cones,
                    struct lx_close_error found[LX_MOST_CLOSE]);

#endif
