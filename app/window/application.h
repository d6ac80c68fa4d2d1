/* SPDX-License-Identifier: MIT */
/* The application: its windows, what all of them share, and the command line. */
#ifndef LUXEL_APP_APPLICATION_H
#define LUXEL_APP_APPLICATION_H

#include <gtk/gtk.h>

#define APP_TYPE_APPLICATION (app_application_get_type())
G_DECLARE_FINAL_TYPE(AppApplication, app_application, APP, APPLICATION, GtkApplication)

AppApplication *app_application_new(void);

/* The settings; NULL where their schema is not installed, and then nothing is kept. */
GSettings *app_application_settings(AppApplication *self);

/* Opens a file in a window that has nothing to lose, or in a new one. */
void app_application_open(AppApplication *self, const char *path);

#endif
