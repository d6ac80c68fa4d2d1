/* SPDX-License-Identifier: MIT */
/* Start, end, keys, appearance. */
#include "application.h"

#include <glib-unix.h>
#include <luxel/version.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/pulse.h"
#include "../base/touch.h"
#include "../files/document.h"
#include "window.h"

struct _AppApplication {
    GtkApplication parent;
    GSettings *settings;
    char *scheme;     /* of colours, that is in force */
    gboolean offered; /* unsaved work */
};

G_DEFINE_FINAL_TYPE(AppApplication, app_application, GTK_TYPE_APPLICATION)

/*
 * Keys of actions.  Letters stand with the letter of the Russian layout on the same key, so that they work where no
 * Latin layout is set up at all.
 */
static const struct {
    const char *action, *keys[4];
} keys[] = {
    {"win.open", {"<Control>o", "<Control>Cyrillic_shcha"}},
    {"win.save", {"<Control>s", "<Control>Cyrillic_yeru"}},
    {"win.save-as", {"<Control><Shift>s", "<Control><Shift>Cyrillic_yeru"}},
    {"win.export::png8", {"<Control>e", "<Control>Cyrillic_u"}},
    {"win.undo", {"<Control>z", "<Control>Cyrillic_ya"}},
    {"win.redo", {"<Control><Shift>z", "<Control><Shift>Cyrillic_ya", "<Control>y"}},
    {"app.new-window", {"<Control>n", "<Control>Cyrillic_te"}},
    {"window.close", {"<Control>w", "<Control>Cyrillic_tse"}},
    {"app.quit", {"<Control>q", "<Control>Cyrillic_shorti"}},
    {"win.one-to-one", {"<Control>0", "<Control>KP_0"}},
    {"win.zoom-in", {"<Control>plus", "<Control>equal"}},
    {"win.zoom-out", {"<Control>minus"}},
    {"win.paste", {"<Control><Shift>v", "<Control><Shift>Cyrillic_em"}},
    {"win.source-duplicate", {"<Control>d", "<Control>Cyrillic_ve"}},
    {"win.source-delete", {"<Control>Delete"}},
    {"win.source-up", {"<Alt>Up"}},
    {"win.source-down", {"<Alt>Down"}},
    {"win.gallery", {"F2"}},
    {"win.search", {"<Control>k", "<Control>Cyrillic_el"}},
    {"win.numbers", {"F9"}},
    {"win.pane(uint32 0)", {"<Control>1", "<Control>KP_1"}},
    {"win.pane(uint32 1)", {"<Control>2", "<Control>KP_2"}},
    {"win.pane(uint32 2)", {"<Control>3", "<Control>KP_3"}},
    {"win.next-pane(1)", {"F6"}},
    {"win.next-pane(-1)", {"<Shift>F6"}},
    {"win.shortcuts", {"<Control>question", "F1"}},
};

GSettings *app_application_settings(AppApplication *self)
{
    return self->settings;
}

static void set_color_scheme(AppApplication *self, const char *scheme)
{
    GtkSettings *settings = gtk_settings_get_default();
    if (g_strcmp0(scheme, self->scheme) == 0)
        return; /* whatever sets it has the whole theme read anew */
    g_free(self->scheme);
    self->scheme = g_strdup(scheme);
    if (g_strcmp0(scheme, "system") == 0)
        gtk_settings_reset_property(settings, "gtk-application-prefer-dark-theme");
    else
        g_object_set(settings, "gtk-application-prefer-dark-theme", g_strcmp0(scheme, "dark") == 0, NULL);
    if (self->settings)
        g_settings_set_string(self->settings, "color-scheme", scheme);
}

static void change_color_scheme(GSimpleAction *action, GVariant *scheme, gpointer data)
{
    set_color_scheme(data, g_variant_get_string(scheme, NULL));
    g_simple_action_set_state(action, scheme);
}

static void quit(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    /* one by one, so that each leaves its unsaved work in order */
    for (GList *windows; (windows = gtk_application_get_windows(data));)
        gtk_window_destroy(windows->data);
}

static void new_window(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    gtk_window_present(GTK_WINDOW(app_window_new(data)));
}

static void about(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    gtk_show_about_dialog(gtk_application_get_active_window(data), "program-name", "Luxel", "version", luxel_version(),
                          "logo-icon-name", "org.luxel.Luxel", "license-type", GTK_LICENSE_MIT_X11, "comments",
                          _("How light sources brighten a surface"), "modal", FALSE, NULL);
}

static gboolean interrupted(gpointer data)
{
    quit(NULL, NULL, data);
    g_application_quit(data);
    return G_SOURCE_CONTINUE;
}

static void load_settings(AppApplication *self)
{
    GSettingsSchemaSource *source = g_settings_schema_source_get_default();
    GSettingsSchema *schema = source ? g_settings_schema_source_lookup(source, "org.luxel.Luxel", TRUE) : NULL;
    if (schema)
        self->settings = g_settings_new_full(schema, NULL, NULL);
    if (schema)
        g_settings_schema_unref(schema);
}

static void load_style(void)
{
    GtkCssProvider *style = gtk_css_provider_new();
    gtk_css_provider_load_from_resource(style, "/org/luxel/Luxel/app.css");
    gtk_style_context_add_provider_for_display(gdk_display_get_default(), GTK_STYLE_PROVIDER(style),
                                               GTK_STYLE_PROVIDER_PRIORITY_APPLICATION);
    g_object_unref(style);
}

