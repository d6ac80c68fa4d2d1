/* SPDX-License-Identifier: MIT */
/* Drawing plan and elevation: lines first, the vectors of the formula over them, what can be grabbed on top. */
#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/geometry.h"
#include "../base/lamp.h"
#include "../base/letters.h"
#include "../base/number.h"
#include "grid_draw.h"
#include "space_lines.h"
#include "stage_private.h"

enum { LETTERS = 11, VECTOR = 46 /* pixels */, MOST_HALFWAYS = 3, RING = 4 };

/* What is drawn on, and in which projection. */
typedef struct Sheet {
    const AppStage *stage;
    cairo_t *cairo;
    GtkWidget *widget;
    GdkRGBA ink;
    AppProjection projection;
} Sheet;

static void set_ink(const Sheet *sheet, double opacity)
{
    const GdkRGBA *ink = &sheet->ink;
    cairo_set_source_rgba(sheet->cairo, (double)ink->red, (double)ink->green, (double)ink->blue, opacity);
}

static void set_lamp(const Sheet *sheet, gsize light, double opacity)
{
    double color[3];
    app_lamp_color(light, color);
    cairo_set_source_rgba(sheet->cairo, color[0], color[1], color[2], opacity);
}

/* A text with its middle at a place, or beginning there, but not beyond the right edge. */
static void draw_text(const Sheet *sheet, const char *text, double x, double y, gboolean centered)
{
    PangoLayout *layout = app_letters_new(sheet->widget, text, NULL, LETTERS);
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    const double left = x - (centered ? width / 2.0 : 0), most = gtk_widget_get_width(sheet->widget) - width - 2;
    cairo_move_to(sheet->cairo, MIN(left, most), y - (centered ? height / 2.0 : 0));
    pango_cairo_show_layout(sheet->cairo, layout);
    cairo_new_path(sheet->cairo);
    g_object_unref(layout);
}

static void place(const Sheet *sheet, const double place_mm[3], double at[2])
{
    app_stage_place(&sheet->stage->map, sheet->projection, place_mm, at);
}

/* ---- lines ---- */

static void set_look(const Sheet *sheet, const AppLine *line)
{
    static const double dashes[] = {3, 3};
    cairo_t *cairo = sheet->cairo;
    const AppStage *stage = sheet->stage;
    const gboolean is_chosen = line->kind == APP_LINE_LAMP && (app_sight_is_chosen(&stage->sight, line->index) ||
                                                               (gssize)line->index == stage->sight.hovered);
    cairo_set_line_width(cairo, is_chosen ? 2.2 : 1.3);
    cairo_set_dash(cairo, dashes, line->kind == APP_LINE_SIGHT ? 2 : 0, 0);
    switch (line->kind) {
    case APP_LINE_LAMP: set_lamp(sheet, line->index, 1); break;
    case APP_LINE_AIM: set_lamp(sheet, line->index, 0.65); break;
    case APP_LINE_SURFACE: set_ink(sheet, 0.9); break;
    case APP_LINE_SCREEN: set_ink(sheet, 0.5); break;
    case APP_LINE_SIGHT: set_ink(sheet, 0.25); break;
    }
}

static void draw_lines(const Sheet *sheet)
{
    const AppSpace *space = sheet->stage->space;
    for (guint i = 0; i < space->lines->len; i++) {
        const AppLine *line = &g_array_index(space->lines, AppLine, i);
        const double(*places)[3] = (const double(*)[3])(const void *)space->places->data;
        if (!(line->projections & 1u << sheet->projection))
            continue;
        for (gsize k = 0; k < line->count; k++) {
            double at[2];
            place(sheet, places[line->first + k], at);
            cairo_line_to(sheet->cairo, at[0], at[1]);
        }
        if (line->closed)
            cairo_close_path(sheet->cairo);
        if (line->goes_on) {
            cairo_new_sub_path(sheet->cairo);
            continue;
        }
        set_look(sheet, line);
        if (line->kind == APP_LINE_SURFACE && line->closed) {
            cairo_stroke_preserve(sheet->cairo);
            set_ink(sheet, 0.06);
            cairo_fill(sheet->cairo);
        } else
            cairo_stroke(sheet->cairo);
    }
    cairo_set_dash(sheet->cairo, NULL, 0, 0);
}

