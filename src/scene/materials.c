/* SPDX-License-Identifier: MIT */
/* Walking over the materials of a scene. */
#include "materials.h"

#include <stdio.h>

#include "../surface/part.h"

static const struct lx_surface_kind *kind_of(const struct lx_item *surface)
{
    return (const struct lx_surface_kind *)surface->variant;
}

/* The material that a part has alone; NULL: that of the surface. */
static const struct lx_material *material_of_part(const struct lx_item *surface, unsigned i)
{
    struct lx_part part;
    lx_part_make(kind_of(surface), surface->parameters, i, &part);
    return part.material;
}

bool lx_uses_own_material(const struct lx_item *surface)
{
    for (unsigned i = 0; i < lx_part_count(kind_of(surface)); i++)
        if (!material_of_part(surface, i))
            return true;
    return false;
}

static const struct lx_material *own_material(const struct lx_item *surface)
{
    return &((const struct lx_surface_common *)surface->common)->material;
}

bool lx_next_material(const struct lx_scene_parameters *scene, struct lx_scene_material *at)
{
    const bool begins = !at->material;
    if (begins)
        *at = (struct lx_scene_material){.surface = 0};
    for (bool is_new = begins; at->surface < scene->surfaces.count; at->surface++, at->next = 0, is_new = true) {
        const struct lx_item *surface = &scene->surfaces.items[at->surface];
        at->part = NULL;
        at->material = own_material(surface);
        if (is_new && lx_uses_own_material(surface))
            return true;
        for (unsigned count = lx_part_count(kind_of(surface)); at->next < count;) {
            at->part = lx_part_name(kind_of(surface), at->next);
            at->material = material_of_part(surface, at->next++);
            if (at->material)
                return true;
        }
    }
    at->material = NULL;
    return false;
}

struct lx_scene_material lx_material_of(const struct lx_scene_parameters *scene, size_t surface, unsigned part)
{
    const struct lx_item *item = &scene->surfaces.items[surface];
    const struct lx_material *material = material_of_part(item, part);
    return (struct lx_scene_material){
        .material = material ? material : own_material(item),
        .surface = surface,
        .part = material ? lx_part_name(kind_of(item), part) : NULL,
    };
}

const char *lx_material_key(const struct lx_scene_material *at, char buffer[LX_MATERIAL_KEY_SIZE])
{
    snprintf(buffer, LX_MATERIAL_KEY_SIZE, "surfaces[%zu].material%s%s", at->surface, at->part ? "s." : "",
             at->part ? at->part : "");
    return buffer;
}
