/* SPDX-License-Identifier: MIT */
/*
 * The pulse of the app, for `--frame-times`: how long the main loop was away between two looks for events, how many
 * new pictures came to the screen, and how long processors worked for each frame of it.
 */
#ifndef LUXEL_APP_PULSE_H
#define LUXEL_APP_PULSE_H

#include <gtk/gtk.h>

/* Begins to watch the main loop of the calling thread. */
void app_pulse_start(void);
gboolean app_pulse_is_on(void);
/* A new picture was put on the screen. */
void app_pulse_picture(void);
/* Counts the frames of a window. */
void app_pulse_watch(GtkWidget *window);
/* What was seen since the last call, in one line; the caller's. */
char *app_pulse_recent(void);
/* Prints what was seen in all on standard output. */
void app_pulse_print(void);

#endif
