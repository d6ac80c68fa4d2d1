/* SPDX-License-Identifier: MIT */
/*
 * The balance of the flux and the means of surfaces against truths: in a closed room of one reflectance the mean is
 * flux/(S (1 - rho)) and all is absorbed, in an integrating sphere as well; between two plates in uniform light the
 * form factor tells what meets the other one; what the tool is to be told where there is no balance or a bound was
 * missed; the same digits for any number of threads.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 2000 };

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"
#define CUBE "{type: room, name: cube, center: [0, 0, 0], size: [4000, 4000, 4000], " MATERIAL("0.5") "}"
#define PLATES                                                                                                         \
    "{type: rectangle, center: [-1500, 0, 0], size: [4000, 4000], axis: [1, 0, 0], " MATERIAL(                         \
        "0.5") "}, {type: rectangle, center: [1500, 0, 0], size: [4000, 4000], axis: [-1, 0, 0], " MATERIAL("0.8") "}"
#define LAMP "{type: point, position: [300, -200, 100], power: 10000}"
#define UNIFORM "{type: ambient, irradiance: 1}"

static luxel_scene *scene_of(const char *keys, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length =
        snprintf(text, sizeof text,
                 "luxel: 1\nunits: photometric\n%s\nscreen: {width: 400, height: 400, resolution: "
                 "[4, 4]}\nobserver: {z: 30000, projection: perspective}\nsurfaces: [%s]\nlights: [%s]\n",
                 keys, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

static luxel_balance *balance_of(const char *keys, const char *surfaces, const char *lights)
{
    luxel_balance *balance = NULL;
    luxel_scene *scene = scene_of(keys, surfaces, lights);
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.reflected_error = 1e-3;
    assert_int_equal(luxel_find_balance(scene, &settings, NULL, &balance), LUXEL_OK);
    luxel_scene_free(scene);
    assert_non_null(balance);
    assert_true(balance->closes);
    assert_true(balance->reached);
    return balance;
}

/* Inside its bound, which is no more than `most`. */
#define EXPECT(amount, truth, most) expect(__LINE__, &(amount), truth, most)
static void expect(int line, const luxel_bounded *amount, double truth, double most)
{
    if (!(fabs(amount->value - truth) <= amount->error + 1e-12 * fabs(truth)) || !(amount->error <= most))
        fail_msg("line %d: %.10g ± %.2g instead of %.10g", line, amount->value, amount->error, truth);
}

static void closed_room(void **state)
{
    (void)state;
    static const char *const walls[] = {"left", "right", "floor", "ceiling", "back", "front"};
    luxel_balance *balance = balance_of("reflections: all", CUBE, LAMP);
    double direct = 0, all = 0;
    assert_int_equal(balance->side_count, 6);
    for (size_t i = 0; i < 6; i++) {
        const luxel_balance_side *side = &balance->sides[i];
        assert_string_equal(side->surface_name, "cube");
        assert_string_equal(side->part_name, walls[i]);
        assert_int_equal(side->part, i);
        assert_int_equal(side->side, LUXEL_SIDE_FRONT);
        assert_true(fabs(side->area_m2 - 16) < 1e-6 && side->reflectance == 0.5);
        assert_true(side->irradiance.error <= 2e-3 * side->irradiance.value);
        direct += side->direct.value / 6;
        all += side->irradiance.value / 6;
    }
    assert_string_equal(balance->unit, "lx");
    assert_string_equal(balance->flux_unit, "lm");
    assert_true(fabs(direct - 10000.0 / 96) < 1e-4 && fabs(all - 10000.0 / 48) < 0.01);
    assert_true(balance->has_emitted);
    EXPECT(balance->emitted, 10000, 1e-6);
    EXPECT(balance->missed, 0, 1);
    EXPECT(balance->arrives, 10000, 1);
    EXPECT(balance->absorbed, 10000, 20);
    EXPECT(balance->escaped, 0, 20);
    EXPECT(balance->pending, 0, 0);
    EXPECT(balance->difference, 0, 60);
    luxel_balance_free(balance);
    /* after two bounces 1/8 of all is on its way */
    balance = balance_of("reflections: 2", CUBE, LAMP);
    EXPECT(balance->absorbed, 8750, 20);
    EXPECT(balance->pending, 1250, 40);
    EXPECT(balance->escaped, 0, 20);
    luxel_balance_free(balance);
}

static void integrating_sphere(void **state)
{
    (void)state;
    const char *sphere = "{type: sphere, center: [0, 0, 0], radius: 500, inside: true, " MATERIAL("0.9") "}";
    luxel_balance *balance = balance_of("reflections: all", sphere,
                                        "{type: spot, position: [0, 100, 50], axis: [1, 0.3, 0.2], inner: 10, outer: "
                                        "40, power: 1000}");
    assert_int_equal(balance->side_count, 1);
    assert_int_equal(balance->sides[0].side, LUXEL_SIDE_INSIDE);
    assert_null(balance->sides[0].surface_name);
    assert_null(balance->sides[0].part_name);
    EXPECT(balance->sides[0].direct, 1000 / M_PI, 0.1);
    EXPECT(balance->sides[0].irradiance, 10000 / M_PI, 3);
    EXPECT(balance->absorbed, 1000, 1);
    EXPECT(balance->missed, 0, 0.1);
    luxel_balance_free(balance);
}

