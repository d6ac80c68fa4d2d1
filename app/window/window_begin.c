/* SPDX-License-Identifier: MIT */
/*
 * Help for beginners.  A window opens with a scene at work, as an instrument does, not with a page to choose from: the
 * pictures of the scenes are one button away, and lie over the scene only as long as one looks at them.
 */
#include <string.h>

#include "../../front/words.h"
#include "gallery.h"
#include "window_private.h"

static const char hint_key[] = "drag-hint", scene_page[] = "scene", gallery_page[] = "gallery";

/* ---- the hint ---- */

void app_window_update_hint(AppWindow *self)
{
    app_view_set_hint(self->view,
                      self->is_hinting && app_window_is_fresh(self) ? _("Drag the lamp: the picture follows") : NULL);
}

/* Whoever has dragged a mark needs it no longer, in this window or another. */
static void mark_moved(AppWindow *self)
{
    if (!self->is_hinting)
        return;
    self->is_hinting = FALSE;
    if (self->settings)
        g_settings_set_boolean(self->settings, hint_key, FALSE);
    app_window_update_hint(self);
}

void app_window_begin_hint(AppWindow *self)
{
    self->is_hinting = !self->settings || g_settings_get_boolean(self->settings, hint_key);
    g_signal_connect_swapped(self->view, "moved", G_CALLBACK(mark_moved), self);
    app_window_update_hint(self);
}

/* ---- the gallery ---- */

gboolean app_window_gallery_is_open(AppWindow *self)
{
    return g_strcmp0(gtk_stack_get_visible_child_name(GTK_STACK(self->pages)), gallery_page) == 0;
}

static void set_gallery(AppWindow *self, gboolean open)
{
    g_action_group_change_action_state(G_ACTION_GROUP(self), "gallery", g_variant_new_boolean(open));
}

static void close_gallery(AppWindow *self)
{
    set_gallery(self, FALSE);
}

static void scene_chosen(AppGallery *gallery, const char *scene, AppWindow *self)
{
    char *chosen = g_strdup(scene); /* the card that has it may go */
    const gboolean is_builtin = g_str_has_prefix(chosen, APP_BUILTIN);
    (void)gallery;
    set_gallery(self, FALSE);
    gtk_widget_activate_action(GTK_WIDGET(self), is_builtin ? "win.new" : "win.open-path", "s",
                               is_builtin ? chosen + strlen(APP_BUILTIN) : chosen);
    g_free(chosen);
}

static void make_gallery(AppWindow *self)
{
    self->gallery = app_gallery_new();
    gtk_stack_add_named(GTK_STACK(self->pages), self->gallery, gallery_page);
    g_signal_connect(self->gallery, "chosen", G_CALLBACK(scene_chosen), self);
    g_signal_connect_swapped(self->gallery, "closed", G_CALLBACK(close_gallery), self);
}

static void change_gallery(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    const gboolean open = g_variant_get_boolean(state);
    if (open && !self->gallery)
        make_gallery(self);
    gtk_stack_set_visible_child_name(GTK_STACK(self->pages), open ? gallery_page : scene_page);
    if (open)
        app_gallery_open(APP_GALLERY(self->gallery));
    else
        gtk_widget_grab_focus(GTK_WIDGET(self->view));
    g_simple_action_set_state(action, state);
}

void app_window_add_begin_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "gallery", .state = "false", .change_state = change_gallery},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}
