/* SPDX-License-Identifier: MIT */
/* The lines that bodies, cones and outlines are drawn with, for the files that put a space together. */
#ifndef LUXEL_APP_SPACE_LINES_H
#define LUXEL_APP_SPACE_LINES_H

#include "space.h"

/* A value of the group of keys `base`, "" for the whole scene: its text, the caller's, or NULL; its numbers. */
char *app_space_text(const luxel_scene *scene, const char *base, const char *name);
gsize app_space_numbers(const luxel_scene *scene, const char *base, const char *name, double *numbers, gsize room);

/* To where a plate looks, a unit vector; FALSE: the surface is none. */
gboolean app_space_front(const luxel_scene *scene, gsize surface, double axis[3]);
/* Half of a surface's sides along the axes of the scene; FALSE: it has no size. */
gboolean app_space_half(const luxel_scene *scene, gsize surface, double half[3]);

/* Makes room for a place. */
void app_space_include(AppSpace *space, const double place_mm[3]);
/* Adds a chain, drawn in both projections. */
void app_space_add_line(AppSpace *space, AppLineKind kind, gsize index, gboolean closed, const double (*places)[3],
                        gsize count);

/* A body: whose it is, the keys that describe it, and its shape, such as "disk". */
typedef struct AppBody {
    AppLineKind kind;
    gsize index;
    const char *base, *shape;
} AppBody;

void app_space_add_body(AppSpace *space, const luxel_scene *scene, const AppBody *body);
/* The silhouettes of a surface, and to where its front looks where it has one. */
void app_space_add_surface(AppSpace *space, const luxel_scene *scene, AppOutlines *outlines, gsize index);
/* The cone of a spot, as lines and as itself. */
void app_space_add_cone(AppSpace *space, const luxel_scene *scene, const AppThing *lamp, const char *base,
                        double reach);

#endif
