/* SPDX-License-Identifier: MIT */
/* The class of the style sheet, and the state of being busy. */
#include "dim.h"

void app_set_stale(GtkWidget *widget, gboolean is_stale)
{
    static const char *const dimmed = "stale";
    if (gtk_widget_has_css_class(widget, dimmed) == is_stale)
        return;
    if (is_stale)
        gtk_widget_add_css_class(widget, dimmed);
    else
        gtk_widget_remove_css_class(widget, dimmed);
    gtk_accessible_update_state(GTK_ACCESSIBLE(widget), GTK_ACCESSIBLE_STATE_BUSY, is_stale, -1);
}
