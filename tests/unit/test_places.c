/* SPDX-License-Identifier: MIT */
/*
 * Places to probe: how free elements are seen, whose material they have, what shades them; many places against each by
 * itself; and the conventions that had a say in a result.
 */
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

#define BALL "{type: sphere, center: [0, 0, 1000], radius: 300}"
#define LAMP "{type: point, position: [0, 0, 2000], intensity: 10}"

static luxel_probe *probe_at(const luxel_scene *scene, const luxel_place *place)
{
    luxel_probe *probe = NULL;
    assert_int_equal(luxel_probe_place(scene, NULL, place, NULL, &probe), LUXEL_OK);
    return probe;
}

static luxel_place element_at(double x, double y, double z, double nx, double ny, double nz)
{
    return (luxel_place){.is_element = true, .position_mm = {x, y, z}, .normal = {nx, ny, nz}};
}

static double value_at(const luxel_scene *scene, luxel_place place)
{
    luxel_probe *probe = probe_at(scene, &place);
    assert_true(probe->has_value);
    const double value = probe->value;
    luxel_probe_free(probe);
    return value;
}

static luxel_scene *altered(const char *name, const char *const *assignments)
{
    luxel_scene *scene = builtin(name);
    for (size_t i = 0; assignments[i]; i++)
        assert_int_equal(luxel_scene_set(scene, assignments[i], NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

#define ALTERED(name, ...) altered(name, (const char *const[]){__VA_ARGS__, NULL})

static void assert_near(double found, double expected, double relative)
{
    if (!(fabs(found - expected) <= relative * fabs(expected)))
        fail_msg("%.17g is not %.17g to %g", found, expected, relative);
}

/* ---- how they are seen ---- */

/* At the place that a point of the screen shows, with the normal there, is the same value, whatever the view. */
static void seen_as_the_scene_says(void **state)
{
    (void)state;
    static const char *const views[] = {"observer.view=parallel", "observer.view=observer",
                                        "observer.projection=perspective"};
    for (size_t v = 0; v < 3; v++) {
        luxel_scene *scene = ALTERED("report", views[v]);
        for (double x = -200; x <= 200; x += 25) {
            luxel_probe *seen = probe_at(scene, &(luxel_place){.screen_mm = {x, x / 3}});
            if (seen->has_value) {
                const double *at = seen->position_mm, *n = seen->normal;
                luxel_probe *free = probe_at(scene, &(luxel_place){.is_element = true,
                                                                   .position_mm = {at[0], at[1], at[2]},
                                                                   .normal = {n[0], n[1], n[2]}});
                assert_true(free->lies_on_surface && free->surface == 0);
                assert_near(free->value, seen->value, 1e-11);
                for (int i = 0; i < 3; i++)
                    assert_true(fabs(free->view[i] - seen->view[i]) <= 1e-15);
                luxel_probe_free(free);
            }
            luxel_probe_free(seen);
        }
        luxel_scene_free(scene);
    }
    luxel_scene *scene = builtin("report");
    const double half = sqrt(3) / 2;
    assert_near(value_at(scene, element_at(150, 0, 1000 + 300 * half, 0.5, 0, half)), 11.0380150393, 1e-11);
    luxel_scene_free(scene);
}

/* A direction of its own, of any length: by hand, with the half vector between it and the light. */
static void seen_from_elsewhere(void **state)
{
    (void)state;
    luxel_scene *scene = ALTERED("report", "lights=[{type: distant, direction: [0, 0, -1], irradiance: 2}]",
                                 "surfaces[0].material={diffuse: 0, specular: 1, shininess: 4}");
    luxel_place place = element_at(0, 0, 5000, 0, 0, 3);
    place.has_view = true;
    for (double angle = 0; angle < 3; angle += 0.25) {
        place.view[0] = 7 * sin(angle), place.view[1] = 0, place.view[2] = 7 * cos(angle);
        assert_near(value_at(scene, place), 2 * pow(cos(angle / 2), 4), 1e-14);
    }
    luxel_probe *probe = probe_at(scene, &place);
    assert_near(hypot(probe->view[0], probe->view[2]), 1, 1e-15);
    luxel_probe_free(probe);
    luxel_scene_free(scene);
}

/* ---- whose material ---- */

static void material_of_the_own_surface(void **state)
{
    (void)state;
    luxel_scene *scene = ALTERED("report", "lights=[{type: distant, direction: [0, 0, -1], irradiance: 1}]",
                                 "surfaces=[{type: sphere, name: dull, center: [-300, 0, 1000], radius: 100, material: "
                                 "{diffuse: 0.1, specular: 0}}, {type: rectangle, name: white, center: [300, 0, 1000], "
                                 "size: [200, 200], material: {diffuse: 0.9, specular: 0}}]");
    luxel_place on = element_at(300, 0, 1000, 0, 0, 1), off = element_at(0, 0, 1400, 0, 0, 1);
    luxel_probe *probe = probe_at(scene, &on);
    assert_near(probe->value, 0.9, 1e-14);
    assert_true(probe->lies_on_surface && probe->surface == 1);
    assert_string_equal(probe->surface_name, "white");
    luxel_probe_free(probe);
    on.position_mm[2] += 0.9e-9 * 100; /* to 1e-9 of its size */
    assert_near(value_at(scene, on), 0.9, 1e-14);
    on.position_mm[2] += 1e-6;
    assert_near(value_at(scene, on), 0.1, 1e-14);
    on = element_at(-300, 0, 1100, 0, 0, 1);
    on.surface = 1; /* counts elsewhere alone */
    assert_near(value_at(scene, on), 0.1, 1e-14);
    probe = probe_at(scene, &off);
    assert_near(probe->value, 0.1, 1e-14);
    assert_true(!probe->lies_on_surface && probe->surface == 0);
    luxel_probe_free(probe);
    off.surface = 1;
    assert_near(value_at(scene, off), 0.9, 1e-14);
    luxel_scene_free(scene);
}

/* ---- what shades them ---- */

static luxel_scene *under(const char *surfaces, const char *lights)
{
    char both[2][512];
    snprintf(both[0], sizeof both[0], "surfaces=[%s]", surfaces);
    snprintf(both[1], sizeof both[1], "lights=[%s]", lights);
    return ALTERED("report", both[0], both[1], "surfaces[0].material={diffuse: 1, specular: 0}", "observer.z=90000");
}

static void shaded_by_every_surface(void **state)
{
    (void)state;
    static const char *const surfaces[] = {
        BALL, BALL ", {type: sphere, center: [90000, 0, 0], radius: 1}",
        "{type: rectangle, center: [0, 0, 1000], size: [300, 300]}",
        "{type: sphere, center: [0, 0, 300], radius: 300}", /* it touches the plane where it is probed */
    };
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++) {
        luxel_scene *scene = under(surfaces[i], LAMP);
        assert_true(value_at(scene, element_at(0, 0, 0, 0, 0, 1)) == 0);
        assert_near(value_at(scene, element_at(1000, 0, 0, 0, 0, 1)), 10 * 2 / (5 * sqrt(5)), 1e-14);
        luxel_scene_free(scene);
        scene = under(surfaces[i], "{type: distant, direction: [0, 0, -1], irradiance: 3}");
        assert_true(value_at(scene, element_at(0, 0, 0, 0, 0, 1)) == 0);
        assert_near(value_at(scene, element_at(1000, 0, 0, 0, 0, 1)), 3, 1e-14);
        luxel_scene_free(scene);
    }
    luxel_scene *scene = under(BALL, LAMP);
    assert_int_equal(luxel_scene_set(scene, "shadows=none", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_near(value_at(scene, element_at(0, 0, 0, 0, 0, 1)), 2.5, 1e-14);
    luxel_scene_free(scene);
}

/* On a surface its own normal is shaded by nothing; another one loses what comes from behind the surface. */
static void on_a_surface(void **state)
{
    (void)state;
    luxel_scene *scene = under(BALL, "{type: point, position: [1000, 0, 1300.1], intensity: 10}");
    assert_true(value_at(scene, element_at(0, 0, 1300, 0, 0, 1)) > 0);
    assert_true(value_at(scene, element_at(300, 0, 1000, 1, 0, 0)) > 0);
    assert_true(value_at(scene, element_at(300, 0, 1000, 0, 0.01, 1)) > 0);   /* before the tangent plane */
    assert_true(value_at(scene, element_at(-300, 0, 1000, 1, 0.01, 0)) == 0); /* through the ball */
    luxel_scene_free(scene);
    scene = under("{type: rectangle, center: [0, 0, 0], size: [300, 300]}",
                  "{type: point, position: [100, 0, -100], intensity: 10}");
    assert_true(value_at(scene, element_at(0, 0, 0, 0, 0, -1)) > 0); /* its back */
    assert_true(value_at(scene, element_at(0, 0, 0, 1, 0, 0.01)) == 0);
    assert_true(value_at(scene, element_at(0, 0, 0, 1, 0, -0.01)) > 0);
    luxel_scene_free(scene);
}

static void inside_a_body(void **state)
{
    (void)state;
    luxel_scene *scene = under("{type: rectangle, center: [0, 0, -500], size: [300, 300]}, " BALL, LAMP);
    luxel_place place = element_at(0, 0, 1100, 0, 0, 1);
    luxel_probe *probe = probe_at(scene, &place);
    assert_true(probe->is_enclosed && probe->enclosing_surface == 1 && probe->value == 0);
    luxel_probe_free(probe);
    static const double outside[][3] = {{0, 0, 1300}, {0, 0, 1300.001}, {0, 0, -500}, {0, 0, -600}};
    for (size_t i = 0; i < 4; i++) {
        memcpy(place.position_mm, outside[i], sizeof outside[i]);
        probe = probe_at(scene, &place);
        assert_false(probe->is_enclosed);
        luxel_probe_free(probe);
    }
    luxel_scene_free(scene);
}

/* ---- many of them ---- */

enum { MANY = 400 };

/* Places on and off the screen and in space, the same each time. */
static void make_places(luxel_place places[MANY])
{
    uint32_t state = 12345;
    double random[7];
    for (size_t i = 0; i < MANY; i++) {
        for (int k = 0; k < 7; k++) {
            state = state * 1664525 + 1013904223;
            random[k] = state / 4294967296.0 - 0.5;
        }
        places[i] = (luxel_place){
            .screen_mm = {600 * random[0], 600 * random[1]},
            .is_element = random[6] > 0.2,
            .position_mm = {800 * random[0], 800 * random[1], 1000 + 800 * random[2]},
            .normal = {random[3], random[4], random[5]},
        };
    }
}

static void same_probe(const luxel_probe *a, const luxel_probe *b)
{
    luxel_probe copy = *a;
    copy.shares = b->shares;
    copy.surface_name = b->surface_name;
    assert_memory_equal(&copy, b, sizeof copy);
    for (size_t i = 0; i < a->share_count; i++) {
        luxel_light_share share = a->shares[i];
        share.name = b->shares[i].name;
        assert_memory_equal(&share, &b->shares[i], sizeof share);
    }
}

static void same_as_single_ones(const char *name, luxel_precision precision, unsigned threads)
{
    luxel_scene *scene = builtin(name);
    luxel_settings settings;
    luxel_place places[MANY];
    luxel_probes *many = NULL;
    make_places(places);
    luxel_settings_init(&settings);
    settings.precision = precision;
    settings.threads = threads;
    settings.tolerance = 1e-3;
    assert_int_equal(luxel_probe_places(scene, &settings, places, MANY, NULL, &many), LUXEL_OK);
    for (size_t i = 0; i < MANY; i += 7) {
        luxel_probe *single = NULL;
        assert_int_equal(luxel_probe_place(scene, &settings, &places[i], NULL, &single), LUXEL_OK);
        same_probe(single, luxel_probes_get(many, i));
        luxel_probe_free(single);
    }
    luxel_probes_free(many);
    luxel_scene_free(scene);
}

static void many_at_once(void **state)
{
    (void)state;
    static const char *const names[] = {"report", "three-lights"};
    for (size_t i = 0; i < 2; i++)
        for (unsigned threads = 1; threads <= 5; threads += 2) {
            same_as_single_ones(names[i], LUXEL_SINGLE, threads);
            same_as_single_ones(names[i], LUXEL_DOUBLE, threads);
        }
    luxel_scene *scene = builtin("report");
    luxel_probes *none = NULL;
    assert_int_equal(luxel_probe_places(scene, NULL, NULL, 0, NULL, &none), LUXEL_OK);
    assert_non_null(none);
    luxel_probes_free(none);
    luxel_scene_free(scene);
}

/* Evaluators have the numbers of probes there. */
static void by_evaluators(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("three-lights");
    luxel_evaluator *evaluator = NULL;
    luxel_place places[MANY];
    make_places(places);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    for (size_t i = 0; i < MANY; i += 5) {
        luxel_probe *probe = probe_at(scene, &places[i]);
        luxel_value value;
        luxel_evaluate_place(evaluator, &places[i], &value, NULL);
        assert_int_equal(value.on_surface, probe->on_surface);
        assert_true(value.value == probe->value && value.error == probe->error);
        if (value.on_surface)
            assert_int_equal(value.surface, probe->surface);
        luxel_probe_free(probe);
    }
    luxel_place wrong = element_at(0, 0, 0, 0, 0, 0);
    luxel_value value;
    luxel_evaluate_place(evaluator, &wrong, &value, NULL);
    assert_false(value.on_surface);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

static bool stop(double done, void *data)
{
    (void)done, (void)data;
    return false;
}

static void refuses(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_place wrong[5];
    for (size_t i = 0; i < 5; i++)
        wrong[i] = element_at(0, 0, 5000, 0, 0, 1);
    wrong[0].normal[2] = 0;
    wrong[1].position_mm[1] = (double)NAN;
    wrong[2].has_view = true;
    wrong[3].surface = 1;
    wrong[4].is_element = false, wrong[4].screen_mm[0] = HUGE_VAL;
    for (size_t i = 0; i < 5; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_probe *probe = NULL;
        assert_int_equal(luxel_probe_place(scene, NULL, &wrong[i], diagnostics, &probe), LUXEL_ERROR_ARGUMENT);
        assert_null(probe);
        assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, i == 3 ? "no-such-surface" : "bad-place");
        luxel_diagnostics_free(diagnostics);
    }
    luxel_settings settings;
    luxel_place places[MANY];
    luxel_probes *probes = NULL;
    make_places(places);
    luxel_settings_init(&settings);
    settings.progress = stop;
    assert_int_equal(luxel_probe_places(scene, &settings, places, MANY, NULL, &probes), LUXEL_CANCELLED);
    assert_null(probes);
    luxel_scene_free(scene);
}

/* ---- conventions ---- */

/* "sampling projection ...": the keys, with a blank behind each. */
static void expect_keys(const luxel_scene *scene, const luxel_conventions_use *use, const char *expected)
{
    char keys[512] = "";
    luxel_conventions *conventions = NULL;
    assert_int_equal(luxel_find_conventions(scene, use, &conventions), LUXEL_OK);
    for (size_t i = 0; i < conventions->count; i++) {
        strcat(keys, conventions->list[i].key);
        strcat(keys, " ");
    }
    assert_string_equal(keys, expected);
    luxel_conventions_free(conventions);
}

static const char *value_of(const luxel_scene *scene, const luxel_conventions_use *use, const char *key,
                            char value[128])
{
    luxel_conventions *conventions = NULL;
    assert_int_equal(luxel_find_conventions(scene, use, &conventions), LUXEL_OK);
    strcpy(value, "none");
    for (size_t i = 0; i < conventions->count; i++)
        if (strcmp(conventions->list[i].key, key) == 0)
            snprintf(value, 128, "%s", conventions->list[i].value);
    luxel_conventions_free(conventions);
    return value;
}

static void conventions_that_counted(void **state)
{
    (void)state;
    char value[128];
    luxel_scene *scene = builtin("report");
    expect_keys(scene, &(luxel_conventions_use){.screen = false}, "units shadows attenuation pattern ");
    expect_keys(scene, &(luxel_conventions_use){.screen = true}, "units shadows projection attenuation pattern ");
    expect_keys(scene, &(luxel_conventions_use){.screen = true, .pixels = true, .brightness = true},
                "units shadows sampling projection view model over_pi highlight normalized attenuation pattern ");
    expect_keys(scene, NULL,
                "units shadows sampling projection view model over_pi highlight normalized attenuation pattern range "
                "rounding ");
    luxel_conventions_use use = {.brightness = true, .has_view = true, .view = {1, 0, 2}};
    assert_string_equal(value_of(scene, &use, "view", value), "parallel, [1, 0, 2]");
    use.only_view = true;
    assert_string_equal(value_of(scene, &use, "view", value), "[1, 0, 2]");
    luxel_scene_free(scene);

    scene = ALTERED("report", "observer.projection=perspective",
                    "surfaces=[{type: sphere, center: [0, 0, 0], radius: 1, material: {model: lambert}}, "
                    "{type: sphere, center: [9, 0, 0], radius: 1, material: {model: phong}}]");
    const bool second[2] = {false, true};
    use = (luxel_conventions_use){.brightness = true, .surfaces = second};
    assert_string_equal(value_of(scene, &use, "model", value), "phong");
    assert_string_equal(value_of(scene, &use, "projection", value), "perspective"); /* it decides the view */
    use.surfaces = NULL;
    assert_string_equal(value_of(scene, &use, "model", value), "lambert, phong");
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(seen_as_the_scene_says),
        cmocka_unit_test(seen_from_elsewhere),
        cmocka_unit_test(material_of_the_own_surface),
        cmocka_unit_test(shaded_by_every_surface),
        cmocka_unit_test(on_a_surface),
        cmocka_unit_test(inside_a_body),
        cmocka_unit_test(many_at_once),
        cmocka_unit_test(by_evaluators),
        cmocka_unit_test(refuses),
        cmocka_unit_test(conventions_that_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
