/* SPDX-License-Identifier: MIT */
/* A row that is new has its place behind the next frame: so long it is waited. */
#include "reveal.h"

typedef struct Wish {
    GtkScrolledWindow *scrolled;
    int row, frames;
} Wish;

static gboolean reveal(GtkWidget *list, GdkFrameClock *clock, gpointer data)
{
    Wish *wish = data;
    GtkListBoxRow *row = gtk_list_box_get_row_at_index(GTK_LIST_BOX(list), wish->row);
    graphene_rect_t at;
    (void)clock;
    if (wish->frames++ == 0)
        return G_SOURCE_CONTINUE;
    if (row && gtk_widget_compute_bounds(GTK_WIDGET(row), list, &at))
        gtk_adjustment_clamp_page(gtk_scrolled_window_get_vadjustment(wish->scrolled), (double)at.origin.y,
                                  (double)(at.origin.y + at.size.height));
    return G_SOURCE_REMOVE;
}

void app_reveal_row(GtkListBox *list, GtkScrolledWindow *scrolled, int row)
{
    Wish *wish = g_new(Wish, 1);
    *wish = (Wish){.scrolled = scrolled, .row = row};
    gtk_widget_add_tick_callback(GTK_WIDGET(list), reveal, wish, g_free);
}
