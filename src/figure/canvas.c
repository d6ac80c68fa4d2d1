/* SPDX-License-Identifier: MIT */
/* Texts and colours on a cairo context. */
#include "canvas.h"

#include <math.h>
#include <pango/pangocairo.h>

/* Without blanks, which pango on Windows would take for parts of names. */
static const char families[] = "DejaVu Sans,Noto Sans,Liberation Sans,Segoe UI,sans-serif";

static void *fonts_of(cairo_t *cairo)
{
    PangoContext *context = pango_cairo_create_context(cairo);
    cairo_font_options_t *options = cairo_font_options_create();
    /* the same widths on every device, so that a figure is laid out alike everywhere */
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context, options);
    pango_cairo_context_set_resolution(context, 72);
    pango_context_set_round_glyph_positions(context, FALSE);
    cairo_font_options_destroy(options);
    return context;
}

struct lx_canvas lx_canvas_of(cairo_t *cairo, bool dark)
{
    struct lx_canvas canvas = {.ink = {0.1, 0.1, 0.1}, .ground = {1, 1, 1}, .faint = {0.45, 0.45, 0.45}};
    if (dark)
        canvas =
            (struct lx_canvas){.ink = {0.93, 0.93, 0.93}, .ground = {0.08, 0.085, 0.09}, .faint = {0.62, 0.62, 0.62}};
    canvas.cairo = cairo;
    canvas.fonts = fonts_of(cairo);
    return canvas;
}

struct lx_canvas lx_canvas_in(cairo_t *cairo, const double ink[3], const double ground[3])
{
    struct lx_canvas canvas = {.cairo = cairo, .fonts = fonts_of(cairo), .decimal_mark = '.'};
    for (int i = 0; i < 3; i++) {
        canvas.ink[i] = ink[i];
        canvas.ground[i] = ground[i];
        canvas.faint[i] = ink[i] + 0.38 * (ground[i] - ink[i]);
    }
    return canvas;
}

void lx_canvas_clear(struct lx_canvas *canvas)
{
    g_object_unref(canvas->fonts);
    canvas->fonts = NULL;
}

static PangoLayout *layout_of(const struct lx_canvas *canvas, const char *text, const struct lx_type *type)
{
    PangoLayout *layout = pango_layout_new(canvas->fonts);
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, families);
    pango_font_description_set_size(font, (gint)lround(type->size * PANGO_SCALE));
    pango_font_description_set_weight(font, type->bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    if (type->wrap > 0) {
        pango_layout_set_width(layout, (int)lround(type->wrap * PANGO_SCALE));
        pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
        pango_layout_set_alignment(layout, type->centered ? PANGO_ALIGN_CENTER : PANGO_ALIGN_LEFT);
    }
    pango_layout_set_text(layout, text, -1);
    return layout;
}

static struct lx_pane size_of(PangoLayout *layout)
{
    PangoRectangle logical;
    pango_layout_get_extents(layout, NULL, &logical);
    /* wrapped lines around their middle begin within the room that they have */
    return (struct lx_pane){.x = (double)logical.x / PANGO_SCALE,
                            .width = (double)logical.width / PANGO_SCALE,
                            .height = (double)logical.height / PANGO_SCALE};
}

struct lx_pane lx_measure(const struct lx_canvas *canvas, const char *text, const struct lx_type *type)
{
    PangoLayout *layout = layout_of(canvas, text, type);
    struct lx_pane size = size_of(layout);
    g_object_unref(layout);
    return size;
}

void lx_write(const struct lx_canvas *canvas, const char *text, const struct lx_type *type, double x, double y,
              double across, double down, double turned)
{
    PangoLayout *layout = layout_of(canvas, text, type);
    struct lx_pane size = size_of(layout);
    cairo_t *cairo = canvas->cairo;
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_rotate(cairo, turned);
    cairo_move_to(cairo, -across * size.width - size.x, -down * size.height);
    if (type->halo) {
        pango_cairo_layout_path(cairo, layout);
        lx_color(canvas, type->halo, 0.85);
        cairo_set_line_width(cairo, type->size * 0.28);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_stroke(cairo);
        cairo_move_to(cairo, -across * size.width - size.x, -down * size.height);
    }
    lx_color(canvas, type->color ? type->color : canvas->ink, 1);
    pango_cairo_show_layout(cairo, layout);
    cairo_new_path(cairo);
    cairo_restore(cairo);
    g_object_unref(layout);
}

void lx_color(const struct lx_canvas *canvas, const double color[3], double opacity)
{
    cairo_set_source_rgba(canvas->cairo, color[0], color[1], color[2], opacity);
}
