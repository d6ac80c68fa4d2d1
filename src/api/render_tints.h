/* SPDX-License-Identifier: MIT */
/*
 * The colours of what pixels show, for pictures in colour of direct light: they are sums of grey pictures of what
 * materials scatter and of their highlights, which each pixel takes by the colours of its own material.
 */
#ifndef LX_API_RENDER_TINTS_H
#define LX_API_RENDER_TINTS_H

#include "../field/field.h"
#include "../scene/colours.h"
#include "session.h"

struct lx_tint {
    double factors[2][LX_CHANNELS]; /* of what is scattered, and of highlights */
};

struct lx_tints {
    struct lx_tint *list;  /* of the surfaces, from the second on; the first is of none */
    uint32_t *of_pixels;   /* which of them */
    double greatest[2][3]; /* factors of all surfaces */
};

/* Those of the picture of a session with a plan.  lx_tints_clear() is due whatever it returns; -1: memory ran out. */
int lx_tints_make(const struct lx_session *session, const struct luxel_field *field, struct lx_tints *tints);
void lx_tints_clear(struct lx_tints *tints);

#endif
