/* SPDX-License-Identifier: MIT */
/* What a window shows of pictures, numbers, readings and faults when they come. */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/lamp.h"
#include "../base/number.h"
#include "../base/pulse.h"
#include "../picture/color.h"
#include "../space/space_view.h"
#include "export.h"
#include "window_private.h"

enum { DIGITS = 6, SAID_SECONDS = 8, MOST_SHARES = 16 };

/* ---- saying ---- */

/* What was said has been read. */
static gboolean forget_said(gpointer data)
{
    AppWindow *self = data;
    self->say_timer = 0;
    gtk_label_set_text(GTK_LABEL(self->message_label), "");
    return G_SOURCE_REMOVE;
}

void app_window_say(AppWindow *self, const char *text)
{
    g_clear_handle_id(&self->say_timer, g_source_remove);
    gtk_label_set_text(GTK_LABEL(self->message_label), text);
}

void app_window_mention(AppWindow *self, const char *text)
{
    app_window_say(self, text);
    self->say_timer = g_timeout_add_seconds(SAID_SECONDS, forget_said, self);
}

/* Messages have the line at the edge, so that none lies over anything: the first that is due, the others wait. */
static void choose_message(AppWindow *self)
{
    GtkWidget *const bars[] = {self->stale_bar, self->fault_bar, self->outside_bar, self->unsaved_bar};
    gboolean is_free = TRUE;
    for (gsize i = 0; i < G_N_ELEMENTS(bars); i++) {
        const gboolean is_due = gtk_info_bar_get_revealed(GTK_INFO_BAR(bars[i]));
        gtk_widget_set_visible(bars[i], is_due && is_free);
        is_free = is_free && !is_due;
    }
}

void app_window_reveal_bar(AppWindow *self, GtkWidget *bar, gboolean revealed)
{
    GtkWidget *focus = gtk_window_get_focus(GTK_WINDOW(self));
    if (!revealed && focus && gtk_widget_is_ancestor(focus, bar))
        gtk_widget_grab_focus(app_window_camera(self));
    gtk_info_bar_set_revealed(GTK_INFO_BAR(bar), revealed);
    choose_message(self);
}

void app_window_set_message(GtkWidget *label, const char *text)
{
    gtk_label_set_text(GTK_LABEL(label), text);
    gtk_widget_set_tooltip_text(label, *text ? text : NULL);
}

void app_window_show_fault(AppWindow *self, const char *text)
{
    app_window_set_message(self->fault_label, text ? text : ""); /* what is no longer shown is not read out either */
    app_window_reveal_bar(self, self->fault_bar, text != NULL);
}

static gboolean is_photometric(AppWindow *self)
{
    char *units = app_document_get(self->document, "units", NULL);
    const gboolean photometric = g_strcmp0(units, "photometric") == 0;
    g_free(units);
    return photometric;
}

/* ---- pictures ---- */

static void show_comparison(AppWindow *self, const AppPicture *picture)
{
    char *text = NULL;
    gtk_widget_set_visible(self->compare_box, self->pinned != NULL);
    gtk_widget_set_visible(self->compare_label, self->pinned != NULL);
    if (!self->pinned)
        return;
    if (picture->has_comparison) {
        const luxel_comparison *comparison = &picture->comparison;
        char difference[APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], share[APP_NUMBER_SIZE];
        const double size = picture->area.high[0] - picture->area.low[0];
        text = g_strdup_printf(_("largest difference %s (%s %% of the maximum) at x = %s, y = %s mm"),
                               app_number_show(comparison->largest.value, DIGITS, difference),
                               app_number_show(100 * comparison->largest_relative, 3, share),
                               app_number_place(comparison->largest.x_mm, size, x),
                               app_number_place(comparison->largest.y_mm, size, y));
    } else if (picture->shot->is_fine)
        text = g_strdup(_("A and B differ in their screens and cannot be compared"));
    if (text)
        gtk_label_set_text(GTK_LABEL(self->compare_label), text);
    g_free(text);
}

/* A coarse picture has other pixels: the figure waits for the fine one. */
static void show_zoom(AppWindow *self)
{
    char text[APP_NUMBER_SIZE + 4], percent[APP_NUMBER_SIZE];
    if (!self->picture->shot->is_fine)
        return;
    app_number_plain(100 * app_view_magnification(self->view), 3, percent);
    g_snprintf(text, sizeof text, "%s %%", app_number_mark(percent));
    if (strcmp(gtk_label_get_text(GTK_LABEL(self->zoom_label)), text) != 0)
        gtk_label_set_text(GTK_LABEL(self->zoom_label), text);
}

