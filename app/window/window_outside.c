/* SPDX-License-Identifier: MIT */
/*
 * The file that the document belongs to, which other programs may change: it is read anew where there is no unsaved
 * work, and else it is asked what is to hold.
 */
#include <string.h>

#include "../../front/words.h"
#include "export.h"
#include "window_private.h"

/* A program that writes a file makes several events of it, of which the last one has it whole. */
enum { SETTLED_MS = 300 };

static void close_question(AppWindow *self)
{
    app_window_set_message(self->outside_label, ""); /* what is no longer shown is not read out either */
    app_window_reveal_bar(self, self->outside_bar, FALSE);
}

static void ask_what_holds(AppWindow *self)
{
    char *text = g_strdup_printf(_("Another program has changed %s, and here there is unsaved work."),
                                 app_document_name(self->document));
    app_window_set_message(self->outside_label, text);
    app_window_reveal_bar(self, self->outside_bar, TRUE);
    g_free(text);
}

/* A file that cannot be opened leaves the document as it is, and is not tried again until it is another one. */
static void read_anew(AppWindow *self)
{
    char *path = g_strdup(app_document_path(self->document));
    close_question(self);
    if (app_window_open(self, path)) {
        char *text =
            g_strdup_printf(_("another program has changed %s: it was read anew"), app_document_name(self->document));
        app_window_mention(self, text);
        g_free(text);
    } else
        app_document_know_file(self->document);
    g_free(path);
}

static gboolean look_at_file(gpointer data)
{
    AppWindow *self = data;
    self->outside_timer = 0;
    if (!app_document_is_changed_outside(self->document))
        close_question(self);
    else if (app_document_is_modified(self->document))
        ask_what_holds(self);
    else
        read_anew(self);
    return G_SOURCE_REMOVE;
}

static void file_changed(AppWindow *self)
{
    g_clear_handle_id(&self->outside_timer, g_source_remove);
    self->outside_timer = g_timeout_add(SETTLED_MS, look_at_file, self);
}

void app_window_watch_file(AppWindow *self)
{
    const char *path = app_document_path(self->document);
    if (!path) {
        app_window_end_watch(self);
        return;
    }
    GFile *file = g_file_new_for_path(path);
    if (!self->watched || !g_file_equal(file, self->watched)) {
        app_window_end_watch(self);
        self->watched = g_object_ref(file);
        self->monitor = g_file_monitor_file(file, G_FILE_MONITOR_WATCH_MOVES, NULL, NULL);
        if (self->monitor)
            g_signal_connect_swapped(self->monitor, "changed", G_CALLBACK(file_changed), self);
    }
    g_object_unref(file);
}

void app_window_end_watch(AppWindow *self)
{
    g_clear_handle_id(&self->outside_timer, g_source_remove);
    if (self->monitor)
        g_signal_handlers_disconnect_by_data(self->monitor, self);
    g_clear_object(&self->monitor);
    g_clear_object(&self->watched);
}

gboolean app_window_may_overwrite(AppWindow *self, const char *path)
{
    if (g_strcmp0(path, app_document_path(self->document)) != 0 || !app_document_is_changed_outside(self->document)) {
        close_question(self);
        return TRUE;
    }
    ask_what_holds(self);
    return FALSE;
}

static void reload(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    if (app_document_path(self->document))
        read_anew(self);
}

/* The work here is to hold: what the file has now may be lost. */
static void overwrite(GSimpleAction *action, GVariant *argument, gpointer data)
{
    AppWindow *self = data;
    (void)action;
    (void)argument;
    close_question(self);
    app_document_know_file(self->document);
    gtk_widget_activate_action(GTK_WIDGET(self), "win.save", NULL);
}

void app_window_add_outside_actions(AppWindow *self)
{
    static const GActionEntry actions[] = {
        {.name = "reload", .activate = reload},
        {.name = "overwrite", .activate = overwrite},
    };
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
    g_signal_connect_swapped(self->outside_bar, "response", G_CALLBACK(close_question), self);
}
