/* SPDX-License-Identifier: MIT */
/* The buttons above a list: what adds to it, by kind, and what is done to the chosen one. */
#ifndef LUXEL_APP_TOOLBAR_H
#define LUXEL_APP_TOOLBAR_H

#include <gtk/gtk.h>
#include <luxel/parameter.h>

GtkWidget *app_toolbar_new(void);
GtkWidget *app_toolbar_add(GtkWidget *bar, const char *icon, const char *meaning, const char *action);
/* A menu of the kinds of a list, "lights" or "surfaces", that have an example; the action gets the name. */
GMenu *app_toolbar_add_kinds(GtkWidget *bar, const luxel_parameters *parameters, const char *list, const char *meaning,
                             const char *action);

#endif
