/* SPDX-License-Identifier: MIT */
/* Files: opening, saving, exporting, recent ones, what is dropped on the window, and unsaved work. */
#include <string.h>

#include "../../front/language.h"
#include "../../front/words.h"
#include "../files/recent.h"
#include "export.h"
#include "window_private.h"

static AppApplication *application_of(AppWindow *self)
{
    return APP_APPLICATION(gtk_window_get_application(GTK_WINDOW(self)));
}

gboolean app_window_open(AppWindow *self, const char *path)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    gboolean done = app_document_open_file(self->document, path, faults);
    if (done) {
        app_recent_add(path);
        app_window_show_fault(self, NULL);
    } else {
        char *fault = app_faults_text(faults, path);
        const char *name = app_document_name(self->document);
        char *text = g_strdup_printf(_("%s\nThe file was not opened. Still shown: %s"), fault ? fault : path,
                                     *name ? name : _("a new scene"));
        app_window_show_fault(self, text);
        g_free(fault);
        g_free(text);
    }
    luxel_diagnostics_free(faults);
    return done;
}

void app_window_open_builtin(AppWindow *self, const char *name)
{
    if (app_document_open_builtin(self->document, name, NULL)) {
        app_window_show_fault(self, NULL);
        return;
    }
    /* TRANSLATORS: %s is a name, such as report */
    char *text = g_strdup_printf(_("there is no built-in scene “%s”"), name);
    app_window_show_fault(self, text);
    g_free(text);
}

/* ---- dialogs ---- */

/* A dialog that is not modal; `done` is called with a path. */
typedef struct Asked {
    AppWindow *window;
    void (*done)(AppWindow *self, const char *path, const AppExport *how);
    const AppExport *how;
} Asked;

static void keep_folder(AppWindow *self, const char *path)
{
    GSettings *settings = app_application_settings(application_of(self));
    char *folder = g_path_get_dirname(path);
    if (settings)
        g_settings_set_string(settings, "recent-folder", folder);
    g_free(folder);
}

static void answered(GtkNativeDialog *dialog, int response, Asked *asked)
{
    GFile *file = response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    char *path = file ? g_file_get_path(file) : NULL;
    if (path && app_window_is_open(asked->window)) {
        keep_folder(asked->window, path);
        asked->done(asked->window, path, asked->how);
    }
    g_free(path);
    g_clear_object(&file);
    if (app_window_is_open(asked->window))
        app_window_take_keyboard(asked->window);
    g_object_unref(asked->window);
    g_free(asked);
    g_object_unref(dialog);
}

void app_chooser_add_filter(GtkFileChooser *chooser, const char *name, const char *const *patterns)
{
    GtkFileFilter *filter = gtk_file_filter_new();
    gtk_file_filter_set_name(filter, name);
    for (gsize i = 0; patterns[i]; i++)
        gtk_file_filter_add_pattern(filter, patterns[i]);
    gtk_file_chooser_add_filter(chooser, filter);
    g_object_unref(filter);
}

static void ask_file(AppWindow *self, GtkFileChooserAction kind, const char *title, const char *name,
                     const AppExport *how, void (*done)(AppWindow *self, const char *path, const AppExport *how))
{
    static const char *const scenes[] = {"*.yaml", "*.yml", "*.json", "*.png", "*.exr", NULL}, *const all[] = {"*",
                                                                                                               NULL};
    GtkFileChooserNative *dialog = gtk_file_chooser_native_new(title, GTK_WINDOW(self), kind, NULL, NULL);
    GtkFileChooser *chooser = GTK_FILE_CHOOSER(dialog);
    GSettings *settings = app_application_settings(application_of(self));
    const char *present = app_document_path(self->document);
    /* beside the scene, or where the last file was */
    char *folder = present    ? g_path_get_dirname(present)
                   : settings ? g_settings_get_string(settings, "recent-folder")
                              : NULL;
    Asked *asked = g_new(Asked, 1);
    *asked = (Asked){g_object_ref(self), done, how};
    if (folder && *folder) {
        GFile *place = g_file_new_for_path(folder);
        gtk_file_chooser_set_current_folder(chooser, place, NULL);
        g_object_unref(place);
    }
    if (kind == GTK_FILE_CHOOSER_ACTION_OPEN) {
        app_chooser_add_filter(chooser, _("Scenes, and pictures that carry one"), scenes);
        app_chooser_add_filter(chooser, _("All files"), all);
    } else
        gtk_file_chooser_set_current_name(chooser, name);
    g_signal_connect(dialog, "response", G_CALLBACK(answered), asked);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), FALSE);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
    g_free(folder);
}

