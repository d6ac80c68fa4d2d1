/* SPDX-License-Identifier: MIT */
/* What the window's buttons, menus and keys do to the picture, the sources and the points. */
#include <string.h>

#include "../../front/words.h"
#include "../base/row.h"
#include "../space/space_view.h"
#include "shortcuts.h"
#include "window_private.h"

static const double ZOOM = 1.25;

/* ---- undo ---- */

/* Text that was typed and is not a value yet goes first. */
static gboolean take_back_text(AppWindow *self)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(self));
    GtkWidget *row = focus ? gtk_widget_get_ancestor(focus, APP_TYPE_ROW) : NULL;
    return row ? app_row_restore(APP_ROW(row)) : app_points_restore(APP_POINTS(self->points), focus);
}

static void undo(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (!take_back_text(self))
        app_document_undo(self->document);
}

static void redo(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    app_document_redo(self->document);
}

/* ---- the view ---- */

static void view_action(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    const char *name = g_action_get_name(G_ACTION(action));
    (void)argument;
    AppSpaceView *space = app_window_is_in_space(self) ? APP_SPACE_VIEW(self->space_view) : NULL;
    const gboolean is_in = strcmp(name, "zoom-in") == 0;
    if (strcmp(name, "fit") == 0 && space)
        app_space_view_fit(space);
    else if (strcmp(name, "fit") == 0)
        app_view_fit(self->view);
    else if (strcmp(name, "one-to-one") == 0)
        app_view_one_to_one(self->view);
    else if (space)
        app_space_view_zoom(space, is_in ? ZOOM : 1 / ZOOM);
    else
        app_view_zoom(self->view, is_in ? ZOOM : 1 / ZOOM);
}

static void expose(GSimpleAction *action, GVariant *stops, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    app_display_form_expose(APP_DISPLAY_FORM(self->display_form), g_variant_get_double(stops));
}

static void normalise(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    app_display_form_normalise(APP_DISPLAY_FORM(self->display_form));
}

static void reset_display(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    app_display_form_reset(APP_DISPLAY_FORM(self->display_form));
}

static void change_false_color(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    AppDisplay display = *app_display_form_get(APP_DISPLAY_FORM(self->display_form));
    (void)action;
    display.palette = g_variant_get_boolean(state) ? self->false_palette : app_palette_named("grey");
    app_display_form_set(APP_DISPLAY_FORM(self->display_form), &display);
}

static void change_isophotes(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    AppDisplay display = *app_display_form_get(APP_DISPLAY_FORM(self->display_form));
    (void)action;
    display.isophotes = g_variant_get_boolean(state);
    app_display_form_set(APP_DISPLAY_FORM(self->display_form), &display);
}

static void change_numbers(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    app_window_show_right(self, g_variant_get_boolean(state));
}

static void change_why(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    if (!g_variant_get_boolean(state) && gtk_widget_get_focus_child(self->why))
        gtk_widget_grab_focus(GTK_WIDGET(self->view));
    app_why_show(APP_WHY(self->why), g_variant_get_boolean(state));
    g_simple_action_set_state(action, state);
}

void app_window_pin_why(AppWindow *self, const double place_mm[2], gssize point)
{
    if (app_why_is_shown(APP_WHY(self->why)) && app_window_shot(self))
        app_why_pin(APP_WHY(self->why), app_window_shot(self), place_mm, point);
}

void app_window_ask_why(AppWindow *self, gssize point)
{
    double place_mm[2] = {self->pointer_mm[0], self->pointer_mm[1]};
    if (!app_window_shot(self) || (point >= 0 && luxel_scene_point(app_window_shot(self)->moment->scene, (gsize)point,
                                                                   &place_mm[0], &place_mm[1]) != LUXEL_OK))
        return;
    g_action_group_change_action_state(G_ACTION_GROUP(self), "why", g_variant_new_boolean(TRUE));
    app_window_pin_why(self, place_mm, point);
}

/* Why? at a point of the scene, by its number. */
static void go_to_point(GSimpleAction *action, GVariant *index, gpointer data)
{
    (void)action;
    app_window_ask_why(data, (gssize)g_variant_get_uint32(index));
}

