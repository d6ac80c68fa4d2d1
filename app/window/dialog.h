/* SPDX-License-Identifier: MIT */
/* Small windows that go with their parent and by Esc, and those of them that ask for something, of one size. */
#ifndef LUXEL_APP_DIALOG_H
#define LUXEL_APP_DIALOG_H

#include <gtk/gtk.h>

/* A window with this in it that is not shown yet. */
GtkWidget *app_dialog_frame(GtkWindow *parent, const char *title, GtkWidget *child);
/* One that asks, not shown yet either, with rows of a label and a field (GtkGrid) to be filled. */
GtkWidget *app_dialog_new(GtkWindow *parent, const char *title, GtkWidget **rows);
/* A row with a field, named by its label; the row below the last one. */
void app_dialog_add_row(GtkWidget *rows, const char *label, GtkWidget *field);
/* The foot below the rows: `note`, NULL: nothing, and two buttons, of which the first closes the dialog. */
GtkWidget *app_dialog_add_buttons(GtkWidget *dialog, GtkWidget *note, const char *accept);

#endif
