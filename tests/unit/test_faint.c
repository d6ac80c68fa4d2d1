/* SPDX-License-Identifier: MIT */
/*
 * Pictures of a pixel or three that show what rounding likes to eat: the faint foot of a highlight, light that grazes,
 * a light right behind the element, a round source right above it, a needle; by every instruction set.  Each was found
 * by the properties (tests/properties).
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "scenes.h"

#define SCENE(surface, light)                                                                                          \
    "luxel: 1\nscreen: {width: 1, height: 1, resolution: [1, 1]}\nobserver: {z: 1000}\nsurfaces: [" surface            \
    "]\nlights: [" light "]\n"

/* All pixels in float64 are the exact values at their samples, to this share of them. */
static void expect_pixels(const luxel_evaluator *evaluator, const luxel_field *field, double share)
{
    for (unsigned row = 0; row < luxel_field_rows(field); row++)
        for (unsigned column = 0; column < luxel_field_columns(field); column++) {
            const double shown = luxel_field_value(field, column, row);
            const double x = luxel_field_x_mm(field)[column], y = luxel_field_y_mm(field)[row];
            const luxel_value exact = luxel_evaluate(evaluator, x, y, NULL);
            assert_true(exact.has_value && exact.error <= 1e-9 * exact.value);
            if (!(fabs(shown - exact.value) <= share * exact.value))
                fail_msg("%s: %.17g, not %.17g", luxel_field_instruction_set(field), shown, exact.value);
        }
}

static void expect_within(double share, const char *text)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    luxel_settings settings;
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    for (size_t i = 0; luxel_instruction_set_name(i); i++) {
        luxel_field *field = NULL;
        if (!luxel_instruction_set_runs(i))
            continue;
        settings.instruction_set = luxel_instruction_set_name(i);
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        expect_pixels(evaluator, field, share);
        luxel_field_free(field);
    }
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

static void expect_exact(const char *text)
{
    expect_within(1e-11, text);
}

/* 1e-43 of the peak. */
static void test_foot_of_highlight(void **state)
{
    (void)state;
    expect_exact(SCENE("{type: sphere, center: [0, 0, 0], radius: 1, material: {model: phong, diffuse: 0, specular: 1, "
                       "shininess: 100}}",
                       "{type: distant, direction: [1, 0, -0.4], irradiance: 1}"));
}

/* A cosine of 2e-7, for a highlight and for a source's pattern. */
static void test_grazing(void **state)
{
    (void)state;
    expect_exact(SCENE("{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {model: phong, diffuse: 1, "
                       "specular: 1, shininess: 1}}",
                       "{type: distant, direction: [0, 1, -2e-7], irradiance: 1}"));
    expect_exact(SCENE("{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {model: lambert}}",
                       "{type: point, position: [0, 0, 1], axis: [1, 0, -2e-7], intensity: 1, pattern: lambertian}"));
}

/* L = -V: no half vector, no highlight. */
static void test_opposite(void **state)
{
    (void)state;
    expect_exact(SCENE("{type: sphere, center: [1, 1, -10], radius: 130, material: {diffuse: 1, specular: 1, "
                       "shininess: 1}}",
                       "{type: point, position: [0, 0, 66.328125], intensity: 1}"));
    expect_exact(SCENE("{type: sphere, center: [1, 1, -44.2], radius: 130, material: {diffuse: 1, specular: 1, "
                       "shininess: 1}}",
                       "{type: point, position: [0, 0, 10], intensity: 1}"));
}

/* An element on the axis of a round source, whose offset from it is all rounding. */
static void test_on_axis(void **state)
{
    (void)state;
#define PLATE "{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {model: lambert}}"
    expect_exact(SCENE(PLATE,
                       "{type: planar, disk: {center: [-116.307261337, -380.000673296, 0.15460250945], radius: 300, "
                       "axis: [116.307261337, 380.000673296, -0.15460250945]}, radiance: 1}"));
    expect_exact(SCENE(PLATE, "{type: planar, disk: {center: [300.1, 200.7, 400.3], radius: 10, aim: [0, 0, 0]}, "
                              "radiance: 1}"));
    expect_exact(SCENE(PLATE, "{type: volume, cylinder: {center: [300.1, 200.7, 400.3], radius: 10, height: 3, "
                              "axis: [300.1, 200.7, 400.3]}, radiance: 1}"));
}

/* A needle, of which there are more cells than room to look at them, beside another light. */
static void test_needle(void **state)
{
    (void)state;
    expect_within(1e-3,
                  "luxel: 1\nscreen: {width: 210, height: 70, resolution: [3, 1]}\nobserver: {z: 3000}\n"
                  "surfaces: [{type: rectangle, center: [0, 0, 1000], size: [600, 1], axis: [1, -1, 1], material: "
                  "{model: phong, diffuse: 0, specular: 1, shininess: 1}}]\n"
                  "lights: [{type: volume, box: {center: [-10, 0, 100], size: [1, 100000, 10]}, radiance: 1}, "
                  "{type: point, position: [0, -10000, 2], intensity: 1}]\n");
}

/* Of a light as near as places are known no error can be told, and so it is told as infinite. */
static void test_error_without_bound(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_probe *probe = NULL;
    assert_int_equal(load(SCENE("{type: sphere, center: [0, 0, -1e9], radius: 8e-7, material: {model: lambert}}",
                                "{type: point, position: [0, 0, -999999999.99999964], intensity: 1}"),
                          diagnostics, &scene),
                     LUXEL_OK);
    assert_int_equal(luxel_probe_screen(scene, NULL, 0, 0, NULL, &probe), LUXEL_OK);
    assert_true(probe->has_value && isinf(probe->error));
    assert_true(probe->share_count == 1 && isinf(probe->shares[0].error));
    luxel_probe_free(probe);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_foot_of_highlight),
        cmocka_unit_test(test_grazing),
        cmocka_unit_test(test_opposite),
        cmocka_unit_test(test_on_axis),
        cmocka_unit_test(test_needle),
        cmocka_unit_test(test_error_without_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
