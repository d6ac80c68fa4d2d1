/* SPDX-License-Identifier: MIT */
/* The camera of a committed scene, for front ends. */
#include <luxel/view.h>

#include <math.h>

#include "../world/camera.h"

bool luxel_scene_project(const luxel_scene *scene, const double position_mm[3], double screen_mm[2])
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    if (!parameters || !position_mm || !screen_mm)
        return false;
    const struct lx_camera camera = lx_camera_of(&parameters->observer);
    return lx_project(&camera, position_mm, screen_mm);
}

bool luxel_scene_unproject(const luxel_scene *scene, const double screen_mm[2], double z_mm, double position_mm[3])
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    if (!parameters || !screen_mm || !position_mm)
        return false;
    const struct lx_camera camera = lx_camera_of(&parameters->observer);
    return lx_unproject(&camera, screen_mm, z_mm, position_mm);
}

bool luxel_scene_height(const luxel_scene *scene, const double position_mm[3], double *z_mm)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    double carried[3];
    if (!parameters || !position_mm || !z_mm)
        return false;
    const struct lx_frame frame = lx_observer_frame(&parameters->observer);
    lx_frame_carry(&frame, position_mm, carried);
    if (!isfinite(carried[2]))
        return false;
    *z_mm = carried[2];
    return true;
}
