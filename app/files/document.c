/* SPDX-License-Identifier: MIT */
/* The document: a scene, its text after each change, and the steps between the texts. */
#include "document.h"

#include <string.h>

#include "../base/number.h"

/* Changes of one key in so short a time are one step even without a gesture: a key held down, a wheel turned. */
enum { MERGE_MICROSECONDS = 700000 };

struct _AppDocument {
    GObject parent;
    luxel_scene *scene;  /* never committed: copies are */
    luxel_scene *opened; /* as it was opened or saved last */
    char *text, *saved_text;
    char *path, *name;
    AppHistory *history;
    guint64 serial, origin;
    char *file_sum;     /* of what the file had when it was opened or saved; NULL: there is none */
    gint64 last_change; /* monotonic time */
    guint gestures;
    const char *topic;       /* of every change; NULL: each has its own */
    gboolean gesture_is_new; /* nothing was changed in it yet */
    gboolean was_modified;
};

enum { CHANGED, RENAMED, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppDocument, app_document, G_TYPE_OBJECT)

static void app_document_finalize(GObject *object)
{
    AppDocument *self = APP_DOCUMENT(object);
    luxel_scene_free(self->scene);
    luxel_scene_free(self->opened);
    app_history_free(self->history);
    g_free(self->text);
    g_free(self->saved_text);
    g_free(self->file_sum);
    g_free(self->path);
    g_free(self->name);
    G_OBJECT_CLASS(app_document_parent_class)->finalize(object);
}

