/* SPDX-License-Identifier: MIT */
/*
 * The panes at the sides of the picture have the widths that a hand gave them, here or in another window.  They are
 * placed when it is known how wide the window really is, and kept only when the divider itself was moved: what a small
 * or a maximized window makes of them is no one's wish.
 */
#include "window_private.h"

enum { LEFT_WIDTH = 340, RIGHT_WIDTH = 380, LEAST_LEFT = 206, LEAST_RIGHT = 205, LEAST_CENTER = 300, NARROW = 1200 };
static const double CENTER_SHARE = 0.6; /* of a narrow window: the picture comes before what stands at its sides */

static void keep(AppWindow *self, const char *key, int *kept, int width)
{
    if (width <= 0 || width == *kept)
        return;
    *kept = width;
    if (self->settings)
        g_settings_set_int(self->settings, key, width);
}

static void keep_both(AppWindow *self)
{
    GtkPaned *left = GTK_PANED(self->left_pane), *right = GTK_PANED(self->right_pane);
    const int whole = gtk_widget_get_width(self->right_pane);
    keep(self, "left-width", &self->left_width, gtk_paned_get_position(left));
    if (gtk_widget_get_visible(self->right_box))
        keep(self, "right-width", &self->right_width, whole - gtk_paned_get_position(right));
}

/* A divider moves by a hand while a button is held, and by what the window does otherwise. */
static void divider_moved(GtkPaned *pane, GParamSpec *spec, AppWindow *self)
{
    (void)pane;
    (void)spec;
    if (self->is_placed && self->is_pressed)
        keep_both(self);
}

static gboolean divider_moved_by_keys(GtkPaned *pane, GtkScrollType type, AppWindow *self)
{
    (void)pane;
    (void)type;
    keep_both(self);
    return FALSE;
}

/* What a hand made of them, of a narrow window less: first the right side gives way, then the left one. */
static void find_widths(AppWindow *self, int *left, int *right)
{
    const int total = gtk_widget_get_width(self->left_pane);
    *left = self->left_width;
    *right = self->right_width;
    if (total <= 0 || total >= NARROW)
        return;
    const int shown = gtk_widget_get_visible(self->right_box) ? *right : 0;
    int over = *left + shown + (int)(CENTER_SHARE * total) - total;
    if (over > 0 && shown > LEAST_RIGHT) {
        *right = MAX(shown - over, LEAST_RIGHT);
        over -= shown - *right;
    }
    if (over > 0 && *left > LEAST_LEFT)
        *left = MAX(*left - over, LEAST_LEFT);
}

/* A pane counts from the left, the right side's width from the right. */
static void place(AppWindow *self)
{
    int left, right;
    find_widths(self, &left, &right);
    const int whole = gtk_widget_get_width(self->right_pane);
    const int position = MAX(whole - right, LEAST_CENTER);
    if (gtk_paned_get_position(GTK_PANED(self->left_pane)) != left)
        gtk_paned_set_position(GTK_PANED(self->left_pane), left);
    if (whole > 0 && position != gtk_paned_get_position(GTK_PANED(self->right_pane)))
        gtk_paned_set_position(GTK_PANED(self->right_pane), position);
}

static gboolean place_once(gpointer data)
{
    AppWindow *self = data;
    if (!app_window_is_open(self))
        return G_SOURCE_REMOVE;
    place(self);
    self->is_placed = TRUE;
    return G_SOURCE_REMOVE;
}

/* How far a divider can go is told when it is known how wide the pane is: at first, and whenever that changes. */
static void room_changed(GtkPaned *pane, GParamSpec *spec, AppWindow *self)
{
    (void)pane;
    (void)spec;
    if (!self->is_pressed)
        g_idle_add_full(G_PRIORITY_HIGH_IDLE, place_once, g_object_ref(self), g_object_unref);
}

void app_window_watch_panes(AppWindow *self)
{
    self->left_width = self->settings ? g_settings_get_int(self->settings, "left-width") : LEFT_WIDTH;
    self->right_width = self->settings ? g_settings_get_int(self->settings, "right-width") : RIGHT_WIDTH;
    gtk_paned_set_position(GTK_PANED(self->left_pane), self->left_width);
    g_signal_connect(self->left_pane, "notify::position", G_CALLBACK(divider_moved), self);
    g_signal_connect(self->right_pane, "notify::position", G_CALLBACK(divider_moved), self);
    g_signal_connect_after(self->left_pane, "move-handle", G_CALLBACK(divider_moved_by_keys), self);
    g_signal_connect_after(self->right_pane, "move-handle", G_CALLBACK(divider_moved_by_keys), self);
    g_signal_connect(self->right_pane, "notify::max-position", G_CALLBACK(room_changed), self);
}
