/* SPDX-License-Identifier: MIT */
/*
 * A scene lit by a group of its lights, as a scene of its own: for texts that are to tell of that group, and to be
 * computed again.  Numbers need no such copy: lx_prepare() takes the group.
 */
#ifndef LX_SCENE_LIT_H
#define LX_SCENE_LIT_H

#include <luxel/render.h>

#include "scene.h"

/* Which lights of a scene's list give light: the settings' group, or those that are enabled; NULL: memory ran out.  It
 * is the caller's. */
bool *lx_lights_on(const struct lx_scene_parameters *scene, const luxel_settings *settings);

/*
 * A committed copy of a committed scene in which the lights of the settings' group are enabled and no others; where
 * there is no group (NULL settings have none), or where it is those that are enabled anyway, *lit is NULL, and the
 * scene will do.  LUXEL_OK, or why that scene cannot be made, which is reported.
 */
luxel_status lx_scene_lit(const luxel_scene *scene, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          luxel_scene **lit);

/* Whether some light is no point, so that an exact value takes an integral, of which thousands take too long for a
 * figure. */
bool lx_has_extended_lights(const struct lx_scene_parameters *scene);

#endif
