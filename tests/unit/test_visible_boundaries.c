/* SPDX-License-Identifier: MIT */
/*
 * Visible boundaries of many obstacles: what dozens of balls and plates leave of a source of each kind, as a sum over
 * the borders of what is seen, is what the integral over arcs tells; and pictures do not fall back on the integral,
 * which takes a hundred times as long.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "campaign.h"
#include "scenes.h"
#include "shadow_scenes.h"

#include "../../src/light/solid/extended.h"
#include "../../src/world/integral/cubature.h"
#include "../../src/world/reference.h"
#include "../../src/world/visibility/boundary.h"

static const char *const sources[] = {
    "{type: planar, rectangle: {center: [20, 30, 900], size: [300, 260], aim: [0, 0, 0]}, radiance: 1}",
    "{type: planar, disk: {center: [20, 30, 900], radius: 150, aim: [0, 0, 0]}, radiance: 1}",
    "{type: volume, box: {center: [20, 30, 900], size: [200, 220, 180]}, radiance: 1}",
    "{type: volume, sphere: {center: [20, 30, 900], radius: 140}, radiance: 1}",
};
enum { LAMPS = 4, MOST_SIZE = 16384 };

/* A plate under balls and smaller plates between it and the source. */
static void write_scene(struct dice *dice, int source, int balls, int plates, char *text)
{
    char *end =
        text + snprintf(text, MOST_SIZE,
                        "luxel: 1\nobserver: {z: 3000}\nscreen: {width: 400, height: 400, resolution: [8, 8]}\n"
                        "surfaces:\n  - {type: rectangle, center: [0, 0, 0], size: [400, 400], axis: [0, 0, 1], "
                        "up: [0, 1, 0], material: {model: lambert}}\n");
    for (int i = 0; i < balls + plates; i++) {
        const double x = dice_uniform(dice, -80, 100), y = dice_uniform(dice, -80, 100);
        const double z = dice_uniform(dice, 300, 600), size = dice_uniform(dice, 5, 25);
        end +=
            snprintf(end, (size_t)(text + MOST_SIZE - end),
                     i < balls ? "  - {type: sphere, center: [%g, %g, %g], radius: %g, material: {model: lambert}}\n"
                               : "  - {type: rectangle, center: [%g, %g, %g], size: [%g, 20], axis: [0.1, 0.2, 1], up: "
                                 "[0, 1, 0], material: {model: lambert}}\n",
                     x, y, z, size);
    }
    snprintf(end, (size_t)(text + MOST_SIZE - end), "lights:\n  - %s\n", sources[source]);
}