static void app_document_class_init(AppDocumentClass *class)
{
    G_OBJECT_CLASS(class)->finalize = app_document_finalize;
    signals[CHANGED] =
        g_signal_new("changed", APP_TYPE_DOCUMENT, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[RENAMED] =
        g_signal_new("renamed", APP_TYPE_DOCUMENT, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
}

static void app_document_init(AppDocument *self)
{
    self->history = app_history_new();
}

AppDocument *app_document_new(void)
{
    AppDocument *self = g_object_new(APP_TYPE_DOCUMENT, NULL);
    gboolean done = app_document_open_builtin(self, "sphere", NULL);
    g_assert(done); /* it is part of the library */
    return self;
}

/* The scene's text as memory of GLib; NULL where out of memory. */
static char *text_of(const luxel_scene *scene)
{
    char *text, *copy;
    if (luxel_scene_write_text(scene, &text) != LUXEL_OK)
        return NULL;
    copy = g_strdup(text);
    luxel_text_free(text);
    return copy;
}

static void tell(AppDocument *self, gboolean renamed)
{
    gboolean modified = app_document_is_modified(self);
    g_object_ref(self);
    self->serial++;
    g_signal_emit(self, signals[CHANGED], 0);
    if (renamed || modified != self->was_modified) {
        self->was_modified = modified;
        g_signal_emit(self, signals[RENAMED], 0);
    }
    g_object_unref(self);
}

/* A digest that tells the content of a file from another; NULL: it cannot be read. */
static char *sum_of_file(const char *path)
{
    char *content, *sum;
    gsize length;
    if (!path || !g_file_get_contents(path, &content, &length, NULL))
        return NULL;
    sum = g_compute_checksum_for_data(G_CHECKSUM_SHA256, (const guchar *)content, length);
    g_free(content);
    return sum;
}

void app_document_know_file(AppDocument *self)
{
    g_free(self->file_sum);
    self->file_sum = sum_of_file(self->path);
}

gboolean app_document_is_changed_outside(const AppDocument *self)
{
    char *sum = sum_of_file(self->path);
    const gboolean is_changed = sum && self->file_sum && strcmp(sum, self->file_sum) != 0;
    g_free(sum);
    return is_changed;
}

/* Takes the scene over.  `saved` FALSE: all of it is unsaved work. */
static gboolean adopt(AppDocument *self, luxel_scene *scene, const char *path, const char *name, gboolean saved)
{
    char *text = scene ? text_of(scene) : NULL;
    if (!text) {
        luxel_scene_free(scene);
        return FALSE;
    }
    luxel_scene_free(self->scene);
    luxel_scene_free(self->opened);
    self->scene = scene;
    self->opened = luxel_scene_copy(scene);
    g_free(self->text);
    g_free(self->saved_text);
    self->text = text;
    self->saved_text = saved ? g_strdup(text) : NULL;
    char *new_path = g_strdup(path), *new_name = name ? g_strdup(name) : path ? g_path_get_basename(path) : NULL;
    g_free(self->path);
    g_free(self->name);
    self->path = new_path;
    self->name = new_name;
    app_history_clear(self->history);
    app_document_know_file(self);
    self->origin++;
    tell(self, TRUE);
    return TRUE;
}

gboolean app_document_open_builtin(AppDocument *self, const char *name, luxel_diagnostics *diagnostics)
{
    luxel_scene *scene;
    return luxel_scene_open_builtin(name, diagnostics, &scene) == LUXEL_OK && adopt(self, scene, NULL, name, TRUE);
}

/* A picture that carries its scene is not where the scene is saved to. */
static gboolean is_picture(const char *path)
{
    char *lower = g_ascii_strdown(path, -1);
    gboolean picture = g_str_has_suffix(lower, ".png") || g_str_has_suffix(lower, ".exr");
    g_free(lower);
    return picture;
}

/* A scene with errors would be one without a picture: it is told what is wrong with it instead. */
static gboolean is_right(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    luxel_scene *copy = luxel_scene_copy(scene);
    gboolean right = copy && luxel_scene_commit(copy, diagnostics) == LUXEL_OK &&
                     luxel_scene_check_view(copy, diagnostics) == LUXEL_OK;
    luxel_scene_free(copy);
    return right;
}

gboolean app_document_open_file(AppDocument *self, const char *path, luxel_diagnostics *diagnostics)
{
    luxel_scene *scene;
    if (luxel_scene_read_file(path, diagnostics, &scene) != LUXEL_OK)
        return FALSE;
    if (!is_right(scene, diagnostics)) {
        luxel_scene_free(scene);
        return FALSE;
    }
    if (!is_picture(path))
        return adopt(self, scene, path, NULL, TRUE);
    char *name = g_path_get_basename(path);
    gboolean done = adopt(self, scene, NULL, name, TRUE);
    g_free(name);
    return done;
}

/* Scenes that name files are read from the folder of the file, so the text must belong there. */
gboolean app_document_open_unsaved(AppDocument *self, const char *text, const char *path,
                                   luxel_diagnostics *diagnostics)
{
    luxel_scene *scene;
    if (luxel_scene_read_text(text, strlen(text), path ? path : "", diagnostics, &scene) != LUXEL_OK)
        return FALSE;
    luxel_scene_set_folder_of(scene, path);
    return adopt(self, scene, path, NULL, FALSE);
}

gboolean app_document_save(AppDocument *self, const char *path, luxel_diagnostics *diagnostics)
{
    if (luxel_scene_write_file(self->scene, path, diagnostics) != LUXEL_OK)
        return FALSE;
    char *new_path = g_strdup(path); /* `path` may be the document's own */
    g_free(self->path);
    g_free(self->name);
    self->path = new_path;
    self->name = g_path_get_basename(new_path);
    g_free(self->saved_text);
    self->saved_text = g_strdup(self->text);
    luxel_scene_set_folder_of(self->scene, self->path);
    luxel_scene_free(self->opened);
    self->opened = luxel_scene_copy(self->scene);
    self->was_modified = FALSE;
    app_document_know_file(self);
    g_signal_emit(self, signals[RENAMED], 0);
    return TRUE;
}

const char *app_document_path(const AppDocument *self)
{
    return self->path;
}

const char *app_document_name(const AppDocument *self)
{
    return self->name ? self->name : "";
}

const char *app_document_text(const AppDocument *self)
{
    return self->text;
}

gboolean app_document_is_modified(const AppDocument *self)
{
    return g_strcmp0(self->text, self->saved_text) != 0;
}

guint64 app_document_serial(const AppDocument *self)
{
    return self->serial;
}

guint64 app_document_origin(const AppDocument *self)
{
    return self->origin;
}

AppDocument *app_document_copy(const AppDocument *self)
{
    AppDocument *copy = g_object_new(APP_TYPE_DOCUMENT, NULL);
    adopt(copy, luxel_scene_copy(self->scene), self->path, self->name, FALSE);
    return copy;
}

luxel_scene *app_document_copy_scene(const AppDocument *self)
{
    return luxel_scene_copy(self->scene);
}

static char *get(const luxel_scene *scene, const char *key, gboolean *written)
{
    char *text = NULL, *copy;
    bool is_written = false;
    if (written)
        *written = FALSE;
    if (!scene || luxel_scene_get(scene, key, NULL, &is_written, &text) != LUXEL_OK)
        return NULL;
    if (written)
        *written = is_written;
    copy = g_strdup(text);
    luxel_text_free(text);
    return copy;
}

char *app_document_get(const AppDocument *self, const char *key, gboolean *written)
{
    return get(self->scene, key, written);
}

double app_document_get_number(const AppDocument *self, const char *key)
{
    double number = 0;
    char *text = app_document_get(self, key, NULL);
    app_list_read(text, &number, 1);
    g_free(text);
    return number;
}

char *app_document_get_opened(const AppDocument *self, const char *key)
{
    return get(self->opened, key, NULL);
}

gsize app_document_size(const AppDocument *self, const char *list)
{
    size_t count = 0;
    return luxel_scene_list_size(self->scene, list, NULL, &count) == LUXEL_OK ? count : 0;
}

static luxel_status make_edit(luxel_scene *scene, const AppEdit *edit, luxel_diagnostics *diagnostics)
{
    luxel_status status = LUXEL_ERROR_ARGUMENT;
    char *assignment, *text = NULL;
    bool written = false;
    switch (edit->kind) {
    case APP_EDIT_SET:
        assignment = g_strconcat(edit->key, "=", edit->value, NULL);
        status = luxel_scene_set(scene, assignment, diagnostics);
        g_free(assignment);
        break;
    case APP_EDIT_REMOVE:
        status = luxel_scene_get(scene, edit->key, diagnostics, &written, &text);
        luxel_text_free(text);
        if (status == LUXEL_OK && written)
            status = luxel_scene_remove(scene, edit->key, diagnostics);
        break;
    case APP_EDIT_INSERT: status = luxel_scene_insert(scene, edit->key, edit->index, edit->value, diagnostics); break;
    case APP_EDIT_MOVE: status = luxel_scene_move(scene, edit->key, edit->index, edit->to, diagnostics); break;
    }
    return status;
}

/* Whether a change now belongs to the step before it. */
static gboolean merges(AppDocument *self)
{
    gint64 now = g_get_monotonic_time();
    gboolean merge = self->gestures > 0 ? !self->gesture_is_new : now - self->last_change < MERGE_MICROSECONDS;
    self->last_change = now;
    self->gesture_is_new = FALSE;
    return merge;
}

gboolean app_document_edit(AppDocument *self, const AppEdit *edits, gsize count, const char *topic,
                           luxel_diagnostics *diagnostics)
{
    luxel_scene *changed = luxel_scene_copy(self->scene);
    gboolean done = changed != NULL;
    for (gsize i = 0; i < count && done; i++)
        done = make_edit(changed, &edits[i], diagnostics) == LUXEL_OK;
    char *text = done ? text_of(changed) : NULL;
    if (!text) {
        luxel_scene_free(changed);
        return FALSE;
    }
    luxel_scene_free(self->scene);
    self->scene = changed;
    if (strcmp(text, self->text) == 0) {
        g_free(text);
        return TRUE;
    }
    /* taking elements in and out is never one with what was done before */
    gboolean merge = edits[0].kind == APP_EDIT_SET && merges(self);
    app_history_add(self->history, self->text, text, topic ? topic : self->topic ? self->topic : edits[0].key, merge);
    g_free(self->text);
    self->text = text;
    tell(self, FALSE);
    return TRUE;
}

gboolean app_document_set(AppDocument *self, const char *key, const char *value, luxel_diagnostics *diagnostics)
{
    const AppEdit edit = {.kind = APP_EDIT_SET, .key = key, .value = value};
    return app_document_edit(self, &edit, 1, NULL, diagnostics);
}

void app_document_set_topic(AppDocument *self, const char *topic)
{
    self->topic = topic;
}

void app_document_begin_gesture(AppDocument *self)
{
    self->gesture_is_new = self->gestures == 0 ? TRUE : self->gesture_is_new;
    self->gestures++;
}

void app_document_end_gesture(AppDocument *self)
{
    if (self->gestures > 0)
        self->gestures--;
    self->last_change = 0;
}

/* Takes over a text of the history, which was right once; FALSE where out of memory. */
static gboolean go_to(AppDocument *self, char *text)
{
    luxel_scene *scene;
    if (!text)
        return FALSE;
    if (luxel_scene_read_text(text, strlen(text), self->path ? self->path : "", NULL, &scene) != LUXEL_OK) {
        g_free(text);
        return FALSE;
    }
    luxel_scene_set_folder_of(scene, self->path);
    luxel_scene_free(self->scene);
    self->scene = scene;
    g_free(self->text);
    self->text = text;
    self->last_change = 0;
    tell(self, FALSE);
    return TRUE;
}

gboolean app_document_undo(AppDocument *self)
{
    return go_to(self, app_history_undo(self->history, self->text));
}

gboolean app_document_redo(AppDocument *self)
{
    return go_to(self, app_history_redo(self->history, self->text));
}

const AppHistory *app_document_history(const AppDocument *self)
{
    return self->history;
}
