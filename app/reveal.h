/* SPDX-License-Identifier: MIT */
/* Lists that scroll to one of their rows. */
#ifndef LUXEL_APP_REVEAL_H
#define LUXEL_APP_REVEAL_H

#include <gtk/gtk.h>

/* Scrolls as little as shows the row, once the rows have their places. */
void app_reveal_row(GtkListBox *list, GtkScrolledWindow *scrolled, int row);

#endif