/* Compares both at some elements of the plate; returns how many of them had so many obstacles. */
static size_t compare(const char *text, struct dice *dice, size_t many)
{
    enum { ELEMENTS = 3 };
    luxel_scene *scene;
    struct lx_prepared prepared;
    size_t had = 0;
    if (load(text, NULL, &scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
    const struct lx_emitter *emitter = &prepared.emitters.items[0];
    for (int i = 0; i < ELEMENTS; i++) {
        const luxel_place asked = {.position_mm = {dice_uniform(dice, -60, 60), dice_uniform(dice, -60, 60), 0},
                                   .normal = {0, 0, 1}};
        const struct lx_element element = lx_element_at(&prepared, &asked);
        struct lx_occlusion occlusion = {.place_mm = {0}};
        lx_bounded found;
        assert_int_equal(lx_occlusion_make(&prepared, &element, emitter, true, &occlusion), 0);
        had += occlusion.obstacles.count >= many;
        if (!lx_boundary_irradiance(emitter, asked.normal, &occlusion, &found))
            fail_msg("%zu obstacles are too many:\n%s", occlusion.obstacles.count, text);
        found = lx_mul(found, emitter->radiance);
        const lx_bounded seen =
            lx_integrate(emitter, &element, &occlusion, true, 0, prepared.tolerance, NULL).irradiance;
        if (!(fabs(found.value - seen.value) <= seen.error + found.error))
            fail_msg("%.17g +- %g by borders, %.17g +- %g by arcs, behind %zu obstacles:\n%s", found.value, found.error,
                     seen.value, seen.error, occlusion.obstacles.count, text);
        lx_occlusion_clear(&occlusion);
    }
    lx_prepared_clear(&prepared);
    luxel_scene_free(scene);
    return had;
}

static void dozens_of_obstacles(void **state)
{
    (void)state;
    enum { ROUNDS = 3, MANY = 15 };
    const int rounds = scenes_to_try(ROUNDS);
    struct dice dice = {31};
    char text[MOST_SIZE];
    size_t had = 0;
    for (int i = 0; i < rounds * LAMPS; i++) {
        write_scene(&dice, i % LAMPS, 30 + dice_pick(&dice, 20), i / LAMPS % 2 ? 10 : 0, text);
        had += compare(text, &dice, MANY);
    }
    assert_true(had >= (size_t)rounds * LAMPS);
}

/* ---- what touches ---- */

static const char *const grid_sources[] = {
    "{type: planar, rectangle: {center: [%g, %g, 900], size: [200, 120], aim: [%g, %g, 0]}, radiance: 1}",
    "{type: planar, disk: {center: [%g, %g, 900], radius: 100, aim: [%g, %g, 0]}, radiance: 1}",
    "{type: volume, sphere: {center: [%g, %g, 900], radius: 100}, radiance: 1}",
    "{type: volume, cylinder: {center: [%g, %g, 900], radius: 40, height: 200, axis: [1, 0, 0]}, radiance: 1}",
    "{type: volume, box: {center: [%g, %g, 900], size: [200, 120, 40]}, radiance: 1}",
};
enum { GRID_LAMPS = 5 };

/* Bodies and plates at places of a grid, as large as its meshes: they stand on each other, side by side, in one plane,
 * and reach into each other. */
static void write_grid(struct dice *dice, int source, char *text)
{
    static const char *const kinds[] = {
        "  - {type: rectangle, center: [%g, %g, %g], size: [80, 40], axis: [0, 0, 1], up: [0, 1, 0]",
        "  - {type: rectangle, center: [%g, %g, %g], size: [40, 80], axis: [0, 1, 0], up: [0, 0, 1]",
        "  - {type: disk, center: [%g, %g, %g], radius: 40, axis: [0, 0, 1]",
        "  - {type: disk, center: [%g, %g, %g], radius: 20, axis: [1, 0, 0]",
        "  - {type: sphere, center: [%g, %g, %g], radius: 20",
        "  - {type: sphere, center: [%g, %g, %g], radius: 40",
        "  - {type: cylinder, center: [%g, %g, %g], radius: 20, height: 80, axis: [0, 0, 1]",
        "  - {type: cylinder, center: [%g, %g, %g], radius: 20, height: 120, axis: [1, 0, 0]",
        "  - {type: cylinder, center: [%g, %g, %g], radius: 40, height: 40, axis: [0, 0.6, 0.8]",
    };
    enum { KINDS_HERE = sizeof kinds / sizeof *kinds, MESH = 20 };
    const int count = 1 + dice_pick(dice, 6);
    char *end = text + snprintf(text, MOST_SIZE,
                                "luxel: 1\nobserver: {z: 3000}\n"
                                "screen: {width: 400, height: 400, resolution: [8, 8]}\nsurfaces:\n"
                                "  - {type: rectangle, center: [0, 0, 0], size: [400, 400], axis: [0, 0, 1], "
                                "up: [0, 1, 0], material: {model: lambert}}\n");
    for (int i = 0; i < count; i++) {
        const double x = MESH * (dice_pick(dice, 9) - 4), y = MESH * (dice_pick(dice, 9) - 4);
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), kinds[dice_pick(dice, KINDS_HERE)], x, y,
                        300.0 + MESH * dice_pick(dice, 8));
        end += snprintf(end, (size_t)(text + MOST_SIZE - end), ", material: {model: lambert}}\n");
    }
    const double at[2] = {MESH * (dice_pick(dice, 5) - 2), MESH * (dice_pick(dice, 5) - 2)};
    const double aim[2] = {dice_pick(dice, 2) ? at[0] : 0, dice_pick(dice, 2) ? at[1] : 0};
    end += snprintf(end, (size_t)(text + MOST_SIZE - end), "lights:\n  - ");
    end += snprintf(end, (size_t)(text + MOST_SIZE - end), grid_sources[source], at[0], at[1], aim[0], aim[1]);
    snprintf(end, (size_t)(text + MOST_SIZE - end), "\n");
}

/* How often it was known, of how many elements that were partly hidden. */
struct tally {
    size_t known, all;
};

