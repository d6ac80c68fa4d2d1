/* SPDX-License-Identifier: MIT */
/*
 * Evaluators: the numbers of probes to the last bit, over every built-in scene; light by light; places on spheres that
 * are not seen; and what is refused.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scenes.h"

static luxel_evaluator *evaluator_of(const luxel_scene *scene, luxel_quantity quantity)
{
    luxel_settings settings;
    luxel_evaluator *evaluator = NULL;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_evaluator_quantity(evaluator), quantity);
    return evaluator;
}

/* Each light's number is that of its share in the probe; lights that are off and places without a value have 0.  In
 * colour the probe adds channels of the diffuse part and of the highlight before both, which rounds otherwise. */
static void same_shares(const luxel_probe *probe, luxel_quantity quantity, const double *shares, size_t lights,
                        bool has_color)
{
    double expected[64] = {0};
    assert_true(lights <= 64);
    for (size_t i = 0; probe->has_value && i < probe->share_count; i++) {
        const luxel_light_share *share = &probe->shares[i];
        expected[share->light] = quantity == LUXEL_IRRADIANCE ? share->irradiance : share->diffuse + share->specular;
    }
    for (size_t i = 0; i < lights && has_color; i++)
        assert_true(fabs(shares[i] - expected[i]) <= 4 * DBL_EPSILON * fabs(expected[i]));
    if (!has_color)
        assert_memory_equal(shares, expected, lights * sizeof *shares);
}

static void same_as_probe(const luxel_scene *scene, const luxel_evaluator *evaluator, double x, double y)
{
    luxel_quantity quantity = luxel_evaluator_quantity(evaluator);
    size_t lights = luxel_evaluator_light_count(evaluator);
    double shares[64];
    for (size_t i = 0; i < lights; i++)
        shares[i] = 7; /* each is set */
    luxel_settings settings;
    luxel_probe *probe = NULL;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    assert_int_equal(luxel_probe_screen(scene, &settings, x, y, NULL, &probe), LUXEL_OK);
    luxel_value value;
    luxel_evaluate_screen(evaluator, x, y, &value, shares);
    assert_int_equal(value.on_surface, probe->on_surface);
    assert_int_equal(value.has_value, probe->has_value);
    assert_true(value.value == probe->value && value.error == probe->error);
    assert_memory_equal(value.position_mm, probe->position_mm, sizeof value.position_mm);
    assert_memory_equal(value.normal, probe->normal, sizeof value.normal);
    same_shares(probe, quantity, shares, lights, luxel_scene_has_color(scene));
    luxel_value again;
    luxel_evaluate_screen(evaluator, x, y, &again, NULL);
    assert_true(again.value == value.value);
    luxel_probe_free(probe);
}

static void test_probes(void **state)
{
    (void)state;
    for (size_t i = 0; luxel_builtin_scene_name(i); i++)
        for (int quantity = 0; quantity < 2; quantity++) {
            luxel_scene *scene = builtin(luxel_builtin_scene_name(i));
            luxel_evaluator *evaluator = evaluator_of(scene, quantity ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS);
            for (int k = 0; k < 9; k++)
                same_as_probe(scene, evaluator, -237.5 + 71.25 * (k % 3) * 3, -210 + 65.5 * (k / 3) * 3);
            luxel_evaluator_free(evaluator);
            luxel_scene_free(scene);
        }
}

