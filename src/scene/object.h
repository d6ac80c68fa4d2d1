/* SPDX-License-Identifier: MIT */
/* The scene object itself, for the files of this room. */
#ifndef LX_SCENE_OBJECT_H
#define LX_SCENE_OBJECT_H

#include <luxel/parameter.h>

#include "../format/kept.h"
#include "../parameter/decode.h"
#include "../parameter/document.h"
#include "carried.h"
#include "scene.h"

struct luxel_scene {
    struct lx_document document;
    size_t compact_bytes; /* what the document held when it was last without garbage */
    bool committed;
    bool is_ahead;                           /* the parameters have values that the document has not (bind.h) */
    struct lx_scene_parameters parameters;   /* meaningful where committed */
    struct lx_carried carried;               /* of the picture that it was read from */
    char *folder;                            /* of the file that it was read from; NULL: none, or the current one */
    struct lx_kept_files kept;               /* what was read of the files that it names */
    struct lx_kept_slot *reflected;          /* what its surfaces reflect, once that was found; NULL: nothing is */
    struct lx_kept_slot *reflected_on_plane; /* likewise, for the measuring plane that was last */
    struct lx_kept *reflected_elsewhere;     /* of the scene that it is a copy of but for what sees it; NULL: nothing */
};

/* The public list of the parameters of any table. */
luxel_parameters *lx_parameters_of(const struct lx_table *table, luxel_translate translate, void *data);

/* Takes the readiness away and frees what it consists of. */
void lx_scene_uncommit(luxel_scene *scene);

/* Forgets what the scene that it is a copy of kept, as bodies, light or files are other ones. */
void lx_scene_part_from_original(luxel_scene *scene);

/* The text of a scene's document, as luxel_scene_write_text() gives it; the caller's. */
luxel_status lx_write_document(const struct lx_document *document, char **text);

/* Reports dimming groups that are there twice, or that no light is in. */
void lx_check_dimming(struct lx_walk *walk, const luxel_scene *scene);

/* A walk over the scene's document. */
struct lx_walk lx_scene_walk(const luxel_scene *scene, luxel_diagnostics *diagnostics);

/* The node of a key in a group of the scene, 0 where it is not written. */
lx_node_id lx_scene_node(const luxel_scene *scene, const char *group, const char *key);

/*
 * What must hold between the parts of a scene for pictures, as far as they are good themselves: something to see,
 * square pixels, an observer outside of all surfaces.  Sets walk->failed.
 */
void lx_validate_view(struct lx_walk *walk, const luxel_scene *scene);

/* Advice about a committed scene without surfaces, or with such that show the observer their backs. */
void lx_advise_unseen(struct lx_walk *walk, const luxel_scene *scene);

/* Advice about luminaires, measuring grids and rooms of a committed scene. */
void lx_advise_design(struct lx_walk *walk, const luxel_scene *scene);

/* Advice about colours of a committed scene. */
void lx_advise_colors(struct lx_walk *walk, const luxel_scene *scene);

/* Lays measuring grids that name a surface on its side, and reports those that cannot lie there. */
void lx_place_grids(struct lx_walk *walk, luxel_scene *scene);

/* Checks what reflected light asks of surfaces and lights. */
void lx_validate_reflections(struct lx_walk *walk, const luxel_scene *scene);

#endif
