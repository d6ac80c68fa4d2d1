/* SPDX-License-Identifier: MIT */
/* From the keys of bodies to their lines. */
#include "space_lines.h"
#include "../base/geometry.h"

#include <math.h>
#include <string.h>

#include "outlines.h"

enum { ROUND = 48 /* places of a circle */, MOST_CORNERS = 400 };
static const double NORMAL = 0.25; /* of a flat body's size: the arrow of its normal */

/* ---- vectors ---- */

static void along(const double place[3], const double u[3], double a, const double v[3], double b, double result[3])
{
    for (int k = 0; k < 3; k++)
        result[k] = place[k] + a * u[k] + b * v[k];
}

/* ---- lines ---- */

void app_space_include(AppSpace *space, const double place_mm[3])
{
    for (int k = 0; k < 3; k++)
        if (isfinite(place_mm[k])) {
            space->low[k] = MIN(space->low[k], place_mm[k]);
            space->high[k] = MAX(space->high[k], place_mm[k]);
        }
}

static void add_line_in(AppSpace *space, const AppLine *line, const double (*places)[3], gsize count)
{
    AppLine added = *line;
    added.first = space->places->len;
    added.count = count;
    g_array_append_vals(space->places, places, (guint)count);
    g_array_append_val(space->lines, added);
    for (gsize i = 0; i < count; i++)
        app_space_include(space, places[i]);
}

void app_space_add_line(AppSpace *space, AppLineKind kind, gsize index, gboolean closed, const double (*places)[3],
                        gsize count)
{
    const AppLine line = {.kind = kind, .index = index, .closed = closed, .projections = (1 << APP_PROJECTIONS) - 1};
    add_line_in(space, &line, places, count);
}

static void fill_circle(const double center[3], const double u[3], const double v[3], double radius,
                        double (*places)[3])
{
    for (int i = 0; i < ROUND; i++)
        along(center, u, radius * cos(2 * G_PI * i / ROUND), v, radius * sin(2 * G_PI * i / ROUND), places[i]);
}

/* ---- bodies ---- */

/* The outline of a sphere is another circle in each projection. */
static void add_sphere(AppSpace *space, const AppBody *body, const double center[3], double radius)
{
    static const double x[3] = {1, 0, 0}, ups[APP_PROJECTIONS][3] = {{0, 1, 0}, {0, 0, 1}};
    double places[ROUND][3];
    for (int i = 0; i < APP_PROJECTIONS; i++) {
        const AppLine line = {.kind = body->kind, .index = body->index, .closed = TRUE, .projections = 1u << i};
        fill_circle(center, x, ups[i], radius, places);
        add_line_in(space, &line, (const double(*)[3])places, ROUND);
    }
}

/* Which side of a flat body is meant. */
static void add_normal(AppSpace *space, const AppBody *body, const double center[3], const double axis[3], double size)
{
    double ends[2][3], n[3];
    if (!app_unit(axis, n))
        return;
    memcpy(ends[0], center, sizeof ends[0]);
    along(center, n, NORMAL * size, n, 0, ends[1]);
    app_space_add_line(space, body->kind, body->index, FALSE, (const double(*)[3])ends, 2);
}

/* The axis that a lamp turned out to have, or that of the keys. */
static void find_axis(const luxel_scene *scene, const AppBody *body, double axis[3])
{
    if (body->kind == APP_LINE_LAMP && luxel_scene_light_direction(scene, body->index, axis))
        return;
    if (app_space_numbers(scene, body->base, "axis", axis, 3) != 3) {
        axis[0] = axis[1] = 0;
        axis[2] = 1;
    }
}

static void add_rectangle(AppSpace *space, const luxel_scene *scene, const AppBody *body, const double center[3])
{
    double size[2], axis[3], up[3] = {0, 1, 0}, u[3], v[3], places[4][3];
    if (app_space_numbers(scene, body->base, "size", size, 2) != 2)
        return;
    find_axis(scene, body, axis);
    app_space_numbers(scene, body->base, "up", up, 3);
    app_basis(axis, up, u, v);
    for (int i = 0; i < 4; i++)
        along(center, u, i == 1 || i == 2 ? size[0] / 2 : -size[0] / 2, v, i >= 2 ? size[1] / 2 : -size[1] / 2,
              places[i]);
    app_space_add_line(space, body->kind, body->index, TRUE, (const double(*)[3])places, 4);
    add_normal(space, body, center, axis, MIN(size[0], size[1]));
}

