/* SPDX-License-Identifier: MIT */
/* Ticks, labels and frames. */
#include "axes.h"

#include <luxel/isophotes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../base/number.h"

static const double TICK = 0.35, GAP = 0.35, LINE = 0.06; /* of the letters' size */

double lx_scale_place(const struct lx_scale *scale, double value)
{
    if (scale->logarithmic)
        return value > 0 ? log(value / scale->low) / log(scale->high / scale->low) : -1;
    return (value - scale->low) / (scale->high - scale->low);
}

const char *lx_tick_text(double value, char buffer[LX_TICK_TEXT])
{
    char number[LX_NUMBER_SIZE];
    const char *at = lx_write_digits(value == 0 ? 0 : value, 6, number);
    size_t used = 0;
    /* a true minus sign, as wide as a plus */
    for (; *at && used + 4 < LX_TICK_TEXT; at++)
        used += (size_t)snprintf(buffer + used, LX_TICK_TEXT - used, *at == '-' ? "−" : "%c", *at);
    buffer[used] = '\0';
    return buffer;
}

/* Ticks the other way round. */
static struct lx_ticks turn(const struct lx_ticks ticks)
{
    struct lx_ticks turned = {.count = ticks.count};
    for (size_t i = 0; i < ticks.count; i++) {
        turned.values[i] = ticks.values[ticks.count - 1 - i];
        memcpy(turned.texts[i], ticks.texts[ticks.count - 1 - i], sizeof turned.texts[i]);
    }
    return turned;
}

struct lx_ticks lx_ticks_of(const struct lx_scale *scale, size_t wanted)
{
    struct lx_ticks ticks = {.count = 0};
    double beyond = 1e-9 * (scale->high - scale->low);
    if (scale->high < scale->low) {
        const struct lx_scale turned = {.low = scale->high, .high = scale->low};
        return turn(lx_ticks_of(&turned, wanted));
    }
    double low = scale->logarithmic ? scale->low * (1 - 1e-9) : scale->low - beyond;
    double high = scale->logarithmic ? scale->high * (1 + 1e-9) : scale->high + beyond;
    ticks.count = luxel_round_levels(low, high, scale->logarithmic, wanted, ticks.values, LX_MOST_TICKS);
    for (size_t i = 0; i < ticks.count; i++) {
        if (fabs(ticks.values[i]) < 1e-12 * (scale->high - scale->low) && !scale->logarithmic)
            ticks.values[i] = 0;
        lx_tick_text(ticks.values[i], ticks.texts[i]);
    }
    return ticks;
}

double lx_plot_x(const struct lx_plot *plot, double value)
{
    return plot->box.x + plot->box.width * lx_scale_place(&plot->x, value);
}

double lx_plot_y(const struct lx_plot *plot, double value)
{
    return plot->box.y + plot->box.height * (1 - lx_scale_place(&plot->y, value));
}

/* Whether ticks stand apart: along x by the widths of their labels, along y by their height. */
static bool stand_apart(const struct lx_canvas *canvas, const struct lx_ticks *ticks, const struct lx_scale *scale,
                        double length, double size, bool upright)
{
    const struct lx_type type = {.size = size};
    double end = -HUGE_VAL;
    for (size_t i = 0; i < ticks->count; i++) {
        struct lx_pane text = lx_measure(canvas, ticks->texts[i], &type);
        double half = (upright ? text.height : text.width) / 2;
        double at = length * lx_scale_place(scale, ticks->values[i]);
        if (at - half < end)
            return false;
        end = at + half + (upright ? 0.3 : 0.9) * size;
    }
    return true;
}

/* Ticks with the canvas's mark in front of fractions. */
static struct lx_ticks marked_ticks(const struct lx_canvas *canvas, const struct lx_scale *scale, size_t wanted)
{
    struct lx_ticks ticks = lx_ticks_of(scale, wanted);
    for (size_t i = 0; i < ticks.count; i++) {
        char *point = strchr(ticks.texts[i], '.');
        if (point)
            *point = canvas->decimal_mark;
    }
    return ticks;
}

struct lx_ticks lx_ticks_along(const struct lx_canvas *canvas, const struct lx_scale *scale, double length, double size,
                               bool upright, size_t most)
{
    struct lx_ticks ticks = {.count = 0};
    for (size_t wanted = most; wanted > 0; wanted--) {
        ticks = marked_ticks(canvas, scale, wanted);
        if (stand_apart(canvas, &ticks, scale, length, size, upright))
            break;
    }
    /* where not even those do, the first is left alone */
    if (!stand_apart(canvas, &ticks, scale, length, size, upright))
        ticks.count = 1;
    return ticks;
}

