/* SPDX-License-Identifier: MIT */
/*
 * The scene in space, in the place of the picture or behind it: two cameras of one scene.  It is told what the picture
 * is told, and what the hand does there the other parts hear as from the picture.
 */
#include "../space/space_view.h"
#include "window_private.h"

static AppSpaceView *space_of(AppWindow *self)
{
    return APP_SPACE_VIEW(self->space_view);
}

gboolean app_window_is_in_space(AppWindow *self)
{
    return gtk_stack_get_visible_child(GTK_STACK(self->cameras)) == self->space_view;
}

GtkWidget *app_window_camera(AppWindow *self)
{
    return app_window_is_in_space(self) ? self->space_view : GTK_WIDGET(self->view);
}

static void pressed(AppSpaceView *view, double x_mm, double y_mm, AppWindow *self)
{
    const double place_mm[2] = {x_mm, y_mm};
    (void)view;
    app_window_pin_why(self, place_mm);
}

static void change_space(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    const gboolean is_wanted = g_variant_get_boolean(state);
    gtk_stack_set_visible_child(GTK_STACK(self->cameras), is_wanted ? self->space_view : GTK_WIDGET(self->view));
    gtk_widget_grab_focus(app_window_camera(self));
    g_simple_action_set_state(action, state);
}

static void look_from_front(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    app_space_view_front(space_of(data));
}

void app_window_add_space(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "space", .state = "false", .change_state = change_space},
        {.name = "space-front", .activate = look_from_front},
    };
    self->space_view = app_space_view_new(self->document);
    gtk_stack_add_named(GTK_STACK(self->cameras), self->space_view, "space");
    g_signal_connect(self->space_view, "pressed", G_CALLBACK(pressed), self);
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}
