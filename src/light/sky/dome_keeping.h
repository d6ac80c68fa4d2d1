/* SPDX-License-Identifier: MIT */
/* Keeping domes: what lists of emitters do with one, without knowing what it is (dome.h). */
#ifndef LX_LIGHT_SKY_DOME_KEEPING_H
#define LX_LIGHT_SKY_DOME_KEEPING_H

struct lx_dome;
struct lx_frame;

/* Carried into another frame. */
struct lx_dome *lx_dome_carry(const struct lx_dome *dome, const struct lx_frame *frame);

/* One user less; NULL is harmless. */
void lx_dome_free(struct lx_dome *dome);

#endif
