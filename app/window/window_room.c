/* SPDX-License-Identifier: MIT */
/*
 * A room to begin a lighting design with, from a few numbers: a small window asks for them, a thread makes the scene as
 * `luxel room` does, and it is opened as unsaved work.
 */
#include <string.h>

#include "../../front/words.h"
#include "../base/number.h"
#include "dialog.h"
#include "window_private.h"

enum { FIELD_CHARS = 10, NOTE_CHARS = 40, DIGITS = 4 };

/* What is asked, in this order; a field that may be empty has no number at first. */
typedef enum Field {
    FIELD_LENGTH,
    FIELD_WIDTH,
    FIELD_HEIGHT,
    FIELD_CEILING,
    FIELD_WALLS,
    FIELD_FLOOR,
    FIELD_PLANE,
    FIELD_MAINTENANCE,
    FIELD_TARGET,
    FIELD_COLUMNS,
    FIELD_ROWS,
    FIELDS
} Field;

static const struct {
    const char *label, *usual;
} fields[FIELDS] = {
    [FIELD_LENGTH] = {N_("Along x, m"), "8"},
    [FIELD_WIDTH] = {N_("Along y, m"), "6"},
    [FIELD_HEIGHT] = {N_("Height, m"), "2.8"},
    [FIELD_CEILING] = {N_("Reflectance of the ceiling"), "0.7"},
    [FIELD_WALLS] = {N_("Reflectance of the walls"), "0.5"},
    [FIELD_FLOOR] = {N_("Reflectance of the floor"), "0.2"},
    [FIELD_PLANE] = {N_("Work plane, m above the floor"), "0.75"},
    [FIELD_MAINTENANCE] = {N_("Maintenance factor"), "0.8"},
    [FIELD_TARGET] = {N_("Average on the work plane, lx"), "500"},
    [FIELD_COLUMNS] = {N_("Luminaires along x"), ""},
    [FIELD_ROWS] = {N_("Luminaires along y"), ""},
};

/* The small window while it is open. */
typedef struct Question {
    AppWindow *window;
    GtkWidget *dialog, *entries[FIELDS], *luminaire, *note, *accept;
    char *file; /* of photometry; NULL: panels */
    GCancellable *cancellable;
} Question;

/* The work of the thread. */
typedef struct Work {
    luxel_room room;
    char *file;
    luxel_room_design design;
    char *fault; /* NULL: it was made */
} Work;

static void free_work(gpointer data)
{
    Work *work = data;
    luxel_text_free(work->design.text);
    g_free(work->fault);
    g_free(work->file);
    g_free(work);
}

static void free_question(gpointer data)
{
    Question *question = data;
    g_object_unref(question->cancellable);
    g_free(question->file);
    g_free(question);
}

/* ---- making it ---- */

static bool goes_on(double done, void *cancellable)
{
    (void)done;
    return !g_cancellable_is_cancelled(cancellable);
}

static void make(GTask *task, gpointer source, gpointer data, GCancellable *cancellable)
{
    Work *work = data;
    luxel_diagnostics *faults = luxel_diagnostics_new();
    luxel_settings settings;
    (void)source;
    luxel_settings_init(&settings);
    settings.progress = goes_on;
    settings.progress_data = cancellable;
    if (luxel_design_room(&work->room, NULL, &settings, faults, &work->design) != LUXEL_OK) {
        work->fault = app_faults_text(faults, NULL);
        if (!work->fault)
            work->fault = g_strdup(_("out of memory"));
    }
    luxel_diagnostics_free(faults);
    g_task_return_boolean(task, TRUE);
}

/* "4 × 3 luminaires: average 609.9 lx, U0 0.844" */
static char *tell_array(const luxel_room_array *array)
{
    char average[APP_AMOUNT_SIZE], uniformity[APP_NUMBER_SIZE];
    return g_strdup_printf(_("%u × %u luminaires: average %s lx, U0 %s"), array->n[0], array->n[1],
                           app_amount_write(array->average.value, array->average.error, average),
                           app_number_show(array->uniformity, DIGITS, uniformity));
}

static void open_room(AppWindow *self, const luxel_room_design *design)
{
    char *said = tell_array(&design->chosen);
    if (!app_window_is_fresh(self)) {
        self = app_window_new(APP_APPLICATION(gtk_window_get_application(GTK_WINDOW(self))));
        gtk_window_present(GTK_WINDOW(self));
    }
    if (app_document_open_unsaved(self->document, design->text, NULL, NULL))
        app_window_mention(self, said);
    g_free(said);
}

static void made(GObject *dialog, GAsyncResult *result, gpointer data)
{
    const Work *work = g_task_get_task_data(G_TASK(result));
    Question *question = g_object_get_data(dialog, "luxel-question");
    (void)data;
    if (!question || g_cancellable_is_cancelled(question->cancellable)) /* it was closed meanwhile */
        return;
    gtk_widget_set_sensitive(question->accept, TRUE);
    if (work->fault) {
        gtk_label_set_text(GTK_LABEL(question->note), work->fault);
        return;
    }
    AppWindow *window = question->window;
    gtk_window_destroy(GTK_WINDOW(dialog));
    if (app_window_is_open(window))
        open_room(window, &work->design);
}

/* ---- asking ---- */

