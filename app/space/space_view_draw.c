/* SPDX-License-Identifier: MIT */
/*
 * What stands in a scene, over the picture of its bodies.  Lines are faint where bodies hide them, areas are left out
 * there, and names make way for each other.
 */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/geometry.h"
#include "../base/lamp.h"
#include "../base/letters.h"
#include "space_view_private.h"

enum {
    GLOW = 36, /* dots of its radius */
    MOST_GLOWS = 60,
    MOST_FILLS = 12,
    MOST_NAMES = 8,
    STEP = 7,   /* dots of a line that are hidden together or not */
    LETTERS = 12,
    BESIDE = 18,
    VECTOR = 70,
    SHORT = 24, /* of a vector that has no letter */
    MOST_VECTORS = 4,
    ROUND = 32,
    CORNER = 16,
    RING = 5
};
static const double HIDDEN = 0.16, DASHES[] = {4, 4}, DOTS[] = {1.5, 4};

typedef struct Sheet {
    const AppSpaceView *view;
    const AppOrbit *orbit;
    cairo_t *cairo;
    GtkWidget *widget;
    GArray *taken; /* graphene_rect_t: where names stand */
} Sheet;

typedef struct Ink {
    double color[3], opacity;
} Ink;

static Ink ink_of(gsize light)
{
    Ink ink = {.opacity = 1};
    app_lamp_color(light, ink.color);
    return ink;
}

static void see(const Sheet *sheet, const double place_mm[3], double seen[3])
{
    app_orbit_see(sheet->orbit, place_mm, seen);
}

static gboolean is_hidden(const Sheet *sheet, const double seen[3])
{
    return sheet->view->lit && sheet->view->lit->moment && app_lit_hides(sheet->view->lit, seen);
}

static void set_lamp(const Sheet *sheet, gsize light, double opacity)
{
    double color[3];
    app_lamp_color(light, color);
    cairo_set_source_rgba(sheet->cairo, color[0], color[1], color[2], opacity);
}

static gboolean is_marked(const Sheet *sheet, gsize light)
{
    return app_sight_is_chosen(&sheet->view->sight, light) || (gssize)light == sheet->view->sight.hovered;
}

/* ---- words ---- */

static gboolean is_free(const Sheet *sheet, const graphene_rect_t *area)
{
    for (guint i = 0; i < sheet->taken->len; i++)
        if (graphene_rect_intersection(&g_array_index(sheet->taken, graphene_rect_t, i), area, NULL))
            return FALSE;
    return TRUE;
}

/* Words with an edge, read on anything, beginning at a place or ending there; they make way for others up and down. */
static void draw_words(const Sheet *sheet, const char *text, double x, double y, gboolean is_left, gboolean is_italic)
{
    enum { MOST_STEPS = 12, WAY = 4 };
    PangoLayout *layout = app_letters_new(sheet->widget, text, is_italic ? "Serif Bold Italic" : "Sans Semi-Bold",
                                          is_italic ? LETTERS + 3 : LETTERS);
    int width, height, step = 0;
    pango_layout_get_pixel_size(layout, &width, &height);
    const double left = is_left ? x - width : x, top = y - height / 2.0;
    graphene_rect_t area;
    do {
        const int off = (step % 2 ? 1 : -1) * ((step + 1) / 2) * WAY;
        area = GRAPHENE_RECT_INIT((float)left, (float)top + (float)off, (float)width, (float)height);
    } while (!is_free(sheet, &area) && ++step < MOST_STEPS);
    g_array_append_val(sheet->taken, area);
    cairo_move_to(sheet->cairo, (double)area.origin.x, (double)area.origin.y);
    pango_cairo_layout_path(sheet->cairo, layout);
    cairo_path_t *path = cairo_copy_path(sheet->cairo);
    cairo_save(sheet->cairo);
    cairo_new_path(sheet->cairo);
    cairo_append_path(sheet->cairo, path);
    cairo_set_source_rgba(sheet->cairo, 0.09, 0.1, 0.11, 0.8);
    cairo_set_line_width(sheet->cairo, 2.5);
    cairo_stroke(sheet->cairo);
    cairo_restore(sheet->cairo);
    cairo_append_path(sheet->cairo, path);
    cairo_fill(sheet->cairo);
    cairo_path_destroy(path);
    g_object_unref(layout);
}