void app_window_rest(AppWindow *self)
{
    const luxel_statistics *statistics =
        self->picture && !self->is_stale ? luxel_field_statistics(app_shot_light(self->picture->shot)) : NULL;
    if (!statistics || !statistics->has_reflected || statistics->reflected_reached) {
        gtk_label_set_text(GTK_LABEL(self->status_label), "");
        return;
    }
    char share[APP_NUMBER_SIZE];
    char *text = g_strdup_printf(_("Reflected light is less exact than it should be: within %s %% of the maximum"),
                                 app_bound_show(100 * statistics->reflected_error, 2, share));
    gtk_label_set_text(GTK_LABEL(self->status_label), text);
    g_free(text);
}

/* What the picture lacks stands on it. */
static void show_direct(AppWindow *self, const AppPicture *picture)
{
    const gboolean is_direct = !picture->faults && picture->shot->moment->is_direct;
    gtk_label_set_text(GTK_LABEL(self->direct_label), self->is_direct
                                                          ? _("Direct light alone; what surfaces reflect was stopped")
                                                          : _("Direct light; what surfaces reflect is being computed"));
    gtk_widget_set_visible(self->direct_label, is_direct);
    gtk_button_set_label(GTK_BUTTON(self->stop_button), self->is_direct ? _("Go on") : _("Stop"));
}

void app_window_show_picture(AppPicture *picture, gpointer owner)
{
    AppWindow *self = owner;
    if (picture->serial < self->first) /* of a scene that is no longer there */
        return;
    app_window_set_stale(self, picture->faults);
    show_direct(self, picture);
    if (picture->faults) {
        app_window_judge(self);
        return;
    }
    app_picture_ref(picture);
    app_picture_unref(self->picture);
    self->picture = picture;
    app_window_offer_turn(self, picture);
    self->late &= ~1u;
    if (!self->pointer_inside)
        app_window_rest(self);
    app_view_set_picture(self->view, picture);
    app_stage_set_moment(APP_STAGE(self->stage), picture->shot->moment);
    app_space_view_set_picture(APP_SPACE_VIEW(self->space_view), picture);
    app_display_form_tell_color(APP_DISPLAY_FORM(self->display_form),
                                luxel_scene_has_color(picture->shot->moment->scene));
    app_display_form_tell_range(APP_DISPLAY_FORM(self->display_form), picture->low, picture->high);
    app_form_suggest(APP_FORM(self->picture_form), "picture.range", picture->low, picture->high);
    app_numbers_set_colors(APP_NUMBERS(self->numbers), picture->display.palette, picture->low, picture->high,
                           picture->display.logarithmic);
    app_dial_set_picture(APP_DIAL(self->bar), picture);
    show_zoom(self);
    show_comparison(self, picture);
    app_why_follow(APP_WHY(self->why), app_window_shot(self));
    app_window_judge(self);
    app_window_ask_numbers(self);
    app_window_ask_pointer(self);
    app_pulse_picture();
}

/* ---- numbers ---- */

void app_window_show_numbers(AppMeasures *measures, gpointer owner)
{
    AppWindow *self = owner;
    if (measures->live->moment->serial < self->first)
        return;
    app_numbers_show(APP_NUMBERS(self->numbers), measures);
    if (measures->has_sources)
        app_sources_show(APP_SOURCES(self->sources), measures, is_photometric(self));
    if (measures->has_isophotes)
        app_dial_set_isophotes(APP_DIAL(self->bar), measures->isophotes);
    if (measures->has_isophotes)
        app_view_set_isophotes(self->view, g_steal_pointer(&measures->isophotes), measures->version.shot);
    app_window_judge(self);
}

/* "2: 12.3, 1: 0.5" as markup: what the lights give, the greatest first; those that give nothing are not told. */
static void add_shares(GString *text, const AppReading *reading)
{
    char number[APP_NUMBER_SIZE];
    gsize *order = app_reading_order(reading), shown = 0;
    while (shown < reading->share_count && shown < MOST_SHARES && reading->shares[order[shown]] != 0) {
        char *lamp = app_lamp_markup(order[shown]);
        g_string_append_printf(text, "%s%s: %s", shown ? ", " : "", lamp,
                               app_number_show(reading->shares[order[shown]], 4, number));
        g_free(lamp);
        shown++;
    }
    if (shown < reading->share_count && reading->shares[order[shown]] != 0)
        g_string_append(text, ", …");
    if (shown == 0)
        g_string_append(text, "0");
    g_free(order);
}

