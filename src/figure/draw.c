/* SPDX-License-Identifier: MIT */
/* The layout of a figure: title, map with bar, sections with their legend, small print, from top to bottom. */
#include <math.h>

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

static struct lx_bar bar_of(const struct lx_figure *figure)
{
    return (struct lx_bar){
        .palette = figure->settings.palette,
        .scale = figure->scale,
        .label = figure->label,
        .levels = figure->levels,
        .level_count = figure->level_count,
        .stepped = figure->settings.bands == LUXEL_BANDS_STEPS,
        .lined = figure->isophotes != NULL,
        .has_below = figure->has_below,
        .has_above = figure->has_above,
    };
}

/* The map as wide as there is room, unless that would make it much higher than wide; the bar at its right. */
static double draw_map_and_bar(const struct lx_figure *figure, const struct lx_canvas *canvas,
                               const struct layout *layout, double top, bool drawn)
{
    const double *size_mm = figure->size_mm;
    const struct lx_bar bar = bar_of(figure);
    struct lx_plot plot = {.x = figure->axes[0], .y = figure->axes[1], .size = layout->size};
    const char *x_label = lx_figure_word(figure, figure->axis_names[0]);
    const char *y_label = lx_figure_word(figure, figure->axis_names[1]);
    double aspect = size_mm[1] / size_mm[0], bar_height = 0, room = 0, gap = 0, bar_width = 0;
    struct lx_margins margins = {0};
    plot.box = (struct lx_pane){.width = layout->width / 2, .height = layout->width / 2 * aspect};
    for (int pass = 0; pass < 3; pass++) { /* ticks and labels, and with them the room, depend on the size */
        margins = lx_plot_margins(canvas, &plot, x_label, y_label);
        /* a low map gets a bar that its ticks have room on */
        bar_height = fmax(plot.box.height, 9 * layout->size);
        bar_width = lx_bar_room(&bar, canvas, bar_height, layout->size);
        gap = fmax(1.2 * layout->size, margins.right - 0.5 * layout->size);
        room = layout->width - 2 * layout->margin - margins.left - gap - bar_width;
        plot.box.width = fmin(room, 1.15 * layout->width / aspect);
        plot.box.height = plot.box.width * aspect;
    }
    bar_height = fmax(plot.box.height, 9 * layout->size);
    double shift = (bar_height - plot.box.height) / 2;
    plot.box.x = layout->margin + margins.left + (room - plot.box.width) / 2;
    plot.box.y = top + margins.above + shift;
    if (drawn) {
        struct lx_pane colors = {plot.box.x + plot.box.width + gap, plot.box.y - shift, bar_width, bar_height};
        struct lx_plot map = plot;
        map.x = (struct lx_scale){.low = -size_mm[0] / 2, .high = size_mm[0] / 2};
        map.y = (struct lx_scale){.low = -size_mm[1] / 2, .high = size_mm[1] / 2};
        lx_draw_map(figure, canvas, &map);
        lx_draw_axes(canvas, &plot, x_label, y_label, false);
        lx_draw_bar(&bar, canvas, &colors, layout->size);
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

static void draw_section(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_plot *plot,
                         int which, const char *x_label)
{
    const struct lx_curves curves = {
        .profile = figure->sections[which],
        .along = which == 0 ? LX_ALONG_X : LX_ALONG_Y,
        .lights = figure->light_places,
        .light_count = figure->light_count,
        .stacked = figure->settings.stacked,
    };
    lx_draw_axes(canvas, plot, x_label, figure->label, true);
    lx_draw_curves(&curves, canvas, plot);
}

static double draw_legend(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct layout *layout,
                          double top, bool drawn)
{
    const struct lx_legend legend = {
        .names = (const char *const *)figure->lights,
        .count = figure->light_count,
        .whole = lx_figure_word(figure, LX_N("all together")),
        .stacked = figure->settings.stacked,
    };
    const struct lx_pane place = {.x = layout->margin, .y = top, .width = layout->width - 2 * layout->margin};
    return lx_draw_legend(&legend, canvas, &place, layout->size, drawn);
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
        const char *x_label = lx_figure_word(figure, which == 0 ? LX_N("x, mm") : LX_N("y, mm"));
        double half = (which == 0 ? screen->width_mm : screen->height_mm) / 2;
        struct lx_plot plot = {
            .x = {.low = -half, .high = half}, .y = section_scale(figure), .size = layout->size, .box.height = height};
        struct lx_type title = {.size = layout->size, .bold = true};
        double left = layout->margin + (beside && which == 1 ? column + 1.5 * layout->gap : 0);
        double start = beside ? top : bottom;
        plot.box.width = 0.8 * column;
        struct lx_margins margins = lx_plot_margins(canvas, &plot, x_label, figure->label);
        title.wrap = column - margins.left;
        plot.box.x = left + margins.left;
        plot.box.y = start + lx_measure(canvas, figure->section_titles[which], &title).height + 0.6 * layout->size;
        plot.box.width = column - margins.left - margins.right;
        if (drawn) {
            lx_write(canvas, figure->section_titles[which], &title, plot.box.x, start, 0, 0, 0);
            draw_section(figure, canvas, &plot, which, x_label);
        }
        bottom = plot.box.y + height + margins.below + layout->gap;
        end = fmax(end, bottom);
    }
    return draw_legend(figure, canvas, layout, end, drawn);
}

/* Draws a text, or only measures; returns where it ends. */
static double draw_text(const char *text, const struct lx_canvas *canvas, const struct lx_type *type, double x,
                        double y, bool drawn)
{
    if (drawn)
        lx_write(canvas, text, type, x, y, 0, 0, 0);
    return y + lx_measure(canvas, text, type).height;
}

double lx_figure_draw(const struct lx_figure *figure, cairo_t *cairo, double width)
{
    /* measuring needs fonts, too */
    cairo_surface_t *nowhere = cairo ? NULL : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *context = cairo ? cairo : cairo_create(nowhere);
    struct lx_canvas canvas = lx_canvas_of(context, figure->settings.dark);
    struct layout layout = layout_of(width);
    struct lx_type title = {.size = 1.3 * layout.size, .bold = true, .wrap = width - 2 * layout.margin};
    struct lx_type caption = {.size = layout.size, .wrap = title.wrap};
    struct lx_type print = {
        .size = fmax(6, 0.75 * layout.size), .color = canvas.faint, .wrap = width - 2 * layout.margin};
    double y = layout.margin;
    bool drawn = cairo != NULL;
    if (*figure->title)
        y = draw_text(figure->title, &canvas, &title, layout.margin, y, drawn) + layout.gap;
    y = draw_map_and_bar(figure, &canvas, &layout, y, drawn);
    if (figure->plane)
        y = draw_text(figure->plane->caption, &canvas, &caption, layout.margin, y + layout.gap, drawn);
    if (figure->sections[0] && figure->sections[1])
        y = draw_sections(figure, &canvas, &layout, y + layout.gap, drawn);
    if (*figure->print)
        y = draw_text(figure->print, &canvas, &print, layout.margin, y + layout.gap, drawn);
    lx_canvas_clear(&canvas);
    if (!cairo) {
        cairo_destroy(context);
        cairo_surface_destroy(nowhere);
    }
    return y + layout.margin;
}
