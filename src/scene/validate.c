/* SPDX-License-Identifier: MIT */
/*
 * What must hold between the parts of a scene for pictures and screen points: something to see, square pixels, and an
 * observer outside of all surfaces.  Parts with errors of their own are left out here.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../base/number.h"
#include "../surface/surface.h"
#include "mend.h"
#include "object.h"
#include "observer.h"

static const double SQUARE_TOLERANCE = 1e-6;
enum { LARGEST_RESOLUTION = 65536 };

static bool is_square(double width_mm, double height_mm, double columns, double rows)
{
    double across = width_mm / columns, down = height_mm / rows;
    return fabs(across - down) <= SQUARE_TOLERANCE * across;
}

/* The resolution nearest to the one wanted whose pixels are square; false where there is none. */
static bool fitting_resolution(const struct lx_screen *screen, unsigned *columns, unsigned *rows)
{
    for (int off = 0; off < LARGEST_RESOLUTION; off++)
        for (int sign = -1; sign <= 1; sign += 2) {
            double c = (double)screen->resolution[0] + sign * off;
            double r = nearbyint(screen->height_mm * (c / screen->width_mm));
            if (c >= 1 && r >= 1 && c <= LARGEST_RESOLUTION && r <= LARGEST_RESOLUTION &&
                is_square(screen->width_mm, screen->height_mm, c, r)) {
                *columns = (unsigned)c;
                *rows = (unsigned)r;
                return true;
            }
        }
    return false;
}

static void check_square(struct lx_walk *walk, const luxel_scene *scene)
{
    enum { DIGITS = 9 };
    const struct lx_screen *screen = &scene->parameters.screen;
    double columns = screen->resolution[0], rows = screen->resolution[1];
    if (is_square(screen->width_mm, screen->height_mm, columns, rows))
        return;
    char across[LX_NUMBER_SIZE], down[LX_NUMBER_SIZE], height[LX_NUMBER_SIZE];
    lx_write_digits(screen->width_mm / columns, 6, across);
    lx_write_digits(screen->height_mm / rows, 6, down);
    struct lx_step group = {NULL, "screen", 0}, step = {&group, "resolution", 0};
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR,
                   lx_document_place(walk->document, lx_scene_node(scene, "screen", "resolution")), &step,
                   LX_MSG_NOT_SQUARE, across, down);
    lx_write_digits(screen->width_mm / columns * rows, DIGITS, height);
    unsigned c, r;
    if (fitting_resolution(screen, &c, &r)) {
        char resolution[40];
        snprintf(resolution, sizeof resolution, "[%u, %u]", c, r);
        lx_hint(walk->diagnostics, LX_MSG_HINT_FITTING_RESOLUTION, LX_ARGS(resolution, height));
    } else {
        lx_hint(walk->diagnostics, LX_MSG_HINT_FITTING_SIZE, LX_ARGS(height));
    }
}

/* Whether a key of a group of the scene is written and good. */
static bool is_good(const char *group, const void *parameters, const char *key)
{
    return lx_is_given(lx_find_parameter(&lx_scene_table, group)->group, parameters, key);
}

/* The observer, as the surfaces are looked at. */
struct watch {
    struct lx_frame frame;
    double z_mm;
    bool is_perspective;
    const char *key; /* that says where it stands */
};

static struct watch watch_of(const struct lx_observer *observer)
{
    return (struct watch){
        .frame = lx_observer_frame(observer),
        .z_mm = lx_observer_height(observer),
        .is_perspective = observer->projection == LX_PERSPECTIVE,
        .key = lx_observer_is_placed(observer) ? "position" : "z",
    };
}

/* Whether a surface is one that observers may stand in, by the middle of its extent. */
static bool is_room(const struct lx_item *surface)
{
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)surface->variant;
    return lx_surface_surrounds(kind, surface->parameters, lx_surface_shape(kind, surface->parameters).anchor_mm);
}

/* What an observer of the scene has to do with surface i, and what to be above; false: it has errors of its own. */
static bool standing_of(const luxel_scene *scene, const struct watch *watch, size_t i, enum lx_standing *standing,
                        double *highest_mm)
{
    const struct lx_item *item = &scene->parameters.surfaces.items[i];
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    if (!kind)
        return false;
    double low[3], high[3];
    lx_surface_extent(kind, item->parameters, &watch->frame, low, high);
    *highest_mm = is_room(item) ? low[2] : high[2];
    *standing = lx_surface_standing(kind, item->parameters, &watch->frame, watch->z_mm, watch->is_perspective);
    return true;
}

/* Reports at the key that says where the observer stands. */
static void report_observer(struct lx_walk *walk, const luxel_scene *scene, const struct watch *watch,
                            enum lx_message message, const char *name, const char *number)
{
    struct lx_step group = {NULL, "observer", 0}, step = {&group, watch->key, 0};
    const lx_node_id id = lx_scene_node(scene, "observer", watch->key);
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, id), &step, message, name, number);
}