/* At the difference both values, and how far apart they are. */
static void add_difference(GString *text, const AppReading *reading)
{
    const luxel_value *a = &reading->minus, *b = &reading->value;
    char n[3][APP_NUMBER_SIZE];
    if (!a->has_value || !b->has_value) {
        g_string_append_printf(text, "\t%s", _("no value in both pictures"));
        return;
    }
    g_string_append_printf(text, "\tA %s   B %s   B − A %s %s", app_number_show(a->value, DIGITS, n[0]),
                           app_number_show(b->value, DIGITS, n[1]), app_number_show(b->value - a->value, DIGITS, n[2]),
                           gettext(app_moment_unit(reading->moment, reading->quantity)));
}

/* The channels and what they mean, as `luxel probe` tells them. */
static void add_color(GString *text, const luxel_color *color)
{
    char *channels = app_color_channels(color), *place = app_color_place(color), *kelvin = app_color_temperature(color);
    g_string_append_printf(text, "\t%s\t%s\t%s", channels, place, kelvin);
    g_free(channels);
    g_free(place);
    g_free(kelvin);
}

static void add_value(GString *text, const AppReading *reading, gboolean is_short)
{
    const luxel_value *value = &reading->value;
    char n[7][APP_NUMBER_SIZE];
    for (int i = 0; i < 3; i++) {
        app_number_place(value->position_mm[i], 1000, n[i]);
        app_number_show(value->normal[i], 3, n[3 + i]);
    }
    const char *then = app_number_separator();
    g_string_append_printf(text, "\tP (%s%s%s%s%s)\t", n[0], then, n[1], then, n[2]);
    if (!is_short)
        g_string_append_printf(text, "N (%s%s%s%s%s)\t", n[3], then, n[4], then, n[5]);
    if (value->has_value)
        g_string_append_printf(text, "%s %s", app_number_show(value->value, DIGITS, n[6]),
                               gettext(app_moment_unit(reading->moment, reading->quantity)));
    else
        g_string_append(text, _("a source lies here"));
    if (reading->color.exists)
        add_color(text, &reading->color);
    else if (reading->has_grey)
        g_string_append_printf(text, "\t%s %u", _("grey"), reading->grey);
}

/* The value as the picture shows it, or at the difference how far apart both are; NaN: there is none. */
static double shown_value(const AppReading *reading)
{
    const luxel_value *value = &reading->value, *minus = &reading->minus;
    if (!value->on_surface || !value->has_value)
        return (double)NAN;
    if (!reading->has_minus)
        return app_color_number(&reading->color, value->value, reading->version.channel);
    return minus->on_surface && minus->has_value ? value->value - minus->value : (double)NAN;
}

/* Columns of the line at the edge, and which of them its kinds have: all of a grey scene, those where there is no room,
 * and those in colour. */
enum { PLACE, POINT, NORMAL, VALUE, GREY, CHANNELS, CHROMATICITY, TEMPERATURE, SHARES, COLUMNS };
enum Kind { KIND_ALL, KIND_SHORT, KIND_COLOR };
static const guint columns_of[APP_STATUS_KINDS] = {
    [KIND_ALL] = 1 << PLACE | 1 << POINT | 1 << NORMAL | 1 << VALUE | 1 << GREY | 1 << SHARES,
    [KIND_SHORT] = 1 << PLACE | 1 << POINT | 1 << VALUE | 1 << GREY | 1 << SHARES,
    [KIND_COLOR] =
        1 << PLACE | 1 << POINT | 1 << VALUE | 1 << CHANNELS | 1 << CHROMATICITY | 1 << TEMPERATURE | 1 << SHARES,
};

