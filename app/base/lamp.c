/* SPDX-License-Identifier: MIT */
/* Colours are those of the curves in figures, so that a lamp is the same one everywhere. */
#include "lamp.h"

#include <luxel/drawing.h>
#include <pango/pangocairo.h>

static gboolean is_dark;

void app_lamp_use_dark(gboolean dark)
{
    is_dark = dark;
}

gboolean app_lamp_is_dark(void)
{
    return is_dark;
}

void app_lamp_color(gsize light, double color[3])
{
    luxel_drawing_style style;
    luxel_drawing_style_init(&style, is_dark);
    luxel_light_color(&style, light, color);
}

char *app_lamp_markup(gsize light)
{
    double color[3];
    app_lamp_color(light, color);
    return g_strdup_printf("<span background=\"#%02x%02x%02x\" color=\"%s\">%zu</span>",
                           (unsigned)(color[0] * 255 + 0.5), (unsigned)(color[1] * 255 + 0.5),
                           (unsigned)(color[2] * 255 + 0.5), is_dark ? "#101216" : "#ffffff", light + 1);
}

/* As large as there is room for in the disk. */
static void draw_number(cairo_t *cairo, const AppBadge *badge)
{
    static const double sizes[] = {11, 9.5, 7.5, 6};
    char number[24];
    const int digits = g_snprintf(number, sizeof number, "%zu", badge->light + 1);
    PangoLayout *layout = pango_cairo_create_layout(cairo);
    PangoFontDescription *font = pango_font_description_from_string("Sans Bold");
    PangoRectangle ink;
    pango_font_description_set_absolute_size(font, sizes[CLAMP(digits, 1, 4) - 1] * PANGO_SCALE);
    pango_layout_set_font_description(layout, font);
    pango_layout_set_text(layout, number, -1);
    pango_layout_get_extents(layout, &ink, NULL);
    cairo_move_to(cairo, -(ink.x + ink.width / 2.0) / PANGO_SCALE, -(ink.y + ink.height / 2.0) / PANGO_SCALE);
    pango_cairo_layout_path(cairo, layout);
    if (!badge->is_on || is_dark)
        cairo_set_source_rgb(cairo, badge->is_on ? 0.06 : 0.9, badge->is_on ? 0.07 : 0.9, badge->is_on ? 0.09 : 0.9);
    else { /* white with a dark edge, which is read on each of the colours */
        cairo_set_source_rgba(cairo, 0, 0, 0, 0.75);
        cairo_set_line_width(cairo, 2);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke_preserve(cairo);
        cairo_set_source_rgb(cairo, 1, 1, 1);
    }
    cairo_fill(cairo);
    pango_font_description_free(font);
    g_object_unref(layout);
}

void app_lamp_draw_badge(cairo_t *cairo, const AppBadge *badge)
{
    double color[3];
    app_lamp_color(badge->light, color);
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, 0, 0, APP_BADGE_RADIUS, 0, 2 * G_PI);
    if (badge->is_on)
        cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    else
        cairo_set_source_rgba(cairo, 0.2, 0.2, 0.2, 0.85);
    cairo_fill_preserve(cairo);
    /* a dark seam under the line shows it on every ground */
    cairo_set_source_rgba(cairo, 0, 0, 0, 0.65);
    cairo_set_line_width(cairo, badge->selected ? 4.5 : 3);
    cairo_stroke_preserve(cairo);
    if (badge->is_on || badge->selected)
        cairo_set_source_rgb(cairo, 1, 1, 1);
    else
        cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    cairo_set_line_width(cairo, badge->selected ? 2.5 : 1.2);
    cairo_stroke(cairo);
    draw_number(cairo, badge);
}
