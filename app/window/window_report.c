/* SPDX-License-Identifier: MIT */
/* Who hands a report in: asked once in a small window, and remembered. */
#include <string.h>

#include "../../front/words.h"
#include "export.h"
#include "window_private.h"

enum { MARGIN = 16, FIELD_CHARS = 32 };

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

static gboolean cancelled(GtkWidget *widget, GVariant *arguments, gpointer dialog)
{
    (void)widget;
    (void)arguments;
    gtk_window_destroy(dialog);
    return TRUE;
}

static void cancel_clicked(GtkWidget *button, GtkWindow *dialog)
{
    (void)button;
    gtk_window_destroy(dialog);
}

static void free_question(gpointer data)
{
    g_free(data);
}

static void add_field(Question *question, GtkWidget *grid, gsize i)
{
    GtkWidget *label = gtk_label_new(_(fields[i].label)), *entry = gtk_entry_new();
    const char *kept = g_hash_table_lookup(question->window->report, fields[i].key);
    question->entries[i] = entry;
    gtk_label_set_xalign(GTK_LABEL(label), 0);
    gtk_editable_set_text(GTK_EDITABLE(entry), kept ? kept : "");
    gtk_editable_set_width_chars(GTK_EDITABLE(entry), FIELD_CHARS);
    gtk_accessible_update_property(GTK_ACCESSIBLE(entry), GTK_ACCESSIBLE_PROPERTY_LABEL, _(fields[i].label), -1);
    g_signal_connect(entry, "activate", G_CALLBACK(accepted), question);
    gtk_grid_attach(GTK_GRID(grid), label, 0, (int)i, 1, 1);
    gtk_grid_attach(GTK_GRID(grid), entry, 1, (int)i, 1, 1);
}

static GtkWidget *new_buttons(Question *question)
{
    GtkWidget *box = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 8);
    GtkWidget *cancel = gtk_button_new_with_label(_("Cancel")), *accept = gtk_button_new_with_label(_("Continue"));
    gtk_widget_set_halign(box, GTK_ALIGN_END);
    gtk_widget_add_css_class(accept, "suggested-action");
    g_signal_connect(cancel, "clicked", G_CALLBACK(cancel_clicked), question->dialog);
    g_signal_connect(accept, "clicked", G_CALLBACK(accepted), question);
    gtk_box_append(GTK_BOX(box), cancel);
    gtk_box_append(GTK_BOX(box), accept);
    return box;
}

void app_window_ask_report(AppWindow *self, void (*done)(AppWindow *self))
{
    Question *question = g_new0(Question, 1);
    GtkWidget *grid = gtk_grid_new(), *box = gtk_box_new(GTK_ORIENTATION_VERTICAL, MARGIN);
    GtkEventController *keys = gtk_shortcut_controller_new();
    *question = (Question){.window = self, .done = done, .dialog = gtk_window_new()};
    g_object_set_data_full(G_OBJECT(question->dialog), "luxel-question", question, free_question);
    gtk_grid_set_column_spacing(GTK_GRID(grid), MARGIN);
    gtk_grid_set_row_spacing(GTK_GRID(grid), MARGIN / 2);
    for (gsize i = 0; i < G_N_ELEMENTS(fields); i++)
        add_field(question, grid, i);
    gtk_widget_set_margin_start(box, MARGIN);
    gtk_widget_set_margin_end(box, MARGIN);
    gtk_widget_set_margin_top(box, MARGIN);
    gtk_widget_set_margin_bottom(box, MARGIN);
    gtk_box_append(GTK_BOX(box), grid);
    gtk_box_append(GTK_BOX(box), new_buttons(question));
    gtk_window_set_child(GTK_WINDOW(question->dialog), box);
    gtk_window_set_title(GTK_WINDOW(question->dialog), _("What the report says of itself"));
    gtk_window_set_resizable(GTK_WINDOW(question->dialog), FALSE);
    gtk_window_set_transient_for(GTK_WINDOW(question->dialog), GTK_WINDOW(self));
    gtk_window_set_destroy_with_parent(GTK_WINDOW(question->dialog), TRUE);
    gtk_shortcut_controller_add_shortcut(GTK_SHORTCUT_CONTROLLER(keys),
                                         gtk_shortcut_new(gtk_keyval_trigger_new(GDK_KEY_Escape, 0),
                                                          gtk_callback_action_new(cancelled, question->dialog, NULL)));
    gtk_widget_add_controller(question->dialog, keys);
    gtk_window_present(GTK_WINDOW(question->dialog));
}

void app_window_init_report(AppWindow *self)
{
    self->report = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    for (gsize i = 0; i < G_N_ELEMENTS(fields) && self->settings; i++)
        g_hash_table_replace(self->report, g_strdup(fields[i].key),
                             g_settings_get_string(self->settings, fields[i].key));
}