/* Reads the numbers; FALSE: one is none, which is said. */
static gboolean read_fields(Question *question, double numbers[FIELDS])
{
    for (gsize i = 0; i < FIELDS; i++) {
        const char *text = gtk_editable_get_text(GTK_EDITABLE(question->entries[i]));
        numbers[i] = 0;
        if ((*text || i < FIELD_TARGET) && !app_number_read(text, &numbers[i])) {
            char *fault = g_strdup_printf(_("%s: “%.20s” is not a number"), _(fields[i].label), text);
            gtk_label_set_text(GTK_LABEL(question->note), fault);
            gtk_widget_grab_focus(question->entries[i]);
            g_free(fault);
            return FALSE;
        }
    }
    return TRUE;
}

static void accepted(Question *question)
{
    double numbers[FIELDS];
    if (!gtk_widget_get_sensitive(question->accept) || !read_fields(question, numbers))
        return;
    Work *work = g_new0(Work, 1);
    luxel_room *room = &work->room;
    luxel_room_init(room);
    for (int k = 0; k < 3; k++) {
        room->size_m[k] = numbers[FIELD_LENGTH + k];
        room->reflectances[k] = numbers[FIELD_CEILING + k];
    }
    for (int k = 0; k < 2; k++)
        room->array[k] = (unsigned)CLAMP(numbers[FIELD_COLUMNS + k], 0, G_MAXUINT16);
    room->plane_m = numbers[FIELD_PLANE];
    room->maintenance = numbers[FIELD_MAINTENANCE];
    room->target = numbers[FIELD_TARGET];
    work->file = g_strdup(question->file);
    room->file = work->file;
    gtk_widget_set_sensitive(question->accept, FALSE);
    gtk_label_set_text(GTK_LABEL(question->note), _("being computed…"));
    GTask *task = g_task_new(question->dialog, question->cancellable, made, NULL);
    g_task_set_task_data(task, work, free_work);
    g_task_run_in_thread(task, make);
    g_object_unref(task);
}

static void file_chosen(GtkNativeDialog *chooser, int response, GtkWidget *dialog)
{
    Question *question = g_object_get_data(G_OBJECT(dialog), "luxel-question");
    GFile *file = response == GTK_RESPONSE_ACCEPT ? gtk_file_chooser_get_file(GTK_FILE_CHOOSER(chooser)) : NULL;
    if (file && question) {
        char *name = g_file_get_basename(file);
        g_free(question->file);
        question->file = g_file_get_path(file);
        gtk_button_set_label(GTK_BUTTON(question->luminaire), name);
        g_free(name);
    }
    g_clear_object(&file);
    g_object_unref(chooser);
    g_object_unref(dialog);
}

static void choose_file(Question *question)
{
    static const char *const patterns[] = {"*.ies", "*.ldt", "*.IES", "*.LDT", NULL};
    GtkFileChooserNative *chooser = gtk_file_chooser_native_new(
        _("Choose a luminaire"), GTK_WINDOW(question->dialog), GTK_FILE_CHOOSER_ACTION_OPEN, NULL, NULL);
    app_chooser_add_filter(GTK_FILE_CHOOSER(chooser), _("Photometry files"), patterns);
    g_signal_connect(chooser, "response", G_CALLBACK(file_chosen), g_object_ref(question->dialog));
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(chooser));
}

static void ask_room(GSimpleAction *action, GVariant *argument, gpointer data)
{
    Question *question = g_new0(Question, 1);
    GtkWidget *rows;
    (void)action;
    (void)argument;
    *question = (Question){.window = data, .cancellable = g_cancellable_new()};
    question->dialog = app_dialog_new(GTK_WINDOW(data), _("A new room with luminaires"), &rows);
    g_object_set_data_full(G_OBJECT(question->dialog), "luxel-question", question, free_question);
    g_signal_connect_swapped(question->dialog, "destroy", G_CALLBACK(g_cancellable_cancel), question->cancellable);
    for (gsize i = 0; i < FIELDS; i++) {
        GtkWidget *entry = question->entries[i] = gtk_entry_new();
        char usual[APP_NUMBER_SIZE];
        g_strlcpy(usual, fields[i].usual, sizeof usual);
        gtk_editable_set_text(GTK_EDITABLE(entry), app_number_mark(usual));
        gtk_editable_set_width_chars(GTK_EDITABLE(entry), FIELD_CHARS);
        if (!*usual)
            gtk_entry_set_placeholder_text(GTK_ENTRY(entry), _("as few as will do"));
        g_signal_connect_swapped(entry, "activate", G_CALLBACK(accepted), question);
        app_dialog_add_row(rows, _(fields[i].label), entry);
    }
    char *panels = g_strdup_printf(_("panels of %d lm"), LUXEL_PANEL_LUMENS);
    question->luminaire = gtk_button_new_with_label(panels);
    g_free(panels);
    gtk_widget_set_tooltip_text(question->luminaire, _("Choose a luminaire"));
    g_signal_connect_swapped(question->luminaire, "clicked", G_CALLBACK(choose_file), question);
    app_dialog_add_row(rows, _("Luminaire"), question->luminaire);
    question->note = gtk_label_new(NULL);
    gtk_label_set_wrap(GTK_LABEL(question->note), TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(question->note), NOTE_CHARS);
    gtk_label_set_xalign(GTK_LABEL(question->note), 0);
    question->accept = app_dialog_add_buttons(question->dialog, question->note, _("Make the room"));
    g_signal_connect_swapped(question->accept, "clicked", G_CALLBACK(accepted), question);
    gtk_window_present(GTK_WINDOW(question->dialog));
}

void app_window_add_room_action(AppWindow *self)
{
    static const GActionEntry actions[] = {{.name = "new-room", .activate = ask_room}};
    g_action_map_add_action_entries(G_ACTION_MAP(self), actions, G_N_ELEMENTS(actions), self);
}
