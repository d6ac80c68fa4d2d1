/* SPDX-License-Identifier: MIT */
/*
 * The scene in space, in the place of the picture: two cameras of one scene.  It is told what the picture is told, and
 * what the hand does there, and in plan and elevation, the other parts hear as from the picture.
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
    app_window_pin_why(self, place_mm, -1);
}

static void change_space(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    const gboolean is_wanted = g_variant_get_boolean(state);
    gtk_stack_set_visible_child(GTK_STACK(self->cameras), is_wanted ? self->space_view : GTK_WIDGET(self->view));
    gtk_widget_grab_focus(app_window_camera(self));
    g_simple_action_set_state(action, state);
    app_window_ask_survey(self);
}

static void look_from_front(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    app_space_view_front(space_of(data));
}

AppSight *app_window_sight(AppWindow *self, int i)
{
    return i == 0 ? app_stage_sight(APP_STAGE(self->stage)) : app_space_view_sight(space_of(self));
}

void app_window_ask_survey(AppWindow *self)
{
    const gboolean is_offered =
        app_document_size(self->document, "grids") > 0 || app_document_size(self->document, "observers") > 0;
    app_numbers_offer_lighting(APP_NUMBERS(self->numbers), is_offered);
    for (int i = 0; i < APP_SIGHTS && !is_offered; i++)
        app_sight_set_lighting(app_window_sight(self, i), NULL, NULL);
    const AppPage page = app_numbers_page(APP_NUMBERS(self->numbers));
    const gboolean is_seen = page == APP_PAGE_SPACE || page == APP_PAGE_LIGHTING || app_window_is_in_space(self);
    luxel_scene *scene = is_offered && is_seen && self->surveyed != self->version
                             ? app_document_copy_scene(self->document)
                             : NULL;
    if (!scene)
        return;
    self->surveyed = self->version;
    app_survey_ask(self->survey, scene, self->version, self->solo);
}

void app_window_show_survey(AppGrids *grids, AppEyes *eyes, guint64 serial, gpointer owner)
{
    AppWindow *self = owner;
    if (serial < self->first)
        return;
    app_numbers_show_lighting(APP_NUMBERS(self->numbers), grids, eyes, serial);
    for (int i = 0; i < APP_SIGHTS; i++) {
        AppSight *sight = app_window_sight(self, i);
        app_sight_set_lighting(sight, eyes ? sight->grids : grids, eyes ? eyes : sight->eyes);
    }
    app_window_judge(self);
}

void app_window_show_vectors(AppWindow *self, const AppReading *reading)
{
    for (int i = 0; i < APP_SIGHTS; i++)
        app_sight_set_reading(app_window_sight(self, i), reading);
}

/* Wherever the pointer is on a lamp, or -1 on none, it is lit up everywhere else. */
void app_window_hover_light(AppWindow *self, gssize light)
{
    app_sources_hover(APP_SOURCES(self->sources), light);
    for (int i = 0; i < APP_SIGHTS; i++)
        app_sight_hover(app_window_sight(self, i), light);
}

static gboolean is_of_lamp(int kind)
{
    return kind != APP_THING_NONE && kind < APP_THING_SURFACE;
}

/* In plan and elevation, or in space. */
static void stage_hovered(GtkWidget *stage, int kind, guint index, AppWindow *self)
{
    const gssize light = is_of_lamp(kind) ? (gssize)index : -1;
    (void)stage;
    app_window_hover_light(self, light);
    app_view_hover(self->view, light < 0 ? APP_MARK_NONE : APP_MARK_SOURCE, light < 0 ? 0 : (gsize)light);
}

static void stage_selected(GtkWidget *stage, int kind, guint index, AppWindow *self)
{
    (void)stage;
    if (is_of_lamp(kind)) {
        app_sources_choose(APP_SOURCES(self->sources), index);
        app_view_select(self->view, APP_MARK_SOURCE, index);
        app_window_show_chosen(self);
    } else if (kind == APP_THING_SURFACE)
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), index);
}

static void toggled(GtkWidget *space, guint index, AppWindow *self)
{
    (void)space;
    app_sources_toggle(APP_SOURCES(self->sources), index);
}

void app_window_connect_spaces(AppWindow *self)
{
    GtkWidget *const spaces[] = {self->stage, self->space_view};
    for (gsize i = 0; i < G_N_ELEMENTS(spaces); i++) {
        g_signal_connect(spaces[i], "selected", G_CALLBACK(stage_selected), self);
        g_signal_connect(spaces[i], "toggled", G_CALLBACK(toggled), self);
        g_signal_connect(spaces[i], "hovered", G_CALLBACK(stage_hovered), self);
    }
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
