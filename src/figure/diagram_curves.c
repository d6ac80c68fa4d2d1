/* SPDX-License-Identifier: MIT */
/* Polar and Cartesian diagrams of a luminaire's sections. */
#include <math.h>
#include <stdio.h>

#include "../base/phrase.h"
#include "axes.h"
#include "diagram.h"
#include "drawing.h"

static const double DEGREE = 0.017453292519943295;

/* ---- polar ---- */

/* The net of a polar diagram: its middle, its radius, and what that stands for. */
struct net {
    double x, y, radius, top, step;
    bool has_above, has_below; /* whether there is light in these half spaces */
};

static bool has_light(const struct lx_diagram *diagram, bool is_above)
{
    for (int i = 0; i < 2; i++)
        for (size_t k = 0; k < diagram->sections[i].count; k++) {
            double angle = fabs(diagram->sections[i].angles_deg[k]);
            if ((is_above ? angle > 90 : angle < 90) && diagram->sections[i].values[k] > 0.002 * diagram->greatest)
                return true;
        }
    return false;
}

/* Round steps of the circles, the last of them at or beyond the greatest value. */
static void choose_circles(const struct lx_diagram *diagram, struct net *net)
{
    const struct lx_scale scale = {.low = 0, .high = diagram->greatest > 0 ? diagram->greatest : 1};
    const struct lx_ticks ticks = lx_ticks_of(&scale, 5);
    net->step = ticks.count > 1 ? ticks.values[1] - ticks.values[0] : scale.high;
    net->top = net->step * ceil(scale.high / net->step * (1 - 1e-9));
}

static void draw_ray(const struct lx_canvas *canvas, const struct net *net, int angle, double size)
{
    const struct lx_type type = {.size = size};
    double across = sin(angle * DEGREE), down = cos(angle * DEGREE);
    char text[16];
    snprintf(text, sizeof text, "%d°", angle > 180 ? 360 - angle : angle);
    cairo_move_to(canvas->cairo, net->x, net->y);
    cairo_line_to(canvas->cairo, net->x + net->radius * across, net->y + net->radius * down);
    cairo_stroke(canvas->cairo);
    double beyond = net->radius + 0.4 * size;
    lx_write(canvas, text, &type, net->x + beyond * across, net->y + beyond * down, 0.5 - 0.5 * across,
             0.5 - 0.5 * down, 0);
}

static void draw_net(const struct lx_canvas *canvas, const struct net *net, double size)
{
    cairo_t *cairo = canvas->cairo;
    double from = net->has_below ? 0 : M_PI, to = net->has_above ? 2 * M_PI : M_PI;
    cairo_set_line_width(cairo, 0.06 * size);
    for (double value = net->step; value <= net->top * (1 + 1e-9); value += net->step) {
        lx_color(canvas, canvas->faint, 0.5);
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, net->x, net->y, net->radius * value / net->top, from, to);
        cairo_stroke(cairo);
    }
    for (int angle = 0; angle < 360; angle += 30) {
        bool is_above = angle > 90 && angle < 270, is_level = angle == 90 || angle == 270;
        lx_color(canvas, canvas->faint, 0.5);
        if (is_level || (is_above ? net->has_above : net->has_below))
            draw_ray(canvas, net, angle, size);
    }
}

/* The values of the circles, on top of everything else. */
static void draw_values(const struct lx_canvas *canvas, const struct net *net, double size)
{
    const struct lx_type type = {.size = 0.9 * size, .halo = canvas->ground};
    double way = net->has_below ? 1 : -1;
    char text[LX_TICK_TEXT];
    for (double value = net->step; value <= net->top * (1 + 1e-9); value += net->step)
        lx_write(canvas, lx_tick_text(value, text), &type, net->x + 0.2 * size,
                 net->y + way * net->radius * value / net->top, 0, way > 0 ? 1 : 0, 0);
}

/* A section, in small steps, as a straight line over angles is none around a pole. */
static void draw_section(const struct lx_canvas *canvas, const struct net *net, const struct lx_section *section)
{
    enum { STEP = 2 };
    for (size_t i = 0; i + 1 < section->count; i++) {
        double from = section->angles_deg[i], to = section->angles_deg[i + 1];
        int parts = 1 + (int)((to - from) / STEP);
        for (int k = i == 0 ? 0 : 1; k <= parts; k++) {
            double share = (double)k / parts, angle = (from + share * (to - from)) * DEGREE;
            double value = section->values[i] + share * (section->values[i + 1] - section->values[i]);
            double radius = net->radius * value / net->top;
            cairo_line_to(canvas->cairo, net->x + radius * sin(angle), net->y + radius * cos(angle));
        }
    }
    cairo_stroke(canvas->cairo);
}

