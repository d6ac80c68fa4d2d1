/* SPDX-License-Identifier: MIT */
/* Widgets that show what is of another version of the scene than the one that is shown. */
#ifndef LUXEL_APP_DIM_H
#define LUXEL_APP_DIM_H

#include <gtk/gtk.h>

/* Dims a widget, and tells screen readers that it waits for another content. */
void app_set_stale(GtkWidget *widget, gboolean is_stale);

#endif
