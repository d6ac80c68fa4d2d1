/* SPDX-License-Identifier: MIT */
/* What the meshes of a scene are as bodies. */
#include <luxel/mesh.h>

#include <math.h>

#include "../light/light.h"
#include "../scene/scene.h"
#include "../surface/surface.h"

/* The volume in cubes of the file's unit; NaN where no body is bounded, or some faces would be counted against it. */
static double volume_of(const struct lx_mesh_survey *survey)
{
    return lx_is_closed(survey) && !survey->is_one_sided && survey->flipped == 0 ? survey->volume : (double)NAN;
}

static luxel_status answer(const struct lx_mesh_use *use, luxel_mesh_survey *survey)
{
    struct lx_mesh_survey made;
    const struct lx_mesh_survey *found = use->survey;
    double sizes[3];
    if (!found) {
        if (!lx_survey_mesh(use->mesh, &made))
            return LUXEL_ERROR_MEMORY;
        found = &made;
    }
    const double unit = use->scale_mm;
    lx_mesh_sizes(use->mesh, sizes);
    *survey = (luxel_mesh_survey){
        .key = use->key,
        .file = use->file,
        .triangles = found->triangles,
        .corners = found->corners,
        .edges = found->edges,
        .open_edges = found->open,
        .crowded_edges = found->crowded,
        .is_closed = lx_is_closed(found),
        .euler_number = found->euler,
        .parts = found->parts,
        .flipped_faces = found->turned_faces,
        .first_flipped = found->turned_at.number,
        .is_one_sided = found->is_one_sided,
        .volume_mm3 = volume_of(found) * unit * unit * unit,
        .scale_mm = unit,
        .size_mm = {sizes[0] * unit, sizes[1] * unit, sizes[2] * unit},
    };
    return LUXEL_OK;
}

/* Item i of a list; NULL: there is none. */
static const struct lx_item *item_of(const struct lx_list *list, size_t i)
{
    return i < list->count ? &list->items[i] : NULL;
}

luxel_status luxel_scene_surface_mesh(const luxel_scene *scene, size_t i, bool *is_mesh, luxel_mesh_survey *survey)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    const struct lx_item *item = parameters ? item_of(&parameters->surfaces, i) : NULL;
    struct lx_mesh_use use;
    if (!item || !is_mesh || !survey)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    *is_mesh = kind->mesh && kind->mesh(item->parameters, &use);
    return *is_mesh ? answer(&use, survey) : LUXEL_OK;
}

luxel_status luxel_scene_light_mesh(const luxel_scene *scene, size_t i, bool *is_mesh, luxel_mesh_survey *survey)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    const struct lx_item *item = parameters ? item_of(&parameters->lights, i) : NULL;
    struct lx_mesh_use use;
    if (!item || !is_mesh || !survey)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_light_kind *kind = (const struct lx_light_kind *)item->variant;
    *is_mesh = kind->mesh && kind->mesh(item->parameters, &use);
    return *is_mesh ? answer(&use, survey) : LUXEL_OK;
}
