/* SPDX-License-Identifier: MIT */
/* The worlds of a scene in colour, one for each part of its light, for whoever asks all of them at each place. */
#ifndef LX_API_COLOR_WORLDS_H
#define LX_API_COLOR_WORLDS_H

#include "../scene/colours.h"
#include "session.h"

struct lx_color_worlds {
    struct lx_color_parts parts;
    struct lx_session *sessions; /* as many; NULL: not opened */
    size_t opened;
};

/* Parts the light that falls on planes.  lx_color_worlds_clear() is due whatever it returns. */
luxel_status lx_color_worlds_begin(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, struct lx_color_worlds *worlds);
/* Opens a session for each part.  Errors as lx_session_open_world(). */
luxel_status lx_color_worlds_open(struct lx_color_worlds *worlds, luxel_diagnostics *diagnostics);
void lx_color_worlds_clear(struct lx_color_worlds *worlds);

/* Adds what a part's world gives to a colour. */
void lx_color_add(const struct lx_color_part *part, lx_bounded value, luxel_color *color);

#endif
