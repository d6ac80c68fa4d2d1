/* SPDX-License-Identifier: MIT */
/* Scenes with reflected light, for whoever does not know it. */
#ifndef LX_API_REFUSE_H
#define LX_API_REFUSE_H

#include "../scene/scene.h"

/* Whether a scene wants light to be reflected. */
bool lx_wants_reflections(const struct lx_scene_parameters *scene);

/* Reports that something knows no reflected light, where the scene wants it: LUXEL_ERROR_ARGUMENT, or LUXEL_OK. */
luxel_status lx_refuse_reflections(const struct lx_scene_parameters *scene, luxel_diagnostics *diagnostics);

#endif
