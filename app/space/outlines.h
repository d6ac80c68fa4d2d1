/* SPDX-License-Identifier: MIT */
/*
 * The silhouettes of a scene's surfaces in plan and elevation.  Those of meshes are found once for each mesh and way
 * that it is turned and kept while a scene is worked on, as a million triangles take longer than a frame.
 */
#ifndef LUXEL_APP_OUTLINES_H
#define LUXEL_APP_OUTLINES_H

#include "space.h"

AppOutlines *app_outlines_new(void);
void app_outlines_free(AppOutlines *outlines);

/*
 * The silhouette of a surface in a projection, which lives until that is asked for again; NULL: there is none.  The
 * surface stood at `then_mm` when it was found, and stands at `now_mm`.
 */
const luxel_silhouette *app_outlines_find(AppOutlines *outlines, const luxel_scene *scene, gsize surface,
                                          AppProjection projection, double then_mm[3], double now_mm[3]);

#endif
