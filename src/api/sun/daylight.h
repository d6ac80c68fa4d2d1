/* SPDX-License-Identifier: MIT */
/* The skies of a scene; and the scene lit by them alone, whose irradiances are daylight factors. */
#ifndef LX_API_DAYLIGHT_H
#define LX_API_DAYLIGHT_H

#include <luxel/bounded.h>
#include <luxel/scene.h>

/* Lights of a scene, and what they give to a horizontal plane under the open sky. */
struct lx_skies {
    size_t *items;
    size_t count;
    luxel_bounded horizontal;
};

/* Finds the skies that shine, whose items the caller frees in any case.  LUXEL_ERROR_SCENE: there is none, or it is
 * dark. */
luxel_status lx_find_skies(const luxel_scene *scene, luxel_diagnostics *diagnostics, struct lx_skies *skies);

/*
 * A committed copy of a committed scene in which only its skies shine, together so strong that they give 100 to a
 * horizontal plane under the open sky: there an irradiance is the daylight factor in percent.  LUXEL_ERROR_SCENE: there
 * is no sky, or it is dark.
 */
luxel_status lx_daylit_scene(const luxel_scene *scene, luxel_diagnostics *diagnostics, luxel_scene **daylit);

#endif