/* ---- grids and observers ---- */

static gboolean see(gconstpointer from, const double place_mm[3], double at[2])
{
    place(from, place_mm, at);
    return TRUE;
}

static void draw_lighting(const Sheet *sheet, double opacity)
{
    enum { REACH = 22 /* dots */ };
    const AppGrids *grids = sheet->stage->sight.grids;
    const AppEyes *eyes = sheet->stage->sight.eyes;
    const AppGridSight sight = {sheet->cairo, sheet->widget, see, sheet, opacity};
    for (gsize i = 0; grids && i < grids->count; i++)
        app_grid_draw(&sight, &grids->list[i], grids->most);
    for (gsize i = 0; eyes && i < eyes->count; i++)
        app_eye_draw(&sight, &eyes->list[i], eyes->moment->serial == sheet->stage->moment->serial,
                     REACH / sheet->stage->map.scale);
}

/* ---- things ---- */

static void draw_arrow(const Sheet *sheet, const double from[2], const double to[2])
{
    const double angle = atan2(to[1] - from[1], to[0] - from[0]);
    cairo_move_to(sheet->cairo, from[0], from[1]);
    cairo_line_to(sheet->cairo, to[0], to[1]);
    cairo_stroke(sheet->cairo);
    if (hypot(to[0] - from[0], to[1] - from[1]) < 6)
        return;
    for (int side = -1; side < 2; side += 2) {
        cairo_move_to(sheet->cairo, to[0], to[1]);
        cairo_line_to(sheet->cairo, to[0] - 7 * cos(angle + side * 0.45), to[1] - 7 * sin(angle + side * 0.45));
    }
    cairo_stroke(sheet->cairo);
}

/* A line from the lamp to its aim; an arrow along its axis; distant light points at the surface. */
static void draw_turning(const Sheet *sheet, const AppThing *thing, const double at[2])
{
    static const double dashes[] = {4, 4}, dots[] = {1.5, 2.5};
    cairo_t *cairo = sheet->cairo;
    double from[2];
    place(sheet, thing->from_mm, from);
    set_lamp(sheet, thing->index, thing->is_on ? 1 : 0.5);
    cairo_set_line_width(cairo, 1.5);
    if (thing->kind == APP_THING_AIM) {
        cairo_set_dash(cairo, dashes, 2, 0);
        cairo_move_to(cairo, from[0], from[1]);
        cairo_line_to(cairo, at[0], at[1]);
        cairo_stroke(cairo);
        cairo_set_dash(cairo, NULL, 0, 0);
        for (int i = 0; i < 2; i++) {
            cairo_move_to(cairo, at[0] - (i ? 0 : 7), at[1] - (i ? 7 : 0));
            cairo_line_to(cairo, at[0] + (i ? 0 : 7), at[1] + (i ? 7 : 0));
        }
        cairo_stroke(cairo);
        cairo_arc(cairo, at[0], at[1], 4, 0, 2 * G_PI);
        cairo_stroke(cairo);
    } else if (thing->kind == APP_THING_DIRECTION) {
        draw_arrow(sheet, at, from);
    } else {
        cairo_set_dash(cairo, dots, thing->kind == APP_THING_C0 ? 2 : 0, 0);
        draw_arrow(sheet, from, at);
        cairo_set_dash(cairo, NULL, 0, 0);
        if (thing->kind == APP_THING_C0)
            draw_text(sheet, "C0", at[0] + 4, at[1] - LETTERS, FALSE);
    }
}

static void draw_observer(const Sheet *sheet, const double at[2])
{
    cairo_t *cairo = sheet->cairo;
    set_ink(sheet, 0.9);
    cairo_set_line_width(cairo, 1.5);
    cairo_move_to(cairo, at[0] - 9, at[1]);
    cairo_curve_to(cairo, at[0] - 4, at[1] - 7, at[0] + 4, at[1] - 7, at[0] + 9, at[1]);
    cairo_curve_to(cairo, at[0] + 4, at[1] + 7, at[0] - 4, at[1] + 7, at[0] - 9, at[1]);
    cairo_stroke(cairo);
    cairo_arc(cairo, at[0], at[1], 2.5, 0, 2 * G_PI);
    cairo_fill(cairo);
}