static void app_application_startup(GApplication *application)
{
    static const GActionEntry actions[] = {
        {.name = "quit", .activate = quit},
        {.name = "new-window", .activate = new_window},
        {.name = "about", .activate = about},
        {.name = "color-scheme", .parameter_type = "s", .state = "'system'", .change_state = change_color_scheme},
    };
    AppApplication *self = APP_APPLICATION(application);
    G_APPLICATION_CLASS(app_application_parent_class)->startup(application);
    load_settings(self);
    load_style();
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        gtk_application_set_accels_for_action(GTK_APPLICATION(self), keys[i].action, keys[i].keys);
    if (self->settings) {
        GVariant *scheme = g_settings_get_value(self->settings, "color-scheme");
        g_action_group_change_action_state(G_ACTION_GROUP(self), "color-scheme", scheme);
        g_variant_unref(scheme);
    }
    app_touch_begin(GTK_APPLICATION(self), self->settings);
    gtk_window_set_default_icon_name("org.luxel.Luxel");
    g_unix_signal_add(SIGINT, interrupted, self);
    g_unix_signal_add(SIGTERM, interrupted, self);
}

static AppWindow *fresh_window(AppApplication *self)
{
    GtkWindow *active = gtk_application_get_active_window(GTK_APPLICATION(self));
    AppWindow *window = active && APP_IS_WINDOW(active) && app_window_is_fresh(APP_WINDOW(active))
                            ? APP_WINDOW(active)
                            : app_window_new(self);
    if (!self->offered)
        app_window_offer_unsaved(window);
    self->offered = TRUE;
    return window;
}

void app_application_open(AppApplication *self, const char *path)
{
    AppWindow *window = fresh_window(self);
    app_window_open(window, path);
    gtk_window_present(GTK_WINDOW(window));
}

static void open_builtin(AppApplication *self, const char *name)
{
    AppWindow *window = fresh_window(self);
    app_window_open_builtin(window, name);
    gtk_window_present(GTK_WINDOW(window));
}

static void app_application_activate(GApplication *application)
{
    GtkWindow *active = gtk_application_get_active_window(GTK_APPLICATION(application));
    if (!active)
        active = GTK_WINDOW(fresh_window(APP_APPLICATION(application)));
    gtk_window_present(active);
}

static void app_application_open_files(GApplication *application, GFile **files, int count, const char *hint)
{
    (void)hint;
    for (int i = 0; i < count; i++) {
        char *path = g_file_get_path(files[i]), *uri = g_file_get_uri(files[i]);
        if (path)
            app_application_open(APP_APPLICATION(application), path);
        else if (g_str_has_prefix(uri, APP_BUILTIN))
            open_builtin(APP_APPLICATION(application), uri + strlen(APP_BUILTIN));
        g_free(path);
        g_free(uri);
    }
}

static int app_application_handle_local_options(GApplication *application, GVariantDict *options)
{
    (void)application;
    if (g_variant_dict_contains(options, "version")) {
        printf("luxel-app %s\n", luxel_version());
        return 0;
    }
    if (g_variant_dict_contains(options, "frame-times"))
        app_pulse_start();
    return -1;
}

static void app_application_shutdown(GApplication *application)
{
    if (app_pulse_is_on())
        app_pulse_print();
    G_APPLICATION_CLASS(app_application_parent_class)->shutdown(application);
}

static void app_application_finalize(GObject *object)
{
    g_free(APP_APPLICATION(object)->scheme);
    G_OBJECT_CLASS(app_application_parent_class)->finalize(object);
}

static void app_application_dispose(GObject *object)
{
    g_clear_object(&APP_APPLICATION(object)->settings);
    G_OBJECT_CLASS(app_application_parent_class)->dispose(object);
}

static void app_application_class_init(AppApplicationClass *class)
{
    GApplicationClass *application = G_APPLICATION_CLASS(class);
    G_OBJECT_CLASS(class)->dispose = app_application_dispose;
    G_OBJECT_CLASS(class)->finalize = app_application_finalize;
    application->startup = app_application_startup;
    application->activate = app_application_activate;
    application->open = app_application_open_files;
    application->shutdown = app_application_shutdown;
    application->handle_local_options = app_application_handle_local_options;
}

static void app_application_init(AppApplication *self)
{
    static const GOptionEntry options[] = {
        {"frame-times", 0, 0, G_OPTION_ARG_NONE, NULL,
         N_("show how fast pictures come, and at the end print how long the main loop was busy"), NULL},
        {"version", 0, 0, G_OPTION_ARG_NONE, NULL, N_("print the version"), NULL},
        {NULL, 0, 0, G_OPTION_ARG_NONE, NULL, NULL, NULL},
    };
    GOptionEntry translated[G_N_ELEMENTS(options)];
    for (gsize i = 0; i < G_N_ELEMENTS(options); i++) {
        translated[i] = options[i];
        translated[i].description = options[i].description ? _(options[i].description) : NULL;
    }
    self->scheme = g_strdup("system");
    g_application_add_main_option_entries(G_APPLICATION(self), translated);
    g_application_set_option_context_parameter_string(G_APPLICATION(self), _("[SCENE…]"));
    g_application_set_option_context_summary(
        G_APPLICATION(self), _("Shows how light sources brighten a surface, and lets them be moved by hand."));
}

AppApplication *app_application_new(void)
{
    return g_object_new(APP_TYPE_APPLICATION, "application-id", "org.luxel.Luxel", "flags", G_APPLICATION_HANDLES_OPEN,
                        NULL);
}
