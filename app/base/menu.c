/* SPDX-License-Identifier: MIT */
/* Menus that are made when they are asked for, and go when they are closed. */
#include "menu.h"

GtkWidget *app_menu_add(GtkWidget *box, const char *text)
{
    GtkWidget *item = gtk_button_new_with_label(text);
    gtk_button_set_has_frame(GTK_BUTTON(item), FALSE);
    gtk_label_set_xalign(GTK_LABEL(gtk_button_get_child(GTK_BUTTON(item))), 0);
    gtk_box_append(GTK_BOX(box), item);
    return item;
}

static gboolean remove_menu(gpointer popover)
{
    if (gtk_widget_get_parent(popover))
        gtk_widget_unparent(popover);
    return G_SOURCE_REMOVE;
}

/* The action that was clicked is still to be done; it may make another form, of which the menu is no part. */
static void menu_closed(GtkWidget *popover, gpointer data)
{
    (void)data;
    g_idle_add_full(G_PRIORITY_DEFAULT_IDLE, remove_menu, g_object_ref(popover), g_object_unref);
}

void app_menu_show(GtkWidget *popover, GtkWidget *parent, GtkWidget *at)
{
    graphene_rect_t bounds;
    gtk_widget_set_parent(popover, parent);
    if (gtk_widget_compute_bounds(at, parent, &bounds)) {
        const GdkRectangle place = {(int)bounds.origin.x, (int)bounds.origin.y, (int)bounds.size.width,
                                    (int)bounds.size.height};
        gtk_popover_set_pointing_to(GTK_POPOVER(popover), &place);
    }
    g_signal_connect(popover, "closed", G_CALLBACK(menu_closed), NULL);
    gtk_popover_popup(GTK_POPOVER(popover));
}