/* ---- lines and areas ---- */

/* What is hidden is added to a path of its own. */
static void add_part(const Sheet *sheet, const double from[3], const double to[3], gboolean hidden)
{
    const int count = CLAMP((int)ceil(hypot(to[0] - from[0], to[1] - from[1]) / STEP), 1, 200);
    for (int i = 0; i < count; i++) {
        double ends[2][3], middle[3];
        for (int k = 0; k < 3; k++) {
            ends[0][k] = from[k] + (to[k] - from[k]) * i / count;
            ends[1][k] = from[k] + (to[k] - from[k]) * (i + 1) / count;
            middle[k] = (ends[0][k] + ends[1][k]) / 2;
        }
        if (is_hidden(sheet, middle) != hidden)
            continue;
        cairo_move_to(sheet->cairo, ends[0][0], ends[0][1]);
        cairo_line_to(sheet->cairo, ends[1][0], ends[1][1]);
    }
}

/* A chain of places; where it is hidden it is faint. */
static void draw_chain(const Sheet *sheet, const double (*places)[3], gsize count, gboolean closed, const Ink *ink)
{
    for (int hidden = 0; hidden < 2; hidden++) {
        for (gsize i = 1; i < count + (closed ? 1 : 0); i++) {
            double from[3], to[3];
            see(sheet, places[i - 1], from);
            see(sheet, places[i % count], to);
            add_part(sheet, from, to, hidden);
        }
        cairo_set_source_rgba(sheet->cairo, ink->color[0], ink->color[1], ink->color[2],
                              ink->opacity * (hidden ? HIDDEN : 1));
        cairo_stroke(sheet->cairo);
    }
}

/* Fills an outline that lies in a plane of three places with the colour that is set, but where bodies hide it. */
static void fill(const Sheet *sheet, const double (*outline)[3], gsize count, const double (*plane)[3])
{
    app_space_view_fill(sheet->view, sheet->cairo, outline, count, plane);
}

static const double (*places_of(const Sheet *sheet, const AppLine *line))[3]
{
    return (const double(*)[3])(const void *)sheet->view->space->places->data + line->first;
}

static gboolean is_everywhere(const AppLine *line)
{
    return line->projections == (1u << APP_PROJECTIONS) - 1;
}

/* Panels are filled. */
static void draw_lamp_line(const Sheet *sheet, const AppLine *line, gboolean is_filled)
{
    const double(*places)[3] = places_of(sheet, line);
    const gboolean is_bold = is_marked(sheet, line->index);
    const Ink ink = ink_of(line->index);
    if (line->closed && is_filled && line->count > 2) {
        const double plane[3][3] = {
            {places[0][0], places[0][1], places[0][2]},
            {places[line->count / 3][0], places[line->count / 3][1], places[line->count / 3][2]},
            {places[2 * line->count / 3][0], places[2 * line->count / 3][1], places[2 * line->count / 3][2]}};
        set_lamp(sheet, line->index, 0.28);
        fill(sheet, places, line->count, (const double(*)[3])plane);
    }
    cairo_set_line_width(sheet->cairo, is_bold ? 2.5 : 1.25);
    cairo_set_dash(sheet->cairo, DASHES, line->closed || line->count > 2 ? 0 : 2, 0);
    draw_chain(sheet, places, line->count, line->closed, &ink);
    cairo_set_dash(sheet->cairo, NULL, 0, 0);
}

static void draw_lines(const Sheet *sheet)
{
    static const Ink screen = {{0.14, 0.34, 0.77}, 0.5}, sight = {{0.14, 0.34, 0.77}, 0.22};
    const AppSpace *space = sheet->view->space;
    gsize fills = 0;
    for (guint i = 0; i < space->lines->len; i++)
        fills += g_array_index(space->lines, AppLine, i).kind == APP_LINE_LAMP ? 1 : 0;
    for (guint i = 0; i < space->lines->len; i++) {
        const AppLine *line = &g_array_index(space->lines, AppLine, i);
        if (!is_everywhere(line))
            continue;
        cairo_set_line_width(sheet->cairo, 1);
        if (line->kind == APP_LINE_SCREEN || line->kind == APP_LINE_SIGHT)
            draw_chain(sheet, places_of(sheet, line), line->count, line->closed,
                       line->kind == APP_LINE_SCREEN ? &screen : &sight);
        else if (line->kind == APP_LINE_LAMP)
            draw_lamp_line(sheet, line, fills <= 2 * MOST_FILLS);
    }
}

