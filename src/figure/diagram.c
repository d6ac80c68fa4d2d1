/* SPDX-License-Identifier: MIT */
/* Diagrams of luminaires: their sections and unit, title and file. */
#include "diagram.h"

#include <math.h>
#include <stdlib.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "../base/phrase.h"
#include "sheet.h"

void luxel_diagram_settings_init(luxel_diagram_settings *settings)
{
    *settings = (luxel_diagram_settings){.width_mm = 160, .dots_per_inch = 200};
}

const char *lx_diagram_word(const struct lx_diagram *diagram, const char *english)
{
    const luxel_language *language = diagram->settings.language;
    return language && language->translate ? language->translate(english, language->data) : english;
}

const char *lx_section_name(const struct lx_diagram *diagram, int which)
{
    if (diagram->is_axial)
        return lx_diagram_word(diagram, LX_N("all planes"));
    if (diagram->photometry->type == LUXEL_PHOTOMETRY_TYPE_C)
        return which == 0 ? "C0–C180" : "C90–C270";
    return lx_diagram_word(diagram, which == 0 ? LX_N("horizontal") : LX_N("vertical"));
}

void lx_curve_color(const struct lx_canvas *canvas, size_t curve, double opacity)
{
    static const double colors[][3] = {{0.84, 0.37, 0}, {0, 0.45, 0.70}, {0, 0.62, 0.45}, {0.80, 0.47, 0.65}};
    lx_color(canvas, colors[curve % 4], opacity);
}

void lx_curve_line(const struct lx_canvas *canvas, size_t curve, double size)
{
    const double dashes[] = {0.7 * size, 0.35 * size};
    cairo_set_dash(canvas->cairo, dashes, curve % 2 == 1 ? 2 : 0, 0);
    cairo_set_line_width(canvas->cairo, 0.16 * size);
    cairo_set_line_join(canvas->cairo, CAIRO_LINE_JOIN_ROUND);
    lx_curve_color(canvas, curve, 1);
}

double lx_draw_names(const struct lx_canvas *canvas, const struct lx_pane *place, double size, const char *const *names,
                     const size_t *curves, size_t count, bool drawn)
{
    const struct lx_type type = {.size = size};
    double x = place->x, y = place->y, height = lx_measure(canvas, "0", &type).height;
    for (size_t i = 0; i < count; i++) {
        double width = lx_measure(canvas, names[i], &type).width + 3.4 * size;
        if (x > place->x && x + width > place->x + place->width) {
            x = place->x;
            y += 1.2 * height;
        }
        if (drawn) {
            lx_curve_line(canvas, curves[i], size);
            cairo_move_to(canvas->cairo, x, y + height / 2);
            cairo_line_to(canvas->cairo, x + 2 * size, y + height / 2);
            cairo_stroke(canvas->cairo);
            cairo_set_dash(canvas->cairo, NULL, 0, 0);
            lx_write(canvas, names[i], &type, x + 2.4 * size, y, 0, 0, 0);
        }
        x += width + size;
    }
    return y + 1.2 * height;
}

/* ---- making ---- */

static bool are_same(const struct lx_section *a, const struct lx_section *b, double greatest)
{
    if (a->count != b->count)
        return false;
    for (size_t i = 0; i < a->count; i++)
        if (a->angles_deg[i] != b->angles_deg[i] || fabs(a->values[i] - b->values[i]) > 1e-6 * greatest)
            return false;
    return true;
}

