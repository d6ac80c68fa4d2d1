/* SPDX-License-Identifier: MIT */
/*
 * Spheres that are seen from inside, against what is known of integrating spheres: lamps in the centre and beside it,
 * of some size, and outside; what observers see of them; their extrema; and whether pictures keep to the reference.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 3000 };

static double between(double low, double high)
{
    return low + (high - low) * (rand() / (RAND_MAX + 1.0));
}

#define SPHERE                                                                                                         \
    "{type: sphere, center: [10, -20, 30], radius: 500, inside: true, material: {model: lambert, diffuse: 1}}"

static luxel_scene *scene_of(const char *observer, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    int length = snprintf(text, sizeof text,
                          "luxel: 1\nscreen: {width: 1200, height: 1200, resolution: [120, 120]}\nobserver: %s\n"
                          "surfaces: [%s]\nlights: [%s]\n",
                          observer, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

/* A place of the sphere, and the direction inwards or, with `side` less than 0, outwards. */
static void place_on(double side, double place[3], double normal[3])
{
    static const double center[3] = {10, -20, 30};
    double length = 0;
    for (int i = 0; i < 3; i++) {
        normal[i] = between(-1, 1);
        length = hypot(length, normal[i]);
    }
    for (int i = 0; i < 3; i++) {
        place[i] = center[i] - 500 * normal[i] / length;
        normal[i] *= side / length;
    }
}

static double lit(const luxel_scene *scene, const double place[3], const double normal[3])
{
    luxel_probe *probe;
    assert_int_equal(luxel_probe_element(scene, NULL, place, normal, NULL, &probe), LUXEL_OK);
    double sum = 0;
    for (size_t i = 0; i < probe->share_count; i++) {
        sum += probe->shares[i].irradiance;
        assert_true(probe->shares[i].error <= 1e-9 * probe->shares[i].irradiance); /* the tolerance */
    }
    assert_false(probe->is_enclosed);
    luxel_probe_free(probe);
    return sum;
}

static void assert_near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected)))
        fail_msg("%.17g instead of %.17g", value, expected);
}

/* In the centre a lamp makes I/R^2 everywhere; elsewhere I cos/r^2 by hand. */
static void test_lamps_inside(void **state)
{
    (void)state;
    luxel_scene *scenes[2] = {
        scene_of("{z: 2000}", SPHERE, "{type: point, position: [10, -20, 30], intensity: 3}"),
        scene_of("{z: 2000}", SPHERE, "{type: point, position: [210, -120, 130], intensity: 3}"),
    };
    for (int k = 0; k < 300; k++) {
        double place[3], normal[3], square = 0, height = 0;
        static const double lamp[3] = {210, -120, 130};
        place_on(1, place, normal);
        for (int i = 0; i < 3; i++) {
            square += (lamp[i] - place[i]) * (lamp[i] - place[i]);
            height += (lamp[i] - place[i]) * normal[i];
        }
        assert_near(lit(scenes[0], place, normal), 3 / 0.25, 1e-12);
        assert_near(lit(scenes[1], place, normal), 3e6 * height / (square * sqrt(square)), 1e-12);
        for (int i = 0; i < 3; i++)
            normal[i] = -normal[i];
        assert_true(lit(scenes[0], place, normal) == 0); /* on the outer side */
    }
    luxel_scene_free(scenes[0]);
    luxel_scene_free(scenes[1]);
}

/* A ball in the centre makes pi L r^2/R^2; what shines by Lambert's law from the wall itself, seen so small that it is
 * a point, I/(4 R^2) everywhere (Ulbricht): with r = 2 R cos each place has I cos cos/r^2. */
static void test_integrating(void **state)
{
    (void)state;
    luxel_scene *ball =
        scene_of("{z: 2000}", SPHERE, "{type: volume, sphere: {center: [10, -20, 30], radius: 60}, radiance: 70}");
    luxel_scene *port = scene_of("{z: 2000}", SPHERE,
                                 "{type: point, position: [10, -20, 530], axis: [0, 0, -1], pattern: lambertian, "
                                 "intensity: 5}");
    luxel_scene *disk = scene_of("{z: 2000}", SPHERE,
                                 "{type: planar, disk: {center: [10, -20, 430], radius: 300, "
                                 "axis: [0, 0, -1]}, radiance: 40}");
    for (int k = 0; k < 200; k++) {
        double place[3], normal[3];
        place_on(1, place, normal);
        assert_near(lit(ball, place, normal), M_PI * 70 * 60 * 60 / (500. * 500), 1e-11);
        if (place[2] < 500)
            assert_near(lit(port, place, normal), 5 / (4 * 0.25), 1e-9);
        if (place[2] < 429) /* a disk shines as the cap behind it does, of the height h = 100: pi L h/(2 R) */
            assert_near(lit(disk, place, normal), M_PI * 40 * 100 / (2 * 500.), 1e-11);
    }
    luxel_scene_free(ball);
    luxel_scene_free(port);
    luxel_scene_free(disk);
}

