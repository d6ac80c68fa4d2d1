/* SPDX-License-Identifier: MIT */
/*
 * A document: the scene that is worked on as its text, with undo, redo and the file that it belongs to.  Every change
 * goes through here; whoever shows the scene listens to the signal "changed".
 *
 * Signals: "changed" after every change of the text; "renamed" when the file, or whether there is unsaved work, is
 * another.  Used from the main thread only.
 */
#ifndef LUXEL_APP_DOCUMENT_H
#define LUXEL_APP_DOCUMENT_H

#include <gio/gio.h>
#include <luxel/luxel.h>

#include "history.h"

/* The prefix that names a built-in scene among files: "builtin:report". */
#define APP_BUILTIN "builtin:"

#define APP_TYPE_DOCUMENT (app_document_get_type())
G_DECLARE_FINAL_TYPE(AppDocument, app_document, APP, DOCUMENT, GObject)

/* A document of the built-in scene `sphere`, which is whole in view with its lamp. */
AppDocument *app_document_new(void);

/*
 * Each replaces the whole document, history included; FALSE leaves it as it was.  A file whose scene has errors is
 * not opened: the diagnostics say them all.
 */
gboolean app_document_open_builtin(AppDocument *self, const char *name, luxel_diagnostics *diagnostics);
gboolean app_document_open_file(AppDocument *self, const char *path, luxel_diagnostics *diagnostics);
/* Unsaved work found again: its text and the file that it belonged to, NULL for none. */
gboolean app_document_open_unsaved(AppDocument *self, const char *text, const char *path,
                                   luxel_diagnostics *diagnostics);

/* Saves the text to a file, which becomes the document's. */
gboolean app_document_save(AppDocument *self, const char *path, luxel_diagnostics *diagnostics);

/* Whether another program has changed the file since it was opened or saved; a file that is gone has not. */
gboolean app_document_is_changed_outside(const AppDocument *self);
/* The content that the file has now counts as known. */
void app_document_know_file(AppDocument *self);

/* The file that it belongs to, or NULL; a name to show; the present text; whether there is unsaved work. */
const char *app_document_path(const AppDocument *self);
const char *app_document_name(const AppDocument *self);
const char *app_document_text(const AppDocument *self);
gboolean app_document_is_modified(const AppDocument *self);

/* A number that every change of the text makes greater; and one that does so for each scene that replaces another. */
guint64 app_document_serial(const AppDocument *self);
guint64 app_document_origin(const AppDocument *self);

/* A document with the same scene, without history, for trying something out. */
AppDocument *app_document_copy(const AppDocument *self);
/* An independent copy of the scene, not committed; the caller's. */
luxel_scene *app_document_copy_scene(const AppDocument *self);

/* The value of a key as YAML, or NULL where there is none; the caller's, g_free().  *written as luxel_scene_get(). */
char *app_document_get(const AppDocument *self, const char *key, gboolean *written);
/* The number of a key, 0 where there is none. */
double app_document_get_number(const AppDocument *self, const char *key);
/* The value that a key had in the file, or the scene that was opened; the caller's. */
char *app_document_get_opened(const AppDocument *self, const char *key);
/* How many elements a list has. */
gsize app_document_size(const AppDocument *self, const char *list);

/* Changes: one step of undo each, and of a gesture one in all that are about the same topic. */
typedef enum AppEditKind {
    APP_EDIT_SET,    /* `value` becomes the key's */
    APP_EDIT_REMOVE, /* the key, or the element of a list, is taken out; harmless where it is not written */
    APP_EDIT_INSERT, /* `value` becomes the element `index` of the list `key` */
    APP_EDIT_MOVE    /* the element `index` of the list `key` becomes the element `to` */
} AppEditKind;

typedef struct AppEdit {
    AppEditKind kind;
    const char *key;
    const char *value;
    gsize index, to;
} AppEdit;

/*
 * Makes edits together, all or none, as one step of undo.  `topic` says what they are about (NULL: the first key).
 * FALSE: one is not possible; the document stays as it was.
 */
gboolean app_document_edit(AppDocument *self, const AppEdit *edits, gsize count, const char *topic,
                           luxel_diagnostics *diagnostics);
gboolean app_document_set(AppDocument *self, const char *key, const char *value, luxel_diagnostics *diagnostics);

/* Between the two, what is about the same topic is one step of undo: a drag of the mouse, a key that is held. */
void app_document_begin_gesture(AppDocument *self);
void app_document_end_gesture(AppDocument *self);

/* While it is set, every change is about this topic, as of several elements that are changed together; NULL: each about
 * its own.  The text lives as long. */
void app_document_set_topic(AppDocument *self, const char *topic);

gboolean app_document_undo(AppDocument *self);
gboolean app_document_redo(AppDocument *self);
const AppHistory *app_document_history(const AppDocument *self);

#endif
