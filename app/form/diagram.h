/* SPDX-License-Identifier: MIT */
/*
 * The polar diagram of a luminaire's file, as `luxel photometry -o` draws it, beside the form of the source, with its
 * flux, peak and beam, and its table of glare ratings.
 */
#ifndef LUXEL_APP_DIAGRAM_H
#define LUXEL_APP_DIAGRAM_H

#include <gtk/gtk.h>

#define APP_TYPE_DIAGRAM (app_diagram_get_type())
G_DECLARE_FINAL_TYPE(AppDiagram, app_diagram, APP, DIAGRAM, GtkBox)

GtkWidget *app_diagram_new(void);
/* Shows a file; NULL, or one that cannot be read: nothing. */
void app_diagram_show(AppDiagram *self, const char *path);

#endif