/* Where a light lies on the element there is neither a value nor a share, whatever the lights before it give. */
static void test_light_on_element(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    assert_int_equal(luxel_scene_set(scene,
                                     "lights=[{type: ambient, irradiance: 3}, {type: point, position: [0, 0, 1300], "
                                     "intensity: 1}, {type: distant, direction: [0, 0, -1], irradiance: 2}]",
                                     NULL),
                     LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_evaluator *evaluator = evaluator_of(scene, LUXEL_BRIGHTNESS);
    double shares[3] = {7, 7, 7};
    luxel_value value;
    luxel_evaluate_screen(evaluator, 0, 0, &value, shares);
    assert_false(value.has_value);
    same_as_probe(scene, evaluator, 0, 0);
    same_as_probe(scene, evaluator, 1, 0);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* A trace is what an evaluation tells of its place, and has no value. */
static void test_trace(void **state)
{
    (void)state;
    static const char *const names[] = {"report", "desk", "sundial"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        luxel_scene *scene = builtin(names[k]);
        luxel_evaluator *evaluator = evaluator_of(scene, LUXEL_BRIGHTNESS);
        size_t met = 0;
        for (int i = 0; i < 9; i++) {
            const double x = 60 * (i % 3 - 1) + 1, y = 60 * (i / 3 - 1);
            luxel_value value;
            luxel_evaluate_screen(evaluator, x, y, &value, NULL);
            luxel_value place;
            luxel_trace_screen(evaluator, x, y, &place);
            assert_false(place.has_value);
            assert_true(place.value == 0 && place.error == 0);
            met += place.on_surface;
            assert_true(place.on_surface == value.on_surface && place.surface == value.surface &&
                        place.part == value.part);
            assert_memory_equal(place.position_mm, value.position_mm, sizeof place.position_mm);
            assert_memory_equal(place.normal, value.normal, sizeof place.normal);
        }
        assert_true(met > 0);
        luxel_value beyond;
        luxel_trace_screen(evaluator, 301, 0, &beyond);
        assert_true(k > 0 || !beyond.on_surface);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

enum { MANY = 500 };

/* Elements around and upon the sphere of the report, some on the screen, and one that cannot be probed. */
static void place_many(luxel_place places[MANY])
{
    memset(places, 0, MANY * sizeof *places);
    for (int i = 0; i < MANY; i++) {
        const double angle = 0.1 * i, reach = 300 + (i % 3) * 40;
        const double normal[3] = {cos(angle) * 0.6, sin(angle) * 0.6, 0.8};
        places[i].is_element = i % 7 != 0;
        places[i].screen_mm[0] = 0.4 * i;
        places[i].screen_mm[1] = -0.3 * i;
        places[i].has_view = i % 5 == 0;
        places[i].view[2] = 1;
        for (int k = 0; k < 3; k++) {
            places[i].normal[k] = normal[k];
            places[i].position_mm[k] = reach * normal[k] + (k == 2 ? 1000 : 0);
        }
    }
    memset(places[123].normal, 0, sizeof places[123].normal);
}

/* Many places at once, by one thread and by four, are the numbers of each. */
static void test_places(void **state)
{
    static luxel_place places[MANY];
    static luxel_value values[MANY];
    (void)state;
    place_many(places);
    for (unsigned threads = 1; threads <= 4; threads += 3) {
        luxel_settings settings;
        luxel_evaluator *evaluator = NULL;
        luxel_scene *scene = builtin("three-lights");
        luxel_settings_init(&settings);
        settings.threads = threads;
        assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
        const size_t lights = luxel_evaluator_light_count(evaluator);
        assert_true(lights > 1 && lights < 8);
        double shares[MANY][8], *packed = &shares[0][0], alone[8];
        assert_int_equal(luxel_evaluate_places(evaluator, places, MANY, values, packed), LUXEL_OK);
        for (size_t i = 0; i < MANY; i++) {
            luxel_value value;
            luxel_evaluate_place(evaluator, &places[i], &value, alone);
            assert_int_equal(values[i].has_value, value.has_value);
            assert_true(values[i].value == value.value && values[i].error == value.error);
            assert_memory_equal(packed + i * lights, alone, lights * sizeof *alone);
        }
        assert_false(values[123].has_value);
        assert_true(values[124].has_value);
        assert_int_equal(luxel_evaluate_places(evaluator, places, MANY, values, NULL), LUXEL_OK);
        assert_true(values[124].has_value);
        assert_int_equal(luxel_evaluate_places(evaluator, NULL, 0, NULL, NULL), LUXEL_OK);
        assert_int_equal(luxel_evaluate_places(evaluator, NULL, 1, values, NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_evaluate_places(NULL, places, 1, values, NULL), LUXEL_ERROR_ARGUMENT);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

static bool goes_on(double done, void *data)
{
    (void)done;
    return *(const bool *)data;
}

static void test_places_cancelled(void **state)
{
    static luxel_place places[MANY];
    static luxel_value values[MANY];
    luxel_settings settings;
    luxel_evaluator *evaluator = NULL;
    luxel_scene *scene = builtin("report");
    bool wanted = true;
    (void)state;
    place_many(places);
    luxel_settings_init(&settings);
    settings.progress = goes_on;
    settings.progress_data = &wanted;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    wanted = false;
    assert_int_equal(luxel_evaluate_places(evaluator, places, MANY, values, NULL), LUXEL_CANCELLED);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

static void test_refused(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    luxel_evaluator *evaluator = NULL;
    luxel_settings settings;
    luxel_settings_init(&settings);
    assert_int_equal(luxel_evaluator_new(NULL, NULL, NULL, &evaluator), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    settings.tolerance = 2;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_ERROR_ARGUMENT);
    assert_null(evaluator);
    luxel_evaluator_free(NULL);
    luxel_scene_free(scene);
}

/* Ambient light is reflected by a share of its own, the same at each place, in values and in pictures. */
static void test_ambient(void **state)
{
    static const struct {
        const char *material;
        double expected;
    } cases[] = {{"{model: lambert, diffuse: 0.8, ambient: 0.25}", 0.75},
                 {"{model: lambert, diffuse: 0.8}", 2.4},
                 {"{model: lambert, diffuse: 0.8, ambient: 0.25, over_pi: true}", 0.75 / M_PI}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[500];
        luxel_scene *scene;
        luxel_evaluator *evaluator;
        luxel_field *field;
        snprintf(text, sizeof text,
                 "luxel: 1\nscreen: {width: 500, height: 500, resolution: [5, 5]}\nobserver: {z: 1500}\n"
                 "surfaces: [{type: sphere, center: [0, 0, 900], radius: 200, material: %s}]\n"
                 "lights: [{type: ambient, irradiance: 3}]\n",
                 cases[i].material);
        if (load(text, NULL, &scene) != LUXEL_OK)
            fail_msg("not a good scene: %s", text);
        assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
        assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
        luxel_value value;
        luxel_evaluate_screen(evaluator, 70, -40, &value, NULL);
        assert_true(value.has_value && fabs(value.value - cases[i].expected) <= 1e-15);
        assert_true(fabs(luxel_field_value(field, 2, 2) - cases[i].expected) <= 1e-7);
        luxel_field_free(field);
        luxel_evaluator_free(evaluator);
        luxel_scene_free(scene);
    }
}

/* Places of a sphere in float32: half of them lie inside, and are dark until they are put back; nothing else moves. */
static void test_settled(void **state)
{
    (void)state;
    enum { COUNT = 500 };
    luxel_scene *scene = NULL;
    luxel_place exact[COUNT], rounded[COUNT];
    luxel_value truth[COUNT], found[COUNT];
    double tolerances[COUNT], moved[COUNT];
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_evaluator *evaluator = evaluator_of(scene, LUXEL_BRIGHTNESS);
    double center[3], radius;
    size_t dark = 0;
    luxel_scene_surface_place(scene, 0, center);
    assert_int_equal(luxel_scene_surface_radius(scene, 0, &radius), LUXEL_OK);
    for (size_t i = 0; i < COUNT; i++) {
        const double z = 1 - ((double)i + 0.5) / COUNT, turn = 2.399963 * (double)i, across = sqrt(1 - z * z);
        const double normal[3] = {across * cos(turn), across * sin(turn), z};
        exact[i] = (luxel_place){.is_element = true};
        tolerances[i] = 1e-4;
        for (int k = 0; k < 3; k++) {
            exact[i].normal[k] = normal[k];
            exact[i].position_mm[k] = center[k] + radius * normal[k];
        }
        rounded[i] = exact[i];
        for (int k = 0; k < 3; k++)
            rounded[i].position_mm[k] = (double)(float)exact[i].position_mm[k];
    }
    assert_int_equal(luxel_evaluate_places(evaluator, exact, COUNT, truth, NULL), LUXEL_OK);
    assert_int_equal(luxel_evaluate_places(evaluator, rounded, COUNT, found, NULL), LUXEL_OK);
    for (size_t i = 0; i < COUNT; i++)
        dark += truth[i].value > 0 && found[i].value == 0;
    assert_true(dark > COUNT / 10);
    luxel_place before[COUNT];
    memcpy(before, rounded, sizeof before);
    assert_int_equal(luxel_evaluator_settle_places(evaluator, rounded, COUNT, tolerances, moved), LUXEL_OK);
    assert_int_equal(luxel_evaluate_places(evaluator, rounded, COUNT, found, NULL), LUXEL_OK);
    for (size_t i = 0; i < COUNT; i++) {
        double off = 0, far = 0;
        for (int k = 0; k < 3; k++) {
            off += (rounded[i].position_mm[k] - center[k]) * (rounded[i].position_mm[k] - center[k]);
            far += (rounded[i].position_mm[k] - before[i].position_mm[k]) *
                   (rounded[i].position_mm[k] - before[i].position_mm[k]);
        }
        assert_true(fabs(sqrt(off) - radius) < 1e-10 && fabs(sqrt(far) - moved[i]) < 1e-12 && moved[i] <= 1e-4);
        assert_true(fabs(found[i].value - truth[i].value) <= 1e-5 * 12 && found[i].surface == 0);
    }
    /* what is farther away, not an element, without a tolerance or no place stays */
    luxel_place others[4] = {exact[0], {.screen_mm = {1, 2}}, exact[0], exact[0]};
    others[0].position_mm[2] -= 1e-3, others[2].position_mm[2] -= 1e-5, others[3].normal[0] = (double)NAN;
    luxel_place kept[4];
    memcpy(kept, others, sizeof kept);
    assert_int_equal(luxel_evaluator_settle_places(evaluator, others, 4, (const double[]){1e-4, 1, 0, 1}, NULL),
                     LUXEL_OK);
    assert_memory_equal(kept, others, sizeof kept);
    assert_int_equal(luxel_evaluator_settle_places(NULL, others, 4, tolerances, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_evaluator_settle_places(evaluator, NULL, 4, tolerances, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_evaluator_settle_places(evaluator, others, 4, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_evaluator_settle_places(evaluator, NULL, 0, NULL, NULL), LUXEL_OK);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ambient), cmocka_unit_test(test_probes),  cmocka_unit_test(test_light_on_element),
        cmocka_unit_test(test_trace),   cmocka_unit_test(test_places),  cmocka_unit_test(test_places_cancelled),
        cmocka_unit_test(test_refused), cmocka_unit_test(test_settled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
