/* SPDX-License-Identifier: MIT */
/* The control of a number: a field that takes what people type, and a label that is dragged. */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "number.h"
#include "row_private.h"

enum {
    LOGARITHMIC_FROM = 100, /* highest over lowest advised value from which a drag is logarithmic */
    WAY = 600               /* dots that a drag takes through the advised range */
};
static const double FARTHEST = 1e300;

gboolean app_row_is_outside(const luxel_parameter_range *range, double value)
{
    return range->given && (value < range->low || value > range->high || (range->low_open && value <= range->low));
}

/* ---- dragging ---- */

/* Where the value stands, and which one stands there: each dot of a drag is as far. */
static double to_scale(const AppRow *self, double value)
{
    return self->logarithmic ? log10(MAX(value, 1e-300)) : value;
}

static double extent(const AppRow *self)
{
    return self->advised.given && isfinite(self->advised.low) && isfinite(self->advised.high)
               ? to_scale(self, self->advised.high) - to_scale(self, self->advised.low)
               : 0;
}

/* The value of a drag, rounded to what its dots can tell apart; `fine` to a tenth of that, `coarse` to ten of them. */
static double from_scale(const AppRow *self, double place, gboolean fine, gboolean coarse)
{
    char text[APP_NUMBER_SIZE];
    if (self->logarithmic)
        return g_ascii_strtod(app_number_round(pow(10, place), fine ? 4 : coarse ? 2 : 3, text), NULL);
    const double power = floor(log10(extent(self) / 500)) + (fine ? -1 : coarse ? 1 : 0);
    const double grain = self->kind == APP_ROW_WHOLE ? 1 : pow(10, coarse ? power : MIN(power, 0));
    return grain < 1 ? round(place * round(1 / grain)) / round(1 / grain) : round(place / grain) * grain;
}

/* ---- showing ---- */

void app_row_show_number(AppRow *self)
{
    self->is_updating = TRUE;
    gtk_spin_button_set_value(GTK_SPIN_BUTTON(self->control), self->value);
    if (self->is_empty)
        gtk_editable_set_text(GTK_EDITABLE(self->control), "");
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

/* ---- the hand on the label ---- */

static gboolean begins(AppRow *self)
{
    self->start = to_scale(self, self->value);
    return extent(self) > 0;
}

/* Within what is advised, or from where the value stands beyond it. */
static void moves(AppRow *self, double dots, gboolean fine, gboolean coarse)
{
    const double low = MIN(to_scale(self, self->advised.low), self->start),
                 high = MAX(to_scale(self, self->advised.high), self->start);
    const double place = CLAMP(self->start + dots * extent(self) / WAY * (fine ? 0.1 : 1), low, high);
    const double value = from_scale(self, place, fine, coarse);
    if (is_legal(self, value) && (value != self->value || self->is_empty))
        take(self, value);
}

/* ---- the field ---- */

static double step_of(const AppRow *self)
{
    if (!self->advised.given || self->kind == APP_ROW_WHOLE || self->logarithmic)
        return 1;
    return pow(10, floor(log10((self->advised.high - self->advised.low) / 50)));
}

/* Keys and the label do what they would, and the numbers have their room. */
static void hide_buttons(GtkWidget *spin)
{
    for (GtkWidget *child = gtk_widget_get_first_child(spin); child; child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_BUTTON(child))
            gtk_widget_set_visible(child, FALSE);
}

/* The field shows what holds where nothing is given, in grey. */
static void show_missing(GtkWidget *spin, const char *missing)
{
    for (GtkWidget *child = gtk_widget_get_first_child(spin); child; child = gtk_widget_get_next_sibling(child))
        if (GTK_IS_TEXT(child))
            gtk_text_set_placeholder_text(GTK_TEXT(child), missing);
}

void app_row_add_number(AppRow *self, GtkWidget *line, const char *missing)
{
    static const AppRowHand hand = {begins, moves};
    const double low = self->legal.given && isfinite(self->legal.low) ? self->legal.low : -FARTHEST;
    const double high = self->legal.given && isfinite(self->legal.high) ? self->legal.high : FARTHEST;
    self->logarithmic = self->advised.given && self->advised.low > 0 && isfinite(self->advised.high) &&
                        self->advised.high >= LOGARITHMIC_FROM * self->advised.low;
    const double step = step_of(self);
    GtkAdjustment *adjustment = gtk_adjustment_new(0, low, high, step, 10 * step, 0);
    self->control = gtk_spin_button_new(adjustment, 0.2, 17);
    gtk_spin_button_set_update_policy(GTK_SPIN_BUTTON(self->control), GTK_UPDATE_IF_VALID);
    gtk_editable_set_width_chars(GTK_EDITABLE(self->control), self->is_part ? 3 : 6);
    gtk_editable_set_max_width_chars(GTK_EDITABLE(self->control), 8);
    gtk_widget_set_hexpand(self->control, self->is_part);
    hide_buttons(self->control);
    show_missing(self->control, missing);
    g_signal_connect(self->control, "input", G_CALLBACK(read_field), self);
    g_signal_connect(self->control, "output", G_CALLBACK(write_field), self);
    g_signal_connect(self->control, "value-changed", G_CALLBACK(field_changed), self);
    gtk_box_append(GTK_BOX(line), self->control);
    if (extent(self) > 0)
        app_row_make_draggable(self, &hand);
}
