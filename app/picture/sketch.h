/* SPDX-License-Identifier: MIT */
/* Sketches: small grey pictures of scenes that are not open, by their direct light, made one after another by a thread
 * of their own. */
#ifndef LUXEL_APP_SKETCH_H
#define LUXEL_APP_SKETCH_H

#include <glib.h>

/* It has at least so many columns and rows, where the scene's picture has them. */
enum { APP_SKETCH_COLUMNS = 200, APP_SKETCH_ROWS = 160 };

typedef struct AppSketch {
    char *scene;         /* as it was asked for */
    GBytes *pixels;      /* three bytes each, red, green, blue; NULL: the scene is not to be had, or takes long */
    guint columns, rows; /* of the pixels */
} AppSketch;

typedef struct AppSketcher AppSketcher;

/* `show` is called in the main loop with each sketch, in the order of the scenes. */
AppSketcher *app_sketcher_new(void (*show)(const AppSketch *sketch, gpointer owner), gpointer owner);
void app_sketcher_free(AppSketcher *sketcher); /* NULL is harmless */

/* Asks for sketches of files, or built-in scenes as "builtin:report"; an earlier question is given up. */
void app_sketcher_ask(AppSketcher *sketcher, const char *const *scenes);

#endif
