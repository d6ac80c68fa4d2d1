/* SPDX-License-Identifier: MIT */
/* Rows: labels, notes and controls; those of numbers are made in row_number.c. */
#include "row.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "choice.h"
#include "letters.h"
#include "number.h"
#include "row_private.h"
#include "touch.h"

enum { FIELD_WIDTH = 120 /* dots: the fields of a form have one left edge, and one right edge */ };
enum { EDITED, RESET, MENU, BROWSE, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppRow, app_row, GTK_TYPE_BOX)

void app_name_control(GtkWidget *control, const char *name)
{
    GtkWidget *inner = gtk_widget_get_first_child(control);
    gtk_accessible_update_property(GTK_ACCESSIBLE(control), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    if (inner && GTK_IS_DROP_DOWN(control))
        gtk_accessible_update_property(GTK_ACCESSIBLE(inner), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
}

/* ---- what a row says of its value ---- */

void app_row_note(AppRow *self, const char *text, gboolean wrong)
{
    gtk_label_set_text(GTK_LABEL(self->note), text ? text : "");
    gtk_widget_set_visible(self->note, text != NULL);
    if (wrong)
        gtk_widget_add_css_class(self->control, "error");
    else
        gtk_widget_remove_css_class(self->control, "error");
    gtk_widget_remove_css_class(self->note, wrong ? "advice" : "error");
    gtk_widget_add_css_class(self->note, wrong ? "error" : "advice");
    gtk_accessible_update_state(GTK_ACCESSIBLE(self->control), GTK_ACCESSIBLE_STATE_INVALID,
                                wrong ? GTK_ACCESSIBLE_INVALID_TRUE : GTK_ACCESSIBLE_INVALID_FALSE, -1);
}

void app_row_say_state(AppRow *self)
{
    if (self->is_wrong)
        return;
    if (self->is_empty || !app_row_is_outside(&self->advised, self->value) || !self->advised_words) {
        app_row_note(self, NULL, FALSE);
        return;
    }
    /* TRANSLATORS: {0} is a range such as "100 to 10000 mm" */
    char **parts = g_strsplit(_("advised: {0}"), "{0}", 2);
    char *text = g_strjoinv(self->advised_words, parts);
    app_row_note(self, text, FALSE);
    g_free(text);
    g_strfreev(parts);
}

void app_row_refuse(AppRow *self, const char *reason)
{
    self->is_wrong = TRUE;
    app_row_note(self, reason, TRUE);
}

void app_row_set_fault(AppRow *self, const char *reason)
{
    if (reason)
        app_row_note(self, reason, TRUE);
    else
        app_row_say_state(self);
}

GtkWidget *app_row_words(AppRow *self)
{
    return self->note;
}

void app_row_set_unit(AppRow *self, const char *unit)
{
    gtk_label_set_text(GTK_LABEL(self->unit), unit);
    gtk_widget_set_visible(self->unit, unit && *unit);
}

/* The name by which screen readers know the control. */
static void name_row(const AppRow *self)
{
    const char *meaning = gtk_widget_get_tooltip_text(GTK_WIDGET(self));
    if (APP_IS_CHOICE(self->control))
        app_choice_name(APP_CHOICE(self->control), self->label, meaning ? meaning : "");
    else
        app_name_control(self->control, self->label);
}

const char *app_row_label(const AppRow *self)
{
    return self->label;
}

void app_row_set_label(AppRow *self, const char *label)
{
    if (strcmp(label, self->label) == 0)
        return;
    g_free(self->label);
    self->label = g_strdup(label);
    if (!self->is_part)
        gtk_label_set_text(GTK_LABEL(self->name), label);
    name_row(self);
}

/* ---- the other kinds ---- */

static void switched(GtkCheckButton *button, AppRow *self)
{
    if (!self->is_updating)
        g_signal_emit(self, signals[EDITED], 0, gtk_check_button_get_active(button) ? "true" : "false");
}

static void chosen(AppChoice *choice, const char *yaml, AppRow *self)
{
    (void)choice;
    g_signal_emit(self, signals[EDITED], 0, yaml);
}

static void choice_refused(AppChoice *choice, const char *reason, AppRow *self)
{
    (void)choice;
    self->is_wrong = *reason != '\0';
    app_row_note(self, *reason ? reason : NULL, self->is_wrong);
}

/* Where it was not changed, nothing is done. */
void app_row_enter(AppRow *self)
{
    const char *typed = gtk_editable_get_text(GTK_EDITABLE(self->control));
    const char *shown = g_object_get_data(G_OBJECT(self->control), "shown");
    if (self->is_updating || g_strcmp0(typed, shown ? shown : "") == 0)
        return;
    self->is_wrong = FALSE;
    char *yaml = self->kind == APP_ROW_YAML ? g_strdup(typed) : app_yaml_quote(typed);
    g_signal_emit(self, signals[EDITED], 0, yaml);
    g_free(yaml);
}

static void add_choice(AppRow *self, const char *choices)
{
    const guint numbers = self->kind == APP_ROW_RANGE ? 2 : self->kind == APP_ROW_CHOICE_OR_WHOLE ? 1 : 0;
    self->control = app_choice_new(choices, numbers);
    g_signal_connect(self->control, "chosen", G_CALLBACK(chosen), self);
    g_signal_connect(self->control, "refused", G_CALLBACK(choice_refused), self);
}

static gboolean is_typed_in(AppRow *self)
{
    return (gtk_widget_get_state_flags(self->control) & GTK_STATE_FLAG_FOCUS_WITHIN) != 0;
}

static void show_text(AppRow *self, const char *yaml)
{
    char *text = !yaml ? g_strdup("") : self->kind == APP_ROW_YAML ? g_strdup(yaml) : app_yaml_unquote(yaml);
    const char *shown = g_object_get_data(G_OBJECT(self->control), "shown");
    if (g_strcmp0(text, shown) != 0 || !is_typed_in(self))
        gtk_editable_set_text(GTK_EDITABLE(self->control), text);
    g_object_set_data_full(G_OBJECT(self->control), "shown", text, g_free);
}

static gboolean restore_text(AppRow *self, const char *holds)
{
    const gboolean differs = strcmp(gtk_editable_get_text(GTK_EDITABLE(self->control)), holds) != 0;
    if (!differs && !self->is_wrong)
        return FALSE;
    self->is_updating = TRUE;
    self->is_wrong = FALSE;
    gtk_editable_set_text(GTK_EDITABLE(self->control), holds);
    gtk_editable_set_position(GTK_EDITABLE(self->control), -1);
    self->is_updating = FALSE;
    app_row_note(self, NULL, FALSE);
    return TRUE;
}

gboolean app_row_restore(AppRow *self)
{
    char text[APP_NUMBER_SIZE] = "";
    const char *shown;
    gboolean restored;
    switch (self->kind) {
    case APP_ROW_NUMBER:
    case APP_ROW_WHOLE:
        restored = restore_text(self, self->is_empty ? "" : app_number_show_all(self->value, text));
        app_row_say_state(self);
        return restored;
    case APP_ROW_TEXT:
    case APP_ROW_DATE:
    case APP_ROW_YAML:
        shown = g_object_get_data(G_OBJECT(self->control), "shown");
        return restore_text(self, shown ? shown : "");
    case APP_ROW_RANGE:
    case APP_ROW_CHOICE_OR_WHOLE: return app_choice_restore(APP_CHOICE(self->control));
    default: return FALSE;
    }
}

void app_row_leave(AppRow *self)
{
    if (!self->is_wrong)
        return;
    char *reason = g_strdup(gtk_label_get_text(GTK_LABEL(self->note)));
    app_row_restore(self);
    app_row_note(self, reason, FALSE);
    g_free(reason);
}

/* What is wrong with it is found out first, then it goes. */
static void text_left(AppRow *self)
{
    app_row_enter(self);
    app_row_leave(self);
}

static void add_text(AppRow *self, const char *hint)
{
    GtkEventController *focus = gtk_event_controller_focus_new();
    self->control = gtk_entry_new();
    gtk_editable_set_enable_undo(GTK_EDITABLE(self->control), FALSE);
    gtk_editable_set_width_chars(GTK_EDITABLE(self->control), 6);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(self->control), 6);
    gtk_entry_set_placeholder_text(GTK_ENTRY(self->control), hint);
    g_signal_connect_swapped(self->control, "activate", G_CALLBACK(app_row_enter), self);
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(text_left), self);
    gtk_widget_add_controller(self->control, focus);
}