/* What stands outside gives exactly 0 inside, and lights the outer side; and its light does not come through. */
static void test_light_outside(void **state)
{
    (void)state;
    for (int k = 0; k < 200; k++) {
        char lights[400];
        double lamp[3], place[3], normal[3], square = 0;
        do {
            square = 0;
            for (int i = 0; i < 3; i++) {
                lamp[i] = between(-1500, 1500);
                square += (lamp[i] - (i == 0 ? 10 : i == 1 ? -20 : 30)) * (lamp[i] - (i == 0 ? 10 : i == 1 ? -20 : 30));
            }
        } while (square <= 500.001 * 500.001);
        snprintf(lights, sizeof lights,
                 "{type: point, position: [%.17g, %.17g, %.17g], intensity: 9}, {type: distant, direction: [%.17g, "
                 "%.17g, %.17g], irradiance: 4}",
                 lamp[0], lamp[1], lamp[2], lamp[1], lamp[2], lamp[0]);
        luxel_scene *scene = scene_of("{z: 2000}", SPHERE, lights);
        place_on(1, place, normal);
        assert_true(lit(scene, place, normal) == 0);
        for (int i = 0; i < 3; i++)
            place[i] += 500 * normal[i]; /* in the centre, on nothing */
        assert_true(lit(scene, place, normal) == 0);
        luxel_scene_free(scene);
        snprintf(lights, sizeof lights, "{type: point, position: [%.17g, %.17g, %.17g], intensity: 9}", lamp[0],
                 lamp[1], lamp[2]);
        scene = scene_of("{z: 2000}", SPHERE, lights);
        double height = 0, away = 0;
        place_on(-1, place, normal);
        for (int i = 0; i < 3; i++) {
            height += (lamp[i] - place[i]) * normal[i];
            away = hypot(away, lamp[i] - place[i]);
        }
        const double value = lit(scene, place, normal);
        if (height > 0)
            assert_near(value, 9e6 * height / (away * away * away), 1e-10);
        else
            assert_true(value == 0);
        luxel_scene_free(scene);
    }
}

/* From outside the farther half is seen, from inside all that is before the observer; pictures keep to the probes. */
static void test_what_is_seen(void **state)
{
    (void)state;
    static const char *const observers[] = {"{z: 2000}", "{z: 2000, projection: perspective}",
                                            "{z: 100, projection: perspective}", "{z: 100}"};
    for (size_t k = 0; k < sizeof observers / sizeof *observers; k++)
        for (int precision = 0; precision < 2; precision++) {
            luxel_scene *scene = scene_of(observers[k],
                                          "{type: sphere, center: [10, -20, 30], radius: 500, inside: true, material: "
                                          "{diffuse: 0.6, specular: 0.3}}",
                                          "{type: point, position: [110, 180, 50], intensity: 3}");
            luxel_settings settings;
            luxel_field *field;
            luxel_evaluator *evaluator;
            luxel_settings_init(&settings);
            settings.precision = precision ? LUXEL_DOUBLE : LUXEL_SINGLE;
            assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
            assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
            const double maximum = luxel_field_statistics(field)->maximum.value;
            size_t shown = 0;
            for (unsigned row = 0; row < 120; row++)
                for (unsigned column = 0; column < 120; column++) {
                    const double x = luxel_field_x_mm(field)[column], y = luxel_field_y_mm(field)[row];
                    luxel_value value;
                    luxel_evaluate_screen(evaluator, x, y, &value, NULL);
                    assert_true(value.on_surface == luxel_field_mask(field)[row * 120 + column]);
                    if (!value.on_surface)
                        continue;
                    shown++;
                    const double off = fabs(luxel_field_value(field, column, row) - value.value);
                    assert_true(off <= (precision ? 1e-11 : 2e-6) * maximum);
                    double toward = 0, away = 0;
                    for (int i = 0; i < 3; i++) {
                        const double center = i == 0 ? 10 : i == 1 ? -20 : 30;
                        away = hypot(away, value.position_mm[i] - center);
                        toward += value.normal[i] * (center - value.position_mm[i]);
                    }
                    assert_near(away, 500, 1e-12);
                    assert_near(toward, 500, 1e-12);
                    if (k < 2)
                        assert_true(value.position_mm[2] < 250);
                }
            assert_int_equal(shown == 120 * 120, k == 2);
            luxel_evaluator_free(evaluator);
            luxel_field_free(field);
            luxel_scene_free(scene);
        }
}

