/* SPDX-License-Identifier: MIT */
/*
 * Skies by borders: what is seen of skies of all kinds through windows, with glass and without, and in the open, behind
 * bodies that touch each other and the floor, is by the potentials of coarse integrals what fine integrals over arcs
 * tell, within both bounds; and few coarse integrals fall back on arcs.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "campaign.h"
#include "scenes.h"
#include "shadow_scenes.h"

#include "../../src/base/vector.h"
#include "../../src/light/sky/dome.h"
#include "../../src/light/sky/perez.h"
#include "../../src/world/integral/sky_potential.h"
#include "../../src/world/reference.h"

enum { MOST_SIZE = 8192, SIZE = 400 };

/* On the floor, or on each other, in a mesh of 20 mm. */
static char *write_bodies(struct dice *dice, char *end, const char *text)
{
    static const char *const kinds[] = {
        "{type: box, center: [%g, %g, %g], size: [40, 40, 40], rotate: [0, %d, 0]",
        "{type: sphere, center: [%g, %g, %g], radius: 20, name: s%d",
        "{type: cylinder, center: [%g, %g, %g], radius: 20, height: 40, axis: [0, 1, 0], name: c%d",
        "{type: disk, center: [%g, %g, %g], radius: 40, axis: [0, 1, 0], name: d%d",
        "{type: rectangle, center: [%g, %g, %g], size: [80, 40], axis: [0, 0, 1], up: [0, 1, 0], name: r%d",
    };
    enum { KINDS_HERE = sizeof kinds / sizeof *kinds, MESH = 20 };
    for (int i = 0, count = dice_pick(dice, 4); i < count; i++) {
        const double x = MESH * (dice_pick(dice, 9) - 4), z = MESH * (dice_pick(dice, 9) - 4);
        const double y = 20 + (dice_pick(dice, 3) == 0 ? MESH * dice_pick(dice, 6) : 0);
        const int kind = dice_pick(dice, KINDS_HERE), number = kind == 0 ? 30 * dice_pick(dice, 3) : i;
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), "  - ");
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), kinds[kind], x, y, z, number);
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), ", material: {model: lambert}}\n");
    }
    return end;
}

static void write_scene(struct dice *dice, bool is_room, unsigned kind, char *text)
{
    static const char *const walls[] = {"left", "right", "back", "front", "ceiling"};
    static const double altitudes[] = {0.01, 1, 12, 45, 70, 90};
    const double altitude = altitudes[dice_pick(dice, 6)], azimuth = dice_uniform(dice, 0, 360);
    char *end = text + snprintf(text, MOST_SIZE,
                                "luxel: 1\nobserver: {z: 3000}\n"
                                "screen: {width: 400, height: 400, resolution: [8, 8]}\nsurfaces:\n");
    end += snprintf(end, (size_t)(text + MOST_SIZE - end),
                    is_room ? "  - {type: room, center: [0, 200, 0], size: [%d, 400, %d], material: {model: lambert}, "
                              "openings: ["
                            : "  - {type: rectangle, center: [0, 0, 0], size: [%d, %d], axis: [0, 1, 0], "
                              "up: [0, 0, -1], material: {model: lambert}}\n",
                    SIZE, SIZE);
    const int first = dice_pick(dice, 5), count = 1 + dice_pick(dice, 2);
    for (int i = 0; is_room && i < count; i++) {
        const bool has_glass = dice_pick(dice, 2);
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), "%s{wall: %s, center: [%g, %g], size: [200, 120]%s}",
                        i > 0 ? ", " : "", walls[(first + i) % 5], 20.0 * dice_pick(dice, 5), 20.0 * dice_pick(dice, 5),
                        has_glass ? ", glass: {n: 1.52, transmittance: 0.96}" : "");
    }
    end += snprintf(end, (size_t)(text + MOST_SIZE - end), is_room ? "]}\n" : "");
    end = write_bodies(dice, end, text);
    snprintf(end, (size_t)(text + MOST_SIZE - end),
             "lights:\n  - {type: sky, kind: %u, sun: {altitude: %g, azimuth: %.17g}, zenith: 1, ground: 0.2, "
             "up: [0, 1, 0], north: [0, 0, -1]}\n",
             kind, altitude, azimuth);
}

/* How many integrals went by borders. */
struct tally {
    size_t by_borders, all;
};

/* Less light than that need not be told from nothing. */
static const double SHADE = 1e-3;

