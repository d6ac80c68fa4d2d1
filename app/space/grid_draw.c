/* SPDX-License-Identifier: MIT */
/* Cells are quadrangles, seen from anywhere; words stay upright, and are left out where they would not fit. */
#include "grid_draw.h"

#include <math.h>
#include <string.h>

#include "../base/geometry.h"
#include "../base/lamp.h"
#include "../base/number.h"

enum { LARGEST = 11, SMALLEST = 8 /* letters */, DIGITS = 3, MOST_DECIMALS = 4, MOST_CELLS = 4000 };
static const double LIGHT = 0.5, PART_OF_AREAS = 0.55, DASHES[] = {4, 3};
static const double low_corner[2] = {-0.5, -0.5}, high_corner[2] = {0.5, 0.5}; /* of a plane */

void app_verdict_color(luxel_verdict verdict, double color[3])
{
    /* right, wrong and second ink, on a light and on a dark ground */
    static const double colors[2][3][3] = {{{0.11, 0.48, 0.29}, {0.70, 0.15, 0.12}, {0.40, 0.42, 0.46}},
                                           {{0.44, 0.83, 0.63}, {1, 0.54, 0.50}, {0.62, 0.64, 0.67}}};
    memcpy(color, colors[app_lamp_is_dark() ? 1 : 0][verdict], 3 * sizeof *color);
}

/* A place on the plane, so many sizes from the middle across and up. */
static void place_on(const luxel_grid *grid, double across, double up, double place_mm[3])
{
    const double x = across * grid->size_mm[0], y = up * grid->size_mm[1];
    for (int k = 0; k < 3; k++)
        place_mm[k] = grid->center_mm[k] + x * grid->across[k] + y * grid->up[k];
}

void app_grid_corners(const luxel_grid *grid, double corners_mm[4][3])
{
    for (int i = 0; i < 4; i++)
        place_on(grid, i == 1 || i == 2 ? 0.5 : -0.5, i >= 2 ? 0.5 : -0.5, corners_mm[i]);
}

/* The outline of a part of the plane as a path; FALSE: it is not seen. */
static gboolean trace(const AppGridSight *sight, const luxel_grid *grid, const double low[2], const double high[2],
                      double seen[4][2])
{
    for (int i = 0; i < 4; i++) {
        double place_mm[3];
        place_on(grid, i == 1 || i == 2 ? high[0] : low[0], i >= 2 ? high[1] : low[1], place_mm);
        if (!sight->see(sight->from, place_mm, seen[i])) {
            cairo_new_path(sight->cairo);
            return FALSE;
        }
        cairo_line_to(sight->cairo, seen[i][0], seen[i][1]);
    }
    cairo_close_path(sight->cairo);
    return TRUE;
}

/* How much room there is within a quadrangle for words that stand upright: the longest lines through its middle. */
static void find_room(const double seen[4][2], double room[2])
{
    double area = 0;
    for (int i = 0; i < 4; i++)
        area += (seen[i][0] * seen[(i + 1) % 4][1] - seen[(i + 1) % 4][0] * seen[i][1]) / 2;
    for (int k = 0; k < 2; k++) {
        double low = seen[0][k], high = seen[0][k];
        for (int i = 1; i < 4; i++) {
            low = MIN(low, seen[i][k]);
            high = MAX(high, seen[i][k]);
        }
        room[k] = high - low;
    }
    /* of one that leans, no more than its area leaves */
    const double share = room[0] * room[1] > 0 ? fabs(area) / (room[0] * room[1]) : 0;
    room[0] *= share;
    room[1] *= share > 0.5 ? 1 : share;
}

