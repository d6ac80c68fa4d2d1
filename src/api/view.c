/* SPDX-License-Identifier: MIT */
/* The camera of a committed scene, for front ends. */
#include <luxel/view.h>

#include "../shade/camera.h"

bool luxel_scene_project(const luxel_scene *scene, const double position_mm[3], double screen_mm[2])
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    return parameters && position_mm && screen_mm && lx_project(&parameters->observer, position_mm, screen_mm);
}

bool luxel_scene_unproject(const luxel_scene *scene, const double screen_mm[2], double z_mm, double position_mm[3])
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    return parameters && screen_mm && position_mm && lx_unproject(&parameters->observer, screen_mm, z_mm, position_mm);
}