/* ---- cones ---- */

/* A cone fades away from its lamp: its outline is the tip and the places of the rim that are seen farthest aside. */
static void draw_cone(const Sheet *sheet, const AppCone *cone, gboolean is_filled)
{
    double axis[3], u[3], v[3], foot[3], rim[ROUND][3], tip_seen[3], foot_seen[3], aside[ROUND];
    static const double y_axis[3] = {0, 1, 0};
    int first = 0, last = 0;
    for (int k = 0; k < 3; k++) {
        axis[k] = cone->axis[k];
        foot[k] = cone->tip_mm[k] + cone->length_mm * axis[k];
    }
    app_basis(axis, y_axis, u, v);
    see(sheet, cone->tip_mm, tip_seen);
    see(sheet, foot, foot_seen);
    const double along = atan2(foot_seen[1] - tip_seen[1], foot_seen[0] - tip_seen[0]);
    for (int i = 0; i < ROUND; i++) {
        double seen[3];
        for (int k = 0; k < 3; k++)
            rim[i][k] =
                foot[k] + cone->radius_mm * (cos(2 * G_PI * i / ROUND) * u[k] + sin(2 * G_PI * i / ROUND) * v[k]);
        see(sheet, rim[i], seen);
        aside[i] = remainder(atan2(seen[1] - tip_seen[1], seen[0] - tip_seen[0]) - along, 2 * G_PI);
        first = aside[i] < aside[first] ? i : first;
        last = aside[i] > aside[last] ? i : last;
    }
    const gboolean is_aside = hypot(foot_seen[0] - tip_seen[0], foot_seen[1] - tip_seen[1]) > 12;
    if (is_filled && is_aside) {
        double outline[ROUND + 1][3], plane[3][3], across[3], color[3];
        const gsize until = (gsize)(last - first + ROUND) % ROUND + 1;
        memcpy(outline[0], cone->tip_mm, sizeof outline[0]);
        for (gsize i = 0; i < until; i++)
            memcpy(outline[i + 1], rim[(gsize)(first + (int)i) % ROUND], sizeof outline[0]);
        app_cross(axis, sheet->orbit->back, across);
        for (int k = 0; k < 3; k++) {
            plane[0][k] = cone->tip_mm[k];
            plane[1][k] = foot[k];
            plane[2][k] = cone->tip_mm[k] + cone->length_mm * across[k];
        }
        app_lamp_color(cone->light, color);
        cairo_pattern_t *fading = cairo_pattern_create_linear(tip_seen[0], tip_seen[1], foot_seen[0], foot_seen[1]);
        cairo_pattern_add_color_stop_rgba(fading, 0, color[0], color[1], color[2], 0.5);
        cairo_pattern_add_color_stop_rgba(fading, 1, color[0], color[1], color[2], 0.06);
        cairo_set_source(sheet->cairo, fading);
        fill(sheet, (const double(*)[3])outline, until + 1, (const double(*)[3])plane);
        cairo_pattern_destroy(fading);
    }
    const Ink ink = ink_of(cone->light);
    cairo_set_line_width(sheet->cairo, is_marked(sheet, cone->light) ? 2 : 1);
    draw_chain(sheet, (const double(*)[3])rim, ROUND, TRUE, &ink);
    for (int i = 0; i < 2 && is_aside; i++) {
        double side[2][3];
        memcpy(side[0], cone->tip_mm, sizeof side[0]);
        memcpy(side[1], rim[i ? first : last], sizeof side[1]);
        draw_chain(sheet, (const double(*)[3])side, 2, FALSE, &ink);
    }
}

static void draw_cones(const Sheet *sheet)
{
    const GArray *cones = sheet->view->space->cones;
    for (guint i = 0; i < cones->len; i++)
        draw_cone(sheet, &g_array_index(cones, AppCone, i), cones->len <= MOST_FILLS);
}

