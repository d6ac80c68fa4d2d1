/* SPDX-License-Identifier: MIT */
/* Where the things of a scene are, read off its keys, and from places back to them. */
#include "space.h"

#include <math.h>
#include <string.h>

#include "../../front/words.h"
#include "../base/geometry.h"
#include "../base/number.h"
#include "../picture/marks.h"
#include "space_lines.h"

static const double ARROW = 0.14;    /* of the reach: arrows of axes */
static const double FAR_OUT = 0.45;  /* of the reach: where distant light is grabbed */
static const double SMALLEST_MM = 1; /* the heights of an observer begin there */
enum { DIRECTION_DIGITS = 4, MOST_PLACES = APP_MOST_THINGS / 6 };

int app_projection_up(AppProjection projection)
{
    return projection == APP_PLAN ? 1 : 2;
}

/* ---- reading ---- */

char *app_space_text(const luxel_scene *scene, const char *base, const char *name)
{
    char *key = g_strdup_printf("%s%s%s", base, *base ? "." : "", name), *text = NULL, *copy;
    bool written;
    if (luxel_scene_get(scene, key, NULL, &written, &text) != LUXEL_OK)
        text = NULL;
    copy = g_strdup(text);
    luxel_text_free(text);
    g_free(key);
    return copy;
}

gsize app_space_numbers(const luxel_scene *scene, const char *base, const char *name, double *numbers, gsize room)
{
    char *text = app_space_text(scene, base, name);
    const gsize count = app_list_read(text, numbers, room);
    g_free(text);
    return count;
}

static void add_thing(AppSpace *space, const AppThing *thing, const char *base, const char *name)
{
    AppThing copy = *thing;
    if (space->things->len >= APP_MOST_THINGS)
        return;
    g_snprintf(copy.key, sizeof copy.key, "%s%s%s", base, *base ? "." : "", name);
    g_array_append_val(space->things, copy);
}

/* How far the scene reaches: the longest side of what holds it. */
static double reach_of(const AppSpace *space)
{
    double reach = 1;
    for (int k = 0; k < 3; k++)
        reach = MAX(reach, space->high[k] - space->low[k]);
    return reach;
}

/* ---- the observer and the screen ---- */

static void add_screen(AppSpace *space, const luxel_scene *scene)
{
    double width = 1, height = 1, corners[4][3];
    app_space_numbers(scene, "", "screen.width", &width, 1);
    app_space_numbers(scene, "", "screen.height", &height, 1);
    for (int i = 0; i < 4; i++) {
        const double at[2] = {i == 1 || i == 2 ? width / 2 : -width / 2, i >= 2 ? height / 2 : -height / 2};
        if (!luxel_scene_unproject(scene, at, 0, corners[i]))
            return;
    }
    app_space_add_line(space, APP_LINE_SCREEN, 0, TRUE, corners, 4);
    char *projection = app_space_text(scene, "", "observer.projection");
    for (int i = 0; i < 4 && g_strcmp0(projection, "perspective") == 0; i++) {
        double sight[2][3];
        memcpy(sight[0], space->eye_mm, sizeof sight[0]);
        memcpy(sight[1], corners[i], sizeof sight[1]);
        app_space_add_line(space, APP_LINE_SIGHT, 0, FALSE, sight, 2);
    }
    g_free(projection);
}

static void add_observer(AppSpace *space, const luxel_scene *scene)
{
    AppThing thing = {.kind = APP_THING_OBSERVER, .is_on = TRUE};
    double target[3] = {0};
    const gboolean is_placed = app_space_numbers(scene, "", "observer.position", thing.at_mm, 3) == 3 &&
                               app_space_numbers(scene, "", "observer.target", target, 3) == 3;
    if (!is_placed && app_space_numbers(scene, "", "observer.z", &thing.at_mm[2], 1) != 1)
        return;
    memcpy(space->eye_mm, thing.at_mm, sizeof space->eye_mm);
    char *view = app_space_text(scene, "", "observer.view");
    space->is_sight_parallel = g_strcmp0(view, "observer") != 0;
    g_free(view);
    const double along[3] = {thing.at_mm[0] - target[0], thing.at_mm[1] - target[1], thing.at_mm[2] - target[2]};
    app_unit(along, space->sight);
    if (!is_placed) {
        space->sight[0] = space->sight[1] = 0;
        space->sight[2] = 1;
    }
    add_thing(space, &thing, "", is_placed ? "observer.position" : "observer.z");
    app_space_include(space, thing.at_mm);
    if (!is_placed)
        return;
    memcpy(thing.from_mm, thing.at_mm, sizeof thing.from_mm);
    memcpy(thing.at_mm, target, sizeof thing.at_mm);
    thing.kind = APP_THING_TARGET;
    add_thing(space, &thing, "", "observer.target");
    app_space_include(space, target);
}

