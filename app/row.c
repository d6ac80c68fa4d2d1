/* SPDX-License-Identifier: MIT */
/* Rows and their four kinds of controls. */
#include "row.h"

#include <math.h>
#include <string.h>

#include "../front/words.h"
#include "number.h"

enum { LOGARITHMIC_FROM = 100 /* highest over lowest advised value from which a slider is logarithmic */ };
static const double FARTHEST = 1e300;

struct _AppRow {
    GtkBox parent;
    AppRowKind kind;
    luxel_interval legal, advised;
    char *label, *advised_words;
    gboolean logarithmic; /* the slider */
    gboolean is_updating; /* values are shown, not edited */
    gboolean is_wrong;    /* what is typed cannot be taken */
    gboolean is_empty;    /* there is no number */
    double value;
    GtkWidget *name, *control, *slider, *unit, *note;
};

enum { EDITED, RESET, MENU, SIGNALS };
static guint signals[SIGNALS];

G_DEFINE_FINAL_TYPE(AppRow, app_row, GTK_TYPE_BOX)

void app_name_control(GtkWidget *control, const char *name)
{
    GtkWidget *inner = gtk_widget_get_first_child(control);
    gtk_accessible_update_property(GTK_ACCESSIBLE(control), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    if (inner && GTK_IS_DROP_DOWN(control))
        gtk_accessible_update_property(GTK_ACCESSIBLE(inner), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
}

/* ---- YAML ---- */

char *app_yaml_quote(const char *text)
{
    GString *quoted = g_string_new("\"");
    for (; *text; text++) {
        if (*text == '"' || *text == '\\')
            g_string_append_c(quoted, '\\');
        if ((guchar)*text < 0x20)
            g_string_append_printf(quoted, "\\u%04x", (guint)*text);
        else
            g_string_append_c(quoted, *text);
    }
    g_string_append_c(quoted, '"');
    return g_string_free(quoted, FALSE);
}

char *app_yaml_unquote(const char *yaml)
{
    const gsize length = strlen(yaml);
    if (length < 2 || (yaml[0] != '"' && yaml[0] != '\'') || yaml[length - 1] != yaml[0])
        return g_strdup(yaml);
    GString *text = g_string_new(NULL);
    for (const char *c = yaml + 1; c < yaml + length - 1; c++) {
        if (yaml[0] == '"' && c[0] == '\\' && c[1] == 'u') {
            char digits[5] = {c[2], c[3], c[4], c[5], 0};
            g_string_append_unichar(text, (gunichar)g_ascii_strtoull(digits, NULL, 16));
            c += 5;
        } else {
            if ((yaml[0] == '"' && c[0] == '\\') || (yaml[0] == '\'' && c[0] == '\'' && c[1] == '\''))
                c++;
            g_string_append_c(text, *c);
        }
    }
    return g_string_free(text, FALSE);
}

/* ---- what a row says of its value ---- */

static void note(AppRow *self, const char *text, gboolean wrong)
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

static gboolean is_outside(const luxel_interval *range, double value)
{
    return range->given && (value < range->low || value > range->high || (range->low_open && value <= range->low));
}

static void say_state(AppRow *self)
{
    if (self->is_wrong)
        return;
    if (self->is_empty || !is_outside(&self->advised, self->value) || !self->advised_words) {
        note(self, NULL, FALSE);
        return;
    }
    /* TRANSLATORS: {0} is a range such as "100 to 10000 mm" */
    char **parts = g_strsplit(_("advised: {0}"), "{0}", 2);
    char *text = g_strjoinv(self->advised_words, parts);
    note(self, text, FALSE);
    g_free(text);
    g_strfreev(parts);
}

void app_row_set_fault(AppRow *self, const char *reason)
{
    if (reason)
        note(self, reason, TRUE);
    else
        say_state(self);
}

void app_row_set_unit(AppRow *self, const char *unit)
{
    gtk_label_set_text(GTK_LABEL(self->unit), unit);
}

static void emit_number(AppRow *self)
{
    char text[APP_NUMBER_SIZE];
    g_signal_emit(self, signals[EDITED], 0, app_number_write(self->value, text));
}

/* ---- numbers ---- */

static double to_slider(const AppRow *self, double value)
{
    return self->logarithmic ? log10(MAX(value, 1e-300)) : value;
}

/* What a slider gives is rounded to what its pixels can tell apart. */
static double from_slider(const AppRow *self, double place)
{
    char text[APP_NUMBER_SIZE];
    if (self->logarithmic)
        return g_ascii_strtod(app_number_round(pow(10, place), 3, text), NULL);
    double grain = pow(10, floor(log10((self->advised.high - self->advised.low) / 500)));
    if (self->kind == APP_ROW_WHOLE || grain > 1)
        grain = 1;
    return grain < 1 ? round(place * round(1 / grain)) / round(1 / grain) : round(place);
}

/* Field and slider show the value. */
static void show_number(AppRow *self)
{
    self->is_updating = TRUE;
    gtk_spin_button_set_value(GTK_SPIN_BUTTON(self->control), self->value);
    if (self->is_empty)
        gtk_editable_set_text(GTK_EDITABLE(self->control), "");
    if (self->slider) {
        char text[APP_NUMBER_SIZE];
        gtk_range_set_value(GTK_RANGE(self->slider), to_slider(self, self->value));
        gtk_accessible_update_property(GTK_ACCESSIBLE(self->slider), GTK_ACCESSIBLE_PROPERTY_VALUE_TEXT,
                                       app_number_write(self->value, text), -1);
    }
    self->is_updating = FALSE;
    say_state(self);
}

/* The user's number. */
static void take(AppRow *self, double value)
{
    self->is_wrong = self->is_empty = FALSE;
    self->value = value;
    show_number(self);
    emit_number(self);
}

static void refuse(AppRow *self, const char *typed)
{
    char *text;
    double value;
    if (!app_number_read(typed, &value))
        /* TRANSLATORS: %s is what was typed into a field */
        text = g_strdup_printf(_("“%s” is no number"), typed);
    else if (self->kind == APP_ROW_WHOLE && value != floor(value))
        text = g_strdup_printf(_("%s is no whole number"), typed);
    else {
        char low[APP_NUMBER_SIZE], high[APP_NUMBER_SIZE];
        app_number_write(self->legal.low, low);
        app_number_write(self->legal.high, high);
        text = isinf(self->legal.high)
                   ? g_strdup_printf(self->legal.low_open ? _("must be above %s") : _("must be at least %s"), low)
                   /* TRANSLATORS: the bounds of what is allowed */
                   : g_strdup_printf(_("must be from %s to %s"), low, high);
    }
    self->is_wrong = TRUE;
    note(self, text, TRUE);
    g_free(text);
}

static gboolean is_legal(const AppRow *self, double value)
{
    return !is_outside(&self->legal, value) && (self->kind != APP_ROW_WHOLE || value == floor(value));
}

static int read_field(GtkSpinButton *spin, double *value, AppRow *self)
{
    const char *typed = gtk_editable_get_text(GTK_EDITABLE(spin));
    if (self->is_empty && *typed == '\0') {
        *value = self->value;
        return TRUE;
    }
    if (!app_number_read(typed, value) || !is_legal(self, *value)) {
        refuse(self, typed);
        return GTK_INPUT_ERROR;
    }
    self->is_wrong = FALSE;
    say_state(self);
    return TRUE;
}

static gboolean write_field(GtkSpinButton *spin, AppRow *self)
{
    char text[APP_NUMBER_SIZE];
    if (self->is_wrong && !self->is_updating)
        return TRUE; /* it stays as it was typed */
    app_number_write(gtk_spin_button_get_value(spin), text);
    if (self->is_empty)
        *text = '\0';
    if (strcmp(text, gtk_editable_get_text(GTK_EDITABLE(spin))) != 0)
        gtk_editable_set_text(GTK_EDITABLE(spin), text);
    self->is_wrong = FALSE;
    return TRUE;
}

static void field_changed(GtkSpinButton *spin, AppRow *self)
{
    if (self->is_updating || self->is_wrong)
        return;
    double value = gtk_spin_button_get_value(spin);
    if (!is_legal(self, value) || (value == self->value && !self->is_empty))
        return;
    take(self, value);
}

static gboolean slider_moved(GtkRange *range, GtkScrollType type, double place, AppRow *self)
{
    const GtkAdjustment *adjustment = gtk_range_get_adjustment(range);
    (void)type;
    place = CLAMP(place, gtk_adjustment_get_lower((GtkAdjustment *)adjustment),
                  gtk_adjustment_get_upper((GtkAdjustment *)adjustment));
    double value = from_slider(self, place);
    if (is_legal(self, value) && (value != self->value || self->is_empty))
        take(self, value);
    return TRUE;
}

static double step_of(const AppRow *self)
{
    if (!self->advised.given || self->kind == APP_ROW_WHOLE || self->logarithmic)
        return 1;
    return pow(10, floor(log10((self->advised.high - self->advised.low) / 50)));
}

static void add_number(AppRow *self, GtkWidget *line)
{
    const double low = self->legal.given && isfinite(self->legal.low) ? self->legal.low : -FARTHEST;
    const double high = self->legal.given && isfinite(self->legal.high) ? self->legal.high : FARTHEST;
    const double step = step_of(self);
    GtkAdjustment *adjustment = gtk_adjustment_new(0, low, high, step, 10 * step, 0);
    self->control = gtk_spin_button_new(adjustment, 0.2, 17);
    gtk_spin_button_set_update_policy(GTK_SPIN_BUTTON(self->control), GTK_UPDATE_IF_VALID);
    gtk_editable_set_width_chars(GTK_EDITABLE(self->control), 8);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(self->control), 8);
    g_signal_connect(self->control, "input", G_CALLBACK(read_field), self);
    g_signal_connect(self->control, "output", G_CALLBACK(write_field), self);
    g_signal_connect(self->control, "value-changed", G_CALLBACK(field_changed), self);
    gtk_box_append(GTK_BOX(line), self->control);
    if (!self->advised.given || !isfinite(self->advised.low) || !isfinite(self->advised.high))
        return;
    self->logarithmic = self->advised.low > 0 && self->advised.high >= LOGARITHMIC_FROM * self->advised.low;
    const double from = to_slider(self, self->advised.low), to = to_slider(self, self->advised.high);
    self->slider = gtk_scale_new_with_range(GTK_ORIENTATION_HORIZONTAL, from, to, (to - from) / 100);
    gtk_scale_set_draw_value(GTK_SCALE(self->slider), FALSE);
    gtk_range_set_round_digits(GTK_RANGE(self->slider), -1);
    g_signal_connect(self->slider, "change-value", G_CALLBACK(slider_moved), self);
    /* TRANSLATORS: %s is the name of a value, such as Radius */
    char *name = g_strdup_printf(_("%s, slider"), self->label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->slider), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    g_free(name);
}

/* ---- the other kinds ---- */

static void switched(GtkCheckButton *button, AppRow *self)
{
    if (!self->is_updating)
        g_signal_emit(self, signals[EDITED], 0, gtk_check_button_get_active(button) ? "true" : "false");
}

static gboolean tell_choice(gpointer data)
{
    AppRow *self = data;
    GtkStringObject *item = gtk_drop_down_get_selected_item(GTK_DROP_DOWN(self->control));
    if (item && gtk_widget_get_parent(GTK_WIDGET(self)))
        g_signal_emit(self, signals[EDITED], 0, gtk_string_object_get_string(item));
    return G_SOURCE_REMOVE;
}

/* A choice may make the form another one, and this row go: not while its list is still at work. */
static void chosen(GtkDropDown *list, GParamSpec *spec, AppRow *self)
{
    (void)list;
    (void)spec;
    if (!self->is_updating)
        g_idle_add_full(G_PRIORITY_DEFAULT, tell_choice, g_object_ref(self), g_object_unref);
}

/* Where it was not changed, nothing is done. */
static void entered(AppRow *self)
{
    const char *typed = gtk_editable_get_text(GTK_EDITABLE(self->control));
    const char *shown = g_object_get_data(G_OBJECT(self->control), "shown");
    if (self->is_updating || g_strcmp0(typed, shown ? shown : "") == 0)
        return;
    char *yaml = self->kind == APP_ROW_TEXT ? app_yaml_quote(typed) : g_strdup(typed);
    g_signal_emit(self, signals[EDITED], 0, yaml);
    g_free(yaml);
}

static void add_choice(AppRow *self, const char *choices)
{
    char **words = g_strsplit(choices ? choices : "", ", ", -1);
    self->control = gtk_drop_down_new_from_strings((const char *const *)words);
    g_signal_connect(self->control, "notify::selected", G_CALLBACK(chosen), self);
    g_strfreev(words);
}

static void add_text(AppRow *self, const char *hint)
{
    GtkEventController *focus = gtk_event_controller_focus_new();
    self->control = gtk_entry_new();
    gtk_editable_set_width_chars(GTK_EDITABLE(self->control), 12);
    gtk_entry_set_placeholder_text(GTK_ENTRY(self->control), hint);
    g_signal_connect_swapped(self->control, "activate", G_CALLBACK(entered), self);
    g_signal_connect_swapped(focus, "leave", G_CALLBACK(entered), self);
    gtk_widget_add_controller(self->control, focus);
}

static void show_choice(AppRow *self, const char *yaml)
{
    GListModel *words = gtk_drop_down_get_model(GTK_DROP_DOWN(self->control));
    guint found = GTK_INVALID_LIST_POSITION;
    for (guint i = 0; i < g_list_model_get_n_items(words); i++) {
        GtkStringObject *word = g_list_model_get_item(words, i);
        if (g_strcmp0(gtk_string_object_get_string(word), yaml) == 0)
            found = i;
        g_object_unref(word);
    }
    gtk_drop_down_set_selected(GTK_DROP_DOWN(self->control), found);
}

static gboolean is_typed_in(AppRow *self)
{
    return (gtk_widget_get_state_flags(self->control) & GTK_STATE_FLAG_FOCUS_WITHIN) != 0;
}

static void show_text(AppRow *self, const char *yaml)
{
    char *text = !yaml ? g_strdup("") : self->kind == APP_ROW_TEXT ? app_yaml_unquote(yaml) : g_strdup(yaml);
    const char *shown = g_object_get_data(G_OBJECT(self->control), "shown");
    if (g_strcmp0(text, shown) != 0 || !is_typed_in(self))
        gtk_editable_set_text(GTK_EDITABLE(self->control), text);
    g_object_set_data_full(G_OBJECT(self->control), "shown", text, g_free);
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
            show_number(self);
        } else if (value != self->value || self->is_empty || !self->is_wrong) {
            /* else a wrong number stays until another value comes */
            self->is_empty = FALSE;
            self->value = value;
            show_number(self);
        }
        break;
    case APP_ROW_SWITCH:
        gtk_check_button_set_active(GTK_CHECK_BUTTON(self->control), g_strcmp0(yaml, "true") == 0);
        break;
    case APP_ROW_CHOICE: show_choice(self, yaml); break;
    case APP_ROW_TEXT:
    case APP_ROW_YAML: show_text(self, yaml); break;
    }
    self->is_updating = FALSE;
}

