/* SPDX-License-Identifier: MIT */
/* What must hold between the parts of a scene.  Parts with errors of their own are left out here. */
#include <math.h>
#include <stdio.h>

#include "../base/number.h"
#include "../surface/surface.h"
#include "object.h"

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

/* What an observer of the scene has to do with surface i; false: it has errors of its own. */
static bool standing_of(const luxel_scene *scene, size_t i, enum lx_standing *standing, double *highest_mm)
{
    const struct lx_observer *observer = &scene->parameters.observer;
    const struct lx_item *item = &scene->parameters.surfaces.items[i];
    const struct lx_surface_kind *kind = (const struct lx_surface_kind *)item->variant;
    if (!kind)
        return false;
    double low[3], high[3];
    kind->extent(item->parameters, low, high);
    *highest_mm = high[2];
    *standing = lx_surface_standing(kind, item->parameters, observer->z_mm, observer->projection == LX_PERSPECTIVE);
    return true;
}

/* Of a surface that shows its back: at the observer's height, or at the surface's axis. */
static void report_back(struct lx_walk *walk, const luxel_scene *scene, size_t i, enum lx_standing standing)
{
    const struct lx_document *document = walk->document;
    char name[40];
    snprintf(name, sizeof name, "surfaces[%zu]", i);
    if (standing == LX_STANDS_BEHIND) {
        struct lx_step group = {NULL, "observer", 0}, step = {&group, "z", 0};
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, lx_scene_node(scene, "observer", "z")),
                       &step, LX_MSG_OBSERVER_BEHIND, name, NULL);
        lx_hint(walk->diagnostics, LX_MSG_HINT_TURN_ROUND, NULL);
        return;
    }
    lx_node_id list = lx_document_find(document, document->root, "surfaces");
    lx_node_id id = lx_document_node(document, list)->first;
    for (size_t k = 0; k < i; k++)
        id = lx_document_node(document, id)->next;
    struct lx_step surfaces = {NULL, "surfaces", 0}, item = {&surfaces, NULL, i}, step = {&item, "axis", 0};
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(document, lx_document_find(document, id, "axis")),
                   &step, LX_MSG_TURNED_AWAY, name, NULL);
    lx_hint(walk->diagnostics, LX_MSG_HINT_TURN_UP, NULL);
}

/* Of the surfaces that the observer is not above only the one that reaches highest is reported. */
static void check_observer(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_observer *observer = &scene->parameters.observer;
    if (observer->projection == LX_PERSPECTIVE && !(observer->z_mm > 0))
        return; /* a rule of its table, and reported by it */
    if (lx_scene_node(scene, "observer", "projection") && !is_good("observer", observer, "projection"))
        return;
    size_t count = scene->parameters.surfaces.count, highest = count;
    double highest_mm = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        enum lx_standing standing;
        double top_mm;
        if (!standing_of(scene, i, &standing, &top_mm) || standing == LX_STANDS_BEFORE)
            continue;
        if (standing != LX_STANDS_TOO_LOW) {
            report_back(walk, scene, i, standing);
        } else if (highest == count || top_mm > highest_mm) {
            highest = i;
            highest_mm = top_mm;
        }
    }
    if (highest == count)
        return;
    char name[40], number[LX_NUMBER_SIZE];
    snprintf(name, sizeof name, "surfaces[%zu]", highest);
    struct lx_step group = {NULL, "observer", 0}, step = {&group, "z", 0};
    lx_walk_report(walk, LUXEL_SEVERITY_ERROR, lx_document_place(walk->document, lx_scene_node(scene, "observer", "z")),
                   &step, LX_MSG_OBSERVER_TOO_LOW, name, lx_write_number(highest_mm, number));
    if (isfinite(highest_mm))
        lx_hint(walk->diagnostics, LX_MSG_HINT_RAISE_OBSERVER, LX_ARGS(number));
}

void lx_validate_scene(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_screen *screen = &scene->parameters.screen;
    if (is_good("screen", screen, "width") && is_good("screen", screen, "height") &&
        is_good("screen", screen, "resolution"))
        check_square(walk, scene);
    if (is_good("observer", &scene->parameters.observer, "z"))
        check_observer(walk, scene);
}