void app_space_view(const AppSpace *space, const double place_mm[3], double view[3])
{
    double to[3];
    for (int k = 0; k < 3; k++)
        to[k] = space->is_sight_parallel ? space->sight[k] : space->eye_mm[k] - place_mm[k];
    app_unit(to, view);
}

gboolean app_space_light(const AppThing *thing, const double place_mm[3], const double normal[3], double light[3])
{
    double to[3], along = 0;
    const gboolean is_lamp = thing->kind == APP_THING_LAMP || thing->kind == APP_THING_DIRECTION;
    if (!is_lamp || !thing->is_on || (thing->place == 0 && thing->places > 1))
        return FALSE;
    for (int k = 0; k < 3; k++)
        to[k] = thing->at_mm[k] - (thing->kind == APP_THING_DIRECTION ? thing->from_mm[k] : place_mm[k]);
    if (!app_unit(to, light))
        return FALSE;
    for (int k = 0; k < 3; k++)
        along += light[k] * normal[k];
    return along > 0;
}

/* ---- surfaces and lamps ---- */

static void add_surface(AppSpace *space, const luxel_scene *scene, AppOutlines *outlines, gsize index)
{
    char base[APP_KEY_SIZE];
    AppThing thing = {.kind = APP_THING_SURFACE, .index = index, .is_on = TRUE};
    g_snprintf(base, sizeof base, "surfaces[%zu]", index);
    double center[3], half[3];
    if (luxel_scene_surface_place(scene, index, center) == LUXEL_OK && app_space_half(scene, index, half))
        for (int k = 0; k < 3; k++)
            space->floor_mm[k] = MIN(space->floor_mm[k], center[k] - half[k]);
    const char *name = app_space_numbers(scene, base, "center", thing.at_mm, 3) == 3 ? "center" : "position";
    if (app_space_numbers(scene, base, name, thing.at_mm, 3) == 3) {
        add_thing(space, &thing, base, name);
        app_space_include(space, thing.at_mm);
        if (outlines)
            app_space_add_surface(space, scene, outlines, index);
    }
}

/* The group of keys that says where a lamp is and what it looks like, such as "lights[0].disk", and the key itself. */
static gboolean find_place(const luxel_scene *scene, gsize index, char base[APP_KEY_SIZE], const char **name,
                           const char **shape)
{
    static const struct {
        const char *group, *name, *shape;
    } places[] = {{"", "position", NULL},          {".rectangle", "center", "rectangle"},
                  {".disk", "center", "disk"},     {".box", "center", "box"},
                  {".sphere", "center", "sphere"}, {".cylinder", "center", "cylinder"},
                  {"", "vertices", "polygon"}};
    for (gsize i = 0; i < G_N_ELEMENTS(places); i++) {
        g_snprintf(base, APP_KEY_SIZE, "lights[%zu]%s", index, places[i].group);
        char *text = app_space_text(scene, base, places[i].name);
        const gboolean found = text && *text == '[';
        g_free(text);
        *name = places[i].name;
        *shape = places[i].shape;
        if (found)
            return TRUE;
    }
    return FALSE;
}

