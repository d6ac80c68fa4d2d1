/* SPDX-License-Identifier: MIT */
/*
 * A runner: a thread for work of which only the newest matters.  A job that is posted takes the place of one that
 * waits, and the one that is being done is told that it is outdated.  What the work reports comes back in the main
 * loop, in order.
 */
#ifndef LUXEL_APP_RUNNER_H
#define LUXEL_APP_RUNNER_H

#include <glib.h>

typedef struct AppRunner AppRunner;

/* Does a job, in the runner's thread; `state` is the runner's own. */
typedef void (*AppWork)(AppRunner *runner, gpointer job, gpointer state);
/* Takes a report, in the main loop; the report is freed afterwards. */
typedef void (*AppDeliver)(gpointer report, gpointer owner);

typedef struct AppRunnerClass {
    const char *name;
    AppWork work;
    GDestroyNotify free_job, free_report, free_state;
    int nice; /* how much the work stands back behind the main loop, as nice(1) counts it */
} AppRunnerClass;

/* The runner takes `state` over; `deliver` is called with `owner` until app_runner_stop(). */
AppRunner *app_runner_new(const AppRunnerClass *class, gpointer state, AppDeliver deliver, gpointer owner);
/* Ends the work and waits for that; nothing is delivered afterwards.  NULL is harmless. */
void app_runner_stop(AppRunner *runner);

/* Takes the job over. */
void app_runner_post(AppRunner *runner, gpointer job);
/* Whether a job waits or is being done. */
gboolean app_runner_is_busy(AppRunner *runner);

/* For the work: whether there is a newer job or the runner is about to stop. */
gboolean app_runner_is_outdated(AppRunner *runner);
/* Takes the job that waits out, if it fits: the one that is being done stands for it then, and is not outdated.  The
 * work's; NULL: none waits that fits. */
gpointer app_runner_take(AppRunner *runner, gboolean (*fits)(gconstpointer job, gconstpointer data),
                         gconstpointer data);
/* Waits so long for a newer job; whether there is one. */
gboolean app_runner_rest(AppRunner *runner, guint milliseconds);
/* Takes the report over. */
void app_runner_report(AppRunner *runner, gpointer report);

#endif