static void report_too_low(struct lx_walk *walk, const luxel_scene *scene, const struct watch *watch, size_t highest,
                           double highest_mm)
{
    char name[40], number[LX_NUMBER_SIZE];
    const bool has_height = strcmp(watch->key, "z") == 0;
    snprintf(name, sizeof name, "surfaces[%zu]", highest);
    if (has_height)
        lx_write_number(highest_mm, number);
    else
        lx_write_digits(highest_mm, 9, number);
    const enum lx_message message = !has_height                                           ? LX_MSG_OBSERVER_TOO_NEAR
                                    : is_room(&scene->parameters.surfaces.items[highest]) ? LX_MSG_OBSERVER_BELOW_ROOM
                                                                                          : LX_MSG_OBSERVER_TOO_LOW;
    report_observer(walk, scene, watch, message, name, number);
    if (isfinite(highest_mm))
        lx_hint(walk->diagnostics, has_height ? LX_MSG_HINT_RAISE_OBSERVER : LX_MSG_HINT_STAND_FARTHER,
                LX_ARGS(number));
}

/* Only the one that reaches highest is reported of the surfaces that the observer is not above. */
static void check_observer(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct watch watch = watch_of(&scene->parameters.observer);
    if (watch.is_perspective && !(watch.z_mm > 0))
        return; /* a rule of its table, and reported by it */
    size_t count = scene->parameters.surfaces.count, highest = count;
    double highest_mm = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        enum lx_standing standing;
        double top_mm;
        if (standing_of(scene, &watch, i, &standing, &top_mm) && standing == LX_STANDS_TOO_LOW &&
            (highest == count || top_mm > highest_mm)) {
            highest = i;
            highest_mm = top_mm;
        }
    }
    if (highest < count)
        report_too_low(walk, scene, &watch, highest, highest_mm);
}

/* Whether the keys of the observer that were written are good, as far as they say how it stands to surfaces. */
static bool is_observer_good(const luxel_scene *scene)
{
    static const char *const keys[] = {"projection", "up"};
    const struct lx_observer *observer = &scene->parameters.observer;
    for (size_t i = 0; i < LX_COUNT(keys); i++)
        if (lx_scene_node(scene, "observer", keys[i]) && !is_good("observer", observer, keys[i]))
            return false;
    return lx_observer_is_sound(observer);
}

static void report_no_surfaces(struct lx_walk *walk, luxel_severity severity)
{
    const lx_node_id surfaces = lx_document_find(walk->document, walk->document->root, "surfaces");
    lx_walk_report(walk, severity, lx_document_place(walk->document, surfaces), &(struct lx_step){NULL, "surfaces", 0},
                   LX_MSG_NO_SURFACES, NULL, NULL);
}

void lx_validate_view(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_screen *screen = &scene->parameters.screen;
    if (is_good("screen", screen, "width") && is_good("screen", screen, "height") &&
        is_good("screen", screen, "resolution"))
        check_square(walk, scene);
    if (is_observer_good(scene))
        check_observer(walk, scene);
    if (scene->committed && scene->parameters.surfaces.count == 0)
        report_no_surfaces(walk, LUXEL_SEVERITY_ERROR);
}

luxel_status luxel_scene_check_view(const luxel_scene *scene, luxel_diagnostics *diagnostics)
{
    if (!luxel_scene_is_committed(scene))
        return lx_refuse(diagnostics, LX_MSG_NOT_COMMITTED, NULL);
    struct lx_walk walk = lx_scene_walk(scene, diagnostics);
    lx_validate_view(&walk, scene);
    return lx_walk_status(&walk);
}

/* The assignment that turns a plate round, whose axis is written or the usual one; else words. */
static void hint_turn(struct lx_walk *walk, const struct lx_item *item, size_t i)
{
    const struct lx_table *table = item->variant->table;
    const struct lx_parameter *axis = lx_find_parameter(table, "axis");
    struct lx_text text = {0};
    if (axis && axis->type == LX_REALS && axis->count == 3 && !lx_is_given(table, item->parameters, "aim")) {
        const double *along = lx_const_member(axis, item->parameters);
        char x[LX_NUMBER_SIZE], y[LX_NUMBER_SIZE], z[LX_NUMBER_SIZE];
        lx_mend_add(&text, "surfaces[%zu].axis=[%s, %s, %s]", i, lx_write_number(0 - along[0], x),
                    lx_write_number(0 - along[1], y), lx_write_number(0 - along[2], z));
        lx_mend_hint(walk, &text);
    } else {
        lx_hint(walk->diagnostics, LX_MSG_HINT_TURN_ROUND, NULL);
    }
}

void lx_advise_unseen(struct lx_walk *walk, const luxel_scene *scene)
{
    if (scene->parameters.surfaces.count == 0)
        report_no_surfaces(walk, LUXEL_SEVERITY_ADVICE);
    const struct watch watch = watch_of(&scene->parameters.observer);
    const struct lx_document *document = walk->document;
    lx_node_id id = lx_document_node(document, lx_document_find(document, document->root, "surfaces"))->first;
    for (size_t i = 0; i < scene->parameters.surfaces.count; i++, id = lx_document_node(document, id)->next) {
        enum lx_standing standing;
        double top_mm;
        if (!standing_of(scene, &watch, i, &standing, &top_mm) || standing != LX_SEES_BACK)
            continue;
        struct lx_step list = {NULL, "surfaces", 0}, item = {&list, NULL, i};
        const lx_node_id axis = lx_document_find(document, id, "axis");
        lx_walk_report(walk, LUXEL_SEVERITY_ADVICE, lx_document_place(document, axis ? axis : id), &item,
                       LX_MSG_SHOWS_BACK, NULL, NULL);
        hint_turn(walk, &scene->parameters.surfaces.items[i], i);
    }
}
