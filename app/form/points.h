/* SPDX-License-Identifier: MIT */
/* The measuring points of the scene: their places, to be typed, pasted, added and deleted. */
#ifndef LUXEL_APP_POINTS_H
#define LUXEL_APP_POINTS_H

#include <gtk/gtk.h>

#include "../files/document.h"

#define APP_TYPE_POINTS (app_points_get_type())
G_DECLARE_FINAL_TYPE(AppPoints, app_points, APP, POINTS, GtkBox)

GtkWidget *app_points_new(AppDocument *document);
void app_points_refresh(AppPoints *self);

/* Esc and undo in a field that was typed into: the place that holds is shown again.  FALSE: there was nothing else. */
gboolean app_points_restore(AppPoints *self, GtkWidget *focus);

void app_points_add(AppPoints *self, double x_mm, double y_mm);
/* Adds a point for each "x, y" of a text; NULL, or what is wrong with it: the caller's. */
char *app_points_paste(AppPoints *self, const char *text);

#endif
