/* SPDX-License-Identifier: MIT */
/* Colour bars and histograms on the caller's context, and what all such drawings share. */
#include "drawing.h"

#include <luxel/figure.h>
#include <math.h>

#include "../base/diagnostics.h"

void luxel_drawing_style_init(luxel_drawing_style *style, bool dark)
{
    *style = (luxel_drawing_style){.letters = 10, .decimal_mark = '.'};
    for (int i = 0; i < 3; i++) {
        style->ink[i] = dark ? 0.93 : 0.1;
        style->ground[i] = dark ? 0.08 : 1;
    }
}

/* ---- arguments ---- */

static bool has_size(double length)
{
    return length > 0 && isfinite(length);
}

static bool style_goes(const luxel_drawing_style *style)
{
    bool goes = style && has_size(style->letters) && LX_CHECK_RESERVE(style, NULL) == LUXEL_OK &&
                (!style->language || LX_CHECK_RESERVE(style->language, NULL) == LUXEL_OK);
    for (int i = 0; goes && i < 3; i++)
        goes = style->ink[i] >= 0 && style->ink[i] <= 1 && style->ground[i] >= 0 && style->ground[i] <= 1;
    return goes;
}

bool lx_can_draw(cairo_t *cairo, const luxel_drawing_style *style, double width, double height)
{
    return cairo && cairo_status(cairo) == CAIRO_STATUS_SUCCESS && style_goes(style) && has_size(width) &&
           has_size(height);
}

bool lx_can_measure(const luxel_drawing_style *style, double width, double height)
{
    return style_goes(style) && has_size(width) && has_size(height);
}

luxel_status luxel_light_color(const luxel_drawing_style *style, size_t i, double color[3])
{
    if (!style_goes(style) || !color)
        return LUXEL_ERROR_ARGUMENT;
    lx_light_color(style->ground, i, color);
    return LUXEL_OK;
}

bool lx_scale_goes(const struct lx_scale *scale)
{
    return isfinite(scale->low) && isfinite(scale->high) && scale->low < scale->high &&
           isfinite(scale->high - scale->low) && (!scale->logarithmic || scale->low > 0);
}

struct lx_scale lx_bar_scale(const luxel_color_bar *bar)
{
    return (struct lx_scale){.low = bar->low, .high = bar->high, .logarithmic = bar->logarithmic};
}

bool lx_bar_goes(const luxel_color_bar *bar)
{
    double color[3];
    if (!bar || LX_CHECK_RESERVE(bar, NULL) != LUXEL_OK || !luxel_palette_color(bar->palette, 0, color))
        return false;
    const struct lx_scale scale = lx_bar_scale(bar);
    return lx_scale_goes(&scale);
}

/* ---- the canvas ---- */

struct lx_canvas lx_drawing_begin(cairo_t *cairo, const luxel_drawing_style *style, double width, double height)
{
    cairo_save(cairo);
    cairo_new_path(cairo);
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_clip(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER);
    cairo_set_operator(cairo, CAIRO_OPERATOR_OVER);
    struct lx_canvas canvas = lx_canvas_in(cairo, style->ink, style->ground);
    canvas.decimal_mark = style->decimal_mark;
    return canvas;
}

luxel_status lx_drawing_end(struct lx_canvas *canvas)
{
    cairo_t *cairo = canvas->cairo;
    lx_canvas_clear(canvas);
    cairo_new_path(cairo);
    cairo_restore(cairo);
    switch (cairo_status(cairo)) {
    case CAIRO_STATUS_SUCCESS: return LUXEL_OK;
    case CAIRO_STATUS_NO_MEMORY: return LUXEL_ERROR_MEMORY;
    default: return LUXEL_ERROR_ARGUMENT;
    }
}

struct lx_canvas lx_measuring_begin(const luxel_drawing_style *style, double width, double height)
{
    cairo_surface_t *nowhere = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *cairo = cairo_create(nowhere);
    cairo_surface_destroy(nowhere); /* the context has it */
    return lx_drawing_begin(cairo, style, width, height);
}

luxel_status lx_measuring_end(struct lx_canvas *canvas)
{
    cairo_t *cairo = canvas->cairo;
    luxel_status status = lx_drawing_end(canvas);
    cairo_destroy(cairo);
    return status;
}

luxel_plot_frame lx_frame_of(const struct lx_plot *plot, bool fits)
{
    return (luxel_plot_frame){
        .x = plot->box.x,
        .y = plot->box.y,
        .width = fits ? plot->box.width : 0,
        .height = fits ? plot->box.height : 0,
        .left = plot->x.low,
        .right = plot->x.high,
        .bottom = plot->y.low,
        .top = plot->y.high,
    };
}