/* ---- things ---- */

static void stroke_cased(const Sheet *sheet, double width)
{
    cairo_path_t *path = cairo_copy_path(sheet->cairo);
    cairo_save(sheet->cairo);
    cairo_set_source_rgba(sheet->cairo, 0, 0, 0, 0.38);
    cairo_set_line_width(sheet->cairo, width + 2.75);
    cairo_stroke(sheet->cairo);
    cairo_restore(sheet->cairo);
    cairo_append_path(sheet->cairo, path);
    cairo_set_line_width(sheet->cairo, width);
    cairo_stroke(sheet->cairo);
    cairo_path_destroy(path);
}

static void draw_glow(const Sheet *sheet, const double at[2], gsize light, double strength)
{
    double color[3];
    app_lamp_color(light, color);
    cairo_pattern_t *glow = cairo_pattern_create_radial(at[0], at[1], 4, at[0], at[1], GLOW);
    cairo_pattern_add_color_stop_rgba(glow, 0, color[0], color[1], color[2], strength);
    cairo_pattern_add_color_stop_rgba(glow, 0.35, color[0], color[1], color[2], 0.45 * strength);
    cairo_pattern_add_color_stop_rgba(glow, 1, color[0], color[1], color[2], 0);
    cairo_set_source(sheet->cairo, glow);
    cairo_arc(sheet->cairo, at[0], at[1], GLOW, 0, 2 * G_PI);
    cairo_fill(sheet->cairo);
    cairo_pattern_destroy(glow);
}

/* How high a lamp is: a plumb line to the lowest place of the bodies. */
static void draw_plumb(const Sheet *sheet, const AppThing *thing)
{
    const int up = sheet->orbit->is_upright ? 1 : 2;
    double line[2][3];
    const Ink ink = ink_of(thing->index);
    memcpy(line[0], thing->at_mm, sizeof line[0]);
    memcpy(line[1], thing->at_mm, sizeof line[1]);
    line[1][up] = sheet->view->space->floor_mm[up];
    cairo_set_line_width(sheet->cairo, 1.25);
    cairo_set_dash(sheet->cairo, DOTS, 2, 0);
    draw_chain(sheet, (const double(*)[3])line, 2, FALSE, &ink);
    cairo_set_dash(sheet->cairo, NULL, 0, 0);
}

/* An arrow to where a lamp beyond the edge is. */
static void draw_edge_arrow(const Sheet *sheet, const double at[2], double angle, gsize light)
{
    cairo_save(sheet->cairo);
    cairo_translate(sheet->cairo, at[0], at[1]);
    cairo_rotate(sheet->cairo, angle);
    cairo_move_to(sheet->cairo, 17, 0);
    cairo_line_to(sheet->cairo, 9, -6);
    cairo_line_to(sheet->cairo, 9, 6);
    cairo_close_path(sheet->cairo);
    set_lamp(sheet, light, 1);
    cairo_fill(sheet->cairo);
    cairo_restore(sheet->cairo);
}

static void draw_badge(const Sheet *sheet, const AppThing *thing, const double at[2], double opacity)
{
    const AppBadge badge = {.light = thing->index,
                            .is_on = thing->is_on,
                            .selected = app_sight_is_chosen(&sheet->view->sight, thing->index)};
    const double grown = (gssize)thing->index == sheet->view->sight.hovered ? 1.25 : 1.1;
    cairo_save(sheet->cairo);
    cairo_translate(sheet->cairo, at[0], at[1]);
    cairo_scale(sheet->cairo, grown, grown);
    if (opacity < 1)
        cairo_push_group(sheet->cairo);
    app_lamp_draw_badge(sheet->cairo, &badge);
    if (opacity < 1) {
        cairo_pop_group_to_source(sheet->cairo);
        cairo_paint_with_alpha(sheet->cairo, opacity);
    }
    cairo_restore(sheet->cairo);
}

/* One place of an array, whose number stands in the middle. */
static void draw_ring(const Sheet *sheet, const AppThing *thing, const double at[2], gboolean is_bold)
{
    cairo_arc(sheet->cairo, at[0], at[1], RING, 0, 2 * G_PI);
    set_lamp(sheet, thing->index, thing->is_on ? 1 : 0.4);
    stroke_cased(sheet, is_bold ? 2.25 : 1.25);
}