/* The form factor of two squares of 4 m at 3 m; outer sides have what is uniform alone. */
static void plates(void **state)
{
    (void)state;
    const double factor = 0.28273278739747;
    luxel_balance *balance = balance_of("reflections: 1", PLATES, UNIFORM);
    assert_int_equal(balance->side_count, 4);
    assert_int_equal(balance->sides[0].side, LUXEL_SIDE_FRONT);
    assert_int_equal(balance->sides[1].side, LUXEL_SIDE_BACK);
    EXPECT(balance->sides[0].irradiance, 1 + 0.8 * factor, 2e-3);
    EXPECT(balance->sides[1].irradiance, 1, 2e-3);
    EXPECT(balance->sides[2].irradiance, 1 + 0.5 * factor, 2e-3);
    assert_false(balance->has_emitted);
    EXPECT(balance->arrives, 64, 1e-3);
    EXPECT(balance->escaped, 32 * 0.5 + 32 * 0.8 - 16 * 1.3 * factor, 0.1);
    EXPECT(balance->pending, 16 * 2 * 0.5 * 0.8 * factor, 0.1);
    EXPECT(balance->absorbed, 16 * (0.5 * (2 + 0.8 * factor) + 0.2 * (2 + 0.5 * factor)), 0.1);
    luxel_balance_free(balance);
    /* a point in the middle between squares of 2 m that are 2 m apart sees a sixth of all in each */
    balance = balance_of("reflections: all",
                         "{type: rectangle, center: [-1000, 0, 0], size: [2000, 2000], axis: [1, 0, 0], " MATERIAL(
                             "0.5") "}, {type: rectangle, center: [1000, 0, 0], size: [2000, 2000], axis: [-1, 0, "
                                    "0], " MATERIAL("0.8") "}",
                         "{type: point, position: [0, 0, 0], power: 600}");
    assert_int_equal(balance->side_count, 2);
    assert_int_equal(balance->sides[1].side, LUXEL_SIDE_FRONT);
    EXPECT(balance->sides[0].direct, 25, 0.01);
    EXPECT(balance->missed, 400, 0.1);
    luxel_balance_free(balance);
}

static void without(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_balance *balance = NULL;
    luxel_scene *scene = scene_of("reflections: none", CUBE, LAMP);
    assert_int_equal(luxel_find_balance(scene, NULL, diagnostics, &balance), LUXEL_OK);
    assert_null(balance);
    assert_int_equal(luxel_find_balance(scene, NULL, diagnostics, NULL), LUXEL_ERROR_ARGUMENT);
    expect_entry(diagnostics, 0, WANTED("missing-argument", 0));
    assert_int_equal(luxel_find_balance(NULL, NULL, NULL, &balance), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
    luxel_balance_free(NULL);
    assert_null(luxel_surface_side_name((luxel_surface_side)7));
    assert_string_equal(luxel_surface_side_name(LUXEL_SIDE_OUTSIDE), "outside");
    luxel_diagnostics_free(diagnostics);
    /* without all shadows light goes through surfaces, and its sum tells nothing */
    balance = balance_of("reflections: 1\nshadows: none", CUBE, LAMP);
    assert_false(balance->has_emitted);
    assert_true(balance->emitted.value == 0 && balance->missed.value == 0);
    luxel_balance_free(balance);
}

static void missed_bound(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_settings settings;
    luxel_balance *balance = NULL;
    luxel_scene *scene = scene_of("reflections: 1", PLATES, UNIFORM);
    luxel_settings_init(&settings);
    settings.reflected_error = 1e-14;
    assert_int_equal(luxel_find_balance(scene, &settings, diagnostics, &balance), LUXEL_OK);
    assert_false(balance->reached);
    expect_entry(diagnostics, 0, WANTED("balance-error", 0));
    luxel_balance_free(balance);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

static void threads(void **state)
{
    (void)state;
    luxel_balance *found[2];
    luxel_scene *scene = scene_of("reflections: all", CUBE, LAMP);
    for (unsigned i = 0; i < 2; i++) {
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.threads = 1 + 2 * i;
        settings.reflected_error = 0.02;
        assert_int_equal(luxel_find_balance(scene, &settings, NULL, &found[i]), LUXEL_OK);
    }
    assert_memory_equal(&found[0]->absorbed, &found[1]->absorbed, sizeof found[0]->absorbed);
    assert_memory_equal(&found[0]->difference, &found[1]->difference, sizeof found[0]->difference);
    for (size_t i = 0; i < 6; i++)
        assert_memory_equal(&found[0]->sides[i].irradiance, &found[1]->sides[i].irradiance, sizeof(luxel_bounded));
    luxel_balance_free(found[0]);
    luxel_balance_free(found[1]);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closed_room), cmocka_unit_test(integrating_sphere), cmocka_unit_test(plates),
        cmocka_unit_test(without),     cmocka_unit_test(missed_bound),       cmocka_unit_test(threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
