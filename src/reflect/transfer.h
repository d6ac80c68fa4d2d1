/* SPDX-License-Identifier: MIT */
/*
 * Transfer: what a tile sends to a receiver, the integral of its light times cos cos' / (pi r^2) over what is seen of
 * it, as weights of the tile's values at its nodes, and of the direct light, which is known in more detail, at once.
 *
 * Far cells that are wholly seen go by their nodes; others are cut, down to cells that are small against their
 * distance; of those what is seen is cut out exactly, where they are flat, else node by node.  Groups of tiles that are
 * wholly seen and far go by their own nodes.
 */
#ifndef LX_REFLECT_TRANSFER_H
#define LX_REFLECT_TRANSFER_H

#include "doubt.h"
#include "group.h"
#include "occluder_cone.h"

struct lx_sent {
    double weights[LX_RULE_NODES];
    double direct;
    double doubt;   /* irradiance that the direct light is not sure of, by the greatest kernel of each window, and */
    double squares; /* of what its last samples differ by */
};

/* One face and one receiver, for which the cones are set. */
struct lx_transfer {
    const struct lx_fineness *fineness;
    const struct lx_receiver *receiver;
    const struct lx_occluder_cones *cones;
    const struct lx_matte_face *face;
    double constant; /* the kernel inside of a sphere; 0: by its formula */
    double least_mm; /* cells are not cut below this */
    double turns_mm; /* within this normals turn, and with them the kernel, however far it is */
};
struct lx_transfer lx_transfer_of(const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                                  const struct lx_occluder_cones *cones, const struct lx_matte_face *face);

/* A tile, of which it is known how it is seen, and what hides it in part. */
void lx_transfer(const struct lx_transfer *transfer, const struct lx_tile *tile, enum lx_outlook sight,
                 const struct lx_partly *partly, struct lx_sent *sent);

/* A group that is wholly seen; false: it is too near. */
bool lx_transfer_group(const struct lx_transfer *transfer, const struct lx_group *group, struct lx_sent *sent);

#endif
