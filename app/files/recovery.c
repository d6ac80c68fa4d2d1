/* SPDX-License-Identifier: MIT */
/*
 * One file a document, a key file with the text and the path in it, and beside it an empty file that is locked as long
 * as the program lives: who gets the lock knows that nobody else works on that file.
 */
#include "recovery.h"

#include <errno.h>
#include <fcntl.h>
#include <glib/gstdio.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>

enum { DELAY_MS = 1000 };
static const char group[] = "unsaved", ending[] = ".unsaved";

struct AppRecovery {
    AppDocument *document;
    char *file, *lock_file;
    int lock;
    gulong changed, renamed;
    guint timer;
    gboolean is_writing, is_stale; /* is_stale: there is more to write than what is being written */
    gboolean is_forgotten;
    gatomicrefcount references;
    GMutex mutex;           /* held while the file is written */
    guint64 asked, written; /* the contents that were made last and that the file has last, counted from 1 */
};

static char *folder_of_work(void)
{
    return g_build_filename(g_get_user_state_dir(), "luxel", NULL);
}

/* Opens and locks; -1 where somebody else holds it or it cannot be. */
static int take_lock(const char *path)
{
    int file = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) == 0)
        return file;
    if (file >= 0)
        close(file);
    return -1;
}

static char *lock_file_of(const char *file)
{
    return g_strconcat(file, ".lock", NULL);
}

static AppRecovery *hold(AppRecovery *self)
{
    g_atomic_ref_count_inc(&self->references);
    return self;
}

static void let_go(gpointer data)
{
    AppRecovery *self = data;
    if (!g_atomic_ref_count_dec(&self->references))
        return;
    if (self->lock >= 0)
        close(self->lock);
    g_mutex_clear(&self->mutex);
    g_free(self->file);
    g_free(self->lock_file);
    g_free(self);
}

/* ---- writing ---- */

typedef struct Contents {
    AppRecovery *recovery;
    char *text, *path; /* text NULL: nothing is to be kept */
    guint64 serial;
} Contents;

static void free_contents(gpointer data)
{
    Contents *contents = data;
    let_go(contents->recovery);
    g_free(contents->text);
    g_free(contents->path);
    g_free(contents);
}

/* What is to be kept now. */
static Contents *contents_of(AppRecovery *self)
{
    Contents *contents = g_new0(Contents, 1);
    contents->recovery = hold(self);
    contents->serial = ++self->asked;
    if (app_document_is_modified(self->document) && !self->is_forgotten) {
        contents->text = g_strdup(app_document_text(self->document));
        contents->path = g_strdup(app_document_path(self->document));
    }
    return contents;
}

static void write_file(const char *file, const Contents *contents)
{
    if (!contents->text) {
        g_unlink(file);
        return;
    }
    GKeyFile *keys = g_key_file_new();
    g_key_file_set_string(keys, group, "text", contents->text);
    if (contents->path)
        g_key_file_set_string(keys, group, "path", contents->path);
    g_key_file_set_int64(keys, group, "time", g_get_real_time() / G_USEC_PER_SEC);
    gsize length;
    char *bytes = g_key_file_to_data(keys, &length, NULL);
    g_file_set_contents_full(file, bytes, (gssize)length, G_FILE_SET_CONTENTS_CONSISTENT, 0600, NULL);
    g_free(bytes);
    g_key_file_free(keys);
}

/* What another thread is still writing must not come after what is newer. */
static void write_contents(const Contents *contents)
{
    AppRecovery *self = contents->recovery;
    g_mutex_lock(&self->mutex);
    if (contents->serial > self->written) {
        self->written = contents->serial;
        write_file(self->file, contents);
    }
    g_mutex_unlock(&self->mutex);
}

static void write_in_thread(GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
    (void)source;
    (void)cancellable;
    write_contents(data);
    g_task_return_boolean(task, TRUE);
}

static gboolean begin_writing(gpointer data);

static void arm(AppRecovery *self)
{
    if (!self->timer && self->document)
        self->timer = g_timeout_add(DELAY_MS, begin_writing, self);
}

static void written(GObject *source, GAsyncResult *result, gpointer data)
{
    AppRecovery *self = data;
    (void)source;
    (void)result;
    self->is_writing = FALSE;
    if (self->is_stale)
        arm(self);
    self->is_stale = FALSE;
    let_go(self);
}

