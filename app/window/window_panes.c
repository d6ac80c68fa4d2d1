/* SPDX-License-Identifier: MIT */
/*
 * The panes at the sides of the picture have the widths that a hand gave them, here or in another window, and nothing
 * else changes them.  They are placed when it is known how wide the window really is, and kept only when the divider
 * itself was moved: what a small or a maximized window makes of them is no one's wish.
 *
 * In a narrow window the numbers are a drawer: it lies over the picture's right side when it is asked for, so that the
 * picture stays where it is.
 */
#include "../base/letters.h"
#include "window_private.h"

enum {
    LEFT_WIDTH = 252,
    RIGHT_WIDTH = 228,
    LEAST_LEFT = 206,
    LEAST_RIGHT = 205,
    LEAST_CENTER = 300,
    NARROW = 1300,
    DRAWER_WIDTH = 320
};
static const double LEFT_SHARE = 0.4; /* of a window, at most */

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
    if (!self->is_narrow && self->is_right_shown)
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

/* ---- the drawer ---- */

static gboolean is_wanted(const AppWindow *self)
{
    return self->is_narrow ? self->is_drawer_open : self->is_right_shown;
}

/* Pane or drawer, with the menu's mark as it is. */
static void show_right(AppWindow *self)
{
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(self), "numbers");
    gtk_widget_set_visible(self->right_box, is_wanted(self));
    if (action)
        g_simple_action_set_state(G_SIMPLE_ACTION(action), g_variant_new_boolean(is_wanted(self)));
}

void app_window_show_right(AppWindow *self, gboolean shown)
{
    if (self->is_narrow)
        self->is_drawer_open = shown;
    else {
        self->is_right_shown = shown;
        if (self->settings)
            g_settings_set_boolean(self->settings, "right-shown", shown);
    }
    if (!shown && gtk_widget_get_focus_child(self->right_box))
        gtk_widget_grab_focus(app_window_camera(self));
    show_right(self);
}

/* Puts the numbers into their pane, or into the drawer, where they are not there yet. */
static void become(AppWindow *self, gboolean narrow)
{
    if (narrow == self->is_narrow)
        return;
    self->is_narrow = narrow;
    g_object_ref(self->right_box);
    if (narrow) {
        gtk_paned_set_end_child(GTK_PANED(self->right_pane), NULL);
        gtk_overlay_add_overlay(GTK_OVERLAY(self->view_overlay), self->right_box);
        gtk_widget_add_css_class(self->right_box, "drawer");
    } else {
        gtk_overlay_remove_overlay(GTK_OVERLAY(self->view_overlay), self->right_box);
        gtk_paned_set_end_child(GTK_PANED(self->right_pane), self->right_box);
        gtk_widget_remove_css_class(self->right_box, "drawer");
    }
    gtk_widget_set_halign(self->right_box, narrow ? GTK_ALIGN_END : GTK_ALIGN_FILL);
    g_object_unref(self->right_box);
    show_right(self);
}

/* ---- the places ---- */

/* Both widths as a hand left them, and the picture has the rest; a pane counts from the left. */
static void place(AppWindow *self)
{
    const int total = gtk_widget_get_width(self->left_pane);
    if (total <= 0)
        return;
    become(self, total < NARROW);
    const int least = self->is_narrow ? DRAWER_WIDTH : LEAST_RIGHT;
    gtk_widget_set_size_request(self->right_box, (int)(least * app_letters_scale(self->right_box)), -1);
    const int left = CLAMP(self->left_width, LEAST_LEFT, MAX((int)(LEFT_SHARE * total), LEAST_LEFT));
    const int whole = gtk_widget_get_width(self->right_pane), position = MAX(whole - self->right_width, LEAST_CENTER);
    if (gtk_paned_get_position(GTK_PANED(self->left_pane)) != left)
        gtk_paned_set_position(GTK_PANED(self->left_pane), left);
    if (!self->is_narrow && whole > 0 && position != gtk_paned_get_position(GTK_PANED(self->right_pane)))
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
    self->is_right_shown = !self->settings || g_settings_get_boolean(self->settings, "right-shown");
    int width, height;
    gtk_window_get_default_size(GTK_WINDOW(self), &width, &height);
    become(self, width < NARROW && !gtk_window_is_maximized(GTK_WINDOW(self)));
    show_right(self);
    gtk_paned_set_position(GTK_PANED(self->left_pane), self->left_width);
    g_signal_connect(self->left_pane, "notify::position", G_CALLBACK(divider_moved), self);
    g_signal_connect(self->right_pane, "notify::position", G_CALLBACK(divider_moved), self);
    g_signal_connect_after(self->left_pane, "move-handle", G_CALLBACK(divider_moved_by_keys), self);
    g_signal_connect_after(self->right_pane, "move-handle", G_CALLBACK(divider_moved_by_keys), self);
    g_signal_connect(self->right_pane, "notify::max-position", G_CALLBACK(room_changed), self);
    /* which a pane with one child does not tell */
    g_signal_connect(self->left_pane, "notify::max-position", G_CALLBACK(room_changed), self);
}
