/* SPDX-License-Identifier: MIT */
/* The layout of a figure: title, map with bar, sections with their legend, small print, from top to bottom. */
#include <math.h>
#include <string.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "figure.h"

/* Sizes that all follow from the width of the paper: letters of 8.5 points at 160 mm, never below 6.8. */
struct layout {
    double width, size, margin, gap;
};

static struct layout layout_of(double width)
{
    double factor = fmax(0.8, width / (160 * 72 / 25.4));
    struct layout layout = {.width = width, .size = 8.5 * factor};
    layout.margin = 0.8 * layout.size;
    layout.gap = 0.9 * layout.size;
    return layout;
}

/* The bar's room beside the map: its colours, ticks and label. */
static double bar_room(const struct lx_figure *figure, const struct lx_canvas *canvas, double size)
{
    const struct lx_type type = {.size = size};
    struct lx_ticks ticks = lx_ticks_of(&figure->scale, 9);
    double widest = 0;
    for (size_t i = 0; i < ticks.count; i++)
        widest = fmax(widest, lx_measure(canvas, ticks.texts[i], &type).width);
    return 1.6 * size + 1.1 * size + widest + lx_measure(canvas, figure->label, &type).height;
}

/* The map as wide as there is room, unless that would make it much higher than wide; the bar at its right. */
static double draw_map_and_bar(const struct lx_figure *figure, const struct lx_canvas *canvas,
                               const struct layout *layout, double top, bool drawn)
{
    const struct lx_screen *screen = &figure->scene->screen;
    struct lx_plot plot = {.x = {.low = -screen->width_mm / 2, .high = screen->width_mm / 2},
                           .y = {.low = -screen->height_mm / 2, .high = screen->height_mm / 2},
                           .size = layout->size};
    double aspect = screen->height_mm / screen->width_mm, bar = bar_room(figure, canvas, layout->size);
    plot.box = (struct lx_box){.width = 100, .height = 100 * aspect};
    struct lx_margins margins = {0};
    double room = 0;
    for (int pass = 0; pass < 2; pass++) { /* the ticks, and with them the margin, depend on the size */
        margins = lx_plot_margins(canvas, &plot);
        room = layout->width - 2 * layout->margin - margins.left - 1.2 * layout->size - bar;
        plot.box.width = fmin(room, 1.15 * layout->width / aspect);
        plot.box.height = plot.box.width * aspect;
    }
    plot.box.x = layout->margin + margins.left + (room - plot.box.width) / 2;
    plot.box.y = top + 0.5 * layout->size;
    /* a low map gets a bar that its ticks have room on */
    double bar_height = fmax(plot.box.height, 9 * layout->size);
    double shift = (bar_height - plot.box.height) / 2;
    plot.box.y += shift;
    if (drawn) {
        lx_draw_map(figure, canvas, &plot);
        lx_draw_axes(canvas, &plot, lx_figure_word(figure, LX_N("x, mm")), lx_figure_word(figure, LX_N("y, mm")),
                     false);
        struct lx_box colors = {plot.box.x + plot.box.width + 1.2 * layout->size, plot.box.y - shift,
                                1.6 * layout->size, bar_height};
        lx_draw_bar(figure, canvas, &colors, layout->size);
    }
    return plot.box.y + fmax(plot.box.height + margins.below, bar_height - shift + 0.5 * layout->size);
}

/* The highest value of both sections, so that they can be compared. */
static double highest(const struct lx_figure *figure)
{
    double most = 0;
    for (int which = 0; which < 2; which++)
        for (size_t i = 0; i < figure->sections[which]->count; i++)
            if (figure->sections[which]->samples[i].has_value)
                most = fmax(most, figure->sections[which]->samples[i].value);
    return most > 0 ? most : 1;
}

/* "— lights[0]  — window": a row of names with their colours, wrapped. */
static double draw_legend(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                          double top, bool drawn)
{
    const struct lx_type type = {.size = layout->size};
    double x = layout->margin, y = top, height = lx_measure(canvas, "0", &type).height;
    if (figure->light_count < 2)
        return top;
    for (size_t i = 0; i <= figure->light_count; i++) {
        bool whole = i == figure->light_count;
        const char *name = whole ? lx_figure_word(figure, LX_N("all together")) : figure->lights[i];
        double color[3], width = lx_measure(canvas, name, &type).width + 3.4 * layout->size;
        memcpy(color, canvas->ink, sizeof color);
        if (!whole)
            lx_light_color(figure, i, color);
        if (x > layout->margin && x + width > layout->width - layout->margin) {
            x = layout->margin;
            y += 1.2 * height;
        }
        if (drawn) {
            lx_color(canvas, color, 1);
            cairo_set_line_width(canvas->cairo, (whole ? 0.21 : 0.3) * layout->size);
            cairo_move_to(canvas->cairo, x, y + height / 2);
            cairo_line_to(canvas->cairo, x + 1.6 * layout->size, y + height / 2);
            cairo_stroke(canvas->cairo);
            lx_write(canvas, name, &type, x + 2 * layout->size, y, 0, 0, 0);
        }
        x += width;
    }
    return y + 1.2 * height;
}