static void change_quantity(GSimpleAction *action, GVariant *state, gpointer data)
{
    AppWindow *self = data;
    self->quantity = strcmp(g_variant_get_string(state, NULL), "irradiance") == 0 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
    g_simple_action_set_state(action, state);
    app_window_ask_picture(self);
}

/* Reflected light is given up, or taken up again. */
static void stop(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    self->is_direct = !self->is_direct;
    app_window_ask_picture(self);
}

static void repair(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    app_window_make_repair(data);
}

static void show_shortcuts(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    app_shortcuts_show(data);
}

/* ---- comparing ---- */

static const char *const side_names[] = {"live", "pinned", "difference"}; /* AppSide */

static void set_side(AppWindow *self, AppSide side)
{
    self->side = side;
    GAction *action = g_action_map_lookup_action(G_ACTION_MAP(self), "side");
    g_simple_action_set_state(G_SIMPLE_ACTION(action), g_variant_new_string(side_names[side]));
    app_window_ask_picture(self);
}

static void change_side(GSimpleAction *action, GVariant *state, gpointer data)
{
    const char *name = g_variant_get_string(state, NULL);
    (void)action;
    for (int i = 0; i < (int)G_N_ELEMENTS(side_names); i++)
        if (strcmp(side_names[i], name) == 0)
            set_side(data, (AppSide)i);
}

static void next_side(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (self->pinned)
        set_side(self, (AppSide)((self->side + 1) % G_N_ELEMENTS(side_names)));
}

static void pin(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (!self->picture || !self->picture->shot || !self->picture->shot->is_fine ||
        self->picture->shot->moment->is_direct || self->is_stale)
        return;
    AppShot *shot = app_shot_ref(self->picture->shot);
    app_shot_unref(self->pinned);
    self->pinned = shot;
    set_side(self, APP_SIDE_LIVE);
    app_window_update_actions(self);
}

static void unpin(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    g_clear_pointer(&self->pinned, app_shot_unref);
    set_side(self, APP_SIDE_LIVE);
    app_window_update_actions(self);
}

/* ---- sources and points ---- */

static void source_add(GSimpleAction *action, GVariant *kind, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    app_sources_add(APP_SOURCES(self->sources), g_variant_get_string(kind, NULL));
}

static void source_action(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppSources *sources = APP_SOURCES(((AppWindow *)data)->sources);
    const char *name = g_action_get_name(G_ACTION(action));
    (void)argument;
    if (strcmp(name, "source-duplicate") == 0)
        app_sources_duplicate(sources);
    else if (strcmp(name, "source-delete") == 0)
        app_sources_delete(sources);
    else if (strcmp(name, "source-up") == 0)
        app_sources_move(sources, -1);
    else if (strcmp(name, "source-down") == 0)
        app_sources_move(sources, 1);
    else
        app_sources_aim(sources);
}

static void point_add(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    app_points_add(APP_POINTS(self->points), 0, 0);
}

typedef enum Pasted { PASTED_ANY, PASTED_SOURCES, PASTED_POINTS } Pasted;

typedef struct Paste {
    AppWindow *window;
    Pasted what;
} Paste;

/* Three numbers are a source, two a point. */
static char *paste(AppWindow *self, const char *text, Pasted what)
{
    char *fault = what == PASTED_POINTS ? app_points_paste(APP_POINTS(self->points), text)
                                        : app_sources_paste(APP_SOURCES(self->sources), text);
    if (fault && what == PASTED_ANY) {
        g_free(fault);
        fault = app_points_paste(APP_POINTS(self->points), text);
    }
    return fault;
}

