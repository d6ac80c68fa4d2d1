/* SPDX-License-Identifier: MIT */
/*
 * Scenes that no picture, or only a part of one, can be made of: plates that show the observer their backs, observers
 * inside of surfaces, no surface at all.  Free elements and grids have their values all the same.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { TEXT_SIZE = 4000, SIDE = 80, PLATES = 6 };

static double between(double low, double high)
{
    return low + (high - low) * (rand() / (RAND_MAX + 1.0));
}

static luxel_scene *scene_of(const char *observer, const char *surfaces, const char *more)
{
    char text[TEXT_SIZE];
    luxel_scene *scene;
    const int length =
        snprintf(text, sizeof text,
                 "luxel: 1\nunits: photometric\nscreen: {width: 800, height: 800, resolution: [%d, %d]}\n"
                 "observer: %s\nsurfaces: [%s]\n%s\n",
                 SIDE, SIDE, observer, surfaces, more);
    assert_true(length > 0 && length < TEXT_SIZE);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    return scene;
}

static luxel_probe *probe_at(const luxel_scene *scene, luxel_quantity quantity, const double place[3],
                             const double normal[3])
{
    luxel_settings settings;
    luxel_probe *probe;
    luxel_settings_init(&settings);
    settings.quantity = quantity;
    assert_int_equal(luxel_probe_element(scene, &settings, place, normal, NULL, &probe), LUXEL_OK);
    assert_true(probe->has_value);
    return probe;
}

/* ---- backs ---- */

struct plate {
    double center[3], axis[3], radius;
};

static void write_plates(const struct plate *plates, char text[TEXT_SIZE])
{
    size_t length = 0;
    for (int i = 0; i < PLATES; i++)
        length += (size_t)snprintf(text + length, TEXT_SIZE - length,
                                   "%s{type: disk, center: [%.17g, %.17g, %.17g], axis: [%.17g, %.17g, %.17g], "
                                   "radius: %.17g, material: {model: lambert}}",
                                   i ? ", " : "", plates[i].center[0], plates[i].center[1], plates[i].center[2],
                                   plates[i].axis[0], plates[i].axis[1], plates[i].axis[2], plates[i].radius);
}

/* The disk that a line of sight meets first on its front, as the user sees it; -1: none.  `margin`: how far the nearest
 * edge is from it, in mm. */
static int first_front(const struct plate *plates, const double from[3], const double way[3], double *margin)
{
    double nearest = HUGE_VAL;
    int found = -1;
    *margin = HUGE_VAL;
    for (int i = 0; i < PLATES; i++) {
        double height = 0, slope = 0, square = 0;
        for (int k = 0; k < 3; k++) {
            height += (from[k] - plates[i].center[k]) * plates[i].axis[k];
            slope += way[k] * plates[i].axis[k];
        }
        if (!(height > 0 && slope < 0))
            continue;
        const double t = -height / slope;
        for (int k = 0; k < 3; k++)
            square += pow(from[k] + t * way[k] - plates[i].center[k], 2);
        *margin = fmin(*margin, fabs(sqrt(square) - plates[i].radius));
        if (square <= plates[i].radius * plates[i].radius && t < nearest) {
            nearest = t;
            found = i;
        }
    }
    return found;
}

