/* SPDX-License-Identifier: MIT */
/* A hold of a thing in space: what moves with it, and how exactly. */
#ifndef LUXEL_APP_HOLD_H
#define LUXEL_APP_HOLD_H

#include "../picture/turn.h"
#include "space.h"

/*
 * Moves a thing, as a projection shows it (NULL: in all directions), and with a lamp the others that are chosen with it
 * (gsize; NULL: none), as one step of undo: those that stand somewhere by as much, or light from far away, which
 * `turn` (NULL: none) is of, turns together.
 */
void app_hold_move(AppThing *thing, const AppProjection *projection, const double to_mm[3], double grain_mm,
                   const GArray *together, const AppTurn *turn, AppDocument *document);

/* A power of ten below what a pixel shows, a tenth of that where the hand moves finely; a round step of some eight
 * pixels where numbers are to be round. */
double app_hold_grain(double pixel_mm, gboolean fine, gboolean round);

#endif
