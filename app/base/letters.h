/* SPDX-License-Identifier: MIT */
/* Letters that are drawn by hand grow with those of the desktop, as those of labels do. */
#ifndef LUXEL_APP_LETTERS_H
#define LUXEL_APP_LETTERS_H

#include <gtk/gtk.h>

/* How much larger than usual the desktop's letters are, 1 to 2. */
double app_letters_scale(GtkWidget *widget);

/*
 * A text in letters of so many dots, times that scale, in the desktop's face or in that of a font's description, such
 * as "Sans Semi-Bold"; the caller's.
 */
PangoLayout *app_letters_new(GtkWidget *widget, const char *text, const char *face, double dots);

#endif
