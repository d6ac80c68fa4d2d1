/* SPDX-License-Identifier: MIT */
/* The layout of a figure: title, map with bar, sections with their legend, small print, from top to bottom. */
#include <math.h>
#include <string.h>

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

/* The map as wide as there is room, unless that would make it much higher than wide; the bar at its right. */
static double draw_map_and_bar(const struct lx_figure *figure, const struct lx_canvas *canvas,
                               const struct layout *layout, double top, bool drawn)
{
    const struct lx_screen *screen = &figure->scene->screen;
    struct lx_plot plot = {.x = {.low = -screen->width_mm / 2, .high = screen->width_mm / 2},
                           .y = {.low = -screen->height_mm / 2, .high = screen->height_mm / 2},
                           .size = layout->size};
    const char *x_label = lx_figure_word(figure, LX_N("x, mm")), *y_label = lx_figure_word(figure, LX_N("y, mm"));
    double aspect = screen->height_mm / screen->width_mm, bar_height = 0, room = 0, gap = 0, bar = 0;
    struct lx_margins margins = {0};
    plot.box = (struct lx_box){.width = layout->width / 2, .height = layout->width / 2 * aspect};
    for (int pass = 0; pass < 3; pass++) { /* ticks and labels, and with them the room, depend on the size */
        margins = lx_plot_margins(canvas, &plot, y_label);
        /* a low map gets a bar that its ticks have room on */
        bar_height = fmax(plot.box.height, 9 * layout->size);
        bar = lx_bar_room(figure, canvas, bar_height, layout->size);
        gap = fmax(1.2 * layout->size, margins.right - 0.5 * layout->size);
        room = layout->width - 2 * layout->margin - margins.left - gap - bar;
        plot.box.width = fmin(room, 1.15 * layout->width / aspect);
        plot.box.height = plot.box.width * aspect;
    }
    bar_height = fmax(plot.box.height, 9 * layout->size);
    double shift = (bar_height - plot.box.height) / 2;
    plot.box.x = layout->margin + margins.left + (room - plot.box.width) / 2;
    plot.box.y = top + margins.above + shift;
    if (drawn) {
        struct lx_box colors = {plot.box.x + plot.box.width + gap, plot.box.y - shift, bar, bar_height};
        lx_draw_map(figure, canvas, &plot);
        lx_draw_axes(canvas, &plot, x_label, y_label, false);
        lx_draw_bar(figure, canvas, &colors, layout->size);
    }
    return plot.box.y + fmax(plot.box.height + margins.below, bar_height - shift + margins.above);
}

/* The values of both sections have one scale, so that they can be compared; by powers of ten as the bar's is. */
static struct lx_scale section_scale(const struct lx_figure *figure)
{
    double most = 0;
    for (int which = 0; which < 2; which++)
        for (size_t i = 0; i < figure->sections[which]->count; i++)
            if (figure->sections[which]->samples[i].has_value)
                most = fmax(most, figure->sections[which]->samples[i].value);
    /* sums are areas, which begin at 0 */
    if (figure->scale.logarithmic && !figure->settings.stacked && most > figure->scale.low)
        return (struct lx_scale){.low = figure->scale.low, .high = 1.3 * most, .logarithmic = true};
    return (struct lx_scale){.low = 0, .high = most > 0 ? 1.06 * most : 1};
}

/* A name of the legend with its line or patch; returns its height, and how wide it is with what keeps it apart. */
static double draw_name(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                        size_t light, struct lx_box *box, bool drawn)
{
    bool whole = light == figure->light_count;
    const char *name = whole ? lx_figure_word(figure, LX_N("all together")) : figure->lights[light];
    struct lx_type type = {.size = layout->size, .wrap = layout->width - 2 * layout->margin - 2 * layout->size};
    struct lx_box text = lx_measure(canvas, name, &type);
    double line = lx_measure(canvas, "0", &type).height, y = box->y + line / 2, color[3];
    box->width = text.width + 2 * layout->size;
    box->height = text.height;
    if (!drawn)
        return text.height;
    memcpy(color, canvas->ink, sizeof color);
    if (!whole)
        lx_light_line(figure, canvas, light, layout->size, color);
    lx_color(canvas, color, 1);
    cairo_set_line_width(canvas->cairo, (whole ? 0.26 : figure->settings.stacked ? 0.8 : 0.16) * layout->size);
    cairo_move_to(canvas->cairo, box->x, y);
    cairo_line_to(canvas->cairo, box->x + 1.6 * layout->size, y);
    cairo_stroke(canvas->cairo);
    cairo_set_dash(canvas->cairo, NULL, 0, 0);
    lx_write(canvas, name, &type, box->x + 2 * layout->size, box->y, 0, 0, 0);
    return text.height;
}

/* "— lights[0]  — window": a row of names with their lines, wrapped. */
static double draw_legend(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                          double top, bool drawn)
{
    struct lx_box box = {.x = layout->margin, .y = top};
    double row = 0;
    if (figure->light_count < 2)
        return top;
    for (size_t i = 0; i <= figure->light_count; i++) {
        double height = draw_name(figure, canvas, layout, i, &box, false);
        if (box.x > layout->margin && box.x + box.width > layout->width - layout->margin) {
            box.x = layout->margin;
            box.y += 1.2 * row;
            row = 0;
        }
        row = fmax(row, height);
        draw_name(figure, canvas, layout, i, &box, drawn);
        box.x += box.width + 1.4 * layout->size;
    }
    return box.y + 1.2 * row;
}

/* Side by side where there is room, else one above the other. */
static double draw_sections(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                            double top, bool drawn)
{
    const struct lx_screen *screen = &figure->scene->screen;
    bool beside = layout->width / layout->size > 40;
    double inner = layout->width - 2 * layout->margin;
    double column = beside ? (inner - 1.5 * layout->gap) / 2 : inner, height = (beside ? 0.62 : 0.45) * column;
    double bottom = top, end = top;
    for (int which = 0; which < 2; which++) {
        double half = (which == 0 ? screen->width_mm : screen->height_mm) / 2;
        struct lx_plot plot = {
            .x = {.low = -half, .high = half}, .y = section_scale(figure), .size = layout->size, .box.height = height};
        struct lx_type title = {.size = layout->size, .bold = true};
        double left = layout->margin + (beside && which == 1 ? column + 1.5 * layout->gap : 0);
        double start = beside ? top : bottom;
        plot.box.width = 0.8 * column;
        struct lx_margins margins = lx_plot_margins(canvas, &plot, figure->label);
        title.wrap = column - margins.left;
        plot.box.x = left + margins.left;
        plot.box.y = start + lx_measure(canvas, figure->section_titles[which], &title).height + 0.6 * layout->size;
        plot.box.width = column - margins.left - margins.right;
        if (drawn) {
            lx_write(canvas, figure->section_titles[which], &title, plot.box.x, start, 0, 0, 0);
            lx_draw_section(figure, canvas, &plot, which);
        }
        bottom = plot.box.y + height + margins.below + layout->gap;
        end = fmax(end, bottom);
    }
    return draw_legend(figure, canvas, layout, end, drawn);
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
