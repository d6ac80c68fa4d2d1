/* SPDX-License-Identifier: MIT */
/* Curves of a profile: the whole as a bold line, each light's share as a line or on top of the others. */
#include <math.h>

#include "parts.h"

enum { COLORS = 10 };

/* Colours that keep apart for those who are colour-blind, too: the nearest two of them differ by ΔE 14 (CIE 1976) on a
 * light ground and 17 on a dark one, in protanopia, deuteranopia and tritanopia (G. M. Machado and others 2009). */
static const unsigned char on_light[COLORS][3] = {{201, 130, 24}, {16, 156, 229}, {20, 128, 90},  {200, 32, 146},
                                                  {68, 36, 163},  {161, 76, 13},  {104, 151, 81}, {106, 8, 9},
                                                  {62, 44, 91},   {158, 137, 137}};
static const unsigned char on_dark[COLORS][3] = {{238, 153, 24},  {154, 205, 255}, {92, 249, 194},  {235, 72, 171},
                                                 {106, 122, 248}, {205, 155, 122}, {240, 240, 120}, {232, 76, 62},
                                                 {148, 151, 230}, {148, 125, 125}};

void lx_light_color(const double ground[3], size_t light, double color[3])
{
    const bool is_dark = ground[0] + ground[1] + ground[2] < 1.5;
    for (int i = 0; i < 3; i++)
        color[i] = (is_dark ? on_dark : on_light)[light % COLORS][i] / 255.0;
}

void lx_light_line(const struct lx_canvas *canvas, size_t light, bool stacked, double size, double color[3])
{
    const size_t count = COLORS;
    const double dashes[][4] = {{0.7, 0.35, 0.7, 0.35}, {0.2, 0.25, 0.2, 0.25}, {0.9, 0.25, 0.2, 0.25}};
    double lengths[4];
    lx_light_color(canvas->ground, light, color);
    if (stacked) /* areas have no dashes: they become paler */
        for (int i = 0; i < 3; i++)
            color[i] += (canvas->ground[i] - color[i]) * fmin(0.15 + 0.3 * (double)(light / count), 0.75);
    for (int i = 0; i < 4; i++)
        lengths[i] = light < count ? 0 : size * dashes[(light / count - 1) % 3][i];
    cairo_set_dash(canvas->cairo, lengths, light < count || stacked ? 0 : 4, 0);
}

double lx_curves_place(const struct lx_curves *curves, size_t i)
{
    const luxel_profile_sample *sample = &curves->profile->samples[i];
    switch (curves->along) {
    case LX_ALONG_X: return sample->x_mm;
    case LX_ALONG_Y: return sample->y_mm;
    default: return sample->abscissa;
    }
}

static double share_of(const struct lx_curves *curves, size_t i, size_t light)
{
    return curves->profile->shares[i * curves->profile->lights + curves->lights[light]];
}

/* What a line shows at a sample: the whole, a share, or the sum of the shares up to one. */
static double value_of(const struct lx_curves *curves, size_t i, size_t light, bool sum)
{
    double value = 0;
    if (light == curves->light_count)
        return curves->profile->samples[i].value;
    for (size_t k = sum ? 0 : light; k <= light; k++)
        value += share_of(curves, i, k);
    return value;
}

static void draw_curve(const struct lx_curves *curves, const struct lx_canvas *canvas, const struct lx_plot *plot,
                       size_t light)
{
    const luxel_profile *profile = curves->profile;
    bool open = false;
    for (size_t i = 0; i < profile->count; i++) {
        bool has = profile->samples[i].has_value;
        if (has) {
            double x = lx_plot_x(plot, lx_curves_place(curves, i));
            double y = lx_plot_y(plot, value_of(curves, i, light, false));
            if (open)
                cairo_line_to(canvas->cairo, x, y);
            else
                cairo_move_to(canvas->cairo, x, y);
        }
        open = has;
    }
    cairo_stroke(canvas->cairo);
}

/* Between the sum up to this light and that before it, run by run of samples with a value. */
static void fill_share(const struct lx_curves *curves, const struct lx_canvas *canvas, const struct lx_plot *plot,
                       size_t light)
{
    const luxel_profile *profile = curves->profile;
    for (size_t first = 0; first < profile->count;) {
        size_t last = first;
        while (last < profile->count && profile->samples[last].has_value)
            last++;
        for (size_t i = first; i < last; i++)
            cairo_line_to(canvas->cairo, lx_plot_x(plot, lx_curves_place(curves, i)),
                          lx_plot_y(plot, value_of(curves, i, light, true)));
        for (size_t i = last; i > first; i--)
            cairo_line_to(canvas->cairo, lx_plot_x(plot, lx_curves_place(curves, i - 1)),
                          lx_plot_y(plot, light > 0 ? value_of(curves, i - 1, light - 1, true) : 0));
        cairo_close_path(canvas->cairo);
        cairo_fill(canvas->cairo);
        first = last + 1;
    }
}

void lx_draw_curves(const struct lx_curves *curves, const struct lx_canvas *canvas, const struct lx_plot *plot)
{
    size_t lights = curves->light_count > 1 ? curves->light_count : 0;
    cairo_t *cairo = canvas->cairo;
    cairo_save(cairo);
    cairo_rectangle(cairo, plot->box.x, plot->box.y, plot->box.width, plot->box.height);
    cairo_clip(cairo);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    for (size_t i = 0; i < lights && curves->stacked; i++) {
        double color[3];
        lx_light_line(canvas, i, true, plot->size, color);
        lx_color(canvas, color, 1);
        fill_share(curves, canvas, plot, i);
    }
    /* the whole below the thinner shares, which it would hide where one light gives all */
    cairo_set_dash(cairo, NULL, 0, 0);
    lx_color(canvas, canvas->ink, 1);
    cairo_set_line_width(cairo, (lights > 0 ? 0.26 : 0.18) * plot->size);
    draw_curve(curves, canvas, plot, curves->light_count);
    for (size_t i = 0; i < lights && !curves->stacked; i++) {
        double color[3];
        lx_light_line(canvas, i, false, plot->size, color);
        lx_color(canvas, color, 1);
        cairo_set_line_width(cairo, 0.12 * plot->size);
        draw_curve(curves, canvas, plot, i);
    }
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_restore(cairo);
}
