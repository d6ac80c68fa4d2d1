/* SPDX-License-Identifier: MIT */
/*
 * Cone diagrams: how wide the beam, up to half of the greatest intensity, is from 1 to 5 m away along the axis, and the
 * illuminance there in its middle.
 */
#include <math.h>

#include "../base/number.h"
#include "../base/phrase.h"
#include "axes.h"
#include "diagram.h"

enum { STEPS = 5, COLUMNS = 4 };

static const double DEGREE = 0.017453292519943295;

/* A row of the table beside the cone: three digits each, a dash where there is no number. */
static void write_cells(const struct lx_canvas *canvas, const double *numbers, const double *columns, double y,
                        double size)
{
    const struct lx_type type = {.size = size};
    for (int i = 0; i < COLUMNS; i++) {
        char text[LX_NUMBER_SIZE];
        lx_write(canvas, isfinite(numbers[i]) ? lx_write_digits(numbers[i], 3, text) : "–", &type, columns[i], y, 1,
                 0.5, 0);
    }
}

/* The diameter of a beam at a distance; none where it is not below the luminaire alone. */
static double diameter(double beam_deg, double distance)
{
    return beam_deg < 180 ? 2 * distance * tan(0.5 * beam_deg * DEGREE) : (double)NAN;
}

static void write_heads(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const double *columns,
                        double y, double size)
{
    const struct lx_type type = {.size = size};
    bool is_turn = diagram->photometry->type == LUXEL_PHOTOMETRY_TYPE_C;
    lx_write(canvas, lx_diagram_word(diagram, LX_N("d, m")), &type, columns[0], y, 1, 0, 0);
    lx_write(canvas, is_turn ? "C0–C180" : lx_section_name(diagram, 0), &type, columns[1], y, 1, 0, 0);
    lx_write(canvas, is_turn ? "C90–C270" : lx_section_name(diagram, 1), &type, columns[2], y, 1, 0, 0);
    lx_write(canvas, lx_diagram_word(diagram, LX_N("lx")), &type, columns[3], y, 1, 0, 0);
}

/* The cone with a line at each distance; a beam wider than there is room for is drawn as wide as that. */
static void draw_beam(const struct lx_canvas *canvas, const struct lx_pane *box, double beam_deg, double size)
{
    cairo_t *cairo = canvas->cairo;
    double x = box->x + box->width / 2, half = fmin(0.5 * box->width, box->height * tan(0.5 * beam_deg * DEGREE));
    cairo_move_to(cairo, x, box->y);
    cairo_line_to(cairo, x - half, box->y + box->height);
    cairo_line_to(cairo, x + half, box->y + box->height);
    cairo_close_path(cairo);
    lx_curve_color(canvas, 0, 0.25);
    cairo_fill(cairo);
    lx_curve_line(canvas, 0, size);
    cairo_set_line_width(cairo, 0.08 * size);
    for (int i = 1; i <= STEPS; i++) {
        double share = (double)i / STEPS, y = box->y + box->height * share;
        lx_color(canvas, canvas->ink, 1);
        cairo_move_to(cairo, x - half * share, y);
        cairo_line_to(cairo, x + half * share, y);
        cairo_stroke(cairo);
    }
}

double lx_draw_cone(const struct lx_diagram *diagram, const struct lx_canvas *canvas, const struct lx_pane *place,
                    double size, bool drawn)
{
    const luxel_photometry_figures *figures = &diagram->figures;
    const struct lx_type small = {.size = size, .wrap = place->width, .color = canvas->faint};
    const char *print = lx_diagram_word(diagram, LX_N("distance, diameters of the beam (50 %) in m, illuminance in the "
                                                      "middle"));
    double line = lx_measure(canvas, "0", &small).height, height = 0.6 * place->width;
    struct lx_pane cone = {.x = place->x, .y = place->y + 1.5 * line, .width = 0.42 * place->width, .height = height};
    double columns[COLUMNS], end = cone.y + height + line;
    for (int i = 0; i < COLUMNS; i++)
        columns[i] = place->x + place->width * (0.53 + 0.155 * i);
    if (!drawn)
        return end + lx_measure(canvas, print, &small).height;
    double middle = luxel_photometry_intensity(diagram->photometry, LUXEL_INTERPOLATE_ANGLE, 0, 0);
    draw_beam(canvas, &cone, isfinite(figures->beam_deg) ? fmin(figures->beam_deg, 180) : 0, size);
    write_heads(diagram, canvas, columns, place->y, size);
    for (int i = 1; i <= STEPS; i++) {
        const double numbers[COLUMNS] = {i, diameter(figures->beam_sections_deg[0], i),
                                         diameter(figures->beam_sections_deg[1], i), middle / (i * i)};
        write_cells(canvas, numbers, columns, cone.y + height * i / STEPS, size);
    }
    lx_write(canvas, print, &small, place->x, end, 0, 0, 0);
    return end + lx_measure(canvas, print, &small).height;
}
