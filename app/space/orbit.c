/* SPDX-License-Identifier: MIT */
/* The camera's vectors follow turn and tilt; zooming keeps the distance, so that the perspective stays. */
#include "orbit.h"

#include <math.h>
#include <string.h>

#include "../base/geometry.h"
#include "space_lines.h"

static const double TURNED = -0.65, TILTED = 0.92;        /* radians, to begin with */
static const double SEEN_SIDE = 0.15;                     /* the cosine at which the front of a plate is seen well */
static const double A_WAY = 0.008;                        /* radians for a pixel */
static const double FAR_OFF = 3.2;                        /* of the camera, in half diagonals of the scene */
static const double NEAREST = 0.02;                       /* of the distance */
static const double LEAST_SCALE = 0.02, MOST_SCALE = 200; /* of one at which the scene fills the widget */
static const double LEAST_TILT = 0.02;
/* Parts of the screen: how much of plates under bodies is to be in view, and of others. */
static const double UNDER = 0.45, AROUND = 1.5;
enum { MARGIN = 40, CORNERS = 8, PASSES = 3 };

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* From coordinates in which z is upwards. */
static void upright(const AppOrbit *self, double x, double y, double z, double vector[3])
{
    vector[0] = x;
    vector[1] = self->is_upright ? z : y;
    vector[2] = self->is_upright ? -y : z;
}

static void aim(AppOrbit *self)
{
    self->tilt = CLAMP(self->tilt, LEAST_TILT, G_PI - LEAST_TILT);
    upright(self, sin(self->turn) * sin(self->tilt), -cos(self->turn) * sin(self->tilt), cos(self->tilt), self->back);
    upright(self, cos(self->turn), sin(self->turn), 0, self->right);
    app_cross(self->back, self->right, self->up);
}

/* ---- what the keys of a scene say ---- */

/* A room tells what is upwards; else the screen of most scenes lies on a table. */
static gboolean is_upright(const luxel_scene *scene)
{
    for (gsize i = 0; i < luxel_scene_surface_count(scene); i++) {
        char base[APP_KEY_SIZE];
        g_snprintf(base, sizeof base, "surfaces[%zu]", i);
        char *type = app_space_text(scene, base, "type"), *up = app_space_text(scene, base, "up");
        const gboolean is_room = g_strcmp0(type, "room") == 0, is_z = g_strcmp0(up, "z") == 0;
        g_free(type);
        g_free(up);
        if (is_room)
            return !is_z;
    }
    return FALSE;
}

/* ---- what is to be in view ---- */

static void add_place(GArray *places, const double place_mm[3])
{
    g_array_append_vals(places, place_mm, 1);
}

/* Where lamps with their panels, aims and bodies are: of a body the corners of a box.  Of plates under bodies, such as
 * tables, and of what is much larger than the screen, only so much as the screen is large. */
static GArray *places_of(const luxel_scene *scene, const AppSpace *space)
{
    GArray *places = g_array_new(FALSE, FALSE, 3 * sizeof(double));
    const gsize count = luxel_scene_surface_count(scene);
    double screen[2] = {1, 1}, axis[3], center[3], half[3], corner[3];
    gsize plates = 0;
    app_space_numbers(scene, "", "screen.width", &screen[0], 1);
    app_space_numbers(scene, "", "screen.height", &screen[1], 1);
    for (guint i = 0; i < space->things->len; i++) {
        const AppThing *thing = &g_array_index(space->things, AppThing, i);
        if (thing->kind == APP_THING_LAMP || thing->kind == APP_THING_AIM)
            add_place(places, thing->at_mm);
    }
    for (guint i = 0; i < space->lines->len; i++) {
        const AppLine *line = &g_array_index(space->lines, AppLine, i);
        for (gsize k = 0; k < line->count && line->kind == APP_LINE_LAMP; k++)
            add_place(places, ((const double(*)[3])(const void *)space->places->data)[line->first + k]);
    }
    for (gsize i = 0; i < count; i++)
        plates += app_space_front(scene, i, axis) ? 1 : 0;
    for (gsize i = 0; i < count; i++) {
        const double most =
            (plates < count && app_space_front(scene, i, axis) ? UNDER : AROUND) * MAX(screen[0], screen[1]);
        if (luxel_scene_surface_place(scene, i, center) != LUXEL_OK || !app_space_half(scene, i, half))
            continue;
        for (int c = 0; c < CORNERS; c++) {
            for (int k = 0; k < 3; k++)
                corner[k] = center[k] + ((c & 1 << k) ? 1 : -1) * MIN(half[k], most);
            add_place(places, corner);
        }
    }
    return places;
}

static void bounds(const GArray *places, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = (double)INFINITY;
        high[k] = (double)-INFINITY;
        for (guint i = 0; i < places->len; i++) {
            const double at = ((const double(*)[3])(const void *)places->data)[i][k];
            low[k] = MIN(low[k], at);
            high[k] = MAX(high[k], at);
        }
    }
}