static void section_title(const struct lx_figure *figure, int which, char *text, size_t size)
{
    char number[LX_NUMBER_SIZE];
    struct lx_text phrase = {0};
    const luxel_language *language = figure->settings.language;
    lx_write_digits(fabs(figure->section_mm[1 - which]) < 1e-6 ? 0 : figure->section_mm[1 - which], 6, number);
    lx_add_phrase(&phrase, which == 0 ? LX_N("section along x at y = {0} mm") : LX_N("section along y at x = {0} mm"),
                  (const char *const[]){number, NULL});
    char *words = lx_text_render(&phrase, language ? language->translate : NULL, language ? language->data : NULL);
    text[0] = '\0';
    strncat(text, words ? words : "", size - 1);
    luxel_text_free(words);
}

/* Side by side where there is room, else one above the other. */
static double draw_sections(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                            double top, bool drawn)
{
    const struct lx_screen *screen = &figure->scene->screen;
    const struct lx_type type = {.size = layout->size, .bold = true};
    bool beside = layout->width / layout->size > 40;
    double most = 1.06 * highest(figure), heading = 1.6 * lx_measure(canvas, "0", &type).height;
    double inner = layout->width - 2 * layout->margin, column = beside ? (inner - 2 * layout->gap) / 2 : inner;
    double height = beside ? 0.62 * column : 0.45 * column, bottom = top;
    for (int which = 0; which < 2; which++) {
        double half = (which == 0 ? screen->width_mm : screen->height_mm) / 2;
        struct lx_plot plot = {.x = {.low = -half, .high = half}, .y = {.low = 0, .high = most}, .size = layout->size};
        plot.box.height = height;
        plot.box.width = column;
        struct lx_margins margins = lx_plot_margins(canvas, &plot);
        double left = layout->margin + (beside && which == 1 ? column + 2 * layout->gap : 0);
        double start = beside ? top : bottom;
        plot.box.x = left + margins.left;
        plot.box.y = start + heading;
        plot.box.width = column - margins.left - (beside ? 0 : layout->gap);
        if (drawn) {
            char title[256];
            section_title(figure, which, title, sizeof title);
            lx_write(canvas, title, &type, plot.box.x, start, 0, 0, 0);
            lx_draw_section(figure, canvas, &plot, which);
        }
        bottom = plot.box.y + height + margins.below + layout->gap;
    }
    return draw_legend(figure, canvas, layout, bottom, drawn);
}

double lx_figure_draw(const struct lx_figure *figure, cairo_t *cairo, double width)
{
    /* measuring needs fonts, too */
    cairo_surface_t *nowhere = cairo ? NULL : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *context = cairo ? cairo : cairo_create(nowhere);
    struct lx_canvas canvas = lx_canvas_of(context, figure->settings.dark);
    struct layout layout = layout_of(width);
    struct lx_type title = {.size = 1.3 * layout.size, .bold = true, .wrap = width - 2 * layout.margin};
    struct lx_type print = {
        .size = fmax(6, 0.75 * layout.size), .color = canvas.faint, .wrap = width - 2 * layout.margin};
    double y = layout.margin;
    bool drawn = cairo != NULL;
    if (*figure->title) {
        if (drawn)
            lx_write(&canvas, figure->title, &title, layout.margin, y, 0, 0, 0);
        y += lx_measure(&canvas, figure->title, &title).height + layout.gap;
    }
    y = draw_map_and_bar(figure, &canvas, &layout, y, drawn);
    if (figure->sections[0] && figure->sections[1])
        y = draw_sections(figure, &canvas, &layout, y + layout.gap, drawn);
    if (*figure->print) {
        y += layout.gap;
        if (drawn)
            lx_write(&canvas, figure->print, &print, layout.margin, y, 0, 0, 0);
        y += lx_measure(&canvas, figure->print, &print).height;
    }
    lx_canvas_clear(&canvas);
    if (!cairo) {
        cairo_destroy(context);
        cairo_surface_destroy(nowhere);
    }
    return y + layout.margin;
}
