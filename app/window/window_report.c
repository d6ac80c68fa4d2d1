/* SPDX-License-Identifier: MIT */
/* Who hands a report in: asked once in a small window, and remembered. */
#include <string.h>

#include "../../front/words.h"
#include "dialog.h"
#include "export.h"
#include "window_private.h"

enum { FIELD_CHARS = 32 };

/* What is asked, in this order; the settings keep each under its key. */
static const struct {
    const char *key, *label;
} fields[] = {
    {"report-author", N_("Author")},           {"report-group", N_("Group")},     {"report-date", N_("Date")},
    {"report-institution", N_("Institution")}, {"report-faculty", N_("Faculty")}, {"report-course", N_("Course")},
    {"report-teacher", N_("Teacher")},         {"report-place", N_("Place")},     {"report-aim", N_("Aim of the work")},
};

/* The window while it is open. */
typedef struct Question {
    AppWindow *window;
    void (*done)(AppWindow *self);
    GtkWidget *dialog, *entries[G_N_ELEMENTS(fields)];
} Question;

static char **place_of(AppReport *report, gsize field)
{
    char **const places[] = {&report->author, &report->group,   &report->date,  &report->institution, &report->faculty,
                             &report->course, &report->teacher, &report->place, &report->aim};
    return places[field];
}

void app_window_load_report(AppWindow *self, AppReport *report)
{
    for (gsize i = 0; i < G_N_ELEMENTS(fields); i++) {
        char *kept = g_hash_table_lookup(self->report, fields[i].key);
        *place_of(report, i) = g_strdup(kept ? kept : "");
    }
}

static void keep(AppWindow *self, const char *key, const char *text)
{
    g_hash_table_replace(self->report, g_strdup(key), g_strdup(text));
    if (self->settings)
        g_settings_set_string(self->settings, key, text);
}

static void accepted(GtkWidget *widget, Question *question)
{
    (void)widget;
    AppWindow *window = question->window;
    void (*done)(AppWindow * self) = question->done;
    for (gsize i = 0; i < G_N_ELEMENTS(fields); i++)
        keep(window, fields[i].key, gtk_editable_get_text(GTK_EDITABLE(question->entries[i])));
    gtk_window_destroy(GTK_WINDOW(question->dialog));
    if (app_window_is_open(window))
        done(window);
}

static void free_question(gpointer data)
{
    g_free(data);
}

static void add_field(Question *question, GtkWidget *rows, gsize i)
{
    GtkWidget *entry = gtk_entry_new();
    const char *kept = g_hash_table_lookup(question->window->report, fields[i].key);
    question->entries[i] = entry;
    gtk_editable_set_text(GTK_EDITABLE(entry), kept ? kept : "");
    gtk_editable_set_width_chars(GTK_EDITABLE(entry), FIELD_CHARS);
    g_signal_connect(entry, "activate", G_CALLBACK(accepted), question);
    app_dialog_add_row(rows, _(fields[i].label), entry);
}

void app_window_ask_report(AppWindow *self, void (*done)(AppWindow *self))
{
    Question *question = g_new0(Question, 1);
    GtkWidget *rows;
    *question = (Question){.window = self, .done = done};
    question->dialog = app_dialog_new(GTK_WINDOW(self), _("What the report says of itself"), &rows);
    g_object_set_data_full(G_OBJECT(question->dialog), "luxel-question", question, free_question);
    for (gsize i = 0; i < G_N_ELEMENTS(fields); i++)
        add_field(question, rows, i);
    g_signal_connect(app_dialog_add_buttons(question->dialog, NULL, _("Continue")), "clicked", G_CALLBACK(accepted),
                     question);
    gtk_window_present(GTK_WINDOW(question->dialog));
}

void app_window_init_report(AppWindow *self)
{
    self->report = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    for (gsize i = 0; i < G_N_ELEMENTS(fields) && self->settings; i++)
        g_hash_table_replace(self->report, g_strdup(fields[i].key),
                             g_settings_get_string(self->settings, fields[i].key));
}