static bool take_sections(struct lx_diagram *diagram)
{
    const luxel_photometry *photometry = diagram->photometry;
    bool is_relative = !photometry->is_absolute && photometry->declared_lumens > 0;
    double factor = is_relative ? 1000 / photometry->declared_lumens : 1;
    diagram->unit = is_relative ? LX_N("cd/klm") : LX_N("cd");
    for (int i = 0; i < 2; i++) {
        struct lx_section *section = &diagram->sections[i];
        if (!lx_section_of(photometry, 90.0 * i, section))
            return false;
        for (size_t k = 0; k < section->count; k++) {
            section->values[k] *= factor;
            diagram->greatest = fmax(diagram->greatest, section->values[k]);
        }
    }
    diagram->is_axial = photometry->type == LUXEL_PHOTOMETRY_TYPE_C &&
                        are_same(&diagram->sections[0], &diagram->sections[1], diagram->greatest) &&
                        photometry->symmetry == LUXEL_SYMMETRY_AXIAL;
    return true;
}

static double draw(const void *what, cairo_t *cairo, double width)
{
    const struct lx_diagram *diagram = what;
    cairo_surface_t *nowhere = cairo ? NULL : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *context = cairo ? cairo : cairo_create(nowhere); /* measuring needs fonts, too */
    struct lx_canvas canvas = lx_canvas_of(context, diagram->settings.dark);
    double size = fmin(fmax(width / 40, 6), 12), margin = size;
    struct lx_pane place = {.x = margin, .y = margin, .width = width - 2 * margin};
    struct lx_type type = {.size = 1.2 * size, .bold = true, .wrap = place.width};
    const char *title = diagram->settings.title;
    if (title && *title) {
        if (cairo)
            lx_write(&canvas, title, &type, place.x, place.y, 0, 0, 0);
        place.y += lx_measure(&canvas, title, &type).height + size;
    }
    double end = diagram->settings.diagram == LUXEL_DIAGRAM_POLAR
                     ? lx_draw_polar(diagram, &canvas, &place, size, cairo != NULL)
                 : diagram->settings.diagram == LUXEL_DIAGRAM_CARTESIAN
                     ? lx_draw_cartesian(diagram, &canvas, &place, size, cairo != NULL)
                     : lx_draw_cone(diagram, &canvas, &place, size, cairo != NULL);
    lx_canvas_clear(&canvas);
    if (!cairo) {
        cairo_destroy(context);
        cairo_surface_destroy(nowhere);
    }
    return end + margin;
}

static luxel_status check_settings(const luxel_diagram_settings *settings, luxel_diagnostics *diagnostics)
{
    if (!(settings->width_mm >= 40 && settings->width_mm <= 1000))
        return lx_setting_out_of_range(diagnostics, "width_mm", settings->width_mm, LX_N("40 to 1000 mm"));
    if (!(settings->dots_per_inch >= 30 && settings->dots_per_inch <= 2400))
        return lx_setting_out_of_range(diagnostics, "dots_per_inch", settings->dots_per_inch, LX_N("30 to 2400"));
    if (settings->diagram > LUXEL_DIAGRAM_CONE)
        return LUXEL_ERROR_ARGUMENT;
    if (settings->language && LX_CHECK_RESERVE(settings->language, diagnostics) != LUXEL_OK)
        return LUXEL_ERROR_ARGUMENT;
    return LX_CHECK_RESERVE(settings, diagnostics);
}

/* ---- in a document ---- */

enum { PAIR_MM = 160, PAIR_DPI = 150 };
static const double POINTS = 72 / 25.4;

/* Both diagrams, the polar one on the left. */
static double draw_pair(const void *what, cairo_t *cairo, double width)
{
    const struct lx_diagram *diagram = what;
    cairo_surface_t *nowhere = cairo ? NULL : cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
    cairo_t *context = cairo ? cairo : cairo_create(nowhere);
    struct lx_canvas canvas = lx_canvas_of(context, false);
    const double size = 7, gap = 2 * size, part = 0.45 * (width - gap);
    const struct lx_pane left = {.x = 0, .y = size, .width = part},
                         right = {.x = part + gap, .y = size, .width = width - part - gap};
    double end = fmax(lx_draw_polar(diagram, &canvas, &left, size, cairo != NULL),
                      lx_draw_cartesian(diagram, &canvas, &right, size, cairo != NULL));
    lx_canvas_clear(&canvas);
    if (!cairo) {
        cairo_destroy(context);
        cairo_surface_destroy(nowhere);
    }
    return end + size;
}

