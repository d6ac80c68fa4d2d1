/* SPDX-License-Identifier: MIT */
/*
 * What domes give where nothing stands before them, kept with a prepared scene for all who ask, in any thread: an
 * integral over a patch of the sky takes milliseconds, and flat surfaces and grids ask for the same one at each of
 * their elements.  What is kept is what anybody would find, so it is no matter who finds it.
 */
#ifndef LX_WORLD_OPEN_DOMES_H
#define LX_WORLD_OPEN_DOMES_H

#include "reference.h"

struct lx_open_domes;

/* NULL: memory ran out, and nothing is kept. */
struct lx_open_domes *lx_open_domes_new(void);
void lx_open_domes_free(struct lx_open_domes *domes);

/* What a patch gives to elements like those that `open` is for, as exact as integrals of a tolerance are; false: nobody
 * has found that yet. */
bool lx_open_domes_look(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        struct lx_lighting *lighting);
void lx_open_domes_note(struct lx_open_domes *domes, const struct lx_open_dome *open, double tolerance, size_t patch,
                        const struct lx_lighting *lighting);

#endif