static gboolean begin_writing(gpointer data)
{
    AppRecovery *self = data;
    self->timer = 0;
    if (self->is_writing) {
        self->is_stale = TRUE;
        return G_SOURCE_REMOVE;
    }
    self->is_writing = TRUE;
    GTask *task = g_task_new(NULL, NULL, written, hold(self));
    g_task_set_task_data(task, contents_of(self), free_contents);
    g_task_run_in_thread(task, write_in_thread);
    g_object_unref(task);
    return G_SOURCE_REMOVE;
}

static void document_changed(AppDocument *document, AppRecovery *self)
{
    (void)document;
    self->is_forgotten = FALSE;
    arm(self);
}

AppRecovery *app_recovery_new(AppDocument *document)
{
    AppRecovery *self = g_new0(AppRecovery, 1);
    g_atomic_ref_count_init(&self->references);
    g_mutex_init(&self->mutex);
    char *folder = folder_of_work(), *unique = g_uuid_string_random();
    char *name = g_strconcat(unique, ending, NULL);
    g_mkdir_with_parents(folder, 0700);
    self->document = g_object_ref(document);
    self->file = g_build_filename(folder, name, NULL);
    self->lock_file = lock_file_of(self->file);
    self->lock = take_lock(self->lock_file);
    self->changed = g_signal_connect(document, "changed", G_CALLBACK(document_changed), self);
    self->renamed = g_signal_connect(document, "renamed", G_CALLBACK(document_changed), self);
    g_free(folder);
    g_free(unique);
    g_free(name);
    return self;
}

void app_recovery_write(AppRecovery *self)
{
    Contents *contents = contents_of(self);
    write_contents(contents);
    free_contents(contents);
}

void app_recovery_forget(AppRecovery *self)
{
    self->is_forgotten = TRUE;
    arm(self);
}

void app_recovery_free(AppRecovery *self)
{
    if (!self)
        return;
    g_signal_handler_disconnect(self->document, self->changed);
    g_signal_handler_disconnect(self->document, self->renamed);
    if (self->timer)
        g_source_remove(self->timer);
    self->timer = 0;
    app_recovery_write(self);
    g_unlink(self->lock_file);
    g_clear_object(&self->document);
    let_go(self);
}

/* ---- finding ---- */

static void free_unsaved(gpointer data)
{
    AppUnsaved *unsaved = data;
    g_free(unsaved->file);
    g_free(unsaved->path);
    g_free(unsaved->name);
    g_free(unsaved->text);
    g_free(unsaved);
}

static AppUnsaved *read_unsaved(const char *file)
{
    GKeyFile *keys = g_key_file_new();
    AppUnsaved *unsaved = NULL;
    char *text = g_key_file_load_from_file(keys, file, G_KEY_FILE_NONE, NULL)
                     ? g_key_file_get_string(keys, group, "text", NULL)
                     : NULL;
    if (text) {
        unsaved = g_new0(AppUnsaved, 1);
        unsaved->file = g_strdup(file);
        unsaved->text = text;
        unsaved->path = g_key_file_get_string(keys, group, "path", NULL);
        unsaved->name = unsaved->path ? g_path_get_basename(unsaved->path) : NULL;
        unsaved->time = g_key_file_get_int64(keys, group, "time", NULL);
    }
    g_key_file_free(keys);
    return unsaved;
}

static int compare_times(gconstpointer a, gconstpointer b)
{
    const AppUnsaved *one = *(AppUnsaved *const *)a, *other = *(AppUnsaved *const *)b;
    return (one->time < other->time) - (one->time > other->time);
}

GPtrArray *app_unsaved_find(void)
{
    GPtrArray *found = g_ptr_array_new_with_free_func(free_unsaved);
    char *folder = folder_of_work();
    GDir *entries = g_dir_open(folder, 0, NULL);
    for (const char *name; entries && (name = g_dir_read_name(entries));) {
        if (!g_str_has_suffix(name, ending))
            continue;
        char *file = g_build_filename(folder, name, NULL), *lock_file = lock_file_of(file);
        int lock = take_lock(lock_file);
        AppUnsaved *unsaved = lock >= 0 ? read_unsaved(file) : NULL;
        if (unsaved)
            g_ptr_array_add(found, unsaved);
        if (lock >= 0) {
            g_unlink(lock_file);
            close(lock);
        }
        g_free(file);
        g_free(lock_file);
    }
    if (entries)
        g_dir_close(entries);
    g_free(folder);
    g_ptr_array_sort(found, compare_times);
    return found;
}

void app_unsaved_discard(const AppUnsaved *unsaved)
{
    g_unlink(unsaved->file);
}