bool lx_fit_plot(const struct lx_canvas *canvas, struct lx_plot *plot, const char *x_label, const char *y_label)
{
    const struct lx_pane place = plot->box;
    for (int pass = 0; pass < 3; pass++) { /* ticks and labels, and with them the room, depend on the size */
        struct lx_margins margins = lx_plot_margins(canvas, plot, x_label, y_label);
        double right = fmax(margins.right, 0.3 * plot->size), above = fmax(margins.above, 0.3 * plot->size);
        plot->box.x = place.x + margins.left;
        plot->box.y = place.y + above;
        plot->box.width = place.width - margins.left - right;
        plot->box.height = place.height - above - margins.below;
        if (!(plot->box.width > plot->size && plot->box.height > plot->size))
            return false;
    }
    return true;
}

/* ---- bars ---- */

static struct lx_bar bar_of(const luxel_color_bar *bar, bool lying)
{
    return (struct lx_bar){
        .palette = bar->palette,
        .scale = lx_bar_scale(bar),
        .label = bar->label,
        .has_below = bar->has_below,
        .has_above = bar->has_above,
        .lying = lying,
    };
}

/* Where the bar itself goes: the ticks' texts at its ends reach beyond it by half of what they take along it. */
static struct lx_pane bar_place(const struct lx_bar *bar, const struct lx_canvas *canvas, double width, double height,
                                double size)
{
    const struct lx_type type = {.size = size};
    struct lx_pane place = {.width = width, .height = height};
    const struct lx_ticks ticks =
        lx_ticks_along(canvas, &bar->scale, bar->lying ? width : height, size, !bar->lying, 9);
    double beyond = 0;
    for (size_t i = 0; i < ticks.count; i++) {
        struct lx_pane text = lx_measure(canvas, ticks.texts[i], &type);
        beyond = fmax(beyond, (bar->lying ? text.width : text.height) / 2);
    }
    double edge = fmin(fmax(beyond, 0.1 * size), 0.2 * (bar->lying ? width : height));
    place.x = bar->lying ? edge : 0.1 * size;
    place.y = bar->lying ? 0.1 * size : edge;
    place.width -= 2 * place.x;
    place.height -= 2 * place.y;
    return place;
}

luxel_status luxel_draw_color_bar(cairo_t *cairo, const luxel_drawing_style *style, const luxel_color_bar *bar,
                                  double width, double height)
{
    if (!lx_can_draw(cairo, style, width, height) || !lx_bar_goes(bar))
        return LUXEL_ERROR_ARGUMENT;
    struct lx_bar drawn = bar_of(bar, width > height);
    struct lx_canvas canvas = lx_drawing_begin(cairo, style, width, height);
    const struct lx_pane place = bar_place(&drawn, &canvas, width, height, style->letters);
    double length = drawn.lying ? place.width : place.height, across = drawn.lying ? place.height : place.width;
    if (lx_bar_room(&drawn, &canvas, length, style->letters) > across + 0.5)
        drawn.label = NULL;
    lx_draw_bar(&drawn, &canvas, &place, style->letters);
    return lx_drawing_end(&canvas);
}

luxel_status luxel_color_bar_room(const luxel_drawing_style *style, const luxel_color_bar *bar, double length,
                                  bool lying, double *room)
{
    if (!lx_can_measure(style, length, length) || !lx_bar_goes(bar) || !room)
        return LUXEL_ERROR_ARGUMENT;
    const struct lx_bar measured = bar_of(bar, lying);
    struct lx_canvas canvas = lx_measuring_begin(style, length, length);
    const struct lx_pane place = bar_place(&measured, &canvas, length, length, style->letters);
    *room = lx_bar_room(&measured, &canvas, lying ? place.width : place.height, style->letters) + 0.2 * style->letters;
    return lx_measuring_end(&canvas);
}

/* ---- histograms ---- */

static bool histogram_goes(const luxel_histogram *histogram, struct lx_scale *scale)
{
    if (!histogram || histogram->bins == 0 || !histogram->edges || !histogram->counts)
        return false;
    *scale = (struct lx_scale){.low = histogram->edges[0],
                               .high = histogram->edges[histogram->bins],
                               .logarithmic = histogram->scale == LUXEL_HISTOGRAM_LOGARITHMIC};
    return lx_scale_goes(scale);
}