static void browsed(AppRow *self)
{
    g_signal_emit(self, signals[BROWSE], 0);
}

static void add_browsing(AppRow *self, GtkWidget *line)
{
    GtkWidget *button = gtk_button_new_with_label(_("Open…"));
    gtk_widget_set_tooltip_text(button, _("Choose a file"));
    g_signal_connect_swapped(button, "clicked", G_CALLBACK(browsed), self);
    gtk_box_append(GTK_BOX(line), self->control);
    gtk_box_append(GTK_BOX(line), button);
}

static gboolean settle(gpointer row)
{
    app_row_leave(row);
    return G_SOURCE_REMOVE;
}

/* When the field itself has judged what was typed. */
static void number_left(AppRow *self)
{
    g_idle_add_full(G_PRIORITY_DEFAULT_IDLE, settle, g_object_ref(self), g_object_unref);
}

/* The field's own undo would bring texts back that were never values. */
static void watch_field(AppRow *self)
{
    GtkEventController *focus = gtk_event_controller_focus_new();
    gtk_editable_set_enable_undo(GTK_EDITABLE(self->control), FALSE);
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(number_left), self);
    gtk_widget_add_controller(self->control, focus);
}

static gboolean key_pressed(GtkEventControllerKey *controller, guint key, guint code, GdkModifierType state,
                            AppRow *self)
{
    const guint lower = gdk_keyval_to_lower(key);
    const gboolean undoes =
        (state & GDK_CONTROL_MASK) && !(state & GDK_SHIFT_MASK) && (lower == GDK_KEY_z || lower == GDK_KEY_Cyrillic_ya);
    (void)controller;
    (void)code;
    return (key == GDK_KEY_Escape || undoes) && app_row_restore(self);
}

