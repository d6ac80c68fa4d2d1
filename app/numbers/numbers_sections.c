/* SPDX-License-Identifier: MIT */
/* The page of sections: the values along two lines through the picture, in all and source by source. */
#include <string.h>

#include "../../front/words.h"
#include "../base/choices.h"
#include "../base/number.h"
#include "../base/scalar.h"
#include "numbers_private.h"

static void draw_profile(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    AppNumbers *self = data;
    const Plot which = GTK_WIDGET(area) == self->plots[PLOT_VERTICAL] ? PLOT_VERTICAL : PLOT_HORIZONTAL;
    luxel_language language;
    luxel_drawing_style style = app_numbers_style(GTK_WIDGET(area), &language);
    luxel_profile_style how;
    const AppCurve *curve = self->curves[which];
    const luxel_profile *profile = curve ? &curve->profile : NULL;
    if (!profile)
        return;
    luxel_profile_style_init(&how);
    if (curve->is_difference) {
        how.low = curve->low;
        how.high = curve->high;
    }
    how.along = which == PLOT_VERTICAL ? LUXEL_ALONG_Y : LUXEL_ALONG_X;
    how.marker = self->section_mm[which];
    how.y_label = self->unit_name;
    if (self->names && profile->lights == self->name_count)
        how.names = (const char *const *)self->names;
    luxel_draw_profile(cairo, &style, profile, &how, width, height);
    if (luxel_profile_frame(&style, profile, &how, width, height, &self->cursors[which].frame) == LUXEL_OK)
        app_numbers_draw_cursor(self, which, cairo, &style);
}

GtkWidget *app_numbers_new_sections(AppNumbers *self)
{
    GtkWidget *page = gtk_box_new(GTK_ORIENTATION_VERTICAL, 8), *scrolled = gtk_scrolled_window_new();
    self->section_place = gtk_label_new(NULL);
    gtk_label_set_xalign(GTK_LABEL(self->section_place), 0);
    gtk_label_set_wrap(GTK_LABEL(self->section_place), TRUE);
    gtk_label_set_max_width_chars(GTK_LABEL(self->section_place), TEXT_COLUMNS);
    gtk_box_append(GTK_BOX(page), self->section_place);
    app_numbers_add_plot(self, PLOT_HORIZONTAL, draw_profile, _("Horizontal section"), page);
    app_numbers_add_plot(self, PLOT_VERTICAL, draw_profile, _("Vertical section"), page);
    gtk_scrolled_window_set_child(GTK_SCROLLED_WINDOW(scrolled), page);
    return scrolled;
}

/* Names for the legend: of a light its own or its type, counted; none of those that are off. */
static void name_lights(AppNumbers *self)
{
    g_strfreev(self->names);
    self->name_count = app_document_size(self->document, "lights");
    self->names = g_new0(char *, self->name_count + 1);
    for (gsize i = 0; i < self->name_count; i++) {
        char *key = g_strdup_printf("lights[%zu].name", i), *name = app_document_get(self->document, key, NULL);
        g_free(key);
        key = g_strdup_printf("lights[%zu].type", i);
        char *type = app_document_get(self->document, key, NULL), *plain = name ? app_yaml_unquote(name) : NULL;
        self->names[i] = g_strdup_printf("%zu %s", i + 1, plain ? plain : type ? app_choice_label(type) : "");
        g_free(plain);
        g_free(name);
        g_free(type);
        g_free(key);
    }
}

void app_numbers_show_sections(AppNumbers *self, AppMeasures *measures)
{
    char x[APP_NUMBER_SIZE], y[APP_NUMBER_SIZE];
    for (int i = 0; i < 2; i++) {
        app_curve_free(self->curves[i]);
        self->curves[i] = g_steal_pointer(&measures->curves[i]);
        self->section_mm[i] = measures->section_mm[i];
    }
    name_lights(self);
    char *text =
        g_strdup_printf(_("Through x = %s, y = %s mm; drag the lines on the picture"),
                        app_number_show(self->section_mm[0], PLACE_DIGITS, x),
                        app_number_show(self->section_mm[1], PLACE_DIGITS, y));
    app_numbers_set_text(self->section_place, text);
    g_free(text);
    for (int i = PLOT_HORIZONTAL; i <= PLOT_VERTICAL; i++)
        app_numbers_tell_cursor(self, (Plot)i);
}
