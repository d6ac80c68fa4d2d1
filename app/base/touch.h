/* SPDX-License-Identifier: MIT */
/*
 * Controls for fingers: where the seat has a touch screen, or where it is switched on under "Appearance", all that can
 * be pressed is at least APP_FINGER dots wide and high, and things on pictures are taken from as far away.
 */
#ifndef LUXEL_APP_TOUCH_H
#define LUXEL_APP_TOUCH_H

#include <gtk/gtk.h>

enum { APP_FINGER = 44 /* dots across that a fingertip hits */ };

/*
 * Adds the action "touch" to a program, with the state of the settings (NULL: it has none), and looks after the windows
 * that come and the touch screens that are plugged in.
 */
void app_touch_begin(GtkApplication *application, GSettings *settings);

/* A finger that rests on a widget does what the right button does: calls "pressed" (gesture, x, y, data). */
void app_touch_on_rest(GtkWidget *widget, GCallback pressed, gpointer data);

/* How far from a thing on a widget a press takes it, `reach` being what suits a mouse. */
int app_touch_reach(GtkWidget *widget, int reach);

#endif
