/* SPDX-License-Identifier: MIT */
/* The silhouettes of a scene's meshes. */
#include <luxel/mesh.h>

#include <math.h>
#include <stdlib.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "../scene/scene.h"
#include "../surface/mesh.h"
#include "../surface/silhouette.h"

/* How far two vectors may be from unit ones at right angles. */
static const double SLACK = 1e-6;

static bool are_axes(const double right[3], const double up[3])
{
    return fabs(lx_dot(right, right) - 1) < SLACK && fabs(lx_dot(up, up) - 1) < SLACK &&
           fabs(lx_dot(right, up)) < SLACK;
}

/* Lines in mm out of those in the frame of the tree. */
static luxel_silhouette *make(const struct lx_silhouette *traced, double size, const double anchor[2])
{
    luxel_silhouette *made = lx_new_array(1, sizeof *made);
    luxel_silhouette_line *lines = lx_new_array(traced->line_count, sizeof *lines);
    double(*places)[2] = lx_new_array(traced->place_count, sizeof *places);
    if (!made || !lines || !places) {
        free(places);
        free(lines);
        free(made);
        return NULL;
    }
    for (size_t i = 0; i < traced->place_count; i++)
        for (int axis = 0; axis < 2; axis++)
            places[i][axis] = anchor[axis] + size * traced->places[i][axis];
    for (size_t i = 0, begin = 0; i < traced->line_count; begin = traced->ends[i++])
        lines[i] = (luxel_silhouette_line){(const double(*)[2])places + begin, traced->ends[i] - begin};
    *made = (luxel_silhouette){.lines = lines, .count = traced->line_count};
    if (made->count == 0) /* the first line holds the places of all */
        free(places);
    return made;
}

luxel_status luxel_find_silhouette(const luxel_scene *scene, size_t i, const double right[3], const double up[3],
                                   luxel_silhouette **silhouette)
{
    const struct lx_scene_parameters *parameters = lx_scene_parameters(scene);
    struct lx_mesh_use use;
    if (!parameters || i >= parameters->surfaces.count || !right || !up || !silhouette || !are_axes(right, up))
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_item *item = &parameters->surfaces.items[i];
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    if (!kind->mesh || !kind->mesh(item->parameters, &use))
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_shape shape = lx_surface_shape(kind, item->parameters);
    const struct lx_mesh_body *body = shape.body;
    const double size = lx_mesh_size_of(&shape),
                 anchor[2] = {lx_dot(shape.anchor_mm, right), lx_dot(shape.anchor_mm, up)};
    struct lx_silhouette traced = {0};
    double axes[2][3];
    for (int axis = 0; axis < 2; axis++) {
        lx_mesh_enter(&shape, axis ? up : right, axes[axis]); /* which divides by the size */
        for (int k = 0; k < 3; k++)
            axes[axis][k] *= size;
    }
    if (body->tree && lx_trace_silhouette(body->tree, axes[0], axes[1], &traced))
        return LUXEL_ERROR_MEMORY;
    luxel_silhouette *made = make(&traced, size, anchor);
    lx_clear_silhouette(&traced);
    if (!made)
        return LUXEL_ERROR_MEMORY;
    *silhouette = made;
    return LUXEL_OK;
}

void luxel_silhouette_free(luxel_silhouette *silhouette)
{
    if (!silhouette)
        return;
    if (silhouette->count > 0)
        free((void *)silhouette->lines[0].places_mm);
    free((void *)silhouette->lines);
    free(silhouette);
}