/* Whole numbers only, even where all counts are small. */
static struct lx_scale count_scale(const luxel_histogram *histogram)
{
    size_t most = 0;
    for (size_t i = 0; i < histogram->bins; i++)
        most = histogram->counts[i] > most ? histogram->counts[i] : most;
    return (struct lx_scale){.low = 0, .high = fmax(1.06 * (double)most, 8)};
}

/* Without smoothed edges, which would leave seams between the bins. */
static void draw_bins(const luxel_histogram *histogram, const luxel_color_bar *colors, const struct lx_canvas *canvas,
                      const struct lx_plot *plot)
{
    cairo_t *cairo = canvas->cairo;
    double bottom = plot->box.y + plot->box.height;
    cairo_save(cairo);
    cairo_set_antialias(cairo, CAIRO_ANTIALIAS_NONE);
    lx_color(canvas, canvas->ink, 0.75);
    for (size_t i = 0; i < histogram->bins; i++) {
        const double *edge = &histogram->edges[i];
        double left = lx_plot_x(plot, edge[0]), right = lx_plot_x(plot, edge[1]), color[3];
        double top = lx_plot_y(plot, (double)histogram->counts[i]);
        if (histogram->counts[i] == 0)
            continue;
        if (colors) {
            const struct lx_scale scale = lx_bar_scale(colors);
            double middle = plot->x.logarithmic ? sqrt(edge[0]) * sqrt(edge[1]) : (edge[0] + edge[1]) / 2;
            luxel_palette_color(colors->palette, lx_scale_place(&scale, middle), color);
            lx_color(canvas, color, 1);
        }
        cairo_rectangle(cairo, left, top, right - left, bottom - top);
        cairo_fill(cairo);
    }
    cairo_restore(cairo);
}

/* The outline, which shows bins that have nearly the colour of the ground. */
static void draw_outline(const luxel_histogram *histogram, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    cairo_move_to(canvas->cairo, plot->box.x, plot->box.y + plot->box.height);
    for (size_t i = 0; i < histogram->bins; i++) {
        double top = lx_plot_y(plot, (double)histogram->counts[i]);
        cairo_line_to(canvas->cairo, lx_plot_x(plot, histogram->edges[i]), top);
        cairo_line_to(canvas->cairo, lx_plot_x(plot, histogram->edges[i + 1]), top);
    }
    cairo_line_to(canvas->cairo, plot->box.x + plot->box.width, plot->box.y + plot->box.height);
    cairo_close_path(canvas->cairo);
    cairo_set_line_width(canvas->cairo, 0.06 * plot->size);
    lx_color(canvas, canvas->ink, 1);
    cairo_stroke(canvas->cairo);
}

luxel_status luxel_draw_histogram(cairo_t *cairo, const luxel_drawing_style *style, const luxel_histogram *histogram,
                                  const luxel_color_bar *colors, const char *x_label, const char *y_label, double width,
                                  double height)
{
    struct lx_plot plot = {.box = {.width = width, .height = height}};
    if (!lx_can_draw(cairo, style, width, height) || !histogram_goes(histogram, &plot.x) ||
        (colors && !lx_bar_goes(colors)))
        return LUXEL_ERROR_ARGUMENT;
    struct lx_canvas canvas = lx_drawing_begin(cairo, style, width, height);
    plot.y = count_scale(histogram);
    plot.size = style->letters;
    if (lx_fit_plot(&canvas, &plot, x_label, y_label)) {
        lx_draw_axes(&canvas, &plot, x_label, y_label, true);
        draw_bins(histogram, colors, &canvas, &plot);
        draw_outline(histogram, &canvas, &plot);
    }
    return lx_drawing_end(&canvas);
}

luxel_status luxel_histogram_frame(const luxel_drawing_style *style, const luxel_histogram *histogram,
                                   const char *x_label, const char *y_label, double width, double height,
                                   luxel_plot_frame *frame)
{
    struct lx_plot plot = {.box = {.width = width, .height = height}};
    if (!lx_can_measure(style, width, height) || !histogram_goes(histogram, &plot.x) || !frame)
        return LUXEL_ERROR_ARGUMENT;
    struct lx_canvas canvas = lx_measuring_begin(style, width, height);
    plot.y = count_scale(histogram);
    plot.size = style->letters;
    const bool fits = lx_fit_plot(&canvas, &plot, x_label, y_label);
    *frame = lx_frame_of(&plot, fits);
    return lx_measuring_end(&canvas);
}
