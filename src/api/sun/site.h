/* SPDX-License-Identifier: MIT */
/* The site of a scene, for whoever asks where its sun stands. */
#ifndef LX_API_SUN_SITE_H
#define LX_API_SUN_SITE_H

#include "../../light/sky/site.h"
#include "../../scene/scene.h"

/* As its first light says that has a place; else as the first sun or sky; else plain. */
void lx_find_sun_site(const struct lx_scene_parameters *scene, struct lx_sun_site *site);

#endif
