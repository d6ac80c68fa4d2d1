/* SPDX-License-Identifier: MIT */
/* A row that is new, or what was just opened, has its place behind the next frame: so long it is waited. */
#include "reveal.h"

typedef struct Wish {
    GtkScrolledWindow *scrolled;
    GtkWidget *part;       /* NULL: the row of a list */
    int row, frames, last; /* frames so far, and in which it is done */
} Wish;

static void free_wish(gpointer data)
{
    Wish *wish = data;
    g_clear_object(&wish->part);
    g_free(wish);
}

static gboolean reveal(GtkWidget *inside, GdkFrameClock *clock, gpointer data)
{
    Wish *wish = data;
    GtkWidget *row = wish->part;
    graphene_rect_t at;
    (void)clock;
    if (wish->frames++ == 0)
        return G_SOURCE_CONTINUE;
    if (!row)
        row = GTK_WIDGET(gtk_list_box_get_row_at_index(GTK_LIST_BOX(inside), wish->row));
    GtkAdjustment *adjustment = gtk_scrolled_window_get_vadjustment(wish->scrolled);
    if (row && gtk_widget_compute_bounds(row, gtk_scrolled_window_get_child(wish->scrolled), &at)) {
        const double top = gtk_adjustment_get_value(adjustment) + (double)at.origin.y;
        const double page = gtk_adjustment_get_page_size(adjustment), bottom = top + (double)at.size.height;
        /* setting ends the motion to where the keyboard's focus was before all had its place; a clamp would not */
        gtk_adjustment_set_value(adjustment, MIN(MAX(gtk_adjustment_get_value(adjustment), bottom - page), top));
    }
    return wish->frames > wish->last ? G_SOURCE_REMOVE : G_SOURCE_CONTINUE;
}

void app_reveal_row(GtkListBox *list, GtkScrolledWindow *scrolled, int row)
{
    Wish *wish = g_new(Wish, 1);
    *wish = (Wish){.scrolled = scrolled, .row = row};
    gtk_widget_add_tick_callback(GTK_WIDGET(list), reveal, wish, free_wish);
}

static void wish_part(GtkWidget *inside, GtkScrolledWindow *scrolled, GtkWidget *part, int last)
{
    Wish *wish = g_new(Wish, 1);
    *wish = (Wish){.scrolled = scrolled, .part = g_object_ref(part), .last = last};
    gtk_widget_add_tick_callback(inside, reveal, wish, free_wish);
}

/* The part has the last word: meanwhile its section is shown, too, and the keyboard's focus scrolls. */
void app_reveal_part(GtkWidget *inside, GtkScrolledWindow *scrolled, GtkWidget *part)
{
    enum { FRAMES = 5 };
    wish_part(inside, scrolled, part, FRAMES);
}

static void opened(GtkExpander *expander, GParamSpec *spec, GtkScrolledWindow *scrolled)
{
    (void)spec;
    if (gtk_expander_get_expanded(expander))
        wish_part(gtk_widget_get_parent(GTK_WIDGET(expander)), scrolled, GTK_WIDGET(expander), 1);
}

void app_reveal_when_opened(GtkExpander *expander, GtkScrolledWindow *scrolled)
{
    g_signal_connect(expander, "notify::expanded", G_CALLBACK(opened), scrolled);
}

static void set_height(GtkListBox *list, GtkScrolledWindow *scrolled)
{
    const int most = GPOINTER_TO_INT(g_object_get_data(G_OBJECT(list), "most-rows"));
    GtkListBoxRow *last = gtk_list_box_get_row_at_index(list, most);
    int all, row = 0;
    gtk_widget_measure(GTK_WIDGET(list), GTK_ORIENTATION_VERTICAL, -1, NULL, &all, NULL, NULL);
    for (; last; last = gtk_list_box_get_row_at_index(list, gtk_list_box_row_get_index(last) + 1)) {
        gtk_widget_measure(GTK_WIDGET(last), GTK_ORIENTATION_VERTICAL, -1, NULL, &row, NULL, NULL);
        all -= row;
    }
    gtk_scrolled_window_set_min_content_height(scrolled, all);
}

void app_reveal_rows(GtkListBox *list, GtkScrolledWindow *scrolled, int most)
{
    if (!g_object_get_data(G_OBJECT(list), "most-rows")) /* how high letters are is known when they are seen */
        g_signal_connect(list, "map", G_CALLBACK(set_height), scrolled);
    g_object_set_data(G_OBJECT(list), "most-rows", GINT_TO_POINTER(most));
    set_height(list, scrolled);
}
