/* SPDX-License-Identifier: MIT */
/* Which surfaces may stand in the light of a planned one. */
#ifndef LX_PICTURE_BLOCKERS_H
#define LX_PICTURE_BLOCKERS_H

#include "plan.h"

/* Puts those that may stand in the light of an emitter behind the end of the list.  How many, or -1: memory ran out. */
int lx_find_blockers(const struct lx_plan *plan, struct lx_planned_surface *lit, const struct lx_emitter *emitter);

#endif
