/* SPDX-License-Identifier: MIT */
/* The keyboard goes from pane to pane: the scene, the picture, the numbers and the colour bar. */
#include "window_private.h"

typedef enum Pane { PANE_SCENE, PANE_PICTURE, PANE_NUMBERS, PANE_BAR, PANES } Pane;

static GtkWidget *widget_of(AppWindow *self, Pane pane)
{
    GtkWidget *const widgets[PANES] = {self->left_scroll, app_window_camera(self), self->right_box, self->bar};
    return widgets[pane];
}

/* The pane that has the keyboard; what stands in none of them counts as before the first. */
static int pane_in_focus(AppWindow *self)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(self));
    for (int pane = 0; pane < PANES && focus; pane++)
        if (focus == widget_of(self, (Pane)pane) || gtk_widget_is_ancestor(focus, widget_of(self, (Pane)pane)))
            return pane;
    return -1;
}

void app_window_take_keyboard(AppWindow *self)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(self));
    if (pane_in_focus(self) < 0 || !gtk_widget_get_mapped(focus))
        gtk_widget_grab_focus(app_window_camera(self));
    gtk_window_present(GTK_WINDOW(self));
}

/* FALSE where the pane is hidden or nothing of it takes the keyboard. */
static gboolean focus_pane(AppWindow *self, Pane pane)
{
    GtkWidget *widget = widget_of(self, pane);
    if (!gtk_widget_get_mapped(widget))
        return FALSE;
    if (pane == PANE_PICTURE)
        return gtk_widget_grab_focus(widget);
    return pane_in_focus(self) == (int)pane || gtk_widget_child_focus(widget, GTK_DIR_TAB_FORWARD);
}

static void choose_pane(GSimpleAction *action, GVariant *pane, gpointer data)
{
    AppWindow *self = data;
    const guint number = g_variant_get_uint32(pane);
    (void)action;
    if (number == PANE_NUMBERS)
        g_action_group_change_action_state(G_ACTION_GROUP(self), "numbers", g_variant_new_boolean(TRUE));
    if (number < PANES)
        focus_pane(self, (Pane)number);
}

static void next_pane(GSimpleAction *action, GVariant *step, gpointer data)
{
    AppWindow *self = data;
    const int way = g_variant_get_int32(step) < 0 ? PANES - 1 : 1;
    int pane = pane_in_focus(self);
    (void)action;
    if (pane < 0)
        pane = way == 1 ? PANES - 1 : PANE_SCENE;
    for (int i = 0; i < PANES; i++) {
        pane = (pane + way) % PANES;
        if (focus_pane(self, (Pane)pane))
            return;
    }
}

static void choose_source(GSimpleAction *action, GVariant *index, gpointer data)
{
    AppWindow *self = data;
    const guint number = g_variant_get_uint32(index);
    (void)action;
    if (number >= app_document_size(self->document, "lights"))
        return;
    app_view_select(self->view, APP_MARK_SOURCE, number);
    g_signal_emit_by_name(self->view, "selected", (int)APP_MARK_SOURCE, number);
}

void app_window_add_focus_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "pane", .activate = choose_pane, .parameter_type = "u"},
        {.name = "next-pane", .activate = next_pane, .parameter_type = "i"},
        {.name = "source-choose", .activate = choose_source, .parameter_type = "u"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}
