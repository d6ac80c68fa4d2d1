/* SPDX-License-Identifier: MIT */
/*
 * The class of the style sheet, and the state of being busy.  The class waits for a blink, as what follows within it
 * is not seen to be dimmed, and a change of style that is taken back costs as much as one that stays.
 */
#include "dim.h"

enum { BLINK = 120 /* ms */ };
static const char dimmed[] = "stale", waiting[] = "luxel-dims";

static gboolean dim(gpointer widget)
{
    g_object_steal_data(widget, waiting);
    gtk_widget_add_css_class(widget, dimmed);
    return G_SOURCE_REMOVE;
}

static void forget(gpointer timer)
{
    g_source_remove(GPOINTER_TO_UINT(timer));
}

void app_set_stale(GtkWidget *widget, gboolean is_stale)
{
    GObject *object = G_OBJECT(widget);
    const gboolean was = gtk_widget_has_css_class(widget, dimmed) || g_object_get_data(object, waiting) != NULL;
    if (was == is_stale)
        return;
    if (is_stale)
        g_object_set_data_full(object, waiting, GUINT_TO_POINTER(g_timeout_add(BLINK, dim, widget)), forget);
    else {
        g_object_set_data(object, waiting, NULL);
        gtk_widget_remove_css_class(widget, dimmed);
    }
    gtk_accessible_update_state(GTK_ACCESSIBLE(widget), GTK_ACCESSIBLE_STATE_BUSY, is_stale, -1);
}
