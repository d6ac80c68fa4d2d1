/* SPDX-License-Identifier: MIT */
/* The usual size is that of GTK's own default, ten points at 96 dots an inch. */
#include "letters.h"

static const double USUAL_POINTS = 10, USUAL_DOTS_OF_AN_INCH = 96, POINTS_OF_AN_INCH = 72, LARGEST = 2;

double app_letters_scale(GtkWidget *widget)
{
    PangoContext *context = gtk_widget_get_pango_context(widget);
    const PangoFontDescription *font = pango_context_get_font_description(context);
    const double size = pango_units_to_double(pango_font_description_get_size(font));
    const double set = pango_cairo_context_get_resolution(context);
    const double inch = (set > 0 ? set : USUAL_DOTS_OF_AN_INCH) / POINTS_OF_AN_INCH;
    const double dots = pango_font_description_get_size_is_absolute(font) ? size : size * inch;
    return CLAMP(dots / (USUAL_POINTS * USUAL_DOTS_OF_AN_INCH / POINTS_OF_AN_INCH), 1, LARGEST);
}

PangoLayout *app_letters_new(GtkWidget *widget, const char *text, const char *face, double dots)
{
    PangoLayout *layout = gtk_widget_create_pango_layout(widget, text);
    PangoFontDescription *font =
        face ? pango_font_description_from_string(face)
             : pango_font_description_copy(pango_context_get_font_description(gtk_widget_get_pango_context(widget)));
    pango_font_description_set_absolute_size(font, dots * app_letters_scale(widget) * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    return layout;
}
