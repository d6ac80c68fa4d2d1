/* SPDX-License-Identifier: MIT */
/*
 * The stage of random scenes: surfaces, a screen that shows the first of them, an observer in front of all.  Most are
 * as users have them; in the others sizes come from the whole legal range.
 */
#include "draft.h"

#include <math.h>
#include <string.h>

/* A number that is not chosen for how it looks but for where programs err. */
static double choose_edge(struct choices *choices)
{
    static const double edges[] = {0, 1, -1, 1000, -300, 1e-3, 1e-6, -1e-6, 1e6, 1e9, -1e9, 1e12};
    return edges[choose(choices, sizeof edges / sizeof edges[0])];
}

void draft_choose_direction(struct choices *choices, double direction[3])
{
    const unsigned kind = choose(choices, 8);
    double length = 0;
    for (int i = 0; i < 3; i++)
        direction[i] = kind == 0 ? 0 : choose_between(choices, -1, 1);
    if (kind == 0) { /* along an axis */
        direction[2 - choose(choices, 3)] = choose(choices, 2) ? -1 : 1;
        return;
    }
    if (kind == 1) /* nearly along x */
        direction[1] *= 1e-9, direction[2] *= 1e-9;
    length = hypot(hypot(direction[0], direction[1]), direction[2]);
    if (length == 0)
        direction[2] = length = 1;
    for (int i = 0; i < 3; i++)
        direction[i] /= length;
}

static double choose_weight(struct choices *choices)
{
    switch (choose(choices, 8)) {
    case 0: return 1;
    case 1: return 0;
    case 2: return choose_size(choices, 1e-12, 1e6);
    default: return choose_between(choices, 0, 1);
    }
}

static double choose_shininess(struct choices *choices)
{
    static const double edges[] = {1, 2, 20, 1e-3, 0.5, 11, 12, 1e4, 65536, 65537, 1e6, 1e-6};
    switch (choose(choices, 4)) {
    case 0: return edges[choose(choices, sizeof edges / sizeof edges[0])];
    case 1: return choose_size(choices, 1e-3, 1e6);
    default: return choose_between(choices, 0.5, 200);
    }
}

static void choose_material(struct choices *choices, struct draft_surface *surface)
{
    surface->words.model = choose(choices, 3);
    surface->words.highlight = choose(choices, 3);
    surface->words.over_pi = choose(choices, 2);
    surface->words.normalized = choose_rarely(choices, 3);
    surface->words.has_ambient = choose_rarely(choices, 3);
    surface->numbers.diffuse = choose_weight(choices);
    surface->numbers.specular = choose_weight(choices);
    surface->numbers.ambient = choose_weight(choices);
    surface->numbers.shininess = choose_shininess(choices);
}

/* The size of all that is in the scene. */
static double choose_scale(struct choices *choices)
{
    switch (choose(choices, 8)) {
    case 6: return choose_size(choices, 1e-8, 1e7);
    case 7: return choose(choices, 2) ? 1e-6 : 1e9;
    default: return choose_between(choices, 50, 600);
    }
}

/* Any front that is seen along -z, mostly straight. */
static void choose_pose(struct choices *choices, struct draft_surface_numbers *numbers)
{
    if (choose(choices, 2) == 0)
        return;
    draft_choose_direction(choices, numbers->axis);
    numbers->axis[2] = fabs(numbers->axis[2]) + choose_size(choices, 1e-6, 1);
    if (choose(choices, 2))
        draft_choose_direction(choices, numbers->up);
}

static void choose_surface(struct choices *choices, double scale, bool is_first, struct draft_surface *surface)
{
    *surface = draft_plain_surface;
    surface->words.type = choose(choices, 8) < 5 ? DRAFT_SPHERE : DRAFT_RECTANGLE;
    const double spread = is_first ? 0.5 : 2;
    for (int i = 0; i < 3; i++)
        surface->numbers.center[i] = choose_between(choices, -spread, spread) * scale;
    surface->numbers.center[2] += choose_between(choices, -1, 4) * scale;
    if (choose_rarely(choices, 8))
        memset(surface->numbers.center, 0, sizeof surface->numbers.center);
    if (choose_rarely(choices, 32))
        surface->numbers.center[choose(choices, 3)] = choose_edge(choices);
    for (int i = 0; i < 2; i++)
        surface->numbers.size[i] = scale * (is_first ? choose_between(choices, 0.5, 2) : choose_size(choices, 0.05, 2));
    if (surface->words.type == DRAFT_RECTANGLE)
        choose_pose(choices, &surface->numbers);
    choose_material(choices, surface);
}

/* The height above which nothing reaches. */
static double top_of(const struct draft_surface *surface)
{
    const double *size = surface->numbers.size;
    return surface->numbers.center[2] + (surface->words.type == DRAFT_SPHERE ? size[0] : hypot(size[0], size[1]) / 2);
}