void app_row_suggest(AppRow *self, double low, double high)
{
    if (APP_IS_CHOICE(self->control))
        app_choice_suggest(APP_CHOICE(self->control), low, high);
}

void app_row_set(AppRow *self, const char *yaml)
{
    double value;
    self->is_updating = TRUE;
    switch (self->kind) {
    case APP_ROW_NUMBER:
    case APP_ROW_WHOLE:
        if (!yaml || !app_number_read(yaml, &value)) {
            self->is_empty = TRUE;
            app_row_show_number(self);
        } else if (value != self->value || self->is_empty || !self->is_wrong) {
            /* else a wrong number stays until another value comes */
            self->is_empty = FALSE;
            self->value = value;
            app_row_show_number(self);
        }
        break;
    case APP_ROW_SWITCH:
        gtk_check_button_set_active(GTK_CHECK_BUTTON(self->control), g_strcmp0(yaml, "true") == 0);
        break;
    case APP_ROW_CHOICE:
    case APP_ROW_RANGE:
    case APP_ROW_CHOICE_OR_WHOLE: app_choice_set(APP_CHOICE(self->control), yaml); break;
    case APP_ROW_TEXT:
    case APP_ROW_DATE:
    case APP_ROW_YAML: show_text(self, yaml); break;
    }
    self->is_updating = FALSE;
}

/* ---- the class ---- */

static void app_row_finalize(GObject *object)
{
    AppRow *self = APP_ROW(object);
    g_object_unref(self->note);
    g_free(self->label);
    g_free(self->advised_words);
    G_OBJECT_CLASS(app_row_parent_class)->finalize(object);
}

static void app_row_class_init(AppRowClass *class)
{
    signals[BROWSE] = g_signal_new("browse", APP_TYPE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    G_OBJECT_CLASS(class)->finalize = app_row_finalize;
    signals[EDITED] =
        g_signal_new("edited", APP_TYPE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, G_TYPE_STRING);
    signals[RESET] = g_signal_new("reset", APP_TYPE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[MENU] =
        g_signal_new("menu", APP_TYPE_ROW, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1, GTK_TYPE_WIDGET);
}

static void label_clicked(GtkGestureClick *gesture, int count, double x, double y, AppRow *self)
{
    const guint button = gtk_gesture_single_get_current_button(GTK_GESTURE_SINGLE(gesture));
    (void)x;
    (void)y;
    if (button == GDK_BUTTON_SECONDARY)
        g_signal_emit(self, signals[MENU], 0, self->name);
    else if (button == GDK_BUTTON_PRIMARY && count == 2)
        g_signal_emit(self, signals[RESET], 0);
}

static void label_held(GtkGestureLongPress *gesture, double x, double y, AppRow *self)
{
    (void)gesture;
    (void)x;
    (void)y;
    g_signal_emit(self, signals[MENU], 0, self->name);
}

static gboolean menu_key(GtkWidget *widget, GVariant *arguments, gpointer data)
{
    (void)arguments;
    (void)data;
    g_signal_emit(widget, signals[MENU], 0, APP_ROW(widget)->name);
    return TRUE;
}

static void app_row_init(AppRow *self)
{
    GtkEventController *keys = gtk_shortcut_controller_new();
    gtk_orientable_set_orientation(GTK_ORIENTABLE(self), GTK_ORIENTATION_VERTICAL);
    gtk_widget_add_css_class(GTK_WIDGET(self), "row");
    gtk_shortcut_controller_add_shortcut(
        GTK_SHORTCUT_CONTROLLER(keys),
        gtk_shortcut_new(gtk_alternative_trigger_new(gtk_keyval_trigger_new(GDK_KEY_Menu, 0),
                                                     gtk_keyval_trigger_new(GDK_KEY_F10, GDK_SHIFT_MASK)),
                         gtk_callback_action_new(menu_key, NULL, NULL)));
    gtk_widget_add_controller(GTK_WIDGET(self), keys);
    keys = gtk_event_controller_key_new();
    gtk_event_controller_set_propagation_phase(keys, GTK_PHASE_CAPTURE);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(key_pressed), self);
    gtk_widget_add_controller(GTK_WIDGET(self), keys);
}

static void add_label(AppRow *self, GtkWidget *line, const char *part, const char *meaning)
{
    GtkGesture *click = gtk_gesture_click_new();
    self->name = gtk_label_new(part ? part : self->label);
    gtk_label_set_xalign(GTK_LABEL(self->name), 0);
    gtk_label_set_wrap(GTK_LABEL(self->name), TRUE);
    if (!part) {
        gtk_label_set_width_chars(GTK_LABEL(self->name), 6);
        gtk_label_set_wrap_mode(GTK_LABEL(self->name), PANGO_WRAP_WORD_CHAR);
        gtk_widget_set_hexpand(self->name, TRUE);
    }
    gtk_widget_set_tooltip_text(GTK_WIDGET(self), meaning);
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), 0);
    g_signal_connect(click, "pressed", G_CALLBACK(label_clicked), self);
    gtk_widget_add_controller(self->name, GTK_EVENT_CONTROLLER(click));
    app_touch_on_rest(self->name, G_CALLBACK(label_held), self);
    gtk_box_append(GTK_BOX(line), self->name);
}

