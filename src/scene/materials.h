/* SPDX-License-Identifier: MIT */
/* All materials of a scene that some surface, or a part of one, has: those of surfaces and those of single walls. */
#ifndef LX_SCENE_MATERIALS_H
#define LX_SCENE_MATERIALS_H

#include "scene.h"

/* The length of the longest key that leads to a material. */
enum { LX_MATERIAL_KEY_SIZE = 64 };

struct lx_scene_material {
    const struct lx_material *material; /* NULL: begin; and at the end */
    size_t surface;
    unsigned next;    /* part to look at */
    const char *part; /* which has it alone; NULL: the surface, or all parts that have none of their own */
};

/* Goes on to the next material, the surface's own before those of its parts; false behind the last. */
bool lx_next_material(const struct lx_scene_parameters *scene, struct lx_scene_material *at);

/* The material of a part of a surface, its place in the walk above. */
struct lx_scene_material lx_material_of(const struct lx_scene_parameters *scene, size_t surface, unsigned part);

/* Where it stands: "surfaces[0].material", or "surfaces[0].materials.floor". */
const char *lx_material_key(const struct lx_scene_material *at, char buffer[LX_MATERIAL_KEY_SIZE]);

/* Whether the surface's own material is that of any of its parts. */
bool lx_uses_own_material(const struct lx_item *surface);

#endif
