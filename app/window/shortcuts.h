/* SPDX-License-Identifier: MIT */
/* A window that lists what keys and the mouse do. */
#ifndef LUXEL_APP_SHORTCUTS_H
#define LUXEL_APP_SHORTCUTS_H

#include <gtk/gtk.h>

/* Shows it, beside its parent. */
void app_shortcuts_show(GtkWindow *parent);

#endif
