/* SPDX-License-Identifier: MIT */
/* The colour bar: the scale's colours from low to high, its ticks, the levels, and what is beyond. */
#include <luxel/figure.h>
#include <math.h>

#include "parts.h"

/* Shares of the letters' size. */
static const double LINE = 0.06, WIDTH = 1.5, TICK = 0.35, GAP = 0.35, POINT = 1;

/* The colours as an image of one column, so that no file holds hundreds of rectangles with seams between them. */
static void draw_colors(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *box)
{
    enum { STEPS = 512 };
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, STEPS);
    if (cairo_surface_status(image) == CAIRO_STATUS_SUCCESS) {
        unsigned char *pixels = cairo_image_surface_get_data(image);
        for (int i = 0; i < STEPS; i++) {
            double t = 1 - (i + 0.5) / STEPS, color[3];
            if (bar->stepped) {
                double below = 0, above = 1;
                for (size_t k = 0; k < bar->level_count; k++) {
                    double place = lx_scale_place(&bar->scale, bar->levels[k]);
                    if (place <= t)
                        below = fmax(below, place);
                    else
                        above = fmin(above, place);
                }
                t = (below + above) / 2;
            }
            luxel_palette_color(bar->palette, t, color);
            uint32_t *line = (uint32_t *)(void *)(pixels + (size_t)i * (size_t)cairo_image_surface_get_stride(image));
            *line = (uint32_t)lround(255 * color[0]) << 16 | (uint32_t)lround(255 * color[1]) << 8 |
                    (uint32_t)lround(255 * color[2]);
        }
        cairo_surface_mark_dirty(image);
        cairo_save(canvas->cairo);
        cairo_translate(canvas->cairo, box->x, box->y);
        cairo_scale(canvas->cairo, box->width, box->height / STEPS);
        cairo_set_source_surface(canvas->cairo, image, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(canvas->cairo), CAIRO_FILTER_NEAREST);
        cairo_paint(canvas->cairo);
        cairo_restore(canvas->cairo);
    }
    cairo_surface_destroy(image);
}

/* The colours at the ends, which the points have, too. */
static void draw_ends(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *box, double size)
{
    for (int end = 0; end < 2; end++) {
        double color[3], half = box->height / 2 + POINT * size;
        luxel_palette_color(bar->palette, end, color);
        lx_color(canvas, color, 1);
        cairo_rectangle(canvas->cairo, box->x, end ? box->y - POINT * size : box->y + box->height / 2, box->width,
                        half);
        cairo_fill(canvas->cairo);
    }
}

/* The bar's edge, pointed at the ends that have values beyond them. */
static void trace_edge(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *box, double size)
{
    double point = POINT * size, middle = box->x + box->width / 2, bottom = box->y + box->height;
    cairo_t *cairo = canvas->cairo;
    cairo_move_to(cairo, box->x, box->y);
    if (bar->has_above)
        cairo_line_to(cairo, middle, box->y - point);
    cairo_line_to(cairo, box->x + box->width, box->y);
    cairo_line_to(cairo, box->x + box->width, bottom);
    if (bar->has_below)
        cairo_line_to(cairo, middle, bottom + point);
    cairo_line_to(cairo, box->x, bottom);
    cairo_close_path(cairo);
}

/* The levels of the isophotes that the map shows. */
static void draw_levels(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *box)
{
    for (size_t i = 0; bar->lined && i < bar->level_count; i++) {
        double t = lx_scale_place(&bar->scale, bar->levels[i]), color[3];
        if (!(t > 0 && t < 1))
            continue;
        luxel_palette_color(bar->palette, t, color);
        bool dark = lx_lightness(color) < 0.5;
        lx_color(canvas, dark ? (const double[]){0.97, 0.97, 0.97} : (const double[]){0.08, 0.08, 0.08}, 0.75);
        cairo_move_to(canvas->cairo, box->x, box->y + box->height * (1 - t));
        cairo_line_to(canvas->cairo, box->x + box->width, box->y + box->height * (1 - t));
        cairo_stroke(canvas->cairo);
    }
}