/* Moves and scales so that the places fill the widget but for its margins. */
static void fill(AppOrbit *self, const GArray *places)
{
    double low[2] = {(double)INFINITY, (double)INFINITY}, high[2] = {(double)-INFINITY, (double)-INFINITY}, seen[3];
    for (guint i = 0; i < places->len; i++) {
        app_orbit_see(self, ((const double(*)[3])(const void *)places->data)[i], seen);
        for (int k = 0; k < 2; k++) {
            low[k] = MIN(low[k], seen[k]);
            high[k] = MAX(high[k], seen[k]);
        }
    }
    app_orbit_pan(self, (self->width - low[0] - high[0]) / 2, (self->height - low[1] - high[1]) / 2);
    self->scale *= MIN(MAX(self->width - 2 * MARGIN, 1) / MAX(high[0] - low[0], 1),
                       MAX(self->height - 2 * MARGIN, 1) / MAX(high[1] - low[1], 1));
}

void app_orbit_fit(AppOrbit *self, const luxel_scene *scene, const AppSpace *space)
{
    GArray *places = places_of(scene, space);
    double low[3], high[3], sides[3];
    if (places->len > 0 && self->width > 0 && self->height > 0) {
        bounds(places, low, high);
        for (int k = 0; k < 3; k++) {
            self->center_mm[k] = (low[k] + high[k]) / 2;
            sides[k] = high[k] - low[k];
        }
        self->distance_mm = FAR_OFF * MAX(sqrt(dot(sides, sides)) / 2, 1);
        self->scale = MIN(self->width, self->height) / self->distance_mm;
        aim(self);
        for (int pass = 0; pass < PASSES; pass++)
            fill(self, places);
    }
    g_array_unref(places);
}

/* ---- how it is looked at ---- */

/* Whether the plates whose fronts the observer sees show them. */
static gboolean shows_fronts(const AppOrbit *self, const luxel_scene *scene, const AppSpace *space)
{
    for (gsize i = 0; i < luxel_scene_surface_count(scene); i++) {
        double axis[3];
        if (app_space_front(scene, i, axis) && dot(axis, space->sight) > 0 && dot(axis, self->back) < SEEN_SIDE)
            return FALSE;
    }
    return TRUE;
}

void app_orbit_begin(AppOrbit *self, const luxel_scene *scene, const AppSpace *space)
{
    static const double tilts[] = {0.92, 0.7, 0.5, 0.35};
    self->is_upright = is_upright(scene);
    self->turn = TURNED;
    for (gsize i = 0; i < G_N_ELEMENTS(tilts); i++) {
        self->tilt = tilts[i];
        aim(self);
        if (shows_fronts(self, scene, space))
            break;
        self->tilt = TILTED;
    }
    app_orbit_fit(self, scene, space);
}

void app_orbit_front(AppOrbit *self)
{
    self->turn = 0;
    self->tilt = G_PI / 2 - 0.12;
    aim(self);
}

void app_orbit_turn(AppOrbit *self, double dx, double dy)
{
    self->turn -= dx * A_WAY;
    self->tilt -= dy * A_WAY;
    aim(self);
}

void app_orbit_pan(AppOrbit *self, double dx, double dy)
{
    for (int k = 0; k < 3 && self->scale > 0; k++)
        self->center_mm[k] += (dy * self->up[k] - dx * self->right[k]) / self->scale;
}

void app_orbit_zoom(AppOrbit *self, const double at[2], double factor)
{
    const double fitting = MIN(self->width, self->height) / self->distance_mm;
    const double wanted = CLAMP(self->scale * factor, LEAST_SCALE * fitting, MOST_SCALE * fitting);
    const double off[2] = {at[0] - self->width / 2, at[1] - self->height / 2}, share = 1 - wanted / self->scale;
    self->scale = wanted;
    app_orbit_pan(self, off[0] * share, off[1] * share);
}

/* ---- seeing ---- */

gboolean app_orbit_see(const AppOrbit *self, const double place_mm[3], double seen[3])
{
    double off[3];
    for (int k = 0; k < 3; k++)
        off[k] = place_mm[k] - self->center_mm[k];
    const double depth = self->distance_mm - dot(off, self->back), near = MAX(depth, NEAREST * self->distance_mm);
    const double factor = self->scale * self->distance_mm / near;
    seen[0] = self->width / 2 + factor * dot(off, self->right);
    seen[1] = self->height / 2 - factor * dot(off, self->up);
    seen[2] = depth;
    return depth == near;
}

double app_orbit_pixel(const AppOrbit *self, double depth_mm)
{
    return MAX(depth_mm, NEAREST * self->distance_mm) / (self->scale * self->distance_mm);
}

void app_orbit_place(const AppOrbit *self, const double seen[3], double place_mm[3])
{
    const double pixel = app_orbit_pixel(self, seen[2]);
    for (int k = 0; k < 3; k++)
        place_mm[k] = self->center_mm[k] + (seen[0] - self->width / 2) * pixel * self->right[k] +
                      (self->height / 2 - seen[1]) * pixel * self->up[k] +
                      (self->distance_mm - seen[2]) * self->back[k];
}

camera app_orbit_camera(const AppOrbit *self, double dots)
{
    camera from = {.columns = (unsigned)MAX(round(self->width * dots), 2)};
    const double pixel = self->width / self->scale / from.columns;
    from.rows = (unsigned)MAX(round(self->height / self->scale / pixel), 2);
    from.width_mm = from.columns * pixel;
    from.height_mm = from.rows * pixel;
    for (int k = 0; k < 3; k++) {
        from.target_mm[k] = self->center_mm[k];
        from.eye_mm[k] = self->center_mm[k] + self->distance_mm * self->back[k];
        from.up[k] = self->up[k];
    }
    return from;
}
