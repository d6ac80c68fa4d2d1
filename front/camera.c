/* SPDX-License-Identifier: MIT */
/* A camera becomes the observer and the screen of a copy, by the keys that a scene file has for them. */
#include "camera.h"

#include <stdio.h>
#include <stdlib.h>

/* Numbers in 15 digits, which are read without arithmetic of more than 64 bits: the page's first part has no other. */
static bool look(luxel_scene *scene, const camera *from, luxel_diagnostics *diagnostics)
{
    char observer[512], screen[160];
    const double *const eye = from->eye_mm, *const target = from->target_mm, *const up = from->up;
    (void)snprintf(
        observer, sizeof observer,
        "observer={position: [%.15g, %.15g, %.15g], target: [%.15g, %.15g, %.15g], up: [%.15g, %.15g, %.15g], "
        "projection: perspective}",
        eye[0], eye[1], eye[2], target[0], target[1], target[2], up[0], up[1], up[2]);
    (void)snprintf(screen, sizeof screen, "screen={width: %.15g, height: %.15g, resolution: [%u, %u]}", from->width_mm,
                   from->height_mm, from->columns, from->rows);
    return luxel_scene_set(scene, observer, diagnostics) == LUXEL_OK &&
           luxel_scene_set(scene, screen, diagnostics) == LUXEL_OK &&
           luxel_scene_commit(scene, diagnostics) == LUXEL_OK;
}

luxel_scene *camera_scene(const luxel_scene *scene, const camera *from, luxel_diagnostics *diagnostics)
{
    luxel_scene *seen = scene ? luxel_scene_copy(scene) : NULL;
    if (seen && look(seen, from, diagnostics))
        return seen;
    luxel_scene_free(seen);
    return NULL;
}

luxel_status camera_depth(const luxel_scene *seen, const luxel_settings *settings, luxel_diagnostics *diagnostics,
                          float *depth_mm, size_t count)
{
    double *depth = calloc(count, sizeof *depth);
    const luxel_geometry wanted = {.depth_mm = depth};
    const luxel_status status = depth ? luxel_find_geometry(seen, settings, diagnostics, &wanted) : LUXEL_ERROR_MEMORY;
    for (size_t i = 0; i < count && status == LUXEL_OK; i++)
        depth_mm[i] = (float)depth[i];
    free(depth);
    return status;
}
