/* SPDX-License-Identifier: MIT */
/*
 * The history of a text, for undo and redo without limit: a step keeps only the bytes that changed, so that ten
 * thousand of them take less room than one picture.
 */
#ifndef LUXEL_APP_HISTORY_H
#define LUXEL_APP_HISTORY_H

#include <glib.h>

/* Owned by its maker; app_history_free(). */
typedef struct AppHistory AppHistory;

AppHistory *app_history_new(void);
void app_history_free(AppHistory *history);

/* Forgets all steps. */
void app_history_clear(AppHistory *history);

/*
 * Adds the step from one text to the other, and forgets what could be redone.  `merge`: where the last step that was
 * added has the same `topic` and nothing was undone since, the two become one.
 */
void app_history_add(AppHistory *history, const char *before, const char *after, const char *topic, gboolean merge);

/* The text before the last step, or after the one undone last; the caller's.  NULL where there is none. */
char *app_history_undo(AppHistory *history, const char *text);
char *app_history_redo(AppHistory *history, const char *text);

gboolean app_history_can_undo(const AppHistory *history);
gboolean app_history_can_redo(const AppHistory *history);

/* What the step is about that would be undone or redone next, such as "lights[0].intensity"; NULL: there is none. */
const char *app_history_undo_topic(const AppHistory *history);
const char *app_history_redo_topic(const AppHistory *history);

#endif