/* One place of an array, whose number stands in the middle. */
static void draw_ring(const Sheet *sheet, const AppThing *thing, const double at[2])
{
    const AppSight *sight = &sheet->stage->sight;
    const gboolean is_bold = app_sight_is_chosen(sight, thing->index) || (gssize)thing->index == sight->hovered;
    cairo_arc(sheet->cairo, at[0], at[1], RING, 0, 2 * G_PI);
    set_lamp(sheet, thing->index, thing->is_on ? 0.5 : 0.1);
    cairo_fill_preserve(sheet->cairo);
    set_lamp(sheet, thing->index, 1);
    cairo_set_line_width(sheet->cairo, is_bold ? 2 : 1);
    cairo_stroke(sheet->cairo);
}

static void draw_badge(const Sheet *sheet, const AppThing *thing, const double at[2])
{
    const AppStage *stage = sheet->stage;
    const AppBadge badge = {
        .light = thing->index, .is_on = thing->is_on, .selected = app_sight_is_chosen(&stage->sight, thing->index)};
    cairo_save(sheet->cairo);
    cairo_translate(sheet->cairo, at[0], at[1]);
    app_lamp_draw_badge(sheet->cairo, &badge);
    if ((gssize)thing->index == stage->sight.hovered) {
        set_ink(sheet, 1);
        cairo_set_line_width(sheet->cairo, 1.6);
        cairo_arc(sheet->cairo, 0, 0, APP_BADGE_RADIUS + 4.5, 0, 2 * G_PI);
        cairo_stroke(sheet->cairo);
    }
    cairo_restore(sheet->cairo);
}

static void draw_thing(const Sheet *sheet, const AppThing *thing)
{
    double at[2];
    place(sheet, thing->at_mm, at);
    switch (thing->kind) {
    case APP_THING_LAMP: (thing->place > 0 ? draw_ring : draw_badge)(sheet, thing, at); break;
    case APP_THING_DIRECTION:
        draw_turning(sheet, thing, at);
        draw_badge(sheet, thing, at);
        break;
    case APP_THING_AIM:
    case APP_THING_AXIS:
    case APP_THING_C0: draw_turning(sheet, thing, at); break;
    case APP_THING_OBSERVER: draw_observer(sheet, at); break;
    case APP_THING_SURFACE:
    case APP_THING_TARGET:
        set_ink(sheet, 0.8);
        cairo_arc(sheet->cairo, at[0], at[1], 2.5, 0, 2 * G_PI);
        cairo_fill(sheet->cairo);
        break;
    case APP_THING_NONE: break;
    }
}

/* Lamps stand first in the list and are drawn last. */
static void draw_things(const Sheet *sheet)
{
    const GArray *things = sheet->stage->space->things;
    for (guint i = things->len; i > 0; i--)
        draw_thing(sheet, &g_array_index(things, AppThing, i - 1));
}

/* ---- the vectors of the formula ---- */

static void draw_vector(const Sheet *sheet, const char *name, const double vector[3])
{
    double from[2];
    place(sheet, sheet->stage->sight.place_mm, from);
    const double to[2] = {from[0] + VECTOR * vector[0],
                          from[1] - VECTOR * vector[app_projection_up(sheet->projection)]};
    cairo_set_line_width(sheet->cairo, 2);
    draw_arrow(sheet, from, to);
    const double length = hypot(to[0] - from[0], to[1] - from[1]), out = length > 1 ? 9 / length : 0;
    draw_text(sheet, name, to[0] + out * (to[0] - from[0]), to[1] + out * (to[1] - from[1]), TRUE);
}

