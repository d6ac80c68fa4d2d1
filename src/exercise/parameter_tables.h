/* SPDX-License-Identifier: MIT */
/* The parameters of a scene as tables of a document: each key with its meaning, its value and the advised range. */
#ifndef LX_EXERCISE_PARAMETER_TABLES_H
#define LX_EXERCISE_PARAMETER_TABLES_H

#include "../document/document.h"
#include "../scene/scene.h"

/* Elements of a list that have a table of their own; the rest is only counted. */
enum { LX_MOST_PARAMETER_TABLES = 12 };

/*
 * Adds them for a committed scene: screen and observer, each surface with its material, each light.  What has no
 * effect, or was not given and has no default, is left out.
 */
void lx_add_parameter_tables(struct luxel_document *document, const struct lx_scene_parameters *scene);

/* "lights[0] window", or "lights[0]" where it has no name. */
void lx_add_element_name(struct lx_text *text, const char *list, size_t index, const char *name);

#endif
