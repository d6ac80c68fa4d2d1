/* SPDX-License-Identifier: MIT */
/*
 * Pictures of a pixel or three that show what rounding likes to eat: the faint foot of a highlight, light that grazes,
 * a light right behind the element, a round source right above it, a needle, the edge of a source that has not yet set,
 * a source in one plane with what it lights or seen edge-on from far away, the axis of a cone like a thread; by every
 * instruction set.  Each was found by the properties (tests/properties).
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "scenes.h"

#define SCENE(surface, light)                                                                                          \
    "luxel: 1\nscreen: {width: 1, height: 1, resolution: [1, 1]}\nobserver: {z: 1000}\nsurfaces: [" surface            \
    "]\nlights: [" light "]\n"

/* All pixels are the exact values at their samples, to this share of them. */
static void expect_pixels(const luxel_evaluator *evaluator, const luxel_field *field, double share)
{
    for (unsigned row = 0; row < luxel_field_rows(field); row++)
        for (unsigned column = 0; column < luxel_field_columns(field); column++) {
            const double shown = luxel_field_value(field, column, row);
            const double x = luxel_field_x_mm(field)[column], y = luxel_field_y_mm(field)[row];
            luxel_value exact;
            luxel_evaluate_screen(evaluator, x, y, &exact, NULL);
            if (!(exact.has_value && exact.error <= fmax(1e-9, 0.1 * share) * exact.value))
                fail_msg("(%g, %g): %.17g is known to %g alone", x, y, exact.value, exact.error);
            if (!(fabs(shown - exact.value) <= share * exact.value))
                fail_msg("%s: %.17g, not %.17g", luxel_field_instruction_set(field), shown, exact.value);
        }
}

static void expect_within(luxel_precision precision, double share, const char *text)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    luxel_settings settings;
    assert_int_equal(load(text, diagnostics, &scene), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_settings_init(&settings);
    settings.precision = precision;
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
    expect_within(LUXEL_DOUBLE, 1e-11, text);
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
    expect_within(LUXEL_DOUBLE, 1e-3,
                  "luxel: 1\nscreen: {width: 210, height: 70, resolution: [3, 1]}\nobserver: {z: 3000}\n"
                  "surfaces: [{type: rectangle, center: [0, 0, 1000], size: [600, 1], axis: [1, -1, 1], material: "
                  "{model: phong, diffuse: 0, specular: 1, shininess: 1}}]\n"
                  "lights: [{type: volume, box: {center: [-10, 0, 100], size: [1, 100000, 10]}, radiance: 1}, "
                  "{type: point, position: [0, -10000, 2], intensity: 1}]\n");
}

/*
 * The upper edge of a wall that stands beside a plate and reaches below it: all that is seen of it, by the cosine or by
 * the lobe, lies between its edge and the samples next to it, or some of it does.
 */
static void test_slivers(void **state)
{
    (void)state;
    static const double heights[] = {1e-3, 1, 7, 13};
    static const char *materials[] = {
        "model: blinn-phong, shininess: 1, highlight: cosine", "model: blinn-phong, shininess: 30, highlight: cosine",
        "model: blinn-phong, shininess: 1, highlight: gated",  "model: phong, shininess: 1, highlight: cosine",
        "model: phong, shininess: 0.5, highlight: plain",      "model: phong, shininess: 1, highlight: plain",
        "model: phong, shininess: 2, highlight: plain",
    };
    for (size_t m = 0; m < sizeof materials / sizeof *materials; m++)
        for (size_t h = 0; h < sizeof heights / sizeof *heights; h++) {
            char text[1024];
            snprintf(
                text, sizeof text,
                SCENE("{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {diffuse: 0, specular: 1, %s}}",
                      "{type: planar, rectangle: {center: [100, 0, %.17g], size: [30, 100], axis: [-1, 0, 0], up: "
                      "[0, 0, 1]}, radiance: 1}"),
                materials[m], heights[h] - 50);
            expect_within(LUXEL_DOUBLE, 1e-3, text);
        }
}

/* Found by `properties --seed 32015034`: all that is seen of a rectangle is one of its corners. */
static void test_corner(void **state)
{
    (void)state;
    expect_within(LUXEL_DOUBLE, 1e-3,
                  "luxel: 1\nscreen: {width: 360, height: 360, resolution: [3, 3]}\n"
                  "observer: {z: 2400, projection: perspective, view: parallel}\n"
                  "surfaces: [{type: sphere, center: [-107, -44, 320], radius: 627.6, material: {model: blinn-phong, "
                  "diffuse: 1, specular: 1, shininess: 1, highlight: cosine}}]\n"
                  "lights: [{type: planar, rectangle: {center: [123, 123, 879.3], size: [70, 20], "
                  "axis: [-424, -500, -1080]}, radiance: 1}]\n");
}

