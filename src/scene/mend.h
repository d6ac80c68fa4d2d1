/* SPDX-License-Identifier: MIT */
/* What mends that which advice is about, as assignments: "-s 'screen.width=600' -s 'screen.height=600'". */
#ifndef LX_SCENE_MEND_H
#define LX_SCENE_MEND_H

#include "object.h"

/* Adds one assignment, made like printf without numbers of floating point. */
void lx_mend_add(struct lx_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Gives the last advice the text as its hint to try; nothing for an empty text.  Takes the text over. */
void lx_mend_hint(struct lx_walk *walk, struct lx_text *text);

/*
 * As lx_walk.mend: brings a number to the nearest one that is advised; for the screen's, all of them that hang
 * together. Nothing where the scene would not do with it, or is so large that trying takes long.
 */
void lx_mend_number(struct lx_walk *walk, const struct lx_step *step, double nearest);

#endif
