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

/* The index of the surface that reaches highest among those without errors, and how high; count: none. */
static size_t highest_surface(const struct lx_list *surfaces, double *z_mm)
{
    size_t highest = surfaces->count;
    *z_mm = -HUGE_VAL;
    for (size_t i = 0; i < surfaces->count; i++) {
        const struct lx_item *item = &surfaces->items[i];
        if (!item->variant)
            continue;
        double low[3], high[3];
        ((const struct lx_surface_kind *)item->variant)->extent(item->parameters, low, high);
        if (highest == surfaces->count || high[2] > *z_mm) {
            highest = i;
            *z_mm = high[2];
        }
    }
    return highest;
}

static void check_observer(struct lx_walk *walk, const luxel_scene *scene)
{
    const struct lx_observer *observer = &scene->parameters.observer;
    struct lx_place place = lx_document_place(walk->document, lx_scene_node(scene, "observer", "z"));
    struct lx_step group = {NULL, "observer", 0}, step = {&group, "z", 0};
    char number[LX_NUMBER_SIZE];
    if (observer->projection == LX_PERSPECTIVE && !(observer->z_mm > 0))
        return; /* a rule of its table, and reported by it */
    double highest;
    size_t surface = highest_surface(&scene->parameters.surfaces, &highest);
    if (surface < scene->parameters.surfaces.count && !(observer->z_mm > highest)) {
        char name[40];
        snprintf(name, sizeof name, "surfaces[%zu]", surface);
        lx_walk_report(walk, LUXEL_SEVERITY_ERROR, place, &step, LX_MSG_OBSERVER_TOO_LOW, name,
                       lx_write_number(highest, number));
        if (isfinite(highest))
            lx_hint(walk->diagnostics, LX_MSG_HINT_RAISE_OBSERVER, LX_ARGS(number));
    }
}

/* Whether a key of a group of the scene is written and good. */
static bool is_good(const char *group, const void *parameters, const char *key)
{
    return lx_is_given(lx_find_parameter(&lx_scene_table, group)->group, parameters, key);
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
