/* SPDX-License-Identifier: MIT */
/*
 * Pictures with reflected light against truths: points of a cube to eight digits, the furnace seen from anywhere, a
 * sphere alone, to which nothing is reflected; the same bytes for any number of threads, probes' pixels and evaluators
 * of the same light, and what is told where the error is larger than was asked for.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 3000 };

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"
#define CUBE(rho) "{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000], " MATERIAL(rho) "}"
#define FRONTAL "screen: {width: 3000, height: 3000, resolution: [7, 7], sampling: nodes}\nobserver: {z: 30000}"

static luxel_scene *scene_of(const char *reflections, const char *view, const char *surfaces, const char *lights)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length = snprintf(text, sizeof text, "luxel: 1\nreflections: %s\n%s\nsurfaces: [%s]\nlights: [%s]\n",
                                reflections, view, surfaces, lights);
    assert_true(length > 0 && length < TEXT_SIZE);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    if (load(text, diagnostics, &scene) != LUXEL_OK)
        fail_msg("%s", luxel_diagnostics_message(diagnostics, 0, NULL, NULL));
    luxel_diagnostics_free(diagnostics);
    return scene;
}

static luxel_field *render(const luxel_scene *scene, double reflected_error, unsigned threads)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = reflected_error;
    settings.threads = threads;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

/* The wall of a cube of 4 m with 10 000 lm in its middle: direct light by its formula, the rest by collocation. */
static void cube(void **state)
{
    (void)state;
    static const struct {
        unsigned column, row;
        double reflected;
    } truths[] = {{3, 3, 255.00881}, {5, 3, 253.33949}, {1, 1, 248.68833}, {5, 5, 248.68833}, {6, 0, 231.79366}};
    luxel_scene *scene = scene_of("all", FRONTAL, CUBE("0.7"), "{type: point, position: [0, 0, 2000], power: 10000}");
    luxel_field *field = render(scene, 2e-3, 0);
    const luxel_statistics *statistics = luxel_field_statistics(field);
    const double bound = statistics->reflected_error * statistics->maximum.value;
    assert_true(statistics->has_reflected && statistics->reflected_reached);
    assert_true(statistics->reflected_error > 0 && statistics->reflected_error <= 2e-3);
    for (size_t i = 0; i < sizeof truths / sizeof *truths; i++) {
        const double x = 0.5 * truths[i].column - 1.5, y = 0.5 * truths[i].row - 1.5;
        const double truth = truths[i].reflected + 10000 / (4 * M_PI) * 2 / pow(4 + x * x + y * y, 1.5);
        const double off = fabs(luxel_field_value(field, truths[i].column, truths[i].row) - truth);
        if (!(off <= bound) || off > 2e-4 * truth)
            fail_msg("pixel %zu is off by %.3g of %.8g, bound %.2g", i, off, truth, bound);
    }
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Everything has E = 1/(1 - 0.5), whatever stands around and wherever the observer does. */
static void furnace(void **state)
{
    (void)state;
    static const char *const views[] = {
        "screen: {width: 3000, height: 3000, resolution: [48, 48]}\nobserver: {z: 30000}",
        "screen: {width: 3600, height: 2400, resolution: [48, 32]}\n"
        "observer: {position: [1800, 600, 3700], target: [0, -300, 1000], projection: perspective}"};
    for (size_t i = 0; i < 2; i++) {
        luxel_scene *scene = scene_of("all", views[i],
                                      CUBE("0.5") ", {type: rectangle, center: [0, -900, 1500], size: [1200, 1000], "
                                                  "axis: [0, 1, 0.2], " MATERIAL("0.5") "}",
                                      "{type: ambient, irradiance: 1}");
        luxel_field *field = render(scene, 0.02, 0);
        const luxel_statistics *statistics = luxel_field_statistics(field);
        const double bound = statistics->reflected_error * statistics->maximum.value;
        assert_true(statistics->has_reflected && bound < 0.3);
        assert_true(statistics->surface_pixels >= 48 * 24);
        for (unsigned row = 0; row < luxel_field_rows(field); row++)
            for (unsigned column = 0; column < luxel_field_columns(field); column++) {
                const double value = luxel_field_value(field, column, row);
                if (luxel_field_mask(field)[row * luxel_field_columns(field) + column] && !(fabs(value - 2) <= bound))
                    fail_msg("view %zu, pixel (%u, %u): %.6g, bound %.2g", i, column, row, value, bound);
            }
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

/* What is convex receives nothing from itself. */
static void alone(void **state)
{
    (void)state;
    static const char view[] = "screen: {width: 1000, height: 1000, resolution: [40, 40]}\nobserver: {z: 3000}";
    luxel_field *fields[2];
    for (int i = 0; i < 2; i++) {
        luxel_scene *scene = scene_of(i == 0 ? "none" : "all", view,
                                      "{type: sphere, center: [0, 0, 1000], radius: 400, " MATERIAL("0.5") "}",
                                      "{type: point, position: [500, 900, 2500], intensity: 10}");
        fields[i] = render(scene, 0, 0);
        luxel_scene_free(scene);
    }
    assert_memory_equal(luxel_field_single(fields[0]), luxel_field_single(fields[1]), 40 * 40 * sizeof(float));
    assert_true(!luxel_field_statistics(fields[0])->has_reflected && luxel_field_statistics(fields[1])->has_reflected);
    assert_true(luxel_field_statistics(fields[0])->reflected_reached);
    luxel_field_free(fields[0]);
    luxel_field_free(fields[1]);
}

/* Any number of threads, and a scene that has kept what was found, make the same bytes; probes tell the same pixels,
 * and evaluators the same light. */
static void agreement(void **state)
{
    (void)state;
    static const char view[] = "screen: {width: 3800, height: 3800, resolution: [19, 19]}\n"
                               "observer: {z: 9000, projection: perspective}";
    luxel_scene *scenes[2];
    luxel_field *fields[2];
    for (unsigned i = 0; i < 2; i++) {
        scenes[i] = scene_of("2", view, CUBE("0.6"), "{type: point, position: [500, 900, 1500], power: 5000}");
        fields[i] = render(scenes[i], 0.02, 1 + 2 * i);
    }
    assert_memory_equal(luxel_field_single(fields[0]), luxel_field_single(fields[1]), 19 * 19 * sizeof(float));
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.quantity = LUXEL_IRRADIANCE;
    settings.reflected_error = 0.02;
    luxel_evaluator *evaluator;
    assert_int_equal(luxel_evaluator_new(scenes[0], &settings, NULL, &evaluator), LUXEL_OK);
    for (int i = 0; i < 4; i++) {
        luxel_probe *probe;
        const double x_mm = -1500 + 800 * i, y_mm = 300 * i - 700;
        assert_int_equal(luxel_probe_screen(scenes[i % 2], &settings, x_mm, y_mm, NULL, &probe), LUXEL_OK);
        assert_true(probe->has_pixel_value && probe->has_reflected && probe->reflected.value > 0);
        assert_true(probe->pixel_value == luxel_field_value(fields[0], probe->column, probe->row));
        luxel_value value;
        luxel_evaluate_screen(evaluator, x_mm, y_mm, &value, NULL);
        assert_true(value.has_value && fabs(value.value - probe->value) <= value.error + probe->error);
        assert_true(value.value > probe->shares[0].irradiance && value.error < 0.05 * value.value);
        luxel_probe_free(probe);
    }
    luxel_evaluator_free(evaluator);
    for (unsigned i = 0; i < 2; i++) {
        luxel_field_free(fields[i]);
        luxel_scene_free(scenes[i]);
    }
}

/* A bound that cannot be had is told. */
static void missed(void **state)
{
    (void)state;
    luxel_scene *scene = scene_of("1", FRONTAL, CUBE("0.7"), "{type: ambient, irradiance: 1}");
    luxel_field *field = render(scene, 1e-14, 0);
    const luxel_statistics *statistics = luxel_field_statistics(field);
    assert_true(statistics->has_reflected && !statistics->reflected_reached && statistics->reflected_error > 1e-14);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cube),      cmocka_unit_test(furnace), cmocka_unit_test(alone),
        cmocka_unit_test(agreement), cmocka_unit_test(missed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