/* ---- opening and saving ---- */

static void open_chosen(AppWindow *self, const char *path, const AppExport *how)
{
    (void)how;
    if (app_window_is_fresh(self))
        app_window_open(self, path);
    else
        app_application_open(application_of(self), path);
}

static void open_action(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    ask_file(data, GTK_FILE_CHOOSER_ACTION_OPEN, _("Open a scene"), NULL, NULL, open_chosen);
}

static void open_path(GSimpleAction *action, GVariant *path, gpointer data)
{
    (void)action;
    open_chosen(data, g_variant_get_string(path, NULL), NULL);
}

static void new_action(GSimpleAction *action, GVariant *name, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    if (!app_window_is_fresh(self)) {
        self = app_window_new(application_of(self));
        gtk_window_present(GTK_WINDOW(self));
    }
    app_window_open_builtin(self, g_variant_get_string(name, NULL));
}

static void save_chosen(AppWindow *self, const char *path, const AppExport *how)
{
    char *text;
    (void)how;
    if (!app_window_may_overwrite(self, path))
        return;
    luxel_diagnostics *faults = luxel_diagnostics_new();
    if (app_document_save(self->document, path, faults)) {
        app_recent_add(path);
        text = g_strdup_printf(_("saved: %s"), path);
        app_window_mention(self, text);
        app_window_show_fault(self, NULL);
        app_window_ask_picture(self);
    } else {
        text = app_faults_text(faults, NULL);
        app_window_show_fault(self, text ? text : _("it could not be written"));
    }
    g_free(text);
    luxel_diagnostics_free(faults);
}

static void save_as(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    const char *name = app_document_name(self->document);
    const gboolean is_yaml =
        g_str_has_suffix(name, ".yaml") || g_str_has_suffix(name, ".yml") || g_str_has_suffix(name, ".json");
    char *suggested = g_strconcat(*name ? name : "scene", is_yaml ? "" : ".yaml", NULL);
    (void)action;
    (void)argument;
    ask_file(self, GTK_FILE_CHOOSER_ACTION_SAVE, _("Save the scene"), suggested, NULL, save_chosen);
    g_free(suggested);
}

static void save(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    char *path = g_strdup(app_document_path(self->document)); /* which saving replaces */
    if (path)
        save_chosen(self, path, NULL);
    else
        save_as(action, argument, data);
    g_free(path);
}

static void save_path(GSimpleAction *action, GVariant *path, gpointer data)
{
    (void)action;
    save_chosen(data, g_variant_get_string(path, NULL), NULL);
}

/* ---- exporting ---- */

static void exported(const char *path, const char *fault, gpointer owner)
{
    AppWindow *self = owner;
    if (!app_window_is_open(self))
        return;
    char *text = fault ? g_strdup_printf("%s: %s", path, fault) : g_strdup_printf(_("saved: %s"), path);
    app_window_show_fault(self, fault ? text : NULL);
    if (!fault)
        app_window_mention(self, text);
    g_free(text);
}

static void export_chosen(AppWindow *self, const char *path, const AppExport *how)
{
    luxel_scene *scene = app_document_copy_scene(self->document);
    char *whole = g_str_has_suffix(path, how->ending) ? g_strdup(path) : g_strconcat(path, how->ending, NULL);
    if (scene) {
        AppReport report;
        app_window_load_report(self, &report);
        app_export(how, scene, self->quantity, app_display_form_get(APP_DISPLAY_FORM(self->display_form)), &report,
                   whole, exported, G_OBJECT(self));
    }
    g_free(whole);
}