/* All values of a grid have as many decimals as leave its greatest three digits. */
static const char *write_value(const luxel_grid *grid, double value, char text[APP_NUMBER_SIZE])
{
    const double most = grid->maximum.value;
    const int decimals = most > 0 ? DIGITS - 1 - (int)floor(log10(most)) : 0;
    if (decimals > MOST_DECIMALS)
        return app_number_show(value, DIGITS, text);
    char form[] = "%.0f";
    form[2] = (char)('0' + MAX(decimals, 0));
    g_ascii_formatd(text, APP_NUMBER_SIZE, form, value);
    return app_number_mark(text);
}

/* The widest of a grid's values decides how large all are: nothing is cut; 0: they do not fit. */
static int letters_for(const luxel_grid *grid, const double room[2], PangoLayout *layout)
{
    PangoFontDescription *font = pango_font_description_from_string("Sans");
    int letters = LARGEST, width = 0, height = 0;
    char text[APP_NUMBER_SIZE];
    pango_layout_set_text(layout, write_value(grid, grid->maximum.value, text), -1);
    for (; letters >= SMALLEST; letters--) {
        pango_font_description_set_absolute_size(font, letters * PANGO_SCALE);
        pango_layout_set_font_description(layout, font);
        pango_layout_get_pixel_size(layout, &width, &height);
        if (width + 3 <= room[0] && height <= room[1])
            break;
    }
    pango_font_description_free(font);
    return letters >= SMALLEST ? letters : 0;
}

/* Black or white, whichever is read better on a colour that lets so much of the ground through. */
static void set_ink_on(const AppGridSight *sight, const double color[3], double opacity)
{
    const double ground = app_lamp_is_dark() ? 0.11 : 1;
    const double light = 0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2];
    const double ink = opacity * light + (1 - opacity) * ground > LIGHT ? 0 : 1;
    cairo_set_source_rgba(sight->cairo, ink, ink, ink, 0.9);
}

static void write_in(const AppGridSight *sight, const char *text, const double seen[4][2], PangoLayout *layout)
{
    int width, height;
    pango_layout_set_text(layout, text, -1);
    pango_layout_get_pixel_size(layout, &width, &height);
    cairo_move_to(sight->cairo, (seen[0][0] + seen[2][0] - width) / 2, (seen[0][1] + seen[2][1] - height) / 2);
    pango_cairo_show_layout(sight->cairo, layout);
    cairo_new_path(sight->cairo);
}

/* Fills a cell, or writes its value in it. */
static void draw_cell(const AppGridSight *sight, const luxel_grid *grid, gsize cell, double most, double opacity,
                      PangoLayout *layout)
{
    const gsize column = cell % grid->columns, row = cell / grid->columns;
    const double low[2] = {(double)column / grid->columns - 0.5, 0.5 - (double)(row + 1) / grid->rows};
    const double high[2] = {(double)(column + 1) / grid->columns - 0.5, 0.5 - (double)row / grid->rows};
    double seen[4][2], color[3];
    char text[APP_NUMBER_SIZE];
    if (!grid->mask[cell] || !trace(sight, grid, low, high, seen))
        return;
    luxel_palette_color(NULL, most > 0 ? grid->values[cell] / most : 0, color);
    if (!layout) {
        cairo_set_source_rgba(sight->cairo, color[0], color[1], color[2], opacity);
        cairo_fill(sight->cairo);
        return;
    }
    cairo_new_path(sight->cairo);
    set_ink_on(sight, color, opacity);
    write_in(sight, write_value(grid, grid->values[cell], text), (const double(*)[2])seen, layout);
}

static void draw_cells(const AppGridSight *sight, const luxel_grid *grid, double most, double opacity)
{
    const gsize count = (gsize)grid->columns * grid->rows;
    double seen[4][2], room[2];
    if (count > MOST_CELLS || !trace(sight, grid, low_corner, high_corner, seen))
        return;
    cairo_new_path(sight->cairo);
    find_room((const double(*)[2])seen, room);
    room[0] /= grid->columns;
    room[1] /= grid->rows;
    PangoLayout *layout = gtk_widget_create_pango_layout(sight->widget, NULL);
    const gboolean has_words = letters_for(grid, room, layout) > 0;
    /* the edges of cells that are seen through would show twice */
    cairo_set_antialias(sight->cairo, CAIRO_ANTIALIAS_NONE);
    for (gsize i = 0; i < count; i++)
        draw_cell(sight, grid, i, most, opacity, NULL);
    cairo_set_antialias(sight->cairo, CAIRO_ANTIALIAS_DEFAULT);
    for (gsize i = 0; i < count && has_words; i++)
        draw_cell(sight, grid, i, most, opacity, layout);
    g_object_unref(layout);
}

