/* SPDX-License-Identifier: MIT */
/*
 * Beams: where light may fall so narrowly that samples of a window miss it, below the beam of a narrow spot and
 * close to a source.  Windows there are sampled more finely whatever their samples tell.
 */
#ifndef LX_REFLECT_BEAM_H
#define LX_REFLECT_BEAM_H

#include <stdbool.h>

#include "../light/emitter.h"
#include "tile.h"

/* One for each emitter that has a place, but the points of clouds, and one for each narrow peak of a luminaire. */
struct lx_beam {
    double place_mm[3], radius_mm; /* of a ball around the source; of a point 0 */
    double axis[3], half_rad;      /* within which most of its light is, at most HALF of beam.c */
    double around_rad;             /* how far from there light as narrow may be, too: of a peak that is long */
    double ring_rad;               /* of a ring, how far from the axis it is, all around; of all else 0 */
};

struct lx_beams {
    struct lx_beam *items;
    size_t count, capacity;
};

/* Beams, no part of which that is more than `share` of its flux is to be missed.  0, or -1 when memory ran out; to be
 * freed by lx_beams_clear() in any case. */
int lx_beams_make(const struct lx_emitters *emitters, double share, struct lx_beams *beams);
void lx_beams_clear(struct lx_beams *beams);

/* Whether a beam falls on a cell, or may, and is much narrower than it. */
bool lx_beams_narrow(const struct lx_beams *beams, const struct lx_tile_cell *cell);

#endif