/* N, V, and of each lamp before the surface L; H, halfway between L and V, of the chosen one, or of all of a few. */
static void draw_vectors(const Sheet *sheet)
{
    const AppStage *stage = sheet->stage;
    const GArray *things = stage->space->things;
    double view[3], light[3];
    guint lamps = 0;
    app_space_view(stage->space, stage->sight.place_mm, view);
    for (guint i = 0; i < things->len; i++) {
        const AppThingKind kind = g_array_index(things, AppThing, i).kind;
        lamps += kind == APP_THING_LAMP || kind == APP_THING_DIRECTION;
    }
    for (guint i = 0; i < things->len; i++) {
        const AppThing *thing = &g_array_index(things, AppThing, i);
        if (!app_space_light(thing, stage->sight.place_mm, stage->sight.normal, light))
            continue;
        set_lamp(sheet, thing->index, 1);
        draw_vector(sheet, "L", light);
        double halfway[3] = {light[0] + view[0], light[1] + view[1], light[2] + view[2]};
        if ((lamps <= MOST_HALFWAYS || (gssize)thing->index == stage->sight.selected) && app_unit(halfway, halfway)) {
            set_lamp(sheet, thing->index, 0.6);
            draw_vector(sheet, "H", halfway);
        }
    }
    set_ink(sheet, 0.6);
    draw_vector(sheet, "V", view);
    set_ink(sheet, 1);
    draw_vector(sheet, "N", stage->sight.normal);
}

/* ---- the sheet itself ---- */

/* A round length that is about a fifth of the width, with its number. */
static void draw_scale(const Sheet *sheet, double width, double height)
{
    const double wanted = width / 5 / sheet->stage->map.scale, power = pow(10, floor(log10(wanted)));
    const double length = power * (wanted / power < 2 ? 1 : wanted / power < 5 ? 2 : 5);
    const double right = width - 8, left = right - length * sheet->stage->map.scale, y = height - 6.5;
    char number[APP_NUMBER_SIZE], *text = g_strdup_printf("%s %s", app_number_show_all(length, number), _("mm"));
    set_ink(sheet, 0.7);
    cairo_set_line_width(sheet->cairo, 1);
    cairo_move_to(sheet->cairo, left, y - 3);
    cairo_line_to(sheet->cairo, left, y);
    cairo_line_to(sheet->cairo, right, y);
    cairo_line_to(sheet->cairo, right, y - 3);
    cairo_stroke(sheet->cairo);
    draw_text(sheet, text, (left + right) / 2, y - 9 * app_letters_scale(sheet->widget), TRUE);
    g_free(text);
}

/* Which way it is looked, and its two coordinates run: whether that is a plan depends on what is up in the scene. */
static void draw_title(const Sheet *sheet, double top)
{
    char *text = g_strdup_printf("%s, x → %s ↑", sheet->projection == APP_PLAN ? _("Seen along z") : _("Seen along y"),
                                 sheet->projection == APP_PLAN ? "y" : "z");
    set_ink(sheet, 0.7);
    draw_text(sheet, text, 6, top + 3, FALSE);
    g_free(text);
}

void app_stage_draw(AppStage *self, cairo_t *cairo, double width, double height)
{
    Sheet sheet = {.stage = self, .cairo = cairo, .widget = GTK_WIDGET(self)};
    gtk_style_context_get_color(gtk_widget_get_style_context(sheet.widget), &sheet.ink);
    const double opacity = self->moment ? app_sight_grid_opacity(&self->sight, self->moment) : 0;
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    for (int i = 0; i < APP_PROJECTIONS; i++) {
        const double top = round(self->map.tops[i]), bottom = round(self->map.tops[i + 1]);
        sheet.projection = (AppProjection)i;
        cairo_save(cairo);
        cairo_rectangle(cairo, 0, top, width, bottom - top);
        cairo_clip(cairo);
        draw_lighting(&sheet, opacity);
        draw_lines(&sheet);
        if (self->sight.has_place)
            draw_vectors(&sheet);
        draw_things(&sheet);
        draw_title(&sheet, top);
        cairo_restore(cairo);
        if (i > 0) {
            set_ink(&sheet, 0.25);
            cairo_set_line_width(cairo, 1);
            cairo_move_to(cairo, 0, top + 0.5);
            cairo_line_to(cairo, width, top + 0.5);
            cairo_stroke(cairo);
        }
    }
    draw_scale(&sheet, width, height);
}