/* The ticks, and the room that their texts take across the bar. */
static struct lx_ticks bar_ticks(const struct lx_bar *bar, const struct lx_canvas *canvas, double length, double size,
                                 double *across)
{
    const struct lx_type type = {.size = size};
    struct lx_ticks ticks = lx_ticks_along(canvas, &bar->scale, length, size, !bar->lying, 9);
    *across = 0;
    for (size_t i = 0; i < ticks.count; i++) {
        struct lx_pane text = lx_measure(canvas, ticks.texts[i], &type);
        *across = fmax(*across, bar->lying ? text.height : text.width);
    }
    return ticks;
}

/* The label runs along the bar, wrapped where it is longer. */
static struct lx_type label_type(double length, double size)
{
    return (struct lx_type){.size = size, .wrap = fmax(length, 6 * size), .centered = true};
}

double lx_bar_room(const struct lx_bar *bar, const struct lx_canvas *canvas, double length, double size)
{
    const struct lx_type label = label_type(length, size);
    double across;
    bar_ticks(bar, canvas, length, size, &across);
    double room = (WIDTH + TICK + (bar->label ? 2 : 1) * GAP) * size + across;
    return room + (bar->label ? lx_measure(canvas, bar->label, &label).height : 0);
}

/* Upright; that of a bar which lies was turned a quarter clockwise, so its ticks' texts are turned back. */
static void draw_upright(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *place,
                         double size)
{
    const struct lx_type type = {.size = size}, label = label_type(place->height, size);
    struct lx_pane box = *place;
    double across, right = box.x + WIDTH * size;
    box.width = WIDTH * size;
    box.y += bar->has_above ? POINT * size : 0;
    box.height -= (bar->has_above + bar->has_below) * POINT * size;
    struct lx_ticks ticks = bar_ticks(bar, canvas, box.height, size, &across);
    cairo_save(canvas->cairo);
    trace_edge(bar, canvas, &box, size);
    cairo_clip(canvas->cairo);
    draw_ends(bar, canvas, &box, size);
    draw_colors(bar, canvas, &box);
    cairo_restore(canvas->cairo);
    cairo_set_line_width(canvas->cairo, LINE * size);
    draw_levels(bar, canvas, &box);
    lx_color(canvas, canvas->ink, 1);
    trace_edge(bar, canvas, &box, size);
    cairo_stroke(canvas->cairo);
    for (size_t i = 0; i < ticks.count; i++) {
        double y = box.y + box.height * (1 - lx_scale_place(&bar->scale, ticks.values[i]));
        lx_color(canvas, canvas->ink, 1);
        cairo_move_to(canvas->cairo, right, y);
        cairo_line_to(canvas->cairo, right + TICK * size, y);
        cairo_stroke(canvas->cairo);
        lx_write(canvas, ticks.texts[i], &type, right + (TICK + GAP) * size, y, bar->lying ? 0.5 : 0,
                 bar->lying ? 0 : 0.5, bar->lying ? -M_PI / 2 : 0);
    }
    if (bar->label)
        lx_write(canvas, bar->label, &label, right + (TICK + 2 * GAP) * size + across, place->y + place->height / 2,
                 0.5, 0, -M_PI / 2);
}

void lx_draw_bar(const struct lx_bar *bar, const struct lx_canvas *canvas, const struct lx_pane *place, double size)
{
    if (!bar->lying) {
        draw_upright(bar, canvas, place, size);
        return;
    }
    /* x runs down and y to the left */
    const struct lx_pane turned = {place->y, -(place->x + place->width), place->height, place->width};
    cairo_save(canvas->cairo);
    cairo_transform(canvas->cairo, &(cairo_matrix_t){.xx = 0, .yx = 1, .xy = -1, .yy = 0});
    draw_upright(bar, canvas, &turned, size);
    cairo_restore(canvas->cairo);
}