/* The unit vector of a luminaire's plane C = 0, made perpendicular to the axis as the library does it. */
static void find_c0(const luxel_scene *scene, const char *base, const double axis[3], double c0[3])
{
    double wanted[3] = {1, 0, 0}, along = 0;
    app_space_numbers(scene, base, "c0", wanted, 3);
    for (int pass = 0; pass < 2; pass++) {
        app_unit(wanted, wanted);
        along = wanted[0] * axis[0] + wanted[1] * axis[1] + wanted[2] * axis[2];
        if (fabs(along) < 1 - 1e-9)
            break;
        wanted[0] = wanted[2] = 0;
        wanted[1] = 1;
    }
    const double across[3] = {wanted[0] - along * axis[0], wanted[1] - along * axis[1], wanted[2] - along * axis[2]};
    app_unit(across, c0);
}

/* What a lamp is turned by: the place that it is aimed at, or the end of an arrow along its axis. */
static void add_turning(AppSpace *space, const luxel_scene *scene, const AppThing *lamp, const char *base, double reach)
{
    AppThing thing = *lamp;
    double axis[3];
    char *type = app_space_text(scene, base, "type");
    memcpy(thing.from_mm, lamp->at_mm, sizeof thing.from_mm);
    if (app_space_numbers(scene, base, "aim", thing.at_mm, 3) == 3) {
        thing.kind = APP_THING_AIM;
        add_thing(space, &thing, base, "aim");
        app_space_include(space, thing.at_mm);
    } else if (luxel_scene_light_direction(scene, lamp->index, axis)) {
        /* corners say themselves which way they shine */
        thing.kind = APP_THING_AXIS;
        for (int k = 0; k < 3; k++)
            thing.at_mm[k] = lamp->at_mm[k] + ARROW * reach * axis[k];
        if (!g_str_has_suffix(lamp->key, ".vertices"))
            add_thing(space, &thing, base, "axis");
        app_space_include(space, thing.at_mm);
    }
    if (g_strcmp0(type, "luminaire") == 0 && luxel_scene_light_direction(scene, lamp->index, axis)) {
        double c0[3];
        find_c0(scene, base, axis, c0);
        thing.kind = APP_THING_C0;
        for (int k = 0; k < 3; k++)
            thing.at_mm[k] = lamp->at_mm[k] + ARROW * reach * c0[k];
        add_thing(space, &thing, base, "c0");
        app_space_include(space, thing.at_mm);
    }
    g_free(type);
}

/* A lamp, or one at a place of an array: each can be taken, and all are moved together. */
static void add_lamp_at(AppSpace *space, const luxel_scene *scene, const AppThing *thing, const AppBody *body,
                        const char *name)
{
    if (thing->place > 0 && space->things->len >= APP_MOST_THINGS / 2) /* there is to be room for others */
        return;
    add_thing(space, thing, body->base, name);
    app_space_include(space, thing->at_mm);
    if (body->shape && (thing->place > 0 || thing->places == 1))
        app_space_add_body(space, scene, body);
}

static void add_lamp(AppSpace *space, const AppMoment *moment, gsize index)
{
    const luxel_scene *scene = moment->scene;
    char base[APP_KEY_SIZE];
    const char *name, *shape;
    const gsize count = luxel_scene_light_place_count(scene, index);
    AppThing thing = {
        .kind = APP_THING_LAMP, .index = index, .is_on = app_moment_is_on(moment, index), .places = count};
    if (!luxel_scene_light_place(scene, index, thing.at_mm) || !find_place(scene, index, base, &name, &shape))
        return;
    const AppBody body = {APP_LINE_LAMP, index, base, shape};
    const double middle[3] = {thing.at_mm[0], thing.at_mm[1], thing.at_mm[2]};
    add_lamp_at(space, scene, &thing, &body, name);
    double(*places)[3] = g_malloc_n(count, sizeof *places);
    const gboolean has_places = count > 1 && luxel_scene_light_places(scene, index, places);
    for (gsize i = 0; has_places && i < MIN(count, MOST_PLACES); i++) {
        thing.place = i + 1;
        for (int k = 0; k < 3; k++) {
            thing.at_mm[k] = places[i][k];
            thing.off_mm[k] = places[i][k] - middle[k];
        }
        add_lamp_at(space, scene, &thing, &body, name);
    }
    g_free(places);
}

