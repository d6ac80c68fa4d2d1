/* SPDX-License-Identifier: MIT */
/* The control of a number: a field that takes what people type, and a slider over the advised range. */
#include <math.h>
#include <string.h>

#include "../front/words.h"
#include "number.h"
#include "row_private.h"

enum { LOGARITHMIC_FROM = 100 /* highest over lowest advised value from which a slider is logarithmic */ };
static const double FARTHEST = 1e300;

gboolean app_row_is_outside(const luxel_parameter_range *range, double value)
{
    return range->given && (value < range->low || value > range->high || (range->low_open && value <= range->low));
}

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
void app_row_show_number(AppRow *self)
{
    self->is_updating = TRUE;
    gtk_spin_button_set_value(GTK_SPIN_BUTTON(self->control), self->value);
    if (self->is_empty)
        gtk_editable_set_text(GTK_EDITABLE(self->control), "");
    if (self->slider) {
        char text[APP_NUMBER_SIZE];
        gtk_range_set_value(GTK_RANGE(self->slider), to_slider(self, self->value));
        gtk_accessible_update_property(GTK_ACCESSIBLE(self->slider), GTK_ACCESSIBLE_PROPERTY_VALUE_TEXT,
                                       app_number_show_all(self->value, text), -1);
    }
    self->is_updating = FALSE;
    app_row_say_state(self);
}

/* The user's number. */
static void take(AppRow *self, double value)
{
    char text[APP_NUMBER_SIZE];
    self->is_wrong = self->is_empty = FALSE;
    self->value = value;
    app_row_show_number(self);
    g_signal_emit_by_name(self, "edited", app_number_write(value, text));
}

static void refuse(AppRow *self, const char *typed)
{
    char *text;
    double value;
    if (!app_number_read(typed, &value))
        /* TRANSLATORS: %s is what was typed into a field */
        text = g_strdup_printf(_("“%s” is not a number"), typed);
    else if (self->kind == APP_ROW_WHOLE && value != floor(value))
        text = g_strdup_printf(_("%s is not a whole number"), typed);
    else {
        char low[APP_NUMBER_SIZE], high[APP_NUMBER_SIZE];
        app_number_show_all(self->legal.low, low);
        app_number_show_all(self->legal.high, high);
        text = isinf(self->legal.high)
                   ? g_strdup_printf(self->legal.low_open ? _("must be above %s") : _("must be at least %s"), low)
                   /* TRANSLATORS: the bounds of what is allowed */
                   : g_strdup_printf(self->legal.low_open ? _("must be above %s and at most %s")
                                                          : _("must be from %s to %s"),
                                     low, high);
    }
    self->is_wrong = TRUE;
    app_row_note(self, text, TRUE);
    g_free(text);
}

static gboolean is_legal(const AppRow *self, double value)
{
    return !app_row_is_outside(&self->legal, value) && (self->kind != APP_ROW_WHOLE || value == floor(value));
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
    app_row_say_state(self);
    return TRUE;
}

static gboolean write_field(GtkSpinButton *spin, AppRow *self)
{
    char text[APP_NUMBER_SIZE];
    if (self->is_wrong && !self->is_updating)
        return TRUE; /* it stays as it was typed */
    app_number_show_all(gtk_spin_button_get_value(spin), text);
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

/* Keys and sliders do what they would, and the numbers have their room. */
static void hide_buttons(GtkWidget *spin)
{
    for (GtkWidget *child = gtk_widget_get_first_child(spin); child; child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_BUTTON(child))
            gtk_widget_set_visible(child, FALSE);
}

static void toggled(GtkToggleButton *toggle)
{
    const gboolean active = gtk_toggle_button_get_active(toggle);
    gtk_button_set_icon_name(GTK_BUTTON(toggle), active ? "pan-down-symbolic" : "pan-start-symbolic");
}

GtkWidget *app_slider_toggle_new(const char *label)
{
    GtkWidget *toggle = gtk_toggle_button_new();
    /* TRANSLATORS: what shows the slider of a value; %s is its name, such as Radius */
    char *name = g_strdup_printf(_("%s: show the slider"), label);
    gtk_button_set_icon_name(GTK_BUTTON(toggle), "pan-start-symbolic");
    gtk_button_set_has_frame(GTK_BUTTON(toggle), FALSE);
    gtk_widget_add_css_class(toggle, "fold");
    gtk_widget_set_valign(toggle, GTK_ALIGN_CENTER);
    app_name_control(toggle, name);
    gtk_widget_set_tooltip_text(toggle, _("Show the slider"));
    g_signal_connect(toggle, "toggled", G_CALLBACK(toggled), NULL);
    g_free(name);
    return toggle;
}

void app_row_add_number(AppRow *self, GtkWidget *line)
{
    const double low = self->legal.given && isfinite(self->legal.low) ? self->legal.low : -FARTHEST;
    const double high = self->legal.given && isfinite(self->legal.high) ? self->legal.high : FARTHEST;
    const double step = step_of(self);
    GtkAdjustment *adjustment = gtk_adjustment_new(0, low, high, step, 10 * step, 0);
    self->control = gtk_spin_button_new(adjustment, 0.2, 17);
    gtk_spin_button_set_update_policy(GTK_SPIN_BUTTON(self->control), GTK_UPDATE_IF_VALID);
    gtk_editable_set_width_chars(GTK_EDITABLE(self->control), self->is_part ? 3 : 6);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(self->control), 8);
    gtk_widget_set_hexpand(self->control, self->is_part);
    hide_buttons(self->control);
    g_signal_connect(self->control, "input", G_CALLBACK(read_field), self);
    g_signal_connect(self->control, "output", G_CALLBACK(write_field), self);
    g_signal_connect(self->control, "value-changed", G_CALLBACK(field_changed), self);
    gtk_box_append(GTK_BOX(line), self->control);
    if (!self->advised.given || !isfinite(self->advised.low) || !isfinite(self->advised.high))
        return;
    self->logarithmic = self->advised.low > 0 && self->advised.high >= LOGARITHMIC_FROM * self->advised.low;
    const double from = to_slider(self, self->advised.low), to = to_slider(self, self->advised.high);
    self->slider = g_object_ref_sink(gtk_scale_new_with_range(GTK_ORIENTATION_HORIZONTAL, from, to, (to - from) / 100));
    gtk_scale_set_draw_value(GTK_SCALE(self->slider), FALSE);
    gtk_range_set_round_digits(GTK_RANGE(self->slider), -1);
    g_signal_connect(self->slider, "change-value", G_CALLBACK(slider_moved), self);
    /* TRANSLATORS: %s is the name of a value, such as Radius */
    char *name = g_strdup_printf(_("%s, slider"), self->label);
    gtk_accessible_update_property(GTK_ACCESSIBLE(self->slider), GTK_ACCESSIBLE_PROPERTY_LABEL, name, -1);
    g_free(name);
}