static void text_came(GObject *source, GAsyncResult *result, gpointer data)
{
    Paste *wanted = data;
    char *text = gdk_clipboard_read_text_finish(GDK_CLIPBOARD(source), result, NULL);
    char *fault = app_window_is_open(wanted->window) ? paste(wanted->window, text ? text : "", wanted->what) : NULL;
    if (fault && (!text || *text == '\0'))
        app_window_show_fault(wanted->window, _("there is no text on the clipboard"));
    else if (fault) {
        char *message =
            g_strdup_printf(wanted->what == PASTED_POINTS ? _("“%.60s” is not a point; expected: x, y; x, y")
                                                          : _("“%.60s” is not a source; expected: x, y, z; x, y, z"),
                            fault);
        app_window_show_fault(wanted->window, message);
        g_free(message);
    } else if (app_window_is_open(wanted->window))
        app_window_show_fault(wanted->window, NULL);
    g_free(fault);
    g_free(text);
    g_object_unref(wanted->window);
    g_free(wanted);
}

static void paste_action(GSimpleAction *action, GVariant *argument, gpointer data)
{
    const char *name = g_action_get_name(G_ACTION(action));
    Paste *wanted = g_new(Paste, 1);
    (void)argument;
    *wanted = (Paste){g_object_ref(data), strcmp(name, "source-paste") == 0  ? PASTED_SOURCES
                                          : strcmp(name, "point-paste") == 0 ? PASTED_POINTS
                                                                             : PASTED_ANY};
    gdk_clipboard_read_text_async(gtk_widget_get_clipboard(data), NULL, text_came, wanted);
}

/* ---- keys without Ctrl ---- */

/* A letter and the one on its key in the Russian layout. */
static const struct {
    guint latin, cyrillic;
    gboolean shifted;
    const char *action;
} letters[] = {
    {GDK_KEY_e, GDK_KEY_Cyrillic_u, FALSE, "win.expose(0.5)"},
    {GDK_KEY_e, GDK_KEY_Cyrillic_u, TRUE, "win.expose(-0.5)"},
    {GDK_KEY_n, GDK_KEY_Cyrillic_te, FALSE, "win.normalise"},
    {GDK_KEY_r, GDK_KEY_Cyrillic_ka, FALSE, "win.reset-display"},
    {GDK_KEY_f, GDK_KEY_Cyrillic_a, FALSE, "win.fit"},
    {GDK_KEY_c, GDK_KEY_Cyrillic_es, FALSE, "win.false-color"},
    {GDK_KEY_i, GDK_KEY_Cyrillic_sha, FALSE, "win.isophotes"},
    {GDK_KEY_p, GDK_KEY_Cyrillic_ze, FALSE, "win.pin"},
    {GDK_KEY_d, GDK_KEY_Cyrillic_ve, FALSE, "win.next-side"},
    {GDK_KEY_w, GDK_KEY_Cyrillic_tse, FALSE, "win.why"},
    {GDK_KEY_s, GDK_KEY_Cyrillic_yeru, FALSE, "win.space"},
};

static gboolean letter_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                               AppWindow *self)
{
    const guint lower = gdk_keyval_to_lower(key);
    (void)controller;
    (void)code;
    if ((state & GDK_CONTROL_MASK) && (lower == GDK_KEY_v || lower == GDK_KEY_Cyrillic_em)) {
        paste_action(G_SIMPLE_ACTION(g_action_map_lookup_action(G_ACTION_MAP(self), "paste")), NULL, self);
        return TRUE;
    }
    const guint digit = gdk_keyval_to_unicode(key);
    if ((state & (GDK_CONTROL_MASK | GDK_ALT_MASK)) == GDK_ALT_MASK && digit >= '1' && digit <= '9')
        return gtk_widget_activate_action(GTK_WIDGET(self), "win.point-why", "u", digit - '1');
    if ((state & (GDK_CONTROL_MASK | GDK_ALT_MASK)) || app_window_gallery_is_open(self))
        return FALSE;
    if (digit >= '1' && digit <= '9')
        return gtk_widget_activate_action(GTK_WIDGET(self), "win.source-choose", "u", digit - '1');
    if (key == GDK_KEY_Escape && app_why_is_shown(APP_WHY(self->why)))
        return gtk_widget_activate_action(GTK_WIDGET(self), "win.why", NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(letters); i++) {
        if ((lower != letters[i].latin && lower != letters[i].cyrillic) ||
            ((state & GDK_SHIFT_MASK) != 0) != letters[i].shifted)
            continue;
        char *name;
        GVariant *target;
        g_action_parse_detailed_name(letters[i].action, &name, &target, NULL);
        gtk_widget_activate_action_variant(GTK_WIDGET(self), name, target);
        if (target)
            g_variant_unref(target);
        g_free(name);
        return TRUE;
    }
    return FALSE;
}

