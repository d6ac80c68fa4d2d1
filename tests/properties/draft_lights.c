/* SPDX-License-Identifier: MIT */
/*
 * The lights of random scenes, of all kinds but those that are read from files: around the surfaces, and where programs
 * err: on a surface and in it, right above it, at the observer, very far.
 */
#include "draft.h"

#include <math.h>
#include <string.h>

/* Each way, of a picture of an extended source. */
enum { MOST_DEAR_PIXELS = 3 };

static double size_of(const struct draft_surface *surface)
{
    return surface->numbers.size[0];
}

static void add(double v[3], const double direction[3], double length)
{
    for (int i = 0; i < 3; i++)
        v[i] += direction[i] * length;
}

/* A place on a surface: of a sphere anywhere, of a rectangle on its plane about the centre. */
static void choose_place_on(struct choices *choices, const struct draft_surface *surface, double place[3],
                            double normal[3])
{
    const struct draft_surface_numbers *numbers = &surface->numbers;
    memcpy(place, numbers->center, sizeof numbers->center);
    if (surface->words.type == DRAFT_SPHERE) {
        draft_choose_direction(choices, normal);
        add(place, normal, numbers->size[0]);
        return;
    }
    const double *axis = numbers->axis;
    const double length = hypot(hypot(axis[0], axis[1]), axis[2]);
    const double beside[3] = {axis[2] / length, 0, -axis[0] / length};
    for (int i = 0; i < 3; i++)
        normal[i] = axis[i] / length;
    add(place, beside, choose_between(choices, -0.5, 0.5) * numbers->size[0]);
}

/* A place as far out as the range goes, or one of few digits. */
static void choose_odd_place(struct choices *choices, double place[3])
{
    static const double edges[] = {0, 1, -1, 1000, 1e-6, 1e6, -1e9, 1e12};
    for (int i = 0; i < 3; i++)
        place[i] = edges[choose(choices, sizeof edges / sizeof edges[0])];
}

/* Where a pixel sees the first surface along -z, and the normal there. */
static void choose_sample(struct choices *choices, const struct draft *draft, double place[3], double normal[3])
{
    const struct draft_words *words = &draft->words;
    const struct draft_surface *first = &draft->surfaces[0];
    const double pitch = draft->numbers.pitch, width = pitch * words->columns, height = pitch * words->rows;
    const double i = choose(choices, words->columns), j = choose(choices, words->rows);
    const bool has_edges = words->nodes && words->columns > 1 && words->rows > 1;
    place[0] = has_edges ? -width / 2 + i * width / (words->columns - 1) : -width / 2 + (i + 0.5) * pitch;
    place[1] = has_edges ? height / 2 - j * height / (words->rows - 1) : height / 2 - (j + 0.5) * pitch;
    place[2] = first->numbers.center[2];
    memcpy(normal, first->numbers.axis, sizeof first->numbers.axis);
    if (first->words.type != DRAFT_SPHERE)
        return;
    const double radius = first->numbers.size[0];
    normal[0] = (place[0] - first->numbers.center[0]) / radius;
    normal[1] = (place[1] - first->numbers.center[1]) / radius;
    normal[2] = sqrt(fmax(1 - normal[0] * normal[0] - normal[1] * normal[1], 0));
    place[2] += radius * normal[2];
}

/* At a sample, or above it, mostly near. */
static void choose_place_above_sample(struct choices *choices, const struct draft *draft, double place[3])
{
    const double above[3] = {0, 0, 1};
    double normal[3];
    choose_sample(choices, draft, place, normal);
    if (choose(choices, 4))
        add(place, above, size_of(&draft->surfaces[0]) * choose_size(choices, 1e-12, 1));
}

/* Where the light makes the peak of its highlight at a sample, or nearly there. */
static void choose_mirrored_place(struct choices *choices, const struct draft *draft, double place[3])
{
    double normal[3];
    choose_sample(choices, draft, place, normal);
    const double mirrored[3] = {2 * normal[2] * normal[0], 2 * normal[2] * normal[1], 2 * normal[2] * normal[2] - 1};
    add(place, mirrored, size_of(&draft->surfaces[0]) * choose_size(choices, 1e-3, 30));
    place[choose(choices, 3)] += size_of(&draft->surfaces[0]) * choose_size(choices, 1e-9, 1e-2);
}