/* What needs to know how far the scene reaches: cones, axes, distant light. */
static void add_directions(AppSpace *space, const AppMoment *moment, gsize lamps, double reach)
{
    const luxel_scene *scene = moment->scene;
    for (gsize i = 0; i < lamps; i++) {
        const AppThing lamp = g_array_index(space->things, AppThing, i);
        char base[APP_KEY_SIZE];
        if (lamp.place > 0)
            continue;
        g_strlcpy(base, lamp.key, sizeof base);
        *strrchr(base, '.') = '\0';
        add_turning(space, scene, &lamp, base, reach);
        app_space_add_cone(space, scene, &lamp, base, reach);
    }
    for (gsize i = 0; i < luxel_scene_light_count(scene); i++) {
        char base[APP_KEY_SIZE];
        double direction[3];
        AppThing thing = {.kind = APP_THING_DIRECTION, .index = i, .is_on = app_moment_is_on(moment, i)};
        if (strcmp(luxel_scene_light_type(scene, i), "distant") != 0 ||
            !luxel_scene_light_direction(scene, i, direction) ||
            luxel_scene_surface_place(scene, 0, thing.from_mm) != LUXEL_OK)
            continue;
        for (int k = 0; k < 3; k++)
            thing.at_mm[k] = thing.from_mm[k] - FAR_OUT * reach * direction[k];
        g_snprintf(base, sizeof base, "lights[%zu]", i);
        add_thing(space, &thing, base, "direction");
        app_space_include(space, thing.at_mm);
    }
}

/* ---- all of it ---- */

AppSpace *app_space_new(const AppMoment *moment, AppOutlines *outlines)
{
    const luxel_scene *scene = moment->scene;
    if (!scene || !luxel_scene_is_committed(scene))
        return NULL;
    AppSpace *space = g_new0(AppSpace, 1);
    space->things = g_array_new(FALSE, TRUE, sizeof(AppThing));
    space->lines = g_array_new(FALSE, TRUE, sizeof(AppLine));
    space->places = g_array_new(FALSE, TRUE, 3 * sizeof(double));
    space->cones = g_array_new(FALSE, TRUE, sizeof(AppCone));
    for (int k = 0; k < 3; k++) {
        space->low[k] = (double)INFINITY;
        space->high[k] = (double)-INFINITY;
    }
    for (gsize i = 0; i < MIN(luxel_scene_light_count(scene), APP_MOST_THINGS / 3); i++)
        add_lamp(space, moment, i);
    const gsize lamps = space->things->len;
    for (gsize i = 0; i < MIN(luxel_scene_surface_count(scene), APP_MOST_THINGS / 3); i++)
        add_surface(space, scene, outlines, i);
    add_observer(space, scene);
    add_screen(space, scene);
    add_directions(space, moment, lamps, reach_of(space));
    return space;
}

void app_space_free(AppSpace *space)
{
    if (!space)
        return;
    g_array_unref(space->things);
    g_array_unref(space->lines);
    g_array_unref(space->places);
    g_array_unref(space->cones);
    g_free(space);
}

char *app_thing_tell(const AppThing *thing)
{
    static const char *const words[] = {[APP_THING_LAMP] = N_("Source %zu"),
                                        [APP_THING_AIM] = N_("Aim of source %zu"),
                                        [APP_THING_AXIS] = N_("Direction of source %zu"),
                                        [APP_THING_C0] = N_("Direction C0 of source %zu"),
                                        [APP_THING_DIRECTION] = N_("Direction of source %zu"),
                                        [APP_THING_SURFACE] = N_("Surface %zu"),
                                        [APP_THING_OBSERVER] = N_("Observer"),
                                        [APP_THING_TARGET] = N_("Where the observer looks")};
    const gboolean is_direction =
        thing->kind == APP_THING_AXIS || thing->kind == APP_THING_C0 || thing->kind == APP_THING_DIRECTION;
    char n[3][APP_NUMBER_SIZE], *name = g_strdup_printf(_(words[thing->kind]), thing->index + 1);
    if (is_direction)
        return name;
    for (int k = 0; k < 3; k++)
        app_number_place(thing->at_mm[k], 1e4, n[k]);
    char *text = g_strdup_printf(_("%s\nx %s, y %s, z %s mm"), name, n[0], n[1], n[2]);
    g_free(name);
    return text;
}

