/* SPDX-License-Identifier: MIT */
/* Exports: the picture, its numbers, figures and reports, written by a thread, just as the command-line tool does. */
#ifndef LUXEL_APP_EXPORT_H
#define LUXEL_APP_EXPORT_H

#include <gio/gio.h>
#include <luxel/figure.h>
#include <luxel/luxel.h>

#include "../picture/display.h"

/* One way to export. */
typedef struct AppExport {
    const char *name;   /* of the action's target: "png8" */
    const char *title;  /* English, to be translated */
    const char *ending; /* of the name that is suggested */
} AppExport;

/* Who hands a report in, and to whom; each may be NULL or "" for nothing; the texts are the owner's, g_free(). */
typedef struct AppReport {
    char *author, *group, *date, *institution, *faculty, *course, *teacher, *place, *aim;
} AppReport;

/* The i-th way; NULL beyond the last. */
const AppExport *app_export_get(gsize i);
const AppExport *app_export_named(const char *name);

/*
 * Writes a scene, which is taken over, as are the texts of `report`; `done` is called in the main loop with NULL or the
 * reason of a failure.  Figures take their colours from `display`.
 */
void app_export(const AppExport *how, luxel_scene *scene, luxel_quantity quantity, const AppDisplay *display,
                const AppReport *report, const char *path,
                void (*done)(const char *path, const char *fault, gpointer owner), GObject *owner);

/*
 * The first messages of a list with their hints, in the user's language, one to a line; those about a place in the file
 * `path` (NULL: in none) begin with it.  The caller's; NULL: none.
 */
char *app_faults_text(const luxel_diagnostics *faults, const char *path);

#endif