static void draw_lamp(const Sheet *sheet, const AppThing *thing, gsize lamps)
{
    double at[3], angle;
    const gboolean is_outside = app_space_view_mark(sheet->view, thing, at, &angle);
    const gboolean hidden = !is_outside && is_hidden(sheet, at), bold = is_marked(sheet, thing->index);
    const gboolean has_number = thing->place == 0;
    if (!has_number && is_outside)
        return;
    if (thing->is_on && !is_outside && MAX(lamps, thing->places) <= MOST_GLOWS && (!has_number || thing->places <= 1))
        draw_glow(sheet, at, thing->index, hidden ? 0.25 : 0.75);
    if (!has_number) {
        draw_ring(sheet, thing, at, bold);
        return;
    }
    if (app_sight_is_chosen(&sheet->view->sight, thing->index) && !is_outside)
        draw_plumb(sheet, thing);
    if (is_outside)
        draw_edge_arrow(sheet, at, angle, thing->index);
    draw_badge(sheet, thing, at, hidden && !bold ? 0.45 : 1);
    const char *name = luxel_scene_light_name(sheet->view->picture->shot->moment->scene, thing->index);
    if (!name || !*name || (lamps > MOST_NAMES && !bold))
        return;
    const gboolean is_left = at[0] > sheet->orbit->width - 140;
    cairo_set_source_rgb(sheet->cairo, 1, 1, 1);
    draw_words(sheet, name, at[0] + (is_left ? -BESIDE : BESIDE), at[1], is_left, FALSE);
}

static void draw_handle(const Sheet *sheet, const AppThing *thing)
{
    cairo_t *cairo = sheet->cairo;
    double at[3], ends[2][3];
    Ink ink = {{1, 1, 1}, 1};
    see(sheet, thing->at_mm, at);
    const gboolean is_own = thing->kind == APP_THING_OBSERVER || thing->kind == APP_THING_TARGET;
    if (!is_own) {
        ink = ink_of(thing->index);
        memcpy(ends[0], thing->from_mm, sizeof ends[0]);
        memcpy(ends[1], thing->at_mm, sizeof ends[1]);
        cairo_set_line_width(cairo, 1.25);
        cairo_set_dash(cairo, DASHES, 2, 0);
        draw_chain(sheet, (const double(*)[3])ends, 2, FALSE, &ink);
        cairo_set_dash(cairo, NULL, 0, 0);
    }
    if (thing->kind == APP_THING_OBSERVER)
        cairo_rectangle(cairo, at[0] - 6, at[1] - 6, 12, 12);
    else if (thing->kind == APP_THING_AIM) {
        for (int i = 0; i < 2; i++) {
            cairo_move_to(cairo, at[0] - (i ? 0 : 8), at[1] - (i ? 8 : 0));
            cairo_line_to(cairo, at[0] + (i ? 0 : 8), at[1] + (i ? 8 : 0));
        }
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, at[0], at[1], 5, 0, 2 * G_PI);
    } else
        cairo_arc(cairo, at[0], at[1], 5, 0, 2 * G_PI);
    cairo_set_source_rgb(cairo, ink.color[0], ink.color[1], ink.color[2]);
    stroke_cased(sheet, 1.75);
}

static void draw_things(const Sheet *sheet)
{
    const GArray *things = sheet->view->space->things;
    gsize lamps = 0;
    for (guint i = things->len; i > 0; i--) {
        const AppThing *thing = &g_array_index(things, AppThing, i - 1);
        const gboolean is_lamp = thing->kind == APP_THING_LAMP || thing->kind == APP_THING_DIRECTION;
        lamps += is_lamp && thing->place == 0 ? 1 : 0;
        if (thing->kind != APP_THING_SURFACE && thing->kind != APP_THING_LAMP)
            draw_handle(sheet, thing);
    }
    for (guint i = things->len; i > 0; i--) {
        const AppThing *thing = &g_array_index(things, AppThing, i - 1);
        if (thing->kind == APP_THING_LAMP || thing->kind == APP_THING_DIRECTION)
            draw_lamp(sheet, thing, lamps);
    }
}