/* 1e-236 of a highlight's peak is to be seen, where sums of what was in doubt leave more than that by rounding. */
static void test_far_foot(void **state)
{
    (void)state;
    expect_within(LUXEL_DOUBLE, 1e-3,
                  "luxel: 1\nscreen: {width: 200, height: 600, resolution: [1, 3], sampling: nodes}\n"
                  "observer: {z: 700}\nsurfaces: [{type: sphere, center: [0, 0, 0], radius: 600, material: "
                  "{model: phong, diffuse: 1, specular: 1, shininess: 200}}]\n"
                  "lights: [{type: volume, sphere: {center: [0, 0, 2], radius: 540, facets: 12}, radiance: 1}]\n");
}

/* A ball of small faces in the far tail of a highlight, 1e-25 of its peak: it is steep even across small faces. */
static void test_steep_tail(void **state)
{
    (void)state;
    expect_within(LUXEL_DOUBLE, 1e-3,
                  SCENE("{type: sphere, center: [35.5, 45.5, 60], radius: 100, material: {diffuse: 0, specular: 1, "
                        "shininess: 200}}",
                        "{type: volume, sphere: {center: [-34.5, -14.5, 100], radius: 3, facets: 8}, radiance: 1}"));
}

/* A rectangle far away that lies nearly in one plane with what it lights, and faces it: its edges cancel. */
static void test_coplanar(void **state)
{
    (void)state;
    for (double away = 1e3; away < 1e8; away *= 10)
        for (double height = 0.02; height < away / 10; height *= 100) {
            char text[1024];
            snprintf(text, sizeof text,
                     SCENE("{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {model: lambert}}",
                           "{type: planar, rectangle: {center: [%.17g, 0, %.17g], size: [1, 3], up: [0, 1, 0], "
                           "axis: [0, 0, -1]}, radiance: 1}"),
                     away, height);
            expect_within(LUXEL_DOUBLE, 1e-11, text);
            expect_within(LUXEL_SINGLE, 2e-6, text);
        }
}

/* So far away and so aslant that heights over its plane have lost digits that samples would need. */
static void test_edge_on(void **state)
{
    (void)state;
#define EDGE_ON(law)                                                                                                   \
    SCENE("{type: sphere, center: [0, 0, 0], radius: 1, material: {model: lambert, diffuse: 1}}",                      \
          "{type: planar, vertices: [[-1, 0, 1e12], [-1, 0, 999999999995], [0, 1, 1e12]], radiance: 1, "               \
          "attenuation: " law "}")
    expect_within(LUXEL_SINGLE, 2e-6, EDGE_ON("none"));
    expect_within(LUXEL_SINGLE, 2e-6, EDGE_ON("practical, k: 3"));
}

/* A cone as narrow as a thread of which a sample lies near the axis, whose angle is lost where it is a difference. */
static void test_narrow_cone(void **state)
{
    (void)state;
    static const double outer[] = {0.004, 0.03, 0.5}, aside[] = {0, 4.2e-4, 0.003};
    for (size_t o = 0; o < sizeof outer / sizeof *outer; o++)
        for (size_t a = 0; a < sizeof aside / sizeof *aside; a++) {
            char text[1024];
            snprintf(
                text, sizeof text,
                SCENE("{type: rectangle, center: [0, 0, 0], size: [1, 1], material: {model: lambert}}",
                      "{type: spot, position: [100, 70, 1000], aim: [%g, 0, 0], intensity: 1, inner: 0, outer: %g, "
                      "falloff: linear}"),
                aside[a], outer[o]);
            expect_within(LUXEL_SINGLE, 2e-6, text);
        }
}

/* The axis of a cone, and next to it, where all is so small that squares of lengths are among the least of float32. */
static void test_tiny_cone(void **state)
{
    (void)state;
    for (double size = 1; size > 1e-6; size /= 10)
        for (double aside = 0; aside < 0.1; aside = 10 * aside + 1e-4) {
            char text[1024];
            snprintf(
                text, sizeof text,
                SCENE("{type: sphere, center: [0, 0, 0], radius: %.17g, material: {model: lambert}}",
                      "{type: spot, position: [%.17g, 0, %.17g], axis: [0, 0, -1], intensity: 1, inner: 0, outer: 90, "
                      "falloff: linear, attenuation: none}"),
                size, aside * size, 10 * size);
            expect_within(LUXEL_SINGLE, 2e-6, text);
        }
}

/* No error can be told of a light as near as places are known, and so it is told as infinite. */
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
        cmocka_unit_test(test_slivers),
        cmocka_unit_test(test_corner),
        cmocka_unit_test(test_far_foot),
        cmocka_unit_test(test_steep_tail),
        cmocka_unit_test(test_coplanar),
        cmocka_unit_test(test_edge_on),
        cmocka_unit_test(test_narrow_cone),
        cmocka_unit_test(test_tiny_cone),
        cmocka_unit_test(test_error_without_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
