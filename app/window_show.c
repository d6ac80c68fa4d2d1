/* SPDX-License-Identifier: MIT */
/* What a window shows of pictures, numbers, readings and faults when they come. */
#include <luxel/drawing.h>
#include <math.h>
#include <string.h>

#include "../front/language.h"
#include "../front/words.h"
#include "export.h"
#include "number.h"
#include "pulse.h"
#include "window_private.h"

enum { DIGITS = 6 };

/* ---- saying ---- */

void app_window_say(AppWindow *self, const char *text)
{
    gtk_label_set_text(GTK_LABEL(self->message_label), text);
}

void app_window_show_fault(AppWindow *self, const char *text)
{
    /* what is no longer shown is not read out either */
    gtk_label_set_text(GTK_LABEL(self->fault_label), text ? text : "");
    gtk_info_bar_set_revealed(GTK_INFO_BAR(self->fault_bar), text != NULL);
}

static gboolean is_photometric(AppWindow *self)
{
    char *units = app_document_get(self->document, "units", NULL);
    const gboolean photometric = g_strcmp0(units, "photometric") == 0;
    g_free(units);
    return photometric;
}

/* Marks the rows that the faults name, in whichever form they stand. */
static void mark_faults(AppWindow *self, const luxel_diagnostics *faults)
{
    AppForm *forms[] = {APP_FORM(self->screen_form), APP_FORM(self->surface_form), APP_FORM(self->material_form),
                        APP_FORM(self->picture_form)};
    for (gsize i = 0; i < G_N_ELEMENTS(forms); i++)
        app_form_set_fault(forms[i], NULL, NULL);
    app_sources_set_fault(APP_SOURCES(self->sources), NULL, NULL);
    for (gsize i = 0; faults && i < luxel_diagnostics_count(faults); i++) {
        const char *key = luxel_diagnostics_get(faults, i)->key;
        char *reason = luxel_diagnostics_message(faults, i, language_translate, NULL);
        for (gsize k = 0; k < G_N_ELEMENTS(forms) && key; k++)
            app_form_set_fault(forms[k], key, reason);
        if (key)
            app_sources_set_fault(APP_SOURCES(self->sources), key, reason);
        luxel_text_free(reason);
    }
}

/* ---- pictures ---- */

static void show_comparison(AppWindow *self, const AppPicture *picture)
{
    char *text = NULL;
    gtk_widget_set_visible(self->compare_box, self->pinned != NULL);
    if (!self->pinned)
        return;
    if (picture->has_comparison) {
        const luxel_comparison *comparison = &picture->comparison;
        char difference[APP_NUMBER_SIZE], x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE], share[APP_NUMBER_SIZE];
        text = g_strdup_printf(_("largest difference %s (%s %% of the maximum) at x = %s, y = %s mm"),
                               app_number_round(comparison->largest.value, DIGITS, difference),
                               app_number_round(100 * comparison->largest_relative, 3, share),
                               app_number_round(comparison->largest.x_mm, DIGITS, x),
                               app_number_round(comparison->largest.y_mm, DIGITS, y));
    } else if (picture->shot->is_fine)
        text = g_strdup(_("A and B differ in their screens and cannot be compared"));
    if (text)
        gtk_label_set_text(GTK_LABEL(self->compare_label), text);
    g_free(text);
}

void app_window_show_picture(AppPicture *picture, gpointer owner)
{
    AppWindow *self = owner;
    if (picture->faults) {
        char *text = app_faults_text(picture->faults);
        self->scene_has_faults = TRUE;
        mark_faults(self, picture->faults);
        app_window_show_fault(self, text);
        g_free(text);
        return;
    }
    if (self->scene_has_faults) {
        mark_faults(self, NULL);
        app_window_show_fault(self, NULL);
    }
    self->scene_has_faults = FALSE;
    app_picture_ref(picture);
    app_picture_unref(self->picture);
    self->picture = picture;
    app_view_set_picture(self->view, picture);
    app_display_form_tell_range(APP_DISPLAY_FORM(self->display_form), picture->low, picture->high);
    app_numbers_set_colors(APP_NUMBERS(self->numbers), picture->display.palette, picture->low, picture->high,
                           picture->display.logarithmic);
    gtk_widget_queue_draw(self->bar);
    show_comparison(self, picture);
    app_window_ask_numbers(self);
    app_window_ask_pointer(self);
    app_pulse_picture();
}

