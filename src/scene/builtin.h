/* SPDX-License-Identifier: MIT */
/* The built-in scenes, which tools/embed.py turns from data/scenes/ into a table. */
#ifndef LX_SCENE_BUILTIN_H
#define LX_SCENE_BUILTIN_H

struct lx_builtin {
    const char *name, *title, *text;
};

extern const struct lx_builtin lx_builtins[]; /* ends with a name that is NULL */

#endif