/* ---- moving ---- */

gboolean app_space_moves(const AppThing *thing, AppProjection projection)
{
    return strcmp(thing->key, "observer.z") != 0 || projection == APP_ELEVATION;
}

static double round_to(double value, double step)
{
    /* by the inverse, which is a whole number for steps below 1, so that 0.3 is 0.3 */
    return !(step > 0) ? value
           : step < 1  ? round(value * round(1 / step)) / round(1 / step)
                       : round(value / step) * step;
}

static gboolean set_direction(const AppThing *thing, const double to_mm[3], AppDocument *document)
{
    const double sign = thing->kind == APP_THING_DIRECTION ? -1 : 1;
    double along[3], unit[3];
    for (int k = 0; k < 3; k++)
        along[k] = sign * (to_mm[k] - thing->from_mm[k]);
    if (!app_unit(along, unit))
        return FALSE;
    for (int k = 0; k < 3; k++)
        unit[k] = round_to(unit[k], pow(10, -DIRECTION_DIGITS));
    char *list = app_list_write(unit, 3);
    const gboolean done = app_document_set(document, thing->key, list, NULL);
    g_free(list);
    return done;
}

/* Sets the coordinates that are moved. */
static gboolean set_place(AppThing *thing, const gboolean moves[3], const double to_mm[3], double grain_mm,
                          AppDocument *document)
{
    double place[3];
    /* what is not moved stays as it is written */
    char *text = app_document_get(document, thing->key, NULL);
    if (app_list_read(text, place, 3) != 3)
        for (int k = 0; k < 3; k++)
            place[k] = thing->at_mm[k] - thing->off_mm[k];
    g_free(text);
    for (int k = 0; k < 3; k++)
        if (moves[k])
            place[k] = round_to(to_mm[k] - thing->off_mm[k], grain_mm);
    char *list = app_list_write(place, 3);
    const gboolean done = app_document_set(document, thing->key, list, NULL);
    for (int k = 0; k < 3 && done; k++)
        thing->at_mm[k] = place[k] + thing->off_mm[k];
    g_free(list);
    return done;
}

static gboolean move(AppThing *thing, const gboolean moves[3], const double to_mm[3], double grain_mm,
                     AppDocument *document)
{
    char number[APP_NUMBER_SIZE];
    switch (thing->kind) {
    case APP_THING_NONE: return FALSE;
    case APP_THING_AXIS:
    case APP_THING_C0:
    case APP_THING_DIRECTION: return set_direction(thing, to_mm, document);
    default: break;
    }
    if (strcmp(thing->key, "observer.z") == 0)
        return moves[2] &&
               app_document_set(document, thing->key,
                                app_number_write(MAX(round_to(to_mm[2], grain_mm), SMALLEST_MM), number), NULL);
    if (g_str_has_suffix(thing->key, ".vertices")) {
        const AppMark mark = {.kind = APP_MARK_SOURCE, .index = thing->index};
        double step[3] = {0};
        for (int k = 0; k < 3; k++) {
            step[k] = moves[k] ? round_to(to_mm[k] - thing->at_mm[k], grain_mm) : 0;
            thing->at_mm[k] += step[k]; /* the next step begins there */
        }
        return app_mark_shift(&mark, step, document);
    }
    return set_place(thing, moves, to_mm, grain_mm, document);
}

gboolean app_space_move(AppThing *thing, AppProjection projection, const double to_mm[3], double grain_mm,
                        AppDocument *document)
{
    const gboolean moves[3] = {TRUE, app_projection_up(projection) == 1, app_projection_up(projection) == 2};
    return move(thing, moves, to_mm, grain_mm, document);
}

gboolean app_space_carry(AppThing *thing, const double to_mm[3], double grain_mm, AppDocument *document)
{
    static const gboolean all[3] = {TRUE, TRUE, TRUE};
    return move(thing, all, to_mm, grain_mm, document);
}
