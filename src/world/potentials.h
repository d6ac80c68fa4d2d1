/* SPDX-License-Identifier: MIT */
/*
 * The potentials of skies and panes (integral/sky_potential.h) that somebody asked for, kept with a prepared scene for
 * all threads.  What is found never moves and stays until all are freed.
 */
#ifndef LX_WORLD_POTENTIALS_H
#define LX_WORLD_POTENTIALS_H

#include "integral/sky_potential.h"

struct lx_potentials;

/* NULL: memory ran out. */
struct lx_potentials *lx_potentials_new(void);
void lx_potentials_free(struct lx_potentials *potentials);

/* That of a sky, by its address, or of a radiance of 1 (NULL), through an opening, or in the open (NULL).  NULL: there
 * is none. */
const struct lx_sky_potential *lx_potentials_find(struct lx_potentials *potentials, const struct lx_sky *sky,
                                                  const struct lx_glass_pane *opening);

#endif