void app_window_draw_bar(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    AppWindow *self = data;
    const AppPicture *picture = self->picture;
    const luxel_language language = {.translate = language_translate, .code = language_code()};
    luxel_drawing_style style;
    GdkRGBA ink;
    if (!picture || width < 60)
        return;
    gtk_style_context_get_color(gtk_widget_get_style_context(GTK_WIDGET(area)), &ink);
    luxel_drawing_style_init(&style, ink.red + ink.green + ink.blue > 1.5f);
    style.letters = 11;
    style.language = &language;
    const double gain = exp2(picture->display.exposure);
    char *label = g_strdup_printf("%s, %s", gettext(luxel_field_quantity_word(picture->shot->field)),
                                  gettext(luxel_field_unit(picture->shot->field)));
    const luxel_bar bar = {.palette = picture->display.palette,
                           .low = picture->low / gain,
                           .high = picture->high / gain,
                           .logarithmic = picture->display.logarithmic,
                           .label = label};
    cairo_translate(cairo, 16, 4);
    luxel_draw_bar(cairo, &style, &bar, width - 32, height - 4);
    g_free(label);
}

/* ---- numbers ---- */

void app_window_show_numbers(AppMeasures *measures, gpointer owner)
{
    AppWindow *self = owner;
    app_numbers_show(APP_NUMBERS(self->numbers), measures);
    if (measures->has_points)
        app_sources_show(APP_SOURCES(self->sources), measures, is_photometric(self));
    if (measures->has_isophotes)
        app_view_set_isophotes(self->view, g_steal_pointer(&measures->isophotes));
}

/* "1 12.3 · 2 0.5": what the lights give, the greatest first so far as there is room. */
static void add_shares(GString *text, const AppReading *reading)
{
    char number[APP_NUMBER_SIZE];
    for (gsize i = 0; i < reading->share_count && i < 6; i++)
        g_string_append_printf(text, "%s%zu: %s", i ? ", " : "", i + 1,
                               app_number_round(reading->shares[i], 4, number));
    if (reading->share_count > 6)
        g_string_append(text, ", …");
}

void app_window_show_reading(const AppReading *reading, gpointer owner)
{
    AppWindow *self = owner;
    const luxel_value *value = &reading->value;
    char n[8][APP_NUMBER_SIZE];
    GString *text = g_string_new(NULL);
    if (!self->pointer_inside) {
        g_string_free(text, TRUE);
        return;
    }
    app_view_set_surface(self->view, value->on_surface ? (gssize)value->surface : -1);
    g_string_append_printf(text, "x %s  y %s %s", app_number_round(reading->x_mm, 5, n[0]),
                           app_number_round(reading->y_mm, 5, n[1]), _("mm"));
    if (!value->on_surface)
        g_string_append_printf(text, "   %s", _("off the surface"));
    else {
        for (int i = 0; i < 3; i++) {
            app_number_round(value->position_mm[i], 6, n[i]);
            app_number_round(value->normal[i], 3, n[3 + i]);
        }
        g_string_append_printf(text, "   P (%s, %s, %s)   N (%s, %s, %s)   ", n[0], n[1], n[2], n[3], n[4], n[5]);
        if (value->has_value)
            g_string_append_printf(text, "%s %s", app_number_round(value->value, DIGITS, n[6]),
                                   gettext(luxel_scene_unit(reading->moment->scene, self->quantity)));
        else
            g_string_append(text, _("a source lies here"));
        if (reading->has_pixel)
            g_string_append_printf(text, "   %s %u", _("grey"), reading->grey);
        if (reading->share_count > 1 && value->has_value) {
            g_string_append_printf(text, "   %s ", _("sources"));
            add_shares(text, reading);
        }
    }
    gtk_label_set_text(GTK_LABEL(self->status_label), text->str);
    g_string_free(text, TRUE);
}