void draft_choose_place(struct choices *choices, const struct draft *draft, double place[3])
{
    const struct draft_surface *surface = &draft->surfaces[choose(choices, (unsigned)draft->surface_count)];
    const double size = size_of(surface);
    double normal[3];
    choose_place_on(choices, surface, place, normal);
    switch (choose(choices, 16)) {
    case 8: add(place, normal, size * choose_size(choices, 1e-9, 0.1)); break;
    case 9: break;
    case 10: add(place, normal, -size * choose_between(choices, 0, 2)); break;
    case 11: place[0] = place[1] = 0, place[2] = draft->numbers.observer_z; break;
    case 12: choose_odd_place(choices, place); break;
    case 13: add(place, normal, size * choose_size(choices, 1, 1e9)); break;
    case 14: choose_place_above_sample(choices, draft, place); break;
    case 15: choose_mirrored_place(choices, draft, place); break;
    default: add(place, normal, size * choose_size(choices, 0.05, 30)); break;
    }
}

static double choose_strength(struct choices *choices)
{
    static const double edges[] = {1, 0, 4.9406564584124654e-324, 1e-310, 1e-200, 1e-40, 1e-30, 1e25, 1e37, 1e200};
    if (choose_rarely(choices, 8))
        return edges[choose(choices, sizeof edges / sizeof edges[0])];
    return choose_size(choices, 0.01, 1e4);
}

static double choose_exponent(struct choices *choices)
{
    static const double edges[] = {1, 0, 0.5, 2, 3.5, 1e-3, 100, 1e5};
    return choose(choices, 2) ? choose_between(choices, 0, 20) : edges[choose(choices, sizeof edges / sizeof edges[0])];
}

/* Where a light shines: at a surface, by a point to aim at or an axis of any length, or anywhere. */
static void choose_towards(struct choices *choices, const struct draft *draft, struct draft_light *light)
{
    double *towards = light->numbers.towards;
    const double *place = light->numbers.place;
    double normal[3];
    if (choose_rarely(choices, 4)) {
        draft_choose_direction(choices, towards);
        return;
    }
    if (choose(choices, 2))
        choose_sample(choices, draft, towards, normal);
    else
        choose_place_on(choices, &draft->surfaces[choose(choices, (unsigned)draft->surface_count)], towards, normal);
    light->words.is_aimed = choose(choices, 2);
    if (light->words.is_aimed)
        return;
    const double length = choose_rarely(choices, 8) ? choose_size(choices, 1e-12, 1e12) : 1;
    for (int i = 0; i < 3; i++)
        towards[i] = (towards[i] - place[i]) * length;
}

static void choose_law(struct choices *choices, double size, struct draft_light *light)
{
    light->words.law = choose(choices, DRAFT_LAWS);
    light->numbers.k = size * choose_size(choices, 1e-3, 1e3);
    for (int i = 0; i < 3; i++) /* each term counts at distances like the size */
        light->numbers.coefficients[i] = choose_size(choices, 1e-3, 1e3) * pow(1e3 / size, i);
}

static void choose_cone(struct choices *choices, struct draft_light *light)
{
    struct draft_light_numbers *numbers = &light->numbers;
    light->words.falloff = choose(choices, 4);
    numbers->outer = choose(choices, 4) ? choose_between(choices, 5, 90) : choose_size(choices, 1e-6, 90);
    if (choose_rarely(choices, 8))
        numbers->outer = 90;
    const unsigned kind = choose(choices, 8);
    numbers->inner = numbers->outer * (kind == 0   ? 0
                                       : kind == 1 ? 1
                                       : kind == 2 ? 1 - choose_size(choices, 1e-9, 0.1)
                                                   : choose_between(choices, 0, 1));
}

/* Two directions at right angles to a third. */
static void choose_plane(const double axis[3], double across[3], double upward[3])
{
    const double length = hypot(hypot(axis[0], axis[1]), axis[2]);
    const double n[3] = {axis[0] / length, axis[1] / length, axis[2] / length};
    const int least = fabs(n[0]) <= fabs(n[1]) && fabs(n[0]) <= fabs(n[2]) ? 0 : fabs(n[1]) <= fabs(n[2]) ? 1 : 2;
    double square = 1 - n[least] * n[least];
    for (int i = 0; i < 3; i++)
        across[i] = ((i == least) - n[least] * n[i]) / sqrt(square);
    for (int i = 0; i < 3; i++)
        upward[i] = n[(i + 1) % 3] * across[(i + 2) % 3] - n[(i + 2) % 3] * across[(i + 1) % 3];
}

