/* SPDX-License-Identifier: MIT */
/*
 * A camera: a scene seen from wherever somebody wants to look at it, with the bodies and the light that it has.  The
 * desktop app and the web page show a scene in space by it.
 */
#ifndef LUXEL_FRONT_CAMERA_H
#define LUXEL_FRONT_CAMERA_H

#include <luxel/luxel.h>

/* Where a camera is, and what it sees: a screen around its target, at right angles to the line of sight. */
typedef struct camera {
    double eye_mm[3], target_mm[3];
    double up[3]; /* what is upwards on the screen */
    double width_mm, height_mm;
    unsigned columns, rows; /* of pixels, which are square */
} camera;

/*
 * A committed copy of a scene with the camera as its observer; the caller's, luxel_scene_free().  NULL where it sees
 * nothing, as from inside a body; the diagnostics (NULL: none) tell why.
 */
luxel_scene *camera_scene(const luxel_scene *scene, const camera *from, luxel_diagnostics *diagnostics);

/* How far it is along the line of sight to what each of `count` pixels of such a copy shows, row by row from the top;
 * 0: nothing is seen there.  Errors as luxel_find_geometry() lists them. */
luxel_status camera_depth(const luxel_scene *seen, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          float *depth_mm, size_t count);

#endif
