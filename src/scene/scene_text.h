/* SPDX-License-Identifier: MIT */
/*
 * The text of a scene that a picture carries.  Writing it takes longer than rendering a small picture, and few pictures
 * are asked for it, so it is written when it is first wanted.
 *
 * Threads: any number may ask for one text at once.
 */
#ifndef LX_SCENE_SCENE_TEXT_H
#define LX_SCENE_SCENE_TEXT_H

#include "scene.h"

struct lx_scene_text;

/* The text of a scene as it is now, however it changes later, or one that was read; NULL: memory ran out. */
struct lx_scene_text *lx_scene_text_of(const luxel_scene *scene);
struct lx_scene_text *lx_scene_text_copy(const char *bytes, size_t length);

/* NULL is harmless. */
void lx_scene_text_free(struct lx_scene_text *text);

/* Its characters, which live as long as it does; NULL where there is none (`text` NULL), or more than can be read
 * again. */
luxel_status lx_scene_text_get(struct lx_scene_text *text, const char **characters);

#endif