/* Under a lamp beside the centre the brightest place is the nearest, the darkest the farthest, seen from the centre of
 * the scene; under one in the centre all is alike. */
static void test_extrema(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("{z: 2000, projection: perspective}",
                                  "{type: sphere, center: [0, 0, 0], radius: 300, inside: true, material: {model: "
                                  "lambert, diffuse: 1}}",
                                  "{type: point, position: [60, 0, -80], intensity: 2}");
    luxel_field *field;
    luxel_evaluator *evaluator;
    luxel_extrema extrema;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(evaluator, field, NULL, NULL, &extrema), LUXEL_OK);
    assert_true(extrema.maximum.exists && extrema.minimum.exists);
    assert_near(extrema.maximum.value, 2 / 0.04, 1e-11);
    assert_near(extrema.maximum.position_mm[0], 180, 1e-6);
    assert_near(extrema.maximum.position_mm[2], -240, 1e-6);
    assert_int_equal(extrema.maximum.place, LUXEL_PEAK_INSIDE);
    assert_int_equal(extrema.minimum.place, LUXEL_PEAK_LIMB);
    for (unsigned i = 0; i < 120 * 120; i++)
        if (luxel_field_mask(field)[i]) {
            const double value = luxel_field_value(field, i % 120, i / 120);
            assert_true(value <= extrema.maximum.value * (1 + 1e-6) && value >= extrema.minimum.value * (1 - 1e-6));
        }
    luxel_evaluator_free(evaluator);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* It hides from each other what is on different sides, and not what is on one. */
static void test_hides_others(void **state)
{
    (void)state;
    const char *plate = SPHERE ", {type: rectangle, center: [10, -20, -100], size: [100, 100]}, "
                               "{type: rectangle, center: [10, -20, -700], size: [100, 100]}";
    luxel_scene *inside = scene_of("{z: 2000}", plate, "{type: point, position: [10, -20, 100], intensity: 1}");
    luxel_scene *outside = scene_of("{z: 2000}", plate, "{type: point, position: [10, -20, 1000], intensity: 1}");
    const double up[3] = {0, 0, 1}, within[3] = {10, -20, -100}, below[3] = {10, -20, -700};
    assert_near(lit(inside, within, up), 1 / 0.04, 1e-12);
    assert_true(lit(inside, below, up) == 0);
    assert_true(lit(outside, within, up) == 0);
    assert_true(lit(outside, below, up) == 0);
    luxel_scene_free(inside);
    luxel_scene_free(outside);
}

static void test_standing_and_advice(void **state)
{
    (void)state;
    expect_text_error("luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: {z: -500}\n"
                      "surfaces: [{type: sphere, center: [0, 0, 0], radius: 400, inside: true}]\nlights: []\n",
                      WANTED(.id = "observer-below-room", .line = 3, .key = "observer.z", .message = "z = -400"));
    expect_text_error("luxel: 1\nscreen: {width: 800, height: 800, resolution: [80, 80]}\nobserver: {z: 100}\n"
                      "surfaces: [{type: sphere, center: [0, 0, 0], radius: 400, inside: false}]\nlights: []\n",
                      WANTED(.id = "observer-too-low", .line = 3, .key = "observer.z"));
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene =
        scene_of("{z: 300, projection: perspective}", "{type: sphere, center: [0, 0, 150], radius: 900, inside: true}",
                 "{type: point, position: [0, 0, 1300], intensity: 1}");
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[400, 400]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    expect_entry(diagnostics, 0, WANTED(.id = "light-behind"));
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lamps_inside),
        cmocka_unit_test(test_integrating),
        cmocka_unit_test(test_light_outside),
        cmocka_unit_test(test_what_is_seen),
        cmocka_unit_test(test_extrema),
        cmocka_unit_test(test_hides_others),
        cmocka_unit_test(test_standing_and_advice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
