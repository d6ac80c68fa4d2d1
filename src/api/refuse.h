/* SPDX-License-Identifier: MIT */
/* Whether a scene has reflected light, for whoever need not know how that is found. */
#ifndef LX_API_REFUSE_H
#define LX_API_REFUSE_H

#include "../scene/scene.h"

/* Whether a scene wants light to be reflected. */
bool lx_wants_reflections(const struct lx_scene_parameters *scene);

#endif
