/* SPDX-License-Identifier: MIT */
/* Files that become a part of the scene: one that is chosen for a key, a mesh or a luminaire that is dropped. */
#include <string.h>

#include "../../front/words.h"
#include "../base/scalar.h"
#include "../form/new_surface.h"
#include "export.h"
#include "window_private.h"

/* What can be chosen for a key. */
typedef struct Choice {
    const char *title, *name;
    const char *patterns[8];
} Choice;

static const Choice choices[] = {
    {N_("Choose a mesh"), N_("Meshes"), {"*.obj", "*.ply", "*.stl", "*.off", "*.gltf", "*.glb", NULL}},
    {N_("Choose a luminaire"), N_("Photometry files"), {"*.ies", "*.ldt", "*.IES", "*.LDT", NULL}},
    {N_("Choose a table of sources"), N_("Tables of sources"), {"*.csv", "*.npy", "*.lp", "*.txt", NULL}},
};

/* By what has the key: surfaces and volume sources take meshes. */
static const Choice *choice_for(AppWindow *self, const char *key)
{
    if (!g_str_has_prefix(key, "lights[") || g_str_has_suffix(key, ".mesh"))
        return &choices[0];
    char *type_key = g_strdup_printf("%.*s.type", (int)(strrchr(key, '.') - key), key);
    char *type = app_document_get(self->document, type_key, NULL);
    const gboolean is_luminaire = g_strcmp0(type, "luminaire") == 0;
    g_free(type);
    g_free(type_key);
    return &choices[is_luminaire ? 1 : 2];
}

static void set_file(AppWindow *self, const char *key, const char *path)
{
    char *file = app_file_in_scene(self->document, path), *quoted = app_yaml_quote(file);
    app_document_set(self->document, key, quoted, NULL);
    g_free(quoted);
    g_free(file);
}

/* ---- dialogs ---- */

typedef struct Asked {
    AppWindow *window;
    char *key; /* NULL: the file becomes a part of the scene of its own */
} Asked;

static void answered(GtkNativeDialog *dialog, int response, Asked *asked)
{
    GFile *file = response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog)) : NULL;
    char *path = file ? g_file_get_path(file) : NULL;
    if (path && app_window_is_open(asked->window)) {
        if (asked->key)
            set_file(asked->window, asked->key, path);
        else
            app_window_take_file(asked->window, path);
    }
    g_free(path);
    g_clear_object(&file);
    g_object_unref(asked->window);
    g_free(asked->key);
    g_free(asked);
    g_object_unref(dialog);
}

static void ask(AppWindow *self, const Choice *choice, const char *key)
{
    static const char *const all[] = {"*", NULL};
    const char *scene = app_document_path(self->document);
    GtkFileChooserNative *dialog =
        gtk_file_chooser_native_new(_(choice->title), GTK_WINDOW(self), GTK_FILE_CHOOSER_ACTION_OPEN, NULL, NULL);
    Asked *asked = g_new(Asked, 1);
    *asked = (Asked){g_object_ref(self), g_strdup(key)};
    if (scene) {
        GFile *file = g_file_new_for_path(scene), *folder = g_file_get_parent(file);
        gtk_file_chooser_set_current_folder(GTK_FILE_CHOOSER(dialog), folder, NULL);
        g_object_unref(folder);
        g_object_unref(file);
    }
    app_chooser_add_filter(GTK_FILE_CHOOSER(dialog), _(choice->name), choice->patterns);
    app_chooser_add_filter(GTK_FILE_CHOOSER(dialog), _("All files"), all);
    g_signal_connect(dialog, "response", G_CALLBACK(answered), asked);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), FALSE);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

static void choose_file(GSimpleAction *action, GVariant *argument, gpointer data)
{
    const char *key = g_variant_get_string(argument, NULL);
    (void)action;
    ask(data, choice_for(data, key), key);
}

static void surface_mesh(GSimpleAction *action, GVariant *argument, gpointer data)
{
    (void)action;
    (void)argument;
    ask(data, &choices[0], NULL);
}

/* For scripts and tests, through the window's actions on the session bus. */
static void choose_file_path(GSimpleAction *action, GVariant *argument, gpointer data)
{
    const char *key, *path;
    (void)action;
    g_variant_get(argument, "(&s&s)", &key, &path);
    set_file(data, key, path);
}

/* ---- what is dropped ---- */

static void add_mesh(AppWindow *self, const char *path)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    char *yaml = app_new_mesh(self->document, path, faults);
    const gsize count = app_document_size(self->document, "surfaces");
    const AppEdit edit = {.kind = APP_EDIT_INSERT, .key = "surfaces", .value = yaml, .index = count};
    if (yaml && app_document_edit(self->document, &edit, 1, NULL, faults)) {
        gtk_drop_down_set_selected(GTK_DROP_DOWN(self->surface_list), (guint)count);
        app_window_show_fault(self, NULL);
    } else {
        char *text = app_faults_text(faults, NULL);
        app_window_show_fault(self, text ? text : path);
        g_free(text);
    }
    g_free(yaml);
    luxel_diagnostics_free(faults);
}

/* A file that is none is told before it comes into the scene. */
static void add_luminaire(AppWindow *self, const char *path)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    luxel_photometry *photometry;
    char *file = app_file_in_scene(self->document, path);
    if (luxel_photometry_read(path, faults, &photometry) == LUXEL_OK) {
        luxel_photometry_free(photometry);
        app_sources_add_luminaire(APP_SOURCES(self->sources), file);
        app_window_show_fault(self, NULL);
    } else {
        char *text = app_faults_text(faults, path);
        const luxel_diagnostic *first = luxel_diagnostics_get(faults, 0);
        char *whole = first && first->line ? g_strdup(text)
                                           : g_strdup_printf("%s: %s", path, text ? text : _("it cannot be read"));
        app_window_show_fault(self, whole);
        g_free(whole);
        g_free(text);
    }
    g_free(file);
    luxel_diagnostics_free(faults);
}

gboolean app_window_take_file(AppWindow *self, const char *path)
{
    switch (app_file_kind(path)) {
    case APP_FILE_MESH: add_mesh(self, path); return TRUE;
    case APP_FILE_LUMINAIRE: add_luminaire(self, path); return TRUE;
    default: return FALSE;
    }
}

static void take_path(GSimpleAction *action, GVariant *path, gpointer data)
{
    (void)action;
    app_window_take_file(data, g_variant_get_string(path, NULL));
}

void app_window_add_chosen_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "choose-file", .activate = choose_file, .parameter_type = "s"},
        {.name = "surface-mesh", .activate = surface_mesh},
        {.name = "choose-file-path", .activate = choose_file_path, .parameter_type = "(ss)"},
        {.name = "take-path", .activate = take_path, .parameter_type = "s"},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}
