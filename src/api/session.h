/* SPDX-License-Identifier: MIT */
/*
 * What rendering and probing share: checked settings, chosen kernels, the prepared scene, and the plan of its
 * picture.
 */
#ifndef LX_API_SESSION_H
#define LX_API_SESSION_H

#include <luxel/render.h>

#include "../picture/plan.h"
#include "../reflect/reflected.h"

struct lx_session {
    luxel_settings settings;
    const struct lx_kernels *kernels;
    struct lx_prepared prepared;
    struct lx_world world; /* of it; with what surfaces reflect, once somebody has found that */
    struct lx_plan plan;
    double done; /* share of the whole work that finding it was */
};

/* The scene is committed and the settings (NULL: the defaults) in their ranges; they are copied. */
luxel_status lx_settings_check(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                               luxel_settings *checked);

/* The scene prepared for checked settings.  Release with lx_prepared_clear() whatever it returns. */
luxel_status lx_session_prepare(const luxel_scene *scene, const luxel_settings *settings,
                                luxel_diagnostics *diagnostics, struct lx_prepared *prepared);

/* Begins a session by the settings, with kernels; lx_session_clear() is due in any case. */
luxel_status lx_session_begin(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                              struct lx_session *session);

/* Opens it with the prepared scene, but without a plan: for whoever needs no picture. */
luxel_status lx_session_open_world(const luxel_scene *scene, const luxel_settings *settings,
                                   luxel_diagnostics *diagnostics, struct lx_session *session);

/* With the plan of the picture.  Release with lx_session_clear() whatever they return.  Errors as luxel_render() lists
 * them. */
luxel_status lx_session_open(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                             struct lx_session *session);
void lx_session_clear(struct lx_session *session);

#endif
