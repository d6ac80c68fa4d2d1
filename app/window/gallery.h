/* SPDX-License-Identifier: MIT */
/*
 * The gallery: recent files and built-in scenes with their pictures, to begin with one of them.
 *
 * Signals: "chosen" (scene) with the path of a file, or "builtin:report"; "closed" when it is left without a choice.
 */
#ifndef LUXEL_APP_GALLERY_H
#define LUXEL_APP_GALLERY_H

#include <gtk/gtk.h>

#define APP_TYPE_GALLERY (app_gallery_get_type())
G_DECLARE_FINAL_TYPE(AppGallery, app_gallery, APP, GALLERY, GtkBox)

GtkWidget *app_gallery_new(void);

/* Shows what there is now, makes the pictures anew, and takes the keyboard. */
void app_gallery_open(AppGallery *self);

#endif