static void compare_on_grid(const char *text, struct dice *dice, struct tally *tally)
{
    enum { ELEMENTS = 4, MESH = 20 };
    luxel_scene *scene;
    struct lx_prepared prepared;
    if (load(text, NULL, &scene) != LUXEL_OK)
        fail_msg("not a scene:\n%s", text);
    assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
    const struct lx_emitter *emitter = &prepared.emitters.items[0];
    for (int i = 0; i < ELEMENTS; i++) {
        const double on_grid = i < ELEMENTS / 2 ? 0 : 7;
        const bool is_among = dice_pick(dice, 3) == 0;
        luxel_place asked = {.position_mm = {MESH * (dice_pick(dice, 9) - 4) + dice_uniform(dice, -1, 1) * on_grid,
                                             MESH * (dice_pick(dice, 9) - 4) + dice_uniform(dice, -1, 1) * on_grid, 0},
                             .normal = {0, 0, 1}};
        for (int k = 0; k < 3 && is_among; k++) /* the bodies, or in one */
            asked.position_mm[k] = (k == 2 ? 300 : -80) + dice_uniform(dice, 0, 8 * MESH);
        for (int k = 0; k < 2 && dice_pick(dice, 3) == 0; k++)
            asked.normal[k] = dice_uniform(dice, -3, 3);
        const struct lx_element element = lx_element_at(&prepared, &asked);
        const double normal[3] = {element.normal.x.value, element.normal.y.value, element.normal.z.value};
        struct lx_occlusion occlusion = {.place_mm = {0}};
        lx_bounded found;
        assert_int_equal(lx_occlusion_make(&prepared, &element, emitter, true, &occlusion), 0);
        if (!lx_extended_touches(emitter, element.place_mm) && lx_is_occluded(&occlusion)) {
            const bool is_known = lx_boundary_irradiance(emitter, normal, &occlusion, &found);
            tally->all++;
            tally->known += is_known;
            const lx_bounded seen = lx_integrate(emitter, &element, &occlusion, true, 0, 1e-10, NULL).irradiance;
            if (is_known && !(fabs(found.value - seen.value) <= seen.error + found.error))
                fail_msg("%.17g +- %g by borders, %.17g +- %g by arcs, at (%.17g, %.17g), normal %g %g:\n%s",
                         found.value, found.error, seen.value, seen.error, asked.position_mm[0], asked.position_mm[1],
                         normal[0], normal[1], text);
        }
        lx_occlusion_clear(&occlusion);
    }
    lx_prepared_clear(&prepared);
    luxel_scene_free(scene);
}

static void obstacles_on_a_grid(void **state)
{
    (void)state;
    enum { ROUNDS = 400 };
    const int rounds = scenes_to_try(ROUNDS);
    struct dice dice = {77};
    struct tally tally = {0};
    char text[MOST_SIZE];
    for (int i = 0; i < rounds; i++) {
        write_grid(&dice, i % GRID_LAMPS, text);
        compare_on_grid(text, &dice, &tally);
    }
    assert_true(tally.known * 5 > tally.all * 4);
}

/* What an element on the inner wall of a tube sees is what one sees that is next to it, a little inwards. */
static void on_inner_walls(void **state)
{
    (void)state;
    enum { ROUNDS = 60 };
    static const double INWARDS = 1e-6, SMOOTH = 1e-6;
    const int rounds = scenes_to_try(ROUNDS);
    struct dice dice = {91};
    char text[MOST_SIZE];
    for (int i = 0; i < rounds; i++) {
        const double angle = i % 2 ? dice_uniform(&dice, 0, 2 * M_PI) : M_PI_2 * dice_pick(&dice, 4);
        const double c = cos(angle), s = sin(angle), height = dice_uniform(&dice, 405, 475);
        char *end =
            text + snprintf(text, MOST_SIZE,
                            "luxel: 1\nobserver: {z: 3000}\nscreen: {width: 400, height: 400, resolution: [8, 8]}\n"
                            "surfaces:\n  - {type: cylinder, center: [60, 80, 440], radius: 20, height: 80, "
                            "axis: [0, 0, 1], material: {model: lambert}}\nlights:\n  - ");
        snprintf(end, (size_t)(text + MOST_SIZE - end), grid_sources[i % GRID_LAMPS], 40.0, 60.0, 40.0, 60.0);
        luxel_scene *scene;
        struct lx_prepared prepared;
        if (load(text, NULL, &scene) != LUXEL_OK)
            fail_msg("not a scene:\n%s", text);
        assert_int_equal(lx_prepare(lx_scene_parameters(scene), NULL, NULL, &prepared), 0);
        luxel_place on_wall = {.position_mm = {60 + 20 * c, 80 + 20 * s, height},
                               .normal = {-c + dice_uniform(&dice, -0.9, 0.9), -s + dice_uniform(&dice, -0.9, 0.9),
                                          dice_uniform(&dice, 0, 2)}};
        luxel_place beside = on_wall;
        beside.position_mm[0] -= INWARDS * c;
        beside.position_mm[1] -= INWARDS * s;
        const struct lx_emitter *emitter = &prepared.emitters.items[0];
        const struct lx_element elements[] = {lx_element_at(&prepared, &on_wall), lx_element_at(&prepared, &beside)};
        const lx_bounded found = lx_light_directly(&prepared, &elements[0], emitter).irradiance;
        const lx_bounded next = lx_light_directly(&prepared, &elements[1], emitter).irradiance;
        if (!(fabs(found.value - next.value) <= found.error + next.error + SMOOTH * next.value))
            fail_msg("%.17g +- %g on the wall, %.17g +- %g beside, at %.17g:\n%s", found.value, found.error, next.value,
                     next.error, angle, text);
        lx_prepared_clear(&prepared);
        luxel_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(obstacles_on_a_grid),
        cmocka_unit_test(dozens_of_obstacles),
        cmocka_unit_test(on_inner_walls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
