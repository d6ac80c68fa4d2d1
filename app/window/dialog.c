/* SPDX-License-Identifier: MIT */
/* Dialogs are windows: those of the toolkit that ask for more than a file are about to go. */
#include "dialog.h"

#include "../../front/words.h"
#include "../base/row.h"

enum { MARGIN = 16 };

static gboolean cancelled(GtkWidget *widget, GVariant *arguments, gpointer dialog)
{
    (void)widget;
    (void)arguments;
    gtk_window_destroy(dialog);
    return TRUE;
}

GtkWidget *app_dialog_frame(GtkWindow *parent, const char *title, GtkWidget *child)
{
    GtkWidget *dialog = gtk_window_new();
    GtkEventController *keys = gtk_shortcut_controller_new();
    gtk_widget_set_margin_start(child, MARGIN);
    gtk_widget_set_margin_end(child, MARGIN);
    gtk_widget_set_margin_top(child, MARGIN);
    gtk_widget_set_margin_bottom(child, MARGIN);
    gtk_window_set_child(GTK_WINDOW(dialog), child);
    gtk_window_set_title(GTK_WINDOW(dialog), title);
    gtk_window_set_transient_for(GTK_WINDOW(dialog), parent);
    gtk_window_set_destroy_with_parent(GTK_WINDOW(dialog), TRUE);
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(keys),
        gtk_shortcut_new(gtk_keyval_trigger_new(GDK_KEY_Escape, 0), gtk_callback_action_new(cancelled, dialog, NULL)));
    gtk_widget_add_controller(dialog, keys);
    return dialog;
}

GtkWidget *app_dialog_new(GtkWindow *parent, const char *title, GtkWidget **rows)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, MARGIN), *dialog = app_dialog_frame(parent, title, box);
    *rows = gtk_grid_new();
    gtk_grid_set_column_spacing(GTK_GRID(*rows), MARGIN);
    gtk_grid_set_row_spacing(GTK_GRID(*rows), MARGIN / 2);
    gtk_box_append(GTK_BOX(box), *rows);
    gtk_window_set_resizable(GTK_WINDOW(dialog), FALSE);
    return dialog;
}

void app_dialog_add_row(GtkWidget *rows, const char *label, GtkWidget *field)
{
    GtkWidget *words = gtk_label_new(label);
    int row = 0;
    while (gtk_grid_get_child_at(GTK_GRID(rows), 0, row))
        row++;
    gtk_label_set_xalign(GTK_LABEL(words), 0);
    app_name_control(field, label);
    gtk_grid_attach(GTK_GRID(rows), words, 0, row, 1, 1);
    gtk_grid_attach(GTK_GRID(rows), field, 1, row, 1, 1);
}

GtkWidget *app_dialog_add_buttons(GtkWidget *dialog, GtkWidget *note, const char *accept)
{
    GtkWidget *box = gtk_window_get_child(GTK_WINDOW(dialog)), *buttons = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8);
    GtkWidget *cancel = gtk_button_new_with_label(_("Cancel")), *button = gtk_button_new_with_label(accept);
    gtk_widget_set_halign(buttons, GTK_ALIGN_END);
    gtk_widget_add_css_class(button, "suggested-action");
    g_signal_connect_swapped(cancel, "clicked", G_CALLBACK(gtk_window_destroy), dialog);
    gtk_box_append(GTK_BOX(buttons), cancel);
    gtk_box_append(GTK_BOX(buttons), button);
    if (note)
        gtk_box_append(GTK_BOX(box), note);
    gtk_box_append(GTK_BOX(box), buttons);
    return button;
}