/* ---- the class ---- */

static void app_row_finalize(GObject *object)
{
    AppRow *self = APP_ROW(object);
    g_free(self->label);
    g_free(self->advised_words);
    G_OBJECT_CLASS(app_row_parent_class)->finalize(object);
}

static void app_row_class_init(AppRowClass *class)
{
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
}

static void add_label(AppRow *self, GtkWidget *line, const char *meaning)
{
    GtkGesture *click = gtk_gesture_click_new();
    self->name = gtk_label_new(self->label);
    gtk_label_set_xalign(GTK_LABEL(self->name), 0);
    gtk_label_set_wrap(GTK_LABEL(self->name), TRUE);
    gtk_label_set_width_chars(GTK_LABEL(self->name), 10);
    gtk_widget_set_hexpand(self->name, TRUE);
    gtk_widget_set_tooltip_text(GTK_WIDGET(self), meaning);
    gtk_gesture_single_set_button(GTK_GESTURE_SINGLE(click), 0);
    g_signal_connect(click, "pressed", G_CALLBACK(label_clicked), self);
    gtk_widget_add_controller(self->name, GTK_EVENT_CONTROLLER(click));
    gtk_box_append(GTK_BOX(line), self->name);
}

GtkWidget *app_row_new(const AppRowSpec *spec)
{
    AppRow *self = g_object_new(APP_TYPE_ROW, NULL);
    GtkWidget *line = gtk_box_new(GTK_ORIENTATION_HORIZONTAL, 6);
    self->kind = spec->kind;
    self->legal = spec->legal;
    self->advised = spec->advised;
    self->label = g_strdup(spec->label);
    self->advised_words = g_strdup(spec->advised_words);
    self->note = gtk_label_new(NULL);
    self->unit = gtk_label_new(spec->unit);
    add_label(self, line, spec->meaning);
    if (spec->kind == APP_ROW_NUMBER || spec->kind == APP_ROW_WHOLE)
        add_number(self, line);
    else if (spec->kind == APP_ROW_SWITCH) {
        self->control = gtk_check_button_new();
        g_signal_connect(self->control, "toggled", G_CALLBACK(switched), self);
    } else if (spec->kind == APP_ROW_CHOICE)
        add_choice(self, spec->choices);
    else
        add_text(self, spec->hint);
    if (!gtk_widget_get_parent(self->control))
        gtk_box_append(GTK_BOX(line), self->control);
    gtk_label_set_xalign(GTK_LABEL(self->unit), 0);
    gtk_label_set_width_chars(GTK_LABEL(self->unit), spec->unit && *spec->unit ? 4 : 0);
    gtk_widget_add_css_class(self->unit, "dim-label");
    gtk_box_append(GTK_BOX(line), self->unit);
    gtk_label_set_xalign(GTK_LABEL(self->note), 0);
    gtk_label_set_wrap(GTK_LABEL(self->note), TRUE);
    gtk_widget_set_visible(self->note, FALSE);
    gtk_widget_add_css_class(self->note, "note");
    gtk_box_append(GTK_BOX(self), line);
    if (self->slider)
        gtk_box_append(GTK_BOX(self), self->slider);
    gtk_box_append(GTK_BOX(self), self->note);
    app_name_control(self->control, self->label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->control), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION,
                                   spec->meaning ? spec->meaning : "", -1);
    return GTK_WIDGET(self);
}
