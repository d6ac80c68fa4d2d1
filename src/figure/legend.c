/* SPDX-License-Identifier: MIT */
/* The legend of curves: a row of names with their lines or patches, wrapped. */
#include <math.h>
#include <string.h>

#include "parts.h"

/* A name with its line or patch; returns its height, and how wide it is with what keeps it apart. */
static double draw_name(const struct lx_legend *legend, const struct lx_canvas *canvas, double width, double size,
                        size_t light, struct lx_pane *box, bool drawn)
{
    bool whole = light == legend->count;
    const char *name = whole ? legend->whole : legend->names[light];
    struct lx_type type = {.size = size, .wrap = width - 2 * size};
    struct lx_pane text = lx_measure(canvas, name, &type);
    double line = lx_measure(canvas, "0", &type).height, y = box->y + line / 2, color[3];
    box->width = text.width + 2 * size;
    box->height = text.height;
    if (!drawn)
        return text.height;
    memcpy(color, canvas->ink, sizeof color);
    if (!whole)
        lx_light_line(canvas, light, legend->stacked, size, color);
    lx_color(canvas, color, 1);
    cairo_set_line_width(canvas->cairo, (whole ? 0.26 : legend->stacked ? 0.8 : 0.16) * size);
    cairo_move_to(canvas->cairo, box->x, y);
    cairo_line_to(canvas->cairo, box->x + 1.6 * size, y);
    cairo_stroke(canvas->cairo);
    cairo_set_dash(canvas->cairo, NULL, 0, 0);
    lx_write(canvas, name, &type, box->x + 2 * size, box->y, 0, 0, 0);
    return text.height;
}

double lx_draw_legend(const struct lx_legend *legend, const struct lx_canvas *canvas, const struct lx_pane *place,
                      double size, bool drawn)
{
    struct lx_pane box = {.x = place->x, .y = place->y};
    double row = 0;
    if (legend->count < 2)
        return place->y;
    for (size_t i = 0; i <= legend->count; i++) {
        double height = draw_name(legend, canvas, place->width, size, i, &box, false);
        if (box.x > place->x && box.x + box.width > place->x + place->width) {
            box.x = place->x;
            box.y += 1.2 * row;
            row = 0;
        }
        row = fmax(row, height);
        draw_name(legend, canvas, place->width, size, i, &box, drawn);
        box.x += box.width + 1.4 * size;
    }
    return box.y + 1.2 * row;
}
