/* SPDX-License-Identifier: MIT */
/*
 * Pictures of a single pixel that shows what rounding likes to eat: the faint foot of a highlight, light that grazes, a
 * light right behind the element.  Each found by the properties (tests/properties), by every instruction set.
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

/* The pixel in float64 is the exact value at its sample, to 1e-11. */
static void expect_exact(const char *text)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    luxel_settings settings;
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    const luxel_value exact = luxel_evaluate(evaluator, 0, 0, NULL);
    assert_true(exact.has_value && exact.error <= 1e-12 * exact.value);
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    for (size_t i = 0; luxel_instruction_set_name(i); i++) {
        luxel_field *field = NULL;
        if (!luxel_instruction_set_runs(i))
            continue;
        settings.instruction_set = luxel_instruction_set_name(i);
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        if (!(fabs(luxel_field_value(field, 0, 0) - exact.value) <= 1e-11 * exact.value))
            fail_msg("%s: %.17g, not %.17g", settings.instruction_set, luxel_field_value(field, 0, 0), exact.value);
        luxel_field_free(field);
    }
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_foot_of_highlight),
        cmocka_unit_test(test_grazing),
        cmocka_unit_test(test_opposite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