/* Asks where a way of exporting is to write. */
static void ask_export(AppWindow *self, const AppExport *how)
{
    char *stem = g_strdup(app_document_name(self->document)), *dot = strrchr(stem, '.');
    if (dot && dot > stem)
        *dot = '\0';
    char *suggested = g_strconcat(*stem ? stem : "picture", how->ending, NULL);
    ask_file(self, GTK_FILE_CHOOSER_ACTION_SAVE, _(how->title), suggested, how, export_chosen);
    g_free(suggested);
    g_free(stem);
}

static void ask_export_of_report(AppWindow *self)
{
    ask_export(self, app_export_named("report"));
}

static void export_action(GSimpleAction *action, GVariant *name, gpointer data)
{
    const AppExport *how = app_export_named(g_variant_get_string(name, NULL));
    (void)action;
    if (how && strcmp(how->name, "report") == 0)
        app_window_ask_report(data, ask_export_of_report);
    else if (how)
        ask_export(data, how);
}

/* For scripts and tests, through the window's actions on the session bus. */
static void export_path(GSimpleAction *action, GVariant *argument, gpointer data)
{
    const char *name, *path;
    (void)action;
    g_variant_get(argument, "(&s&s)", &name, &path);
    if (app_export_named(name))
        export_chosen(data, path, app_export_named(name));
}

/* ---- unsaved work ---- */

/* "own.yaml", or what a scene without a name has. */
static char *name_of(const AppUnsaved *unsaved)
{
    luxel_scene *scene = NULL;
    gsize sources;
    if (unsaved->name)
        return g_strdup(unsaved->name);
    if (luxel_scene_read_text(unsaved->text, strlen(unsaved->text), "", NULL, &scene) != LUXEL_OK ||
        luxel_scene_commit(scene, NULL) != LUXEL_OK) {
        luxel_scene_free(scene);
        return g_strdup(_("a new scene"));
    }
    sources = luxel_scene_light_count(scene);
    luxel_scene_free(scene);
    return g_strdup_printf(ngettext("a new scene with %zu source", "a new scene with %zu sources", sources), sources);
}

static void show_offer(AppWindow *self)
{
    const AppUnsaved *unsaved = self->unsaved && self->unsaved->len > 0 ? g_ptr_array_index(self->unsaved, 0) : NULL;
    if (unsaved) {
        GDateTime *time = g_date_time_new_from_unix_local(unsaved->time);
        char *when = time ? g_date_time_format(time, "%Y-%m-%d %H:%M") : g_strdup("");
        char *name = name_of(unsaved);
        char *text = g_strdup_printf(self->is_discarded ? _("Unsaved work was discarded: %s, of %s")
                                                        : _("Unsaved work was found: %s, of %s"),
                                     name, when);
        app_window_set_message(self->unsaved_label, text);
        gtk_button_set_label(GTK_BUTTON(self->discard_button), self->is_discarded ? _("Close") : _("Discard"));
        g_free(name);
        g_free(text);
        g_free(when);
        if (time)
            g_date_time_unref(time);
    }
    if (!unsaved)
        app_window_set_message(self->unsaved_label, ""); /* what is no longer shown is not read out either */
    app_window_reveal_bar(self, self->unsaved_bar, unsaved != NULL);
}

void app_window_offer_unsaved(AppWindow *self)
{
    self->unsaved = app_unsaved_find();
    show_offer(self);
}

/* What is restored is at once unsaved work of the window, which keeps it; then the old copy may go. */
static void restore(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (!self->unsaved || self->unsaved->len == 0)
        return;
    const AppUnsaved *unsaved = g_ptr_array_index(self->unsaved, 0);
    AppWindow *window = app_window_is_fresh(self) ? self : app_window_new(application_of(self));
    luxel_diagnostics *faults = luxel_diagnostics_new();
    if (app_document_open_unsaved(window->document, unsaved->text, unsaved->path, faults)) {
        app_recovery_write(window->recovery);
        app_unsaved_discard(unsaved);
        g_ptr_array_remove_index(self->unsaved, 0);
        self->is_discarded = FALSE;
    } else {
        char *text = app_faults_text(faults, NULL);
        app_window_show_fault(self, text);
        g_free(text);
    }
    luxel_diagnostics_free(faults);
    if (window != self)
        gtk_window_present(GTK_WINDOW(window));
    show_offer(self);
}