/* ---- all of them ---- */

static void set_enabled(AppWindow *self, const char *name, gboolean enabled)
{
    g_simple_action_set_enabled(G_SIMPLE_ACTION(g_action_map_lookup_action(G_ACTION_MAP(self), name)), enabled);
}

void app_window_update_actions(AppWindow *self)
{
    const AppHistory *history = app_document_history(self->document);
    const AppDisplay *display = app_display_form_get(APP_DISPLAY_FORM(self->display_form));
    const gboolean any = app_document_size(self->document, "lights") > 0;
    static const char *const of_sources[] = {"source-duplicate", "source-delete", "source-up", "source-down"};
    set_enabled(self, "undo", app_history_can_undo(history));
    set_enabled(self, "redo", app_history_can_redo(history));
    set_enabled(self, "unpin", self->pinned != NULL);
    set_enabled(self, "surface-delete", app_document_size(self->document, "surfaces") > 1); /* a scene has one */
    for (gsize i = 0; i < G_N_ELEMENTS(of_sources); i++)
        set_enabled(self, of_sources[i], any);
    GAction *colored = g_action_map_lookup_action(G_ACTION_MAP(self), "false-color");
    g_simple_action_set_state(G_SIMPLE_ACTION(colored), g_variant_new_boolean(strcmp(display->palette, "grey") != 0));
    GAction *lines = g_action_map_lookup_action(G_ACTION_MAP(self), "isophotes");
    g_simple_action_set_state(G_SIMPLE_ACTION(lines), g_variant_new_boolean(display->isophotes));
}

void app_window_add_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "undo", .activate = undo},
        {.name = "redo", .activate = redo},
        {.name = "repair", .activate = repair},
        {.name = "stop", .activate = stop},
        {.name = "fit", .activate = view_action},
        {.name = "one-to-one", .activate = view_action},
        {.name = "zoom-in", .activate = view_action},
        {.name = "zoom-out", .activate = view_action},
        {.name = "expose", .activate = expose, .parameter_type = "d"},
        {.name = "normalise", .activate = normalise},
        {.name = "reset-display", .activate = reset_display},
        {.name = "false-color", .state = "false", .change_state = change_false_color},
        {.name = "isophotes", .state = "false", .change_state = change_isophotes},
        {.name = "numbers", .state = "true", .change_state = change_numbers},
        {.name = "why", .state = "false", .change_state = change_why},
        {.name = "quantity", .parameter_type = "s", .state = "'brightness'", .change_state = change_quantity},
        {.name = "side", .parameter_type = "s", .state = "'live'", .change_state = change_side},
        {.name = "next-side", .activate = next_side},
        {.name = "shortcuts", .activate = show_shortcuts},
        {.name = "pin", .activate = pin},
        {.name = "unpin", .activate = unpin},
        {.name = "source-add", .activate = source_add, .parameter_type = "s"},
        {.name = "source-duplicate", .activate = source_action},
        {.name = "source-delete", .activate = source_action},
        {.name = "source-up", .activate = source_action},
        {.name = "source-down", .activate = source_action},
        {.name = "source-aim", .activate = source_action},
        {.name = "source-paste", .activate = paste_action},
        {.name = "point-add", .activate = point_add},
        {.name = "point-why", .activate = go_to_point, .parameter_type = "u"},
        {.name = "point-paste", .activate = paste_action},
        {.name = "paste", .activate = paste_action},
    };
    GtkEventController *keys = gtk_event_controller_key_new();
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(letter_pressed), self);
    gtk_widget_add_controller(GTK_WIDGET(self), keys);
}