static void add_round(AppSpace *space, const luxel_scene *scene, const AppBody *body, const double center[3])
{
    static const double y[3] = {0, 1, 0};
    double radius, height, axis[3], n[3], u[3], v[3], ends[2][3], places[2][ROUND][3];
    if (app_space_numbers(scene, body->base, "radius", &radius, 1) != 1)
        return;
    find_axis(scene, body, axis);
    app_unit(axis, n);
    app_basis(axis, y, u, v);
    if (app_space_numbers(scene, body->base, "height", &height, 1) != 1) {
        fill_circle(center, u, v, radius, places[0]);
        app_space_add_line(space, body->kind, body->index, TRUE, (const double(*)[3])places[0], ROUND);
        add_normal(space, body, center, axis, 2 * radius);
        return;
    }
    for (int i = 0; i < 2; i++) {
        along(center, n, i ? height / 2 : -height / 2, n, 0, ends[i]);
        fill_circle(ends[i], u, v, radius, places[i]);
        app_space_add_line(space, body->kind, body->index, TRUE, (const double(*)[3])places[i], ROUND);
    }
    for (int i = 0; i < ROUND; i += ROUND / 4) {
        double side[2][3];
        memcpy(side[0], places[0][i], sizeof side[0]);
        memcpy(side[1], places[1][i], sizeof side[1]);
        app_space_add_line(space, body->kind, body->index, FALSE, (const double(*)[3])side, 2);
    }
}

static void add_box(AppSpace *space, const luxel_scene *scene, const AppBody *body, const double center[3])
{
    static const int corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double size[3], places[2][4][3];
    if (app_space_numbers(scene, body->base, "size", size, 3) != 3)
        return;
    for (int end = 0; end < 2; end++) {
        for (int i = 0; i < 4; i++) {
            places[end][i][0] = center[0] + corners[i][0] * size[0] / 2;
            places[end][i][1] = center[1] + corners[i][1] * size[1] / 2;
            places[end][i][2] = center[2] + (end ? size[2] : -size[2]) / 2;
        }
        app_space_add_line(space, body->kind, body->index, TRUE, (const double(*)[3])places[end], 4);
    }
    for (int i = 0; i < 4; i++) {
        double edge[2][3];
        memcpy(edge[0], places[0][i], sizeof edge[0]);
        memcpy(edge[1], places[1][i], sizeof edge[1]);
        app_space_add_line(space, body->kind, body->index, FALSE, (const double(*)[3])edge, 2);
    }
}

gboolean app_space_front(const luxel_scene *scene, gsize surface, double axis[3])
{
    char base[APP_KEY_SIZE];
    double height;
    g_snprintf(base, sizeof base, "surfaces[%zu]", surface);
    return app_space_numbers(scene, base, "axis", axis, 3) == 3 &&
           app_space_numbers(scene, base, "height", &height, 1) != 1 && app_unit(axis, axis);
}

gboolean app_space_half(const luxel_scene *scene, gsize surface, double half[3])
{
    char base[APP_KEY_SIZE];
    double radius, axis[3];
    g_snprintf(base, sizeof base, "surfaces[%zu]", surface);
    if (luxel_scene_surface_radius(scene, surface, &radius) != LUXEL_OK)
        return FALSE;
    const gboolean is_box = app_space_numbers(scene, base, "size", half, 3) == 3;
    const gboolean is_plate = !is_box && app_space_front(scene, surface, axis);
    for (int k = 0; k < 3; k++)
        half[k] = is_box ? half[k] / 2 : radius * (is_plate ? sqrt(MAX(1 - axis[k] * axis[k], 0)) : 1);
    return TRUE;
}

/* The normal of a plate. */
static void add_front(AppSpace *space, const luxel_scene *scene, gsize index)
{
    char base[APP_KEY_SIZE];
    double center[3], axis[3], radius = 0;
    g_snprintf(base, sizeof base, "surfaces[%zu]", index);
    if (app_space_front(scene, index, axis) && luxel_scene_surface_place(scene, index, center) == LUXEL_OK &&
        luxel_scene_surface_radius(scene, index, &radius) == LUXEL_OK)
        add_normal(space, &(AppBody){APP_LINE_SURFACE, index, base, NULL}, center, axis, 2 * radius);
}

void app_space_add_surface(AppSpace *space, const luxel_scene *scene, AppOutlines *outlines, gsize index)
{
    double then[3], now[3];
    for (int i = 0; i < APP_PROJECTIONS; i++) {
        const int up = app_projection_up((AppProjection)i);
        const luxel_silhouette *silhouette = app_outlines_find(outlines, scene, index, (AppProjection)i, then, now);
        for (gsize k = 0; silhouette && k < silhouette->count; k++) {
            const luxel_silhouette_line *from = &silhouette->lines[k];
            const AppLine line = {.kind = APP_LINE_SURFACE,
                                  .index = index,
                                  .closed = TRUE,
                                  .goes_on = k + 1 < silhouette->count,
                                  .projections = 1u << i};
            double(*places)[3] = g_malloc_n(from->count, sizeof *places);
            for (gsize m = 0; m < from->count; m++) {
                memcpy(places[m], now, sizeof places[m]);
                places[m][0] = now[0] + from->places_mm[m][0] - then[0];
                places[m][up] = now[up] + from->places_mm[m][1] - then[up];
            }
            add_line_in(space, &line, (const double(*)[3])places, from->count);
            g_free(places);
        }
    }
    add_front(space, scene, index);
}