/* The unit before the control, which ends where those of the other rows do, and below it the note. */
static void add_what_surrounds(AppRow *self, GtkWidget *line)
{
    gtk_widget_add_css_class(self->unit, "dim-label");
    gtk_box_insert_child_after(GTK_BOX(line), self->unit, self->name);
    /* half of it is room for larger letters */
    const int width = (int)(FIELD_WIDTH * (1 + app_letters_scale(self->control)) / 2);
    gtk_widget_set_size_request(self->control, self->kind == APP_ROW_SWITCH ? -1 : width, -1);
    gtk_box_append(GTK_BOX(self), self->note);
}

GtkWidget *app_row_new(const AppRowSpec *spec)
{
    AppRow *self = g_object_new(APP_TYPE_ROW, NULL);
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 4);
    const gboolean is_long = spec->kind == APP_ROW_YAML || spec->kind == APP_ROW_DATE;
    self->kind = spec->kind;
    self->legal = spec->legal;
    self->advised = spec->advised;
    self->label = g_strdup(spec->label);
    self->advised_words = g_strdup(spec->advised_words);
    self->is_part = spec->part != NULL;
    self->note = g_object_ref_sink(gtk_label_new(NULL));
    self->unit = gtk_label_new(NULL);
    app_row_set_unit(self, spec->unit ? spec->unit : "");
    add_label(self, line, spec->part, spec->meaning);
    if (spec->kind == APP_ROW_NUMBER || spec->kind == APP_ROW_WHOLE) {
        app_row_add_number(self, line, spec->missing);
        watch_field(self);
    } else if (spec->kind == APP_ROW_SWITCH) {
        self->control = gtk_check_button_new();
        g_signal_connect(self->control, "toggled", G_CALLBACK(switched), self);
    } else if (spec->kind == APP_ROW_CHOICE || spec->kind == APP_ROW_RANGE || spec->kind == APP_ROW_CHOICE_OR_WHOLE)
        add_choice(self, spec->choices);
    else
        add_text(self, spec->hint);
    if (spec->kind == APP_ROW_DATE)
        app_row_make_date(self);
    if (spec->is_file)
        add_browsing(self, line);
    if (!gtk_widget_get_parent(self->control) && !is_long)
        gtk_box_append(GTK_BOX(line), self->control);
    gtk_label_set_xalign(GTK_LABEL(self->note), 0);
    gtk_label_set_wrap(GTK_LABEL(self->note), TRUE);
    gtk_widget_set_visible(self->note, FALSE);
    gtk_widget_add_css_class(self->note, "note");
    gtk_box_append(GTK_BOX(self), line);
    if (is_long)
        gtk_box_append(GTK_BOX(self), self->control);
    if (!spec->part)
        add_what_surrounds(self, line);
    name_row(self);
    if (!APP_IS_CHOICE(self->control))
        gtk_accessible_update_property(GTK_ACCESSIBLE(self->control), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                       spec->meaning ? spec->meaning : "", -1);
    return GTK_WIDGET(self);
}