/* Readings stand in columns, as wide as the widest of each that is usual, so that no number moves another. */
void app_window_set_columns(AppWindow *self)
{
    char *place = g_strdup_printf("x −000.00  y −000.00 %s  ", _("mm"));
    char *value = g_strdup_printf("0.000000e-00 %s  ", gettext("W/(sr·m²)")); /* the widest of the units */
    char *grey = g_strdup_printf("%s 255   ", _("grey"));
    char *shares = g_strdup_printf("%s 1: 0.0000, 2: 0.0000", _("sources"));
    char *kelvin = g_strdup_printf(_("%s K, Duv %s"), "00000", "−0.0000  ");
    const char *const widest[COLUMNS] = {[PLACE] = place,
                                         [POINT] = "P (−000.000, −000.000, 0000.000)  ",
                                         [NORMAL] = "N (−0.000, −0.000, −0.000)  ",
                                         [VALUE] = value,
                                         [GREY] = grey,
                                         [CHANNELS] = "R, G, B 0.000000, 0.000000, 0.000000  ",
                                         [CHROMATICITY] = "x, y 0.00000, 0.00000  ",
                                         [TEMPERATURE] = kelvin,
                                         [SHARES] = shares};
    PangoLayout *layout = gtk_widget_create_pango_layout(self->status_label, NULL);
    int width;
    for (int kind = 0; kind < APP_STATUS_KINDS; kind++) {
        PangoTabArray *tabs = pango_tab_array_new(0, TRUE);
        int end = 0, tab = 0;
        for (int i = 0; i < COLUMNS; i++) {
            if (!(columns_of[kind] >> i & 1))
                continue;
            pango_layout_set_text(layout, widest[i], -1);
            pango_layout_get_pixel_size(layout, &width, NULL);
            end += width;
            if (i < SHARES)
                pango_tab_array_set_tab(tabs, tab++, PANGO_TAB_LEFT, end);
        }
        self->status_tabs[kind] = tabs;
        self->status_widths[kind] = end;
    }
    g_free(kelvin);
    g_object_unref(layout);
    g_free(shares);
    g_free(grey);
    g_free(value);
    g_free(place);
}

void app_window_show_reading(const AppReading *reading, gpointer owner)
{
    AppWindow *self = owner;
    char n[2][APP_NUMBER_SIZE];
    const AppVersion version = app_window_version(self);
    if (!self->pointer_inside || !app_version_equal(&reading->version, &version))
        return;
    self->reading = reading->version;
    self->reading_mm[0] = reading->x_mm;
    self->reading_mm[1] = reading->y_mm;
    GString *text = g_string_new(NULL);
    const luxel_value *value = &reading->value;
    const gboolean pinned = self->picture && self->picture->side == APP_SIDE_PINNED;
    /* The shares of several sources, and colours, are worth more than the normal, which Why? tells. */
    const int width = gtk_widget_get_width(self->status_label);
    const enum Kind kind = reading->color.exists                                               ? KIND_COLOR
                           : reading->share_count > 1 && width < self->status_widths[KIND_ALL] ? KIND_SHORT
                                                                                               : KIND_ALL;
    const gboolean has_room = kind != KIND_COLOR || width >= self->status_widths[kind]; /* the list has them, too */
    self->is_on_surface = value->on_surface;
    app_view_set_surface(self->view, value->on_surface ? (gssize)value->surface : -1);
    const double size = self->picture ? 100 * (self->picture->area.high[0] - self->picture->area.low[0]) : 1000;
    g_string_append_printf(text, "x %s  y %s %s%s", app_number_place(reading->x_mm, size, n[0]),
                           app_number_place(reading->y_mm, size, n[1]), _("mm"), pinned ? "   A:" : "");
    if (reading->has_minus && (value->on_surface || reading->minus.on_surface))
        add_difference(text, reading);
    else if (!value->on_surface)
        g_string_append_printf(text, "\t%s", _("off the surface"));
    else
        add_value(text, reading, kind != KIND_ALL);
    char *markup = g_markup_escape_text(text->str, -1);
    g_string_assign(text, markup);
    g_free(markup);
    if (has_room && !reading->has_minus && reading->share_count > 1 && value->on_surface && value->has_value) {
        g_string_append_printf(text, "\t%s ", _("sources"));
        add_shares(text, reading);
    }
    gtk_label_set_tabs(GTK_LABEL(self->status_label), self->status_tabs[kind]);
    gtk_label_set_markup(GTK_LABEL(self->status_label), text->str);
    app_dial_set_needle(APP_DIAL(self->bar), shown_value(reading));
    app_sources_show_shares(APP_SOURCES(self->sources), reading);
    app_window_show_vectors(self, reading);
    if (value->on_surface && value->has_value)
        app_why_point(APP_WHY(self->why), app_window_shot(self), reading->x_mm, reading->y_mm);
    app_window_judge(self);
    g_string_free(text, TRUE);
}