static void draw_edge(const AppGridSight *sight, const luxel_grid *grid, luxel_verdict verdict, gboolean is_area)
{
    double seen[4][2], color[3];
    if (!trace(sight, grid, low_corner, high_corner, seen))
        return;
    app_verdict_color(verdict, color);
    cairo_set_source_rgb(sight->cairo, color[0], color[1], color[2]);
    cairo_set_line_width(sight->cairo, is_area ? 1 : 1.75);
    cairo_set_dash(sight->cairo, DASHES, is_area ? 2 : 0, 0);
    cairo_stroke(sight->cairo);
    cairo_set_dash(sight->cairo, NULL, 0, 0);
}

/* The verdict of the limits whose names begin so; those of the grid itself begin with none of the areas' names. */
static luxel_verdict verdict_of(const AppGrid *grid, const char *area)
{
    luxel_verdict verdict = LUXEL_PASS;
    gsize count = 0;
    for (gsize i = 0; i < grid->limit_count; i++) {
        const char *name = grid->limits[i].name;
        const gboolean is_of_area = g_str_has_prefix(name, "surround") || g_str_has_prefix(name, "background");
        if (area ? !g_str_has_prefix(name, area) : is_of_area)
            continue;
        const luxel_limit both[] = {{.verdict = verdict}, grid->limits[i]};
        verdict = app_limits_verdict(both, G_N_ELEMENTS(both));
        count++;
    }
    return count > 0 ? verdict : LUXEL_UNDECIDED;
}

void app_grid_draw(const AppGridSight *sight, const AppGrid *grid, double most)
{
    static const char *const names[] = {"background", "surround"};
    const luxel_grid *const areas[] = {grid->grid->background, grid->grid->surround};
    for (gsize i = 0; i < G_N_ELEMENTS(areas); i++)
        if (areas[i])
            draw_cells(sight, areas[i], most, PART_OF_AREAS * sight->opacity);
    draw_cells(sight, grid->grid, most, sight->opacity);
    for (gsize i = 0; i < G_N_ELEMENTS(areas); i++)
        if (areas[i])
            draw_edge(sight, areas[i], verdict_of(grid, names[i]), TRUE);
    draw_edge(sight, grid->grid, verdict_of(grid, NULL), FALSE);
}

void app_eye_draw(const AppGridSight *sight, const AppEye *eye, gboolean is_judged, double reach_mm)
{
    double view[3], end_mm[3], at[2], end[2], color[3];
    cairo_t *cairo = sight->cairo;
    if (!app_unit(eye->sight.view, view))
        return;
    for (int k = 0; k < 3; k++)
        end_mm[k] = eye->sight.eye_mm[k] + reach_mm * view[k];
    if (!sight->see(sight->from, eye->sight.eye_mm, at) || !sight->see(sight->from, end_mm, end))
        return;
    is_judged = is_judged && eye->limit_count > 0;
    app_verdict_color(is_judged ? app_limits_verdict(eye->limits, eye->limit_count) : LUXEL_UNDECIDED, color);
    cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    cairo_set_line_width(cairo, 1.75);
    cairo_arc(cairo, at[0], at[1], 3.5, 0, 2 * G_PI);
    cairo_fill(cairo);
    cairo_move_to(cairo, at[0], at[1]);
    cairo_line_to(cairo, end[0], end[1]);
    cairo_stroke(cairo);
}