static void choose_observer(struct choices *choices, double scale, struct draft *draft)
{
    double top = draft->words.perspective ? 0 : -HUGE_VAL;
    for (size_t i = 0; i < draft->surface_count; i++)
        top = fmax(top, top_of(&draft->surfaces[i]));
    double above = scale * choose_size(choices, 0.1, 30);
    if (choose_rarely(choices, 16))
        above = scale * choose_size(choices, 1e-6, 1e9);
    draft->numbers.observer_z = top + fmax(above, 1e-9 * fabs(top));
}

/* A number of few digits, so that sums and halves of its multiples are exact. */
static double rounded(double value)
{
    int exponent;
    const double fraction = frexp(value, &exponent);
    return ldexp(nearbyint(ldexp(fraction, 12)), exponent - 12);
}

static void choose_screen(struct choices *choices, struct draft *draft)
{
    /* Nodes whose distances are exact, so that the screen is as symmetric in numbers as on paper. */
    static const unsigned with_nodes[] = {5, 3, 2, 9, 1}, in_centers[] = {6, 5, 4, 7, 8, 1};
    struct draft_words *words = &draft->words;
    const struct draft_surface_numbers *first = &draft->surfaces[0].numbers;
    words->nodes = choose(choices, 2);
    words->columns = words->nodes ? with_nodes[choose(choices, 5)] : in_centers[choose(choices, 6)];
    words->rows = words->columns;
    if (choose_rarely(choices, 4))
        words->rows = words->nodes ? with_nodes[choose(choices, 5)] : in_centers[choose(choices, 6)];
    double size = 2 * first->size[0] * choose_between(choices, 0.4, 1.6);
    const double away = draft->numbers.observer_z - first->center[2];
    if (words->perspective && away > 0)
        size *= draft->numbers.observer_z / away;
    draft->numbers.pitch = rounded(size / words->columns);
}

/* To a multiple of a step; what was not 0 stays so. */
static double snapped(double value, double step)
{
    const double multiple = nearbyint(value / step);
    return value == 0 || !isfinite(multiple) ? value : multiple == 0 ? copysign(step, value) : multiple * step;
}

static void snap(double *values, size_t count, double step)
{
    for (size_t i = 0; i < count; i++)
        values[i] = snapped(values[i], step);
}

/* Few-digit numbers throughout: cones, horizons, shadows and edges end exactly where samples lie. */
static void snap_draft(struct draft *draft, double step)
{
    for (size_t i = 0; i < draft->surface_count; i++) {
        snap(draft->surfaces[i].numbers.center, 3, step);
        snap(draft->surfaces[i].numbers.size, 2, step);
    }
    for (size_t i = 0; i < draft->light_count; i++) {
        struct draft_light_numbers *numbers = &draft->lights[i].numbers;
        snap(numbers->place, 3, step);
        snap(numbers->towards, 3, step);
        numbers->outer = fmin(snapped(numbers->outer, 15), 90);
        numbers->inner = fmin(snapped(numbers->inner, 15), numbers->outer);
    }
    draft->numbers.observer_z = snapped(draft->numbers.observer_z + 2 * step, step);
    draft->numbers.pitch = snapped(draft->numbers.pitch, step / 2);
}

/* Mostly before a surface; some through a light, which then lies on the middle cell or in its plane. */
static void choose_grid(struct choices *choices, double scale, struct draft *draft)
{
    struct draft_grid *grid = &draft->grid;
    grid->words.columns = 1 + choose(choices, 3);
    grid->words.rows = 1 + choose(choices, 2);
    if (draft->light_count > 0 && choose_rarely(choices, 16))
        memcpy(grid->numbers.center, draft->lights[0].numbers.place, sizeof grid->numbers.center);
    else
        draft_choose_place(choices, draft, grid->numbers.center);
    draft_choose_direction(choices, grid->numbers.axis);
    if (choose(choices, 2))
        draft_choose_direction(choices, grid->numbers.up);
    for (int i = 0; i < 2; i++)
        grid->numbers.size[i] = scale * choose_size(choices, 1e-3, 3);
}

void draft_make(struct choices *choices, unsigned extended_one_in, struct draft *draft)
{
    *draft = draft_plain;
    const double scale = choose_scale(choices);
    draft->words.perspective = choose_rarely(choices, 3);
    draft->words.from_observer = choose_rarely(choices, 3);
    draft->words.no_shadows = choose_rarely(choices, 4);
    draft->surface_count = 1 + (choose_rarely(choices, 3) ? choose(choices, DRAFT_SURFACES) : 0);
    for (size_t i = 0; i < draft->surface_count; i++)
        choose_surface(choices, scale, i == 0, &draft->surfaces[i]);
    choose_observer(choices, scale, draft);
    choose_screen(choices, draft);
    draft_make_lights(choices, extended_one_in, draft);
    if (choose_rarely(choices, 4))
        snap_draft(draft, rounded(scale / 4));
    if (choose(choices, 2)) /* last, so that a seed's scene is as it was without */
        choose_grid(choices, scale, draft);
}