/* The file goes at once; what was in it stays with the bar, to be restored after all, until that is closed. */
static void discard(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (!self->unsaved || self->unsaved->len == 0)
        return;
    if (self->is_discarded)
        g_ptr_array_remove_index(self->unsaved, 0);
    else
        app_unsaved_discard(g_ptr_array_index(self->unsaved, 0));
    self->is_discarded = !self->is_discarded;
    show_offer(self);
}

/* ---- menus and drops ---- */

static void fill_recent(AppWindow *self)
{
    char **paths = app_recent_paths();
    g_menu_remove_all(self->recent_menu);
    for (guint i = 0; paths[i]; i++) {
        char *name = g_filename_display_basename(paths[i]);
        GMenuItem *item = g_menu_item_new(name, NULL);
        g_menu_item_set_action_and_target(item, "win.open-path", "s", paths[i]);
        g_menu_append_item(self->recent_menu, item);
        g_object_unref(item);
        g_free(name);
    }
    g_strfreev(paths);
}

/* As much of a title as a menu has room for. */
static char *short_title(const char *title)
{
    enum { MOST = 60 };
    if (g_utf8_strlen(title, -1) <= MOST)
        return g_strdup(title);
    char *start = g_utf8_substring(title, 0, MOST), *blank = strrchr(start, ' ');
    if (blank)
        *blank = '\0';
    for (gsize length = strlen(start); length > 0 && strchr(",:;", start[length - 1]); length--)
        start[length - 1] = '\0';
    char *text = g_strconcat(start, " …", NULL);
    g_free(start);
    return text;
}

void app_window_fill_menus(AppWindow *self)
{
    for (gsize i = 0; luxel_builtin_scene_name(i); i++) {
        char *text = short_title(gettext(luxel_builtin_scene_title(i)));
        GMenuItem *item = g_menu_item_new(text, NULL);
        g_menu_item_set_action_and_target(item, "win.new", "s", luxel_builtin_scene_name(i));
        g_menu_append_item(self->builtin_menu, item);
        g_object_unref(item);
        g_free(text);
    }
    for (gsize i = 0; app_export_get(i); i++) {
        GMenuItem *item = g_menu_item_new(_(app_export_get(i)->title), NULL);
        g_menu_item_set_action_and_target(item, "win.export", "s", app_export_get(i)->name);
        g_menu_append_item(self->export_menu, item);
        g_object_unref(item);
    }
    fill_recent(self);
    g_signal_connect_object(gtk_recent_manager_get_default(), "changed", G_CALLBACK(fill_recent), self,
                            G_CONNECT_SWAPPED);
}

static gboolean dropped(GtkDropTarget *target, const GValue *value, double x, double y, AppWindow *self)
{
    GSList *files = g_value_get_boxed(value);
    (void)target;
    (void)x;
    (void)y;
    for (GSList *at = files; at; at = at->next) {
        char *path = g_file_get_path(at->data);
        if (path && !app_window_take_file(self, path))
            open_chosen(self, path, NULL);
        g_free(path);
    }
    return files != NULL;
}

void app_window_add_file_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "new", .activate = new_action, .parameter_type = "s"},
        {.name = "open", .activate = open_action},
        {.name = "open-path", .activate = open_path, .parameter_type = "s"},
        {.name = "save", .activate = save},
        {.name = "save-as", .activate = save_as},
        {.name = "save-path", .activate = save_path, .parameter_type = "s"},
        {.name = "export", .activate = export_action, .parameter_type = "s"},
        {.name = "export-path", .activate = export_path, .parameter_type = "(ss)"},
        {.name = "restore", .activate = restore},
        {.name = "discard", .activate = discard},
    };
    GtkDropTarget *drop = gtk_drop_target_new(GDK_TYPE_FILE_LIST, GDK_ACTION_COPY);
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
    g_signal_connect(drop, "drop", G_CALLBACK(dropped), self);
    gtk_widget_add_controller(GTK_WIDGET(self), GTK_EVENT_CONTROLLER(drop));
}