static void add_polygon(AppSpace *space, const luxel_scene *scene, const AppBody *body, const double center[3],
                        const double off[3])
{
    double *places = g_new(double, 3 * MOST_CORNERS), axis[3];
    const gsize count = app_space_numbers(scene, body->base, "vertices", places, 3 * MOST_CORNERS) / 3;
    for (gsize i = 0; i < 3 * count; i++)
        places[i] += off[i % 3];
    if (count > 2) {
        app_space_add_line(space, body->kind, body->index, TRUE, (const double(*)[3])places, count);
        if (luxel_scene_light_direction(scene, body->index, axis))
            add_normal(space, body, center, axis, hypot(places[0] - center[0], places[1] - center[1]));
    }
    g_free(places);
}

void app_space_add_body(AppSpace *space, const luxel_scene *scene, const AppBody *body)
{
    const AppThing *thing = &g_array_index(space->things, AppThing, space->things->len - 1);
    const double center[3] = {thing->at_mm[0], thing->at_mm[1], thing->at_mm[2]};
    const char *shape = body->shape ? body->shape : "";
    double radius;
    if (strcmp(shape, "sphere") == 0 && app_space_numbers(scene, body->base, "radius", &radius, 1) == 1)
        add_sphere(space, body, center, radius);
    else if (strcmp(shape, "rectangle") == 0)
        add_rectangle(space, scene, body, center);
    else if (strcmp(shape, "disk") == 0 || strcmp(shape, "cylinder") == 0)
        add_round(space, scene, body, center);
    else if (strcmp(shape, "box") == 0)
        add_box(space, scene, body, center);
    else if (strcmp(shape, "polygon") == 0)
        add_polygon(space, scene, body, center, thing->off_mm);
}

/* A cone reaches to what its lamp is aimed at. */
static void add_cone(AppSpace *space, const luxel_scene *scene, const AppThing *lamp, const char *base, double reach,
                     double angle)
{
    static const double FREE = 0.6, FARTHEST = 75 * G_PI / 180; /* of the reach; an angle that can be drawn */
    double aim[3];
    AppCone cone = {.light = lamp->index, .length_mm = FREE * reach};
    memcpy(cone.tip_mm, lamp->at_mm, sizeof cone.tip_mm);
    luxel_scene_light_direction(scene, lamp->index, cone.axis);
    if (app_space_numbers(scene, base, "aim", aim, 3) == 3)
        cone.length_mm = hypot(hypot(aim[0] - cone.tip_mm[0], aim[1] - cone.tip_mm[1]), aim[2] - cone.tip_mm[2]);
    cone.radius_mm = cone.length_mm * tan(MIN(angle, FARTHEST));
    g_array_append_val(space->cones, cone);
}

void app_space_add_cone(AppSpace *space, const luxel_scene *scene, const AppThing *lamp, const char *base, double reach)
{
    static const double LENGTH = 0.3, WIDEST = 80; /* of the reach; degrees that can be drawn */
    static const double y[3] = {0, 1, 0};
    double outer, axis[3], u[3], v[3], end[3], rim[ROUND][3], side[2][3];
    if (app_space_numbers(scene, base, "outer", &outer, 1) != 1 ||
        !luxel_scene_light_direction(scene, lamp->index, axis))
        return;
    const double angle = MIN(outer, WIDEST) * G_PI / 180, length = LENGTH * reach * cos(angle);
    add_cone(space, scene, lamp, base, reach, angle);
    app_basis(axis, y, u, v);
    along(lamp->at_mm, axis, length, axis, 0, end);
    fill_circle(end, u, v, length * tan(angle), rim);
    app_space_add_line(space, APP_LINE_AIM, lamp->index, TRUE, (const double(*)[3])rim, ROUND);
    for (int i = 0; i < ROUND; i += ROUND / 8) {
        memcpy(side[0], lamp->at_mm, sizeof side[0]);
        memcpy(side[1], rim[i], sizeof side[1]);
        app_space_add_line(space, APP_LINE_AIM, lamp->index, FALSE, (const double(*)[3])side, 2);
    }
}
