/* SPDX-License-Identifier: MIT */
/*
 * Parts: a kind of surface may stand for several, as a room does for its walls.  Whoever computes goes through the
 * parts; whoever speaks to people names the surface, and the part of it.
 */
#ifndef LX_SURFACE_PART_H
#define LX_SURFACE_PART_H

#include "../material/material.h"
#include "authored.h"
#include "surface.h"

/* Room for the parameters of a part. */
struct lx_own_parameters {
    struct lx_plate_parameters plate;
};

struct lx_part {
    const struct lx_surface_kind *kind;
    const void *parameters; /* by that kind: those that were written, or `own` */
    struct lx_shape shape;
    const struct lx_material *material; /* NULL: that of the whole surface */
    struct lx_own_parameters own;
};

/* How many parts surfaces of a kind have: 1 where they are one by themselves. */
unsigned lx_part_count(const struct lx_surface_kind *kind);

/* Part i of a surface.  It must not be moved, as it may point into itself. */
void lx_part_make(const struct lx_surface_kind *kind, const void *parameters, unsigned i, struct lx_part *part);

/* Pieces of parts: what openings leave of them, all of them where there are none.  Piece i, as of part `*number`. */
size_t lx_piece_count(const struct lx_surface_kind *kind, const void *parameters);
void lx_piece_make(const struct lx_surface_kind *kind, const void *parameters, size_t i, struct lx_part *piece,
                   unsigned *number);

/* What part i is called ("floor"); NULL: the surface is one by itself. */
const char *lx_part_name(const struct lx_surface_kind *kind, unsigned i);

/* How a flat part with four sides lies, as base/pose.h has it: seen from its front along -axis. */
struct lx_flat {
    double center_mm[3], size_mm[2], axis[3], up[3];
};

/* False: the part is not flat, or has other sides. */
bool lx_part_flat(const struct lx_part *part, struct lx_flat *flat);

#endif
