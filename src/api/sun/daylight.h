/* SPDX-License-Identifier: MIT */
/* A scene lit by daylight alone, for whoever shows daylight factors as what they are: a share of irradiance. */
#ifndef LX_API_DAYLIGHT_H
#define LX_API_DAYLIGHT_H

#include <luxel/scene.h>

/*
 * A committed copy of a committed scene in which only its skies shine, together so strong that they give 100 to a
 * horizontal plane under the open sky: there an irradiance is the daylight factor in percent.  LUXEL_ERROR_SCENE: there
 * is no sky, or it is dark.
 */
luxel_status lx_daylit_scene(const luxel_scene *scene, luxel_diagnostics *diagnostics, luxel_scene **daylit);

#endif