/* Fronts are seen through backs, in pictures as by hand; each pixel has the exact value of what it shows. */
static void backs_are_not_drawn(void **state)
{
    (void)state;
    for (int trial = 0; trial < 40; trial++) {
        struct plate plates[PLATES];
        char text[TEXT_SIZE];
        const bool is_perspective = trial % 2;
        for (int i = 0; i < PLATES; i++) {
            for (int k = 0; k < 3; k++) {
                plates[i].center[k] = between(-300, 300);
                plates[i].axis[k] = between(-1, 1);
            }
            plates[i].axis[2] += i % 2 ? -1.2 : 1.2;
            plates[i].radius = between(50, 300);
        }
        write_plates(plates, text);
        luxel_scene *scene = scene_of(is_perspective ? "{z: 1500, projection: perspective}" : "{z: 1500}", text,
                                      "lights: [{type: point, position: [200, 300, 1200], intensity: 9}, "
                                      "{type: point, position: [-200, 300, -900], intensity: 5}]");
        luxel_settings settings;
        luxel_field *field;
        luxel_evaluator *evaluator;
        luxel_settings_init(&settings);
        settings.precision = LUXEL_DOUBLE;
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
        const double maximum = luxel_field_statistics(field)->maximum.value;
        for (unsigned row = 0; row < SIDE; row++)
            for (unsigned column = 0; column < SIDE; column++) {
                const double x = -400 + (column + 0.5) * 10, y = 400 - (row + 0.5) * 10;
                const double from[3] = {is_perspective ? 0 : x, is_perspective ? 0 : y, 1500};
                const double way[3] = {is_perspective ? x : 0, is_perspective ? y : 0, -1500};
                double margin;
                const int front = first_front(plates, from, way, &margin);
                if (margin < 1e-6)
                    continue;
                luxel_value value;
                luxel_evaluate_screen(evaluator, x, y, &value, NULL);
                assert_int_equal(value.on_surface, front >= 0);
                assert_int_equal(luxel_field_mask(field)[row * SIDE + column], front >= 0);
                if (front < 0)
                    continue;
                assert_int_equal(value.surface, front);
                assert_true(fabs(luxel_field_value(field, column, row) - value.value) <= 1e-10 * maximum);
            }
        luxel_evaluator_free(evaluator);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

#define MATERIAL(rho) "material: {model: lambert, diffuse: " rho ", over_pi: true}"
#define PLATE(z, axis, rho)                                                                                            \
    "{type: rectangle, center: [0, 0, " z "], size: [1000, 1000], axis: [0, 0, " axis "], " MATERIAL(rho) "}"

/* Two plates that face each other have one light, wherever the observer is: between them, where nothing shows its back,
 * above, aside and inside a third body are all the same. */
static void floor_and_ceiling(void **state)
{
    (void)state;
    static const char *const observers[] = {"{z: 500, projection: perspective}", "{z: 2000}",
                                            "{z: 2000, projection: perspective}",
                                            "{position: [5000, 0, 300], target: [0, 0, 300]}"};
    const double places[2][3] = {{200, 100, 0}, {-300, 20, 1000}}, normals[2][3] = {{0, 0, 1}, {0, 0, -1}};
    double truths[2];
    for (size_t i = 0; i < 4; i++) {
        luxel_scene *scene = scene_of(observers[i], PLATE("0", "1", "0.7") ", " PLATE("1000", "-1", "0.5"),
                                      "reflections: all\nlights: [{type: point, position: [200, 100, 400], "
                                      "intensity: 100}]\n");
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_scene_check_view(scene, diagnostics), LUXEL_OK);
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        size_t backs = 0;
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            if (strcmp(luxel_diagnostics_get(diagnostics, k)->id, "turned-away") != 0)
                continue;
            /* what turns it round is an assignment, for a front end's button */
            char *hint = luxel_diagnostics_hint(diagnostics, k, NULL, NULL);
            assert_non_null(strstr(hint, strstr(luxel_diagnostics_get(diagnostics, k)->key, "[0]")
                                             ? "-s 'surfaces[0].axis=[0, 0, -1]'"
                                             : "-s 'surfaces[1].axis=[0, 0, 1]'"));
            luxel_text_free(hint);
            backs++;
        }
        assert_int_equal(backs, i == 0 ? 0 : i == 3 ? 2 : 1);
        for (int k = 0; k < 2; k++) {
            luxel_probe *probe = probe_at(scene, LUXEL_IRRADIANCE, places[k], normals[k]);
            if (i == 0)
                truths[k] = probe->value;
            assert_true(probe->lies_on_surface && probe->reflected_reached);
            assert_true(fabs(probe->value - truths[k]) <= 1e-9 * truths[k]);
            luxel_probe_free(probe);
        }
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* ---- observers and screens that make no picture ---- */

/* All that looks through the screen says why not; elements, grids and an evaluator's elements have their values. */
static void numbers_without_pictures(void **state)
{
    (void)state;
    static const struct {
        const char *change, *id;
    } cases[] = {{"observer.z=1000", "observer-too-low"}, {"screen.resolution=[3, 2]", "not-square"}};
    const double top[3] = {0, 0, 1300}, up[3] = {0, 0, 1};
    for (size_t i = 0; i < 2; i++) {
        luxel_scene *scene = opened_with(
            "report",
            (const char *const[]){cases[i].change, "units=photometric", "lights[0].attenuation=inverse-square",
                                  "grids=[{center: [0, 0, 1400], size: [100, 100], n: [2, 2]}]"},
            4);
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_field *field;
        luxel_probe *probe;
        luxel_probes *probes;
        luxel_profile *profile;
        luxel_evaluator *evaluator;
        luxel_grid *grid;
        luxel_glare *glare;
        luxel_light_reach reach;
        double depth[6];
        const luxel_profile_path path = {.type = LUXEL_PATH_LINE, .to_mm = {10, 10}, .samples = 3};
        const luxel_place places[2] = {{.screen_mm = {0, 0}},
                                       {.is_element = true, .position_mm = {0, 0, 1300}, .normal = {0, 0, 1}}};
        luxel_value values[2];
        assert_int_equal(luxel_evaluator_new(scene, NULL, diagnostics, &evaluator), LUXEL_OK);
        assert_int_equal(luxel_render(scene, NULL, diagnostics, &field), LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_probe_screen(scene, NULL, 0, 0, diagnostics, &probe), LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_probe_places(scene, NULL, places, 2, diagnostics, &probes), LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_find_profile(evaluator, &path, diagnostics, &profile), LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_find_light_reach(scene, NULL, diagnostics, &reach), LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_find_geometry(scene, NULL, diagnostics, &(luxel_geometry){.depth_mm = depth}),
                         LUXEL_ERROR_SCENE);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 6);
        for (size_t k = 0; k < 6; k++)
            expect_entry(diagnostics, k, WANTED(.id = cases[i].id));
        luxel_diagnostics_clear(diagnostics);

        const double truth = 10 * 700 / pow(4 + 0.49, 1.5) / 1000;
        probe = probe_at(scene, LUXEL_IRRADIANCE, top, up);
        assert_true(fabs(probe->value - truth) <= 1e-12 * truth);
        luxel_probe_free(probe);
        assert_int_equal(luxel_evaluate_places(evaluator, places, 2, values, NULL), LUXEL_OK);
        assert_true(!values[0].on_surface && values[1].has_value && values[1].value > 0);
        luxel_trace_screen(evaluator, 0, 0, &values[0]);
        assert_false(values[0].on_surface);
        assert_int_equal(luxel_find_grid(scene, NULL, 0, diagnostics, &grid), LUXEL_OK);
        assert_true(grid->average.value > 0);
        assert_int_equal(luxel_find_glare(scene, NULL, &(luxel_glare_sight){.eye_mm = {0, 0, 2000}, .view = {0, 1, 0}},
                                          diagnostics, &glare),
                         LUXEL_OK);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
        luxel_glare_free(glare);
        luxel_grid_free(grid);
        luxel_evaluator_free(evaluator);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

/* Without surfaces elements have E = I cos / r^2, and what the keys of materials are by default. */
static void no_surfaces(void **state)
{
    (void)state;
    const double place[3] = {300, 0, 0}, up[3] = {0, 0, 1}, cosine = 1 / sqrt(1.09);
    const double truth = 10 * cosine / 1.09, half = cos(acos(cosine) / 2);
    for (int reflects = 0; reflects < 2; reflects++) {
        luxel_scene *scene = scene_of("{z: 900}", "",
                                      reflects ? "reflections: all\n"
                                                 "lights: [{type: point, position: [0, 0, 1000], intensity: 10}]\n"
                                                 "grids: [{center: [300, 0, 0], size: [1, 1], n: [1, 1]}]"
                                               : "lights: [{type: point, position: [0, 0, 1000], intensity: 10}]\n"
                                                 "grids: [{center: [300, 0, 0], size: [1, 1], n: [1, 1]}]");
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_field *field;
        luxel_grid *grid;
        luxel_evaluator *evaluator;
        luxel_probe *probe = probe_at(scene, LUXEL_IRRADIANCE, place, up);
        assert_true(fabs(probe->value - truth) <= 1e-12 && !probe->lies_on_surface && probe->surface == SIZE_MAX);
        luxel_probe_free(probe);
        probe = probe_at(scene, LUXEL_BRIGHTNESS, place, up);
        const double brightness = 0.8 * truth + 0.5 * 10 / 1.09 * pow(half, 20);
        assert_true(fabs(probe->value - brightness) <= 1e-12 * brightness);
        luxel_probe_free(probe);
        assert_int_equal(luxel_evaluator_new(scene, NULL, diagnostics, &evaluator), LUXEL_OK);
        const luxel_place asked = {.is_element = true, .position_mm = {300, 0, 0}, .normal = {0, 0, 1}};
        luxel_value value;
        assert_int_equal(luxel_evaluate_places(evaluator, &asked, 1, &value, NULL), LUXEL_OK);
        assert_true(fabs(value.value - brightness) <= 1e-12 * brightness);
        luxel_evaluator_free(evaluator);
        assert_int_equal(luxel_find_grid(scene, NULL, 0, diagnostics, &grid), LUXEL_OK);
        assert_true(fabs(grid->average.value - truth) <= 1e-12);
        luxel_grid_free(grid);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
        assert_int_equal(luxel_render(scene, NULL, diagnostics, &field), LUXEL_ERROR_SCENE);
        expect_entry(diagnostics, 0, WANTED(.id = "no-surfaces", .line = 5, .key = "surfaces"));
        luxel_diagnostics_clear(diagnostics);
        assert_int_equal(luxel_scene_advise(scene, diagnostics), LUXEL_OK);
        assert_int_equal(luxel_scene_advise_peak(scene, diagnostics), LUXEL_OK);
        size_t told = 0;
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            const char *id = luxel_diagnostics_get(diagnostics, k)->id;
            told += strcmp(id, "no-surfaces") == 0;
            assert_true(strcmp(id, "no-surfaces") == 0 || strcmp(id, "not-advised") == 0);
        }
        assert_int_equal(told, 1);
        luxel_diagnostics_free(diagnostics);
        luxel_scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(backs_are_not_drawn),
        cmocka_unit_test(floor_and_ceiling),
        cmocka_unit_test(numbers_without_pictures),
        cmocka_unit_test(no_surfaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
