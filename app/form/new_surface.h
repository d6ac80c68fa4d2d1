/* SPDX-License-Identifier: MIT */
/*
 * New surfaces, of a kind or a mesh file, each where it is seen; and what a file becomes in a scene: a mesh one more
 * surface, a photometry file one more source.
 */
#ifndef LUXEL_APP_NEW_SURFACE_H
#define LUXEL_APP_NEW_SURFACE_H

#include "../files/document.h"

/* What a file is by the ending of its name. */
typedef enum AppFileKind { APP_FILE_OTHER, APP_FILE_MESH, APP_FILE_LUMINAIRE } AppFileKind;
AppFileKind app_file_kind(const char *path);

/* A path as the document's scene names it: from the scene's folder where the file lies in it, else whole; the
 * caller's. */
char *app_file_in_scene(const AppDocument *document, const char *path);

/*
 * A surface of a kind as YAML, the caller's: its example, of a size that suits the screen, where the observer sees it;
 * a room around all there is.  NULL: there is no such kind, or it has no example, as a mesh of a file.
 */
char *app_new_surface(const AppDocument *document, const luxel_parameters *parameters, const char *kind);
/* The surface `chosen`, moved aside so that both are seen where that is possible, as YAML; the caller's. */
char *app_doubled_surface(const AppDocument *document, gsize chosen);

/*
 * A surface of a mesh file as YAML, the caller's: as large as it is where that suits the screen, else made so, before
 * the first surface, where the observer sees it.  NULL: it cannot be read, the diagnostics say why.
 */
char *app_new_mesh(const AppDocument *document, const char *path, luxel_diagnostics *diagnostics);

#endif
