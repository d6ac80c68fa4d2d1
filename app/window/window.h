/* SPDX-License-Identifier: MIT */
/* A window: one document, its picture, its forms and numbers, and all that can be done with them. */
#ifndef LUXEL_APP_WINDOW_H
#define LUXEL_APP_WINDOW_H

#include <gtk/gtk.h>

#include "application.h"

#define APP_TYPE_WINDOW (app_window_get_type())
G_DECLARE_FINAL_TYPE(AppWindow, app_window, APP, WINDOW, GtkApplicationWindow)

AppWindow *app_window_new(AppApplication *application);
/* Opens a file here; where that fails the reason is shown and the document stays. */
gboolean app_window_open(AppWindow *self, const char *path);
/* Shows a built-in scene, as it shows a file. */
void app_window_open_builtin(AppWindow *self, const char *name);
/* Whether there is nothing in it yet that opening a file could take away. */
gboolean app_window_is_fresh(AppWindow *self);
/* Offers unsaved work that was found. */
void app_window_offer_unsaved(AppWindow *self);

#endif
