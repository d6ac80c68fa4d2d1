/* SPDX-License-Identifier: MIT */
/* A scrolled window shows one of its rows or parts. */
#ifndef LUXEL_APP_REVEAL_H
#define LUXEL_APP_REVEAL_H

#include <gtk/gtk.h>

/* Scrolls as little as shows the row, once the rows have their places. */
void app_reveal_row(GtkListBox *list, GtkScrolledWindow *scrolled, int row);

/* Scrolls as little as shows a part of what is scrolled, once all has its place. */
void app_reveal_part(GtkWidget *inside, GtkScrolledWindow *scrolled, GtkWidget *part);

/* Scrolls so far as shows what an expander holds, its head at the least, whenever it is opened. */
void app_reveal_when_opened(GtkExpander *expander, GtkScrolledWindow *scrolled);

/* A list is as high as its rows, of which no more than `most` are seen without scrolling; after each change of them. */
void app_reveal_rows(GtkListBox *list, GtkScrolledWindow *scrolled, int most);

#endif