/* ---- the vectors of the formula ---- */

static void draw_vector(const Sheet *sheet, const char *name, const double vector[3], double share,
                        const double color[3])
{
    double from[3], to[3], end[3];
    see(sheet, sheet->view->sight.place_mm, from);
    const double length_mm = share * VECTOR * app_orbit_pixel(sheet->orbit, from[2]);
    for (int k = 0; k < 3; k++)
        end[k] = sheet->view->sight.place_mm[k] + length_mm * vector[k];
    see(sheet, end, to);
    const double length = hypot(to[0] - from[0], to[1] - from[1]), head = MIN(11, 0.6 * length);
    const double u[2] = {length > 0 ? (to[0] - from[0]) / length : 1, length > 0 ? (to[1] - from[1]) / length : 0};
    cairo_t *cairo = sheet->cairo;
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_move_to(cairo, from[0], from[1]);
    cairo_line_to(cairo, to[0], to[1]);
    for (int side = -1; side < 2; side += 2) {
        cairo_move_to(cairo, to[0], to[1]);
        cairo_line_to(cairo, to[0] - head * (u[0] - side * 0.45 * u[1]), to[1] - head * (u[1] + side * 0.45 * u[0]));
    }
    cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    stroke_cased(sheet, 2.25);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
    if (length >= SHORT)
        draw_words(sheet, name, to[0] + 13 * u[0] - 5, to[1] + 13 * u[1], FALSE, TRUE);
}

/* N, V, of the lamps before the surface L with their number, and H of the chosen one. */
static void draw_vectors(const Sheet *sheet)
{
    static const double normal[3] = {1, 1, 1}, seeing[3] = {0.79, 0.81, 0.84}, halfway[3] = {1, 0.85, 0.54};
    const AppSpaceView *view = sheet->view;
    double towards[3], light[3], at[3];
    int vectors = 0;
    app_space_view(view->space, view->sight.place_mm, towards);
    for (guint i = 0; i < view->space->things->len; i++) {
        const AppThing *thing = &g_array_index(view->space->things, AppThing, i);
        double color[3], half[3];
        if (!app_space_light(thing, view->sight.place_mm, view->sight.normal, light) ||
            (vectors >= MOST_VECTORS && (gssize)thing->index != view->sight.selected))
            continue;
        char *name = g_strdup_printf("L%zu", thing->index + 1);
        app_lamp_color(thing->index, color);
        draw_vector(sheet, name, light, 1.25, color);
        g_free(name);
        vectors++;
        for (int k = 0; k < 3; k++)
            half[k] = light[k] + towards[k];
        if ((gssize)thing->index == view->sight.selected && app_unit(half, half))
            draw_vector(sheet, "H", half, 1.05, halfway);
    }
    draw_vector(sheet, "V", towards, 0.9, seeing);
    draw_vector(sheet, "N", view->sight.normal, 1.1, normal);
    see(sheet, view->sight.place_mm, at);
    cairo_arc(sheet->cairo, at[0], at[1], 7, 0, 2 * G_PI);
    cairo_set_source_rgb(sheet->cairo, 1, 1, 1);
    stroke_cased(sheet, 2);
}

void app_space_view_draw(AppSpaceView *self, cairo_t *cairo)
{
    const Sheet sheet = {.view = self,
                         .orbit = app_space_view_orbit(self),
                         .cairo = cairo,
                         .widget = GTK_WIDGET(self),
                         .taken = g_array_new(FALSE, FALSE, sizeof(graphene_rect_t))};
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    app_space_view_draw_grids(self, cairo);
    draw_lines(&sheet);
    draw_cones(&sheet);
    draw_things(&sheet);
    if (self->sight.has_place && !self->sight.is_stale)
        draw_vectors(&sheet);
    if (self->lit && self->lit->moment && self->lit->moment->direct) {
        cairo_set_source_rgb(cairo, 1, 1, 1);
        draw_words(&sheet, _("Space shows direct light"), CORNER, sheet.orbit->height - CORNER, FALSE, FALSE);
    }
    g_array_unref(sheet.taken);
}