static void draw_part(void *cairo, void *data)
{
    draw_pair(data, cairo, PAIR_MM * POINTS);
}

static void release(void *data)
{
    struct lx_diagram *diagram = data;
    for (int i = 0; diagram && i < 2; i++)
        lx_section_clear(&diagram->sections[i]);
    free(diagram);
}

luxel_status lx_diagram_add(const luxel_photometry *photometry, const luxel_language *language,
                            struct luxel_document *document, luxel_diagnostics *diagnostics)
{
    struct lx_diagram *diagram = lx_new_array(1, sizeof *diagram);
    const struct lx_page_sheet sheet = {
        .title = "", .width_mm = PAIR_MM, .dots_per_inch = PAIR_DPI, .draw = draw_pair, .what = diagram};
    unsigned char *bytes = NULL;
    size_t length = 0;
    if (!diagram)
        return lx_out_of_memory(diagnostics);
    diagram->photometry = photometry;
    luxel_diagram_settings_init(&diagram->settings);
    diagram->settings.language = language;
    luxel_status status = take_sections(diagram) ? LUXEL_OK : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK)
        status = lx_sheet_png(&sheet, diagnostics, &bytes, &length);
    if (status != LUXEL_OK) {
        release(diagram);
        return status;
    }
    const struct lx_drawing drawing = {.width_pt = PAIR_MM * POINTS,
                                       .height_pt = draw_pair(diagram, NULL, PAIR_MM * POINTS),
                                       .draw = draw_part,
                                       .release = release,
                                       .data = diagram};
    lx_document_picture(document, bytes, length, &drawing,
                        LX_N("The polar diagram, and the intensity over the angle from the axis."), NULL);
    free(bytes);
    return LUXEL_OK;
}

/* ---- as a file ---- */

static luxel_status write_to(const struct lx_destination *destination, const luxel_photometry *photometry,
                             const luxel_diagram_settings *settings, luxel_diagnostics *diagnostics)
{
    struct lx_diagram diagram = {.photometry = photometry};
    luxel_diagram_settings_init(&diagram.settings);
    if (settings)
        diagram.settings = *settings;
    if (!photometry || !destination->path)
        return LUXEL_ERROR_ARGUMENT;
    luxel_status status = luxel_check_figure_name(destination->path, diagnostics);
    if (status == LUXEL_OK)
        status = check_settings(&diagram.settings, diagnostics);
    if (status == LUXEL_OK)
        status = take_sections(&diagram) && luxel_photometry_find_figures(photometry, &diagram.figures) == LUXEL_OK
                     ? LUXEL_OK
                     : lx_out_of_memory(diagnostics);
    if (status == LUXEL_OK) {
        const char *title = diagram.settings.title;
        const struct lx_page_sheet sheet = {.title = title ? title : "",
                                            .width_mm = diagram.settings.width_mm,
                                            .dots_per_inch = diagram.settings.dots_per_inch,
                                            .dark = diagram.settings.dark,
                                            .draw = draw,
                                            .what = &diagram};
        status = lx_sheet_write(&sheet, destination, diagnostics);
    }
    for (int i = 0; i < 2; i++)
        lx_section_clear(&diagram.sections[i]);
    return status;
}

luxel_status luxel_diagram_write(const luxel_photometry *photometry, const luxel_diagram_settings *settings,
                                 const char *path, luxel_diagnostics *diagnostics)
{
    return write_to(&(struct lx_destination){.path = path}, photometry, settings, diagnostics);
}

luxel_status luxel_diagram_write_memory(const luxel_photometry *photometry, const luxel_diagram_settings *settings,
                                        const char *name, luxel_diagnostics *diagnostics, unsigned char **bytes,
                                        size_t *length)
{
    return write_to(&(struct lx_destination){name, bytes, length}, photometry, settings, diagnostics);
}