double lx_draw_polar(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                     double size, bool drawn)
{
    const struct lx_type type = {.size = size};
    const struct lx_pane angle = lx_measure(canvas, "120°", &type);
    const char *const names[] = {lx_section_name(diagram, 0), lx_section_name(diagram, 1)};
    struct net net = {.has_above = has_light(diagram, true)};
    net.has_below = has_light(diagram, false) || !net.has_above;
    choose_circles(diagram, &net);
    net.radius = place->width / 2 - angle.width - 0.4 * size;
    net.x = place->x + place->width / 2;
    net.y = place->y + angle.height / 2 + (net.has_above ? net.radius + angle.height : 0);
    double end = net.y + (net.has_below ? net.radius + angle.height : angle.height / 2) + size;
    if (drawn) {
        draw_net(canvas, &net, size);
        for (int i = diagram->is_axial ? 0 : 1; i >= 0; i--) {
            lx_curve_line(canvas, (size_t)i, size);
            draw_section(canvas, &net, &diagram->sections[i]);
        }
        cairo_set_dash(canvas->cairo, NULL, 0, 0);
        draw_values(canvas, &net, size);
        lx_write(canvas, lx_diagram_word(diagram, diagram->unit), &type, place->x + place->width, end, 1, 0, 0);
    }
    const struct lx_pane below = {.x = place->x, .y = end, .width = place->width - 5 * size};
    return lx_draw_names(canvas, &below, size, names, (const size_t[]){0, 1}, diagram->is_axial ? 1 : 2, drawn);
}

/* ---- Cartesian ---- */

/* The curves of a Cartesian diagram: sections, of type C each half on its own where they differ. */
struct curves {
    int sections[4];
    bool is_turned[4]; /* the half below 0, turned over */
    const char *names[4];
    size_t count;
};

static bool has_equal_halves(const struct lx_section *section, double greatest)
{
    for (size_t i = 0, k = section->count - 1; i < k; i++, k--)
        if (fabs(section->values[i] - section->values[k]) > 1e-6 * greatest)
            return false;
    return true;
}

static struct curves choose_curves(const struct lx_diagram *diagram)
{
    static const char *const halves[2][2] = {{"C0", "C180"}, {"C90", "C270"}}, *const both[] = {"C0, C180",
                                                                                                "C90, C270"};
    struct curves curves = {.count = 0};
    bool is_turn = diagram->photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    for (int i = 0; i < (diagram->is_axial ? 1 : 2); i++) {
        bool is_one = !is_turn || has_equal_halves(&diagram->sections[i], diagram->greatest);
        for (int half = 0; half < (is_one ? 1 : 2); half++) {
            curves.sections[curves.count] = i;
            curves.is_turned[curves.count] = half == 1;
            curves.names[curves.count++] = diagram->is_axial || !is_turn ? lx_section_name(diagram, i)
                                           : is_one                      ? both[i]
                                                                         : halves[i][half];
        }
    }
    return curves;
}

static void draw_curve(const struct lx_canvas *canvas, const struct lx_plot *plot, const struct lx_section *section,
                       bool is_turned)
{
    for (size_t n = 0; n < section->count; n++) {
        size_t i = is_turned ? section->count - 1 - n : n;
        double angle = is_turned ? -section->angles_deg[i] : section->angles_deg[i];
        if (angle >= plot->x.low && angle <= plot->x.high)
            cairo_line_to(canvas->cairo, lx_plot_x(plot, angle), lx_plot_y(plot, section->values[i]));
    }
    cairo_stroke(canvas->cairo);
}

double lx_draw_cartesian(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                         double size, bool drawn)
{
    static const size_t all[] = {0, 1, 2, 3};
    bool is_turn = diagram->photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    const struct curves curves = choose_curves(diagram);
    double height = 0.62 * place->width, most = has_light(diagram, true) ? 180 : 90;
    struct lx_plot plot = {.box = {.x = place->x, .y = place->y, .width = place->width, .height = height},
                           .x = {.low = is_turn ? 0 : -most, .high = most},
                           .y = {.low = 0, .high = diagram->greatest > 0 ? 1.06 * diagram->greatest : 1},
                           .size = size};
    const char *x_label = lx_diagram_word(diagram, is_turn ? LX_N("gamma, degrees") : LX_N("angle, degrees"));
    const char *y_label = lx_diagram_word(diagram, diagram->unit);
    if (drawn && lx_fit_plot(canvas, &plot, x_label, y_label)) {
        lx_draw_axes(canvas, &plot, x_label, y_label, true);
        for (size_t i = curves.count; i-- > 0;) {
            lx_curve_line(canvas, i, size);
            draw_curve(canvas, &plot, &diagram->sections[curves.sections[i]], curves.is_turned[i]);
        }
        cairo_set_dash(canvas->cairo, NULL, 0, 0);
    }
    const struct lx_pane below = {.x = place->x, .y = place->y + height + 0.6 * size, .width = place->width};
    return lx_draw_names(canvas, &below, size, curves.names, all, curves.count, drawn);
}
