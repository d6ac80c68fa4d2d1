/* SPDX-License-Identifier: MIT */
/* A menu that pops up at a part of a form. */
#ifndef LUXEL_APP_MENU_H
#define LUXEL_APP_MENU_H

#include <gtk/gtk.h>

/* A button of a menu with this text, at the end of its box. */
GtkWidget *app_menu_add(GtkWidget *box, const char *text);

/* Shows a new popover at a part of its parent; the parent has it, and not the part, which may go. */
void app_menu_show(GtkWidget *popover, GtkWidget *parent, GtkWidget *at);

#endif
