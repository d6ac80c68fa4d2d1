/* SPDX-License-Identifier: MIT */
/* The colour bar: the scale's colours from low to high, its ticks, the levels, and what is beyond. */
#include <math.h>

#include "figure.h"

static const double LINE = 0.06;

/* The colours as an image of one column, so that no file holds hundreds of rectangles with seams between them. */
static void draw_colors(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_box *box)
{
    enum { STEPS = 512 };
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, STEPS);
    if (cairo_surface_status(image) == CAIRO_STATUS_SUCCESS) {
        unsigned char *pixels = cairo_image_surface_get_data(image);
        for (int i = 0; i < STEPS; i++) {
            double t = 1 - (i + 0.5) / STEPS, color[3];
            if (figure->settings.bands == LUXEL_BANDS) {
                double below = 0, above = 1;
                for (size_t k = 0; k < figure->level_count; k++) {
                    double place = lx_scale_place(&figure->scale, figure->levels[k]);
                    if (place <= t)
                        below = fmax(below, place);
                    else
                        above = fmin(above, place);
                }
                t = (below + above) / 2;
            }
            luxel_palette_color(figure->settings.palette, t, color);
            uint32_t *line = (uint32_t *)(void *)(pixels + (size_t)i * (size_t)cairo_image_surface_get_stride(image));
            *line = (uint32_t)lround(255 * color[0]) << 16 | (uint32_t)lround(255 * color[1]) << 8 |
                    (uint32_t)lround(255 * color[2]);
        }
        cairo_surface_mark_dirty(image);
        cairo_save(canvas->cairo);
        cairo_rectangle(canvas->cairo, box->x, box->y, box->width, box->height);
        cairo_clip(canvas->cairo);
        cairo_translate(canvas->cairo, box->x, box->y);
        cairo_scale(canvas->cairo, box->width, box->height / STEPS);
        cairo_set_source_surface(canvas->cairo, image, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(canvas->cairo), CAIRO_FILTER_NEAREST);
        cairo_pattern_set_extend(cairo_get_source(canvas->cairo), CAIRO_EXTEND_PAD);
        cairo_paint(canvas->cairo);
        cairo_restore(canvas->cairo);
    }
    cairo_surface_destroy(image);
}

void lx_draw_bar(const struct lx_figure *figure, const struct lx_canvas *canvas, const struct lx_box *box, double size)
{
    const struct lx_type type = {.size = size};
    struct lx_ticks ticks;
    double height = lx_measure(canvas, "0", &type).height, widest = 0, right = box->x + box->width;
    draw_colors(figure, canvas, box);
    cairo_set_line_width(canvas->cairo, LINE * size);
    lx_color(canvas, canvas->ink, 1);
    cairo_rectangle(canvas->cairo, box->x, box->y, box->width, box->height);
    cairo_stroke(canvas->cairo);
    for (size_t wanted = 9;; wanted--) {
        ticks = lx_ticks_of(&figure->scale, wanted);
        if (wanted == 1 || 1.5 * height * (double)ticks.count <= box->height)
            break;
    }
    for (size_t i = 0; i < ticks.count; i++) {
        double y = box->y + box->height * (1 - lx_scale_place(&figure->scale, ticks.values[i]));
        lx_color(canvas, canvas->ink, 1);
        cairo_move_to(canvas->cairo, right, y);
        cairo_line_to(canvas->cairo, right + 0.35 * size, y);
        cairo_stroke(canvas->cairo);
        lx_write(canvas, ticks.texts[i], &type, right + 0.7 * size, y, 0, 0.5, 0);
        widest = fmax(widest, lx_measure(canvas, ticks.texts[i], &type).width);
    }
    for (size_t i = 0; figure->isophotes && i < figure->level_count; i++) {
        double t = lx_scale_place(&figure->scale, figure->levels[i]), color[3];
        if (!(t > 0 && t < 1))
            continue;
        luxel_palette_color(figure->settings.palette, t, color);
        bool dark = 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2] < 0.5;
        lx_color(canvas, dark ? (const double[]){0.97, 0.97, 0.97} : (const double[]){0.08, 0.08, 0.08}, 0.75);
        cairo_move_to(canvas->cairo, box->x, box->y + box->height * (1 - t));
        cairo_line_to(canvas->cairo, right, box->y + box->height * (1 - t));
        cairo_stroke(canvas->cairo);
    }
    lx_write(canvas, figure->label, &type, right + 1.05 * size + widest, box->y + box->height / 2, 0.5, 0, -M_PI / 2);
}
