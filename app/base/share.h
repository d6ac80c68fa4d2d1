/* SPDX-License-Identifier: MIT */
/*
 * The share of a source at the place under the pointer: a bar in the source's colour, what it gives and how much of the
 * whole that is, in columns that stay where they are.
 */
#ifndef LUXEL_APP_SHARE_H
#define LUXEL_APP_SHARE_H

#include <gtk/gtk.h>

#define APP_TYPE_SHARE (app_share_get_type())
G_DECLARE_FINAL_TYPE(AppShare, app_share, APP, SHARE, GtkWidget)

GtkWidget *app_share_new(gsize light);

/* Shows a share of the whole; a NaN shows nothing, as there is no pointer. */
void app_share_set(AppShare *self, double share, double whole);

#endif
