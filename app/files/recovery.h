/* SPDX-License-Identifier: MIT */
/*
 * Unsaved work, kept in the user's state folder: what a document holds that its file does not is written a second after
 * it came up, off the main thread, so that a crash or a kill loses no more than that.
 */
#ifndef LUXEL_APP_RECOVERY_H
#define LUXEL_APP_RECOVERY_H

#include "document.h"

/* Keeps the unsaved work of one document; owned by its maker. */
typedef struct AppRecovery AppRecovery;

AppRecovery *app_recovery_new(AppDocument *document);
/* Writes what is left to be written, and leaves it for the next start; what is saved leaves nothing. */
void app_recovery_free(AppRecovery *recovery);
/* Writes it now, before anything else goes on. */
void app_recovery_write(AppRecovery *recovery);
/* The document's work was given up: nothing of it is kept. */
void app_recovery_forget(AppRecovery *recovery);

/* Work of a program that is no longer there. */
typedef struct AppUnsaved {
    char *file; /* where it is kept */
    char *path; /* the scene's file, or NULL */
    char *name; /* to show */
    char *text;
    gint64 time; /* seconds since 1970 */
} AppUnsaved;

/* What was left unsaved, newest first: AppUnsaved's; the caller's. */
GPtrArray *app_unsaved_find(void);
/* Deletes it for good. */
void app_unsaved_discard(const AppUnsaved *unsaved);

#endif