/* A triangle, a kite, or an L, which is not convex. */
static void choose_corners(struct choices *choices, struct draft_light *light)
{
    static const double outlines[3][DRAFT_CORNERS][2] = {
        {{-1, -1}, {1, -1}, {0, 1}},
        {{-1, 0}, {0, -0.5}, {1, 0}, {0, 2}},
        {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}},
    };
    static const unsigned counts[] = {3, 4, 6};
    const unsigned outline = choose(choices, 3);
    double across[3], upward[3], axis[3];
    draft_choose_direction(choices, axis);
    choose_plane(axis, across, upward);
    light->words.corners = counts[outline];
    for (unsigned i = 0; i < counts[outline]; i++) {
        memcpy(light->numbers.corners[i], light->numbers.place, sizeof light->numbers.place);
        add(light->numbers.corners[i], across, outlines[outline][i][0] * light->numbers.size[0]);
        add(light->numbers.corners[i], upward, outlines[outline][i][1] * light->numbers.size[1]);
    }
}

static void choose_extent(struct choices *choices, double size, struct draft_light *light)
{
    static const unsigned facets[] = {0, 0, 0, 8, 4, 12};
    struct draft_light_words *words = &light->words;
    words->shape = choose(choices, words->type == DRAFT_PLANAR ? DRAFT_OUTLINES : DRAFT_BODIES);
    words->measure = choose(choices, words->type == DRAFT_PLANAR ? 3 : 2);
    words->facets = facets[choose(choices, 6)];
    for (int i = 0; i < 3; i++)
        light->numbers.size[i] =
            size * (choose_rarely(choices, 6) ? choose_size(choices, 1e-6, 1e3) : choose_size(choices, 0.02, 1));
    choose_corners(choices, light);
}

/* One light in so many is extended; 0: none. */
static enum draft_light_type choose_type(struct choices *choices, unsigned extended_one_in)
{
    static const enum draft_light_type types[] = {DRAFT_POINT, DRAFT_POINT,   DRAFT_SPOT,
                                                  DRAFT_SPOT,  DRAFT_DISTANT, DRAFT_AMBIENT};
    if (extended_one_in > 0 && choose_rarely(choices, extended_one_in))
        return choose(choices, 2) ? DRAFT_VOLUME : DRAFT_PLANAR;
    return types[choose(choices, sizeof types / sizeof types[0])];
}

static void choose_light(struct choices *choices, const struct draft *draft, unsigned extended_one_in,
                         struct draft_light *light)
{
    const double size = size_of(&draft->surfaces[0]);
    *light = draft_plain_light;
    light->words.type = choose_type(choices, extended_one_in);
    light->numbers.strength = choose_strength(choices);
    if (light->words.type == DRAFT_AMBIENT)
        return;
    draft_choose_place(choices, draft, light->numbers.place);
    choose_towards(choices, draft, light);
    choose_law(choices, size, light);
    light->numbers.exponent = choose_exponent(choices);
    if (light->words.type == DRAFT_DISTANT) {
        light->words.is_aimed = 0;
    } else if (light->words.type == DRAFT_POINT) {
        light->words.pattern = choose(choices, 3);
    } else if (light->words.type == DRAFT_SPOT) {
        choose_cone(choices, light);
        light->numbers.exponent = choose(choices, 2) ? light->numbers.exponent : 0;
    } else {
        light->words.parts = choose_rarely(choices, 3) ? 1 + choose(choices, 4) : 0;
        choose_extent(choices, size, light);
    }
}

void draft_make_lights(struct choices *choices, unsigned extended_one_in, struct draft *draft)
{
    draft->light_count = choose_rarely(choices, 32) ? 0 : 1 + choose(choices, DRAFT_LIGHTS);
    for (size_t i = 0; i < draft->light_count; i++)
        choose_light(choices, draft, draft_has_extended(draft) ? 0 : extended_one_in, &draft->lights[i]);
    if (draft_has_extended(draft)) {
        draft->words.columns = draft->words.columns < MOST_DEAR_PIXELS ? draft->words.columns : MOST_DEAR_PIXELS;
        draft->words.rows = draft->words.rows < MOST_DEAR_PIXELS ? draft->words.rows : MOST_DEAR_PIXELS;
    }
}