static void compare(const char *text, struct dice *dice, struct tally *tally)
{
    enum { ELEMENTS = 3 };
    luxel_scene *scene;
    struct lx_prepared prepared;
    if (load(text, NULL, &scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
    const struct lx_emitter *emitter = &prepared.emitters.items[0];
    for (int i = 0; i < ELEMENTS; i++) {
        luxel_place asked = {.position_mm = {dice_uniform(dice, -180, 180), 0, dice_uniform(dice, -180, 180)},
                             .normal = {0, 1, 0}};
        for (int k = 0; k < 3 && i == 2; k++) {
            asked.position_mm[k] = dice_uniform(dice, -150, 150) + (k == 1 ? 180 : 0);
            asked.normal[k] = dice_uniform(dice, -1, 1);
        }
        const struct lx_element element = lx_element_at(&prepared, &asked);
        prepared.tolerance = 1e-3;
        const struct lx_lighting found = lx_light_directly(&prepared, &element, emitter);
        struct lx_prepared without = prepared; /* what keeps nothing finds all anew, by arcs */
        without.potentials = NULL;
        without.open_domes = NULL;
        const size_t of_arcs = lx_light_directly(&without, &element, emitter).parts;
        prepared.tolerance = 1e-8;
        const lx_bounded seen = lx_light_directly(&prepared, &element, emitter).irradiance;
        if (seen.value > 0) {
            tally->all++;
            tally->by_borders += found.parts < of_arcs || found.parts <= 2;
        }
        if (!(fabs(found.irradiance.value - seen.value) <= seen.error + found.irradiance.error) ||
            !(found.irradiance.error <= 1e-3 * (found.irradiance.value + SHADE)))
            fail_msg("%.17g +- %g by borders, %.17g +- %g by arcs, at (%.17g, %.17g, %.17g), normal %g %g %g:\n%s",
                     found.irradiance.value, found.irradiance.error, seen.value, seen.error, asked.position_mm[0],
                     asked.position_mm[1], asked.position_mm[2], asked.normal[0], asked.normal[1], asked.normal[2],
                     text);
    }
    lx_prepared_clear(&prepared);
    luxel_scene_free(scene);
}

static void try_scenes(bool is_room, unsigned seed)
{
    enum { ROUNDS = 32 };
    const int rounds = scenes_to_try(ROUNDS);
    struct dice dice = {seed};
    struct tally tally = {0};
    char text[MOST_SIZE];
    for (int i = 0; i < rounds; i++) {
        write_scene(&dice, is_room, 1 + (unsigned)i % LX_SKY_KINDS, text);
        compare(text, &dice, &tally);
    }
    assert_true(tally.by_borders * 10 >= tally.all * 9);
}

static void through_windows(void **state)
{
    (void)state;
    try_scenes(true, 5);
}

static void in_the_open(void **state)
{
    (void)state;
    try_scenes(false, 6);
}

/* ---- potentials ---- */

/* Along the edge from one direction to another, by the middles of small steps. */
static lx_bounded along_edge(const struct lx_sky_potential *potential, const double from[3], const double to[3],
                             const double normal[3])
{
    enum { STEPS = 4000 };
    lx_bounded sum = {0, 0};
    double step[3];
    for (int k = 0; k < 3; k++)
        step[k] = (to[k] - from[k]) / STEPS;
    for (int i = 0; i < STEPS; i++) {
        double towards[3];
        for (int k = 0; k < 3; k++)
            towards[k] = from[k] + (i + 0.5) * step[k];
        const lx_bounded part = lx_sky_potential_step(potential, towards, step, normal);
        sum.value += part.value;
        sum.error += part.error;
    }
    return sum;
}

/* Over a triangle of directions by halving its edges so often: the luminance at the middle of each small one. */
static double over_triangle(const struct lx_sky *sky, const struct lx_glass_pane *pane, const double a[3],
                            const double b[3], const double c[3], const double normal[3], int depth)
{
    double ab[3], bc[3], ca[3], middle[3], cross[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = (a[k] + b[k]) / 2, bc[k] = (b[k] + c[k]) / 2, ca[k] = (c[k] + a[k]) / 2;
        middle[k] = (a[k] + b[k] + c[k]) / 3;
    }
    if (depth > 0)
        return over_triangle(sky, pane, a, ab, ca, normal, depth - 1) +
               over_triangle(sky, pane, ab, b, bc, normal, depth - 1) +
               over_triangle(sky, pane, ca, bc, c, normal, depth - 1) +
               over_triangle(sky, pane, ab, bc, ca, normal, depth - 1);
    lx_cross(a, b, cross);
    const double length = lx_normalize(middle), solid = lx_dot(c, cross) / 2 / (length * length * length);
    return solid * lx_dot(middle, normal) * (sky ? lx_sky_luminance(sky, middle) : 1) *
           (pane && pane->index > 0 ? lx_pane_transmittance(pane, -lx_dot(pane->axis, middle)) : 1);
}

/* Triangles of directions by both. */
static void potentials_are_integrals(void **state)
{
    (void)state;
    enum { DEPTH = 7 };
    static const double up[3] = {0, 1, 0}, normal[3] = {0.3, 0.5, -0.4};
    static const double corners[2][3][3] = {{{-1, 0.9, 0.2}, {-1, 0.1, 0.9}, {-0.7, 0.02, -0.6}},
                                            {{-0.8, 0.9, -0.4}, {-1, 0.3, 0.3}, {-0.1, 0.2, -0.6}}};
    for (unsigned kind = 0; kind <= LX_SKY_KINDS; kind++)
        for (int glass = kind == 0; glass < 3; glass++) {
            const double sun[3] = {glass == 1 ? 0.6 : -0.6, 0.64, 0.48};
            const struct lx_sky sky = lx_sky_of_kind(kind > 0 ? kind : 1, up, sun), *shown = kind > 0 ? &sky : NULL;
            const struct lx_glass_pane pane = {.axis = {1, 0, 0}, .index = glass > 0 ? 1.52 : 0, .transmittance = 0.96};
            struct lx_sky_potential *potential = lx_sky_potential_new(shown, &pane);
            assert_true(potential && lx_sky_potential_is_good(potential));
            for (int i = 0; i < 2; i++) {
                lx_bounded sum = {0, 0};
                for (int k = 0; k < 3; k++) {
                    const lx_bounded part = along_edge(potential, corners[i][k], corners[i][(k + 1) % 3], normal);
                    sum.value += part.value;
                    sum.error += part.error;
                }
                const double whole =
                    over_triangle(shown, &pane, corners[i][0], corners[i][1], corners[i][2], normal, DEPTH);
                assert_true(fabs(sum.value - whole) < 3e-4 * fabs(whole) + sum.error);
            }
            lx_sky_potential_free(potential);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(potentials_are_integrals),
        cmocka_unit_test(through_windows),
        cmocka_unit_test(in_the_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