/* A label along an axis, which is not longer than that, nor shorter than a word. */
static struct lx_type label_type(const struct lx_plot *plot, double length)
{
    return (struct lx_type){.size = plot->size, .wrap = fmax(length, 6 * plot->size), .centered = true};
}

struct lx_margins lx_plot_margins(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *x_label,
                                  const char *y_label)
{
    const struct lx_type type = {.size = plot->size}, label = label_type(plot, plot->box.height);
    struct lx_ticks ticks = lx_ticks_along(canvas, &plot->y, plot->box.height, plot->size, true, 7);
    double widest = 0, height = lx_measure(canvas, "0", &type).height;
    for (size_t i = 0; i < ticks.count; i++)
        widest = fmax(widest, lx_measure(canvas, ticks.texts[i], &type).width);
    ticks = lx_ticks_along(canvas, &plot->x, plot->box.width, plot->size, false, 7);
    return (struct lx_margins){
        .left = widest + (TICK + 2 * GAP) * plot->size + (y_label ? lx_measure(canvas, y_label, &label).height : 0),
        .right = ticks.count > 0 ? lx_measure(canvas, ticks.texts[ticks.count - 1], &type).width / 2 : 0,
        .above = height / 2,
        .below = (TICK + GAP) * plot->size + (x_label ? 2.1 : 1) * height};
}

static void line(const struct lx_canvas *canvas, double x1, double y1, double x2, double y2)
{
    cairo_move_to(canvas->cairo, x1, y1);
    cairo_line_to(canvas->cairo, x2, y2);
    cairo_stroke(canvas->cairo);
}

static void draw_x(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *label, bool grid)
{
    const struct lx_type type = {.size = plot->size};
    const struct lx_pane *box = &plot->box;
    struct lx_ticks ticks = lx_ticks_along(canvas, &plot->x, box->width, plot->size, false, 7);
    double bottom = box->y + box->height, below = bottom + (TICK + GAP) * plot->size;
    for (size_t i = 0; i < ticks.count; i++) {
        double x = lx_plot_x(plot, ticks.values[i]);
        if (grid) {
            lx_color(canvas, canvas->faint, 0.18);
            line(canvas, x, box->y, x, bottom);
        }
        lx_color(canvas, canvas->ink, 1);
        line(canvas, x, bottom, x, bottom + TICK * plot->size);
        lx_write(canvas, ticks.texts[i], &type, x, below, 0.5, 0, 0);
    }
    double height = lx_measure(canvas, "0", &type).height;
    if (label)
        lx_write(canvas, label, &type, box->x + box->width / 2, below + 1.1 * height, 0.5, 0, 0);
}

static void draw_y(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *label, bool grid)
{
    const struct lx_type type = {.size = plot->size};
    const struct lx_pane *box = &plot->box;
    struct lx_ticks ticks = lx_ticks_along(canvas, &plot->y, box->height, plot->size, true, 7);
    double right = box->x - (TICK + GAP) * plot->size, widest = 0;
    for (size_t i = 0; i < ticks.count; i++) {
        double y = lx_plot_y(plot, ticks.values[i]);
        if (grid) {
            lx_color(canvas, canvas->faint, 0.18);
            line(canvas, box->x, y, box->x + box->width, y);
        }
        lx_color(canvas, canvas->ink, 1);
        line(canvas, box->x - TICK * plot->size, y, box->x, y);
        lx_write(canvas, ticks.texts[i], &type, right, y, 1, 0.5, 0);
        widest = fmax(widest, lx_measure(canvas, ticks.texts[i], &type).width);
    }
    const struct lx_type along = label_type(plot, box->height);
    if (label)
        lx_write(canvas, label, &along, right - widest - GAP * plot->size, box->y + box->height / 2, 0.5, 1, -M_PI / 2);
}

void lx_draw_axes(const struct lx_canvas *canvas, const struct lx_plot *plot, const char *x_label, const char *y_label,
                  bool grid)
{
    cairo_set_line_width(canvas->cairo, LINE * plot->size);
    draw_x(canvas, plot, x_label, grid);
    draw_y(canvas, plot, y_label, grid);
    lx_color(canvas, canvas->ink, 1);
    cairo_rectangle(canvas->cairo, plot->box.x, plot->box.y, plot->box.width, plot->box.height);
    cairo_stroke(canvas->cairo);
}
