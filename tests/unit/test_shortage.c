/* SPDX-License-Identifier: MIT */
/*
 * Memory that runs out: every allocation of the library fails once, and each time the call ends with
 * LUXEL_ERROR_MEMORY or does without, changes nothing and loses nothing.  The linker puts the functions of shortage.c
 * in the place of malloc() and its kin (see meson.build).
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scenes.h"
#include "shortage.h"

static void loading(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_scene *scene = NULL;
        shortage_begin(i);
        luxel_status status = load(good_scene, NULL, &scene);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        luxel_scene_free(scene);
    }
}

/* The brightness of some place. */
static double value_of(const luxel_scene *scene)
{
    luxel_evaluator *evaluator;
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_value seen;
    luxel_evaluate_screen(evaluator, 10, 20, &seen, NULL);
    luxel_evaluator_free(evaluator);
    assert_true(seen.has_value && seen.value > 0);
    return seen.value;
}

/* A mesh, outlines, groups and lists of groups. */
static void loading_lights_of_some_size(void **state)
{
    (void)state;
    char mesh[] = "/tmp/luxel-shortage-XXXXXX", words[1024];
    static const char body[] = "OFF\n4 4 6\n0 0 1500\n90 0 1500\n0 90 1500\n0 0 1590\n"
                               "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    int file = mkstemp(mesh);
    assert_true(file >= 0 && write(file, body, sizeof body - 1) == sizeof body - 1 && close(file) == 0);
    snprintf(words, sizeof words,
             "grids: [{center: [0, 0, 0], size: [9, 9], n: [2, 2]}]\n"
             "lights:\n  - {type: volume, mesh: %s, power: 1}\n"
             "  - {type: volume, sphere: {center: [0, 0, 1800], radius: 9, facets: 5}, power: 1}\n"
             "  - {type: planar, rectangle: {center: [0, 0, 1800], size: [9, 5]}, power: 1, parts: 2}\n"
             "  - {type: planar, vertices: [[0, 0, 1800], [0, 9, 1800], [9, 9, 1800], [1, 8, 1800]], power: 1}\n",
             mesh);
    char *text = changed("lights:\n", words);
    luxel_scene *whole = NULL;
    assert_int_equal(load(text, NULL, &whole), LUXEL_OK);
    const double expected = value_of(whole);
    luxel_scene_free(whole);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_scene *scene = NULL;
        shortage_begin(i);
        luxel_status status = load(text, NULL, &scene);
        luxel_scene *copy = status == LUXEL_OK ? luxel_scene_copy(scene) : NULL;
        shortage_end();
        if (!(status == LUXEL_OK && (copy || shortage_met())) && !(shortage_met() && status == LUXEL_ERROR_MEMORY))
            fail_msg("status %d at allocation %ld", (int)status, i);
        assert_true(status != LUXEL_OK || value_of(scene) == expected); /* and nothing is left out in silence */
        luxel_scene_free(copy);
        luxel_scene_free(scene);
    }
    free(text);
    unlink(mesh);
}

static void setting(void **state)
{
    (void)state;
    luxel_scene *scene;
    char *before = NULL, *after = NULL;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_write_text(scene, &before), LUXEL_OK);
    bool was_set = false;
    for (long i = 0; !was_set; i++) {
        shortage_begin(i);
        luxel_status status = luxel_scene_set(scene, "surfaces[0].material.specular=0.25", NULL);
        shortage_end();
        was_set = status == LUXEL_OK;
        if (was_set)
            break;
        assert_int_equal(status, LUXEL_ERROR_MEMORY);
        assert_true(luxel_scene_is_committed(scene));
        assert_int_equal(luxel_scene_write_text(scene, &after), LUXEL_OK);
        assert_string_equal(before, after);
        luxel_text_free(after);
    }
    luxel_text_free(before);
    luxel_scene_free(scene);
}

static void copying_and_writing(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        shortage_begin(i);
        luxel_scene *copy = luxel_scene_copy(scene);
        shortage_end();
        assert_true((copy == NULL) == shortage_met());
        luxel_scene_free(copy);
    }
    /* as it was read, and then with values replaced and added in both styles */
    static const char *const changes[] = {NULL,
                                          "lights[0].intensity=20",
                                          "shadows=none",
                                          "lights[0].name=a",
                                          "surfaces=[{type: sphere}]",
                                          "surfaces[0].material.model=phong"};
    for (size_t change = 0; change < sizeof changes / sizeof changes[0]; change++) {
        if (changes[change])
            assert_int_equal(luxel_scene_set(scene, changes[change], NULL), LUXEL_OK);
        for (long i = 0; i == 0 || shortage_met(); i++) {
            char *text = NULL;
            shortage_begin(i);
            luxel_status status = luxel_scene_write_text(scene, &text);
            shortage_end();
            assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
            luxel_text_free(text);
        }
    }
    luxel_scene_free(scene);
}

/* Puts in, takes out and moves, each in one way that patches the text and in one that sets or writes it anew. */
static luxel_status edit(luxel_scene *scene, unsigned which)
{
    switch (which) {
    case 0: return luxel_scene_insert(scene, "lights", 1, "{type: ambient}", NULL);
    case 1: return luxel_scene_insert(scene, "grids", 0, "{}", NULL);
    case 2: return luxel_scene_remove(scene, "surfaces[0].name", NULL);
    case 3: return luxel_scene_remove(scene, "points[0]", NULL);
    case 4: return luxel_scene_remove(scene, "units", NULL);
    default: return luxel_scene_move(scene, "lights", 0, 1, NULL);
    }
}

static void changing_elements(void **state)
{
    (void)state;
    static const char text[] = "? luxel\n: 1\n? units\n: x\npoints: [[0, 0]]\nlights: [{}, {type: spot}]\n"
                               "surfaces:\n- name: b\n  type: sphere\n";
    for (unsigned which = 0; which < 6; which++) {
        bool done = false;
        for (long i = 0; !done; i++) {
            luxel_scene *scene = NULL;
            char *after = NULL;
            assert_int_equal(luxel_scene_read_text(text, sizeof text - 1, "a", NULL, &scene), LUXEL_OK);
            shortage_begin(i);
            luxel_status status = edit(scene, which);
            shortage_end();
            done = !shortage_met();
            assert_int_equal(status, done ? LUXEL_OK : LUXEL_ERROR_MEMORY);
            assert_int_equal(luxel_scene_write_text(scene, &after), LUXEL_OK);
            assert_true((strcmp(after, text) == 0) == !done);
            luxel_text_free(after);
            luxel_scene_free(scene);
        }
    }
}

static void getting(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        char *text = NULL;
        shortage_begin(i);
        luxel_status status = luxel_scene_get(scene, i % 2 ? "lights" : "shadows", NULL, NULL, &text);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        assert_true((text == NULL) == shortage_met());
        luxel_text_free(text);
    }
    luxel_scene_free(scene);
}

/* With many errors to report: entries may get lost, but nothing else. */
static void reporting(void **state)
{
    (void)state;
    static const char text[] = "luxel: 3\nscreen: {width: -1, height: x, resolution: [1, 2], foo: 1}\nunits: lux\n"
                               "observer: {z: \"5\"}\nsurfaces: []\n"
                               "lights: [{type: point, inner: 3}, {type: sun}, 5, {type: spot, inner: 5, outer: 3}]\n";
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_scene *scene = NULL;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        shortage_begin(i);
        luxel_status status = load(text, diagnostics, &scene);
        shortage_end();
        assert_true(status == LUXEL_ERROR_SCENE || (shortage_met() && status == LUXEL_ERROR_MEMORY));
        for (size_t k = 0; k < luxel_diagnostics_count(diagnostics); k++) {
            char *message = luxel_diagnostics_message(diagnostics, k, NULL, NULL);
            assert_non_null(message);
            luxel_text_free(message);
        }
        luxel_scene_free(scene);
        luxel_diagnostics_free(diagnostics);
    }
}

static void advising(void **state)
{
    (void)state;
    luxel_scene *scene;
    char *low = changed("z: 1500", "z: 15000");
    assert_int_equal(load(low, NULL, &scene), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        shortage_begin(i);
        luxel_status status = luxel_scene_advise(scene, diagnostics);
        shortage_end();
        assert_true(status == LUXEL_OK || (shortage_met() && status == LUXEL_ERROR_MEMORY));
        luxel_diagnostics_free(diagnostics);
    }
    luxel_scene_free(scene);
    free(low);
}

static void listing_parameters(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        shortage_begin(i);
        luxel_parameters *parameters = luxel_parameters_new();
        shortage_end();
        assert_true((parameters == NULL) == shortage_met());
        luxel_parameters_free(parameters);
    }
}

/* Lights are lowered for what is told of them. */
static void telling_of_lights(void **state)
{
    (void)state;
    char *text = changed("lights:\n", "lights:\n  - {type: planar, rectangle: {center: [0, 0, 1800], size: [9, 5]}, "
                                      "power: 1, parts: 2}\n");
    luxel_scene *scene;
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        double flux = 7, place[3] = {7, 7, 7};
        shortage_begin(i);
        luxel_status status = luxel_scene_light_flux(scene, 0, &flux);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        assert_true((flux == 7) == shortage_met());
        shortage_begin(i);
        bool stands = luxel_scene_light_place(scene, 0, place);
        shortage_end();
        assert_true(stands != shortage_met() && (place[0] == 7) == shortage_met());
    }
    luxel_scene_free(scene);
    free(text);
}

static void writing_the_schema(void **state)
{
    (void)state;
    char *whole = NULL;
    assert_int_equal(luxel_scene_schema(&whole), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        char *text = NULL;
        shortage_begin(i);
        luxel_status status = luxel_scene_schema(&text);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        if (text)
            assert_string_equal(text, whole);
        luxel_text_free(text);
    }
    luxel_text_free(whole);
}

/* A grid and its file: both are whole or not there at all. */
static void measuring(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    char folder[] = "/tmp/luxel-shortage-XXXXXX", path[64];
    char *text = changed("points:", "grids: [{name: a, center: [0, 0, 0], size: [9, 9], n: [2, 3]}]\npoints:");
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/grid.csv", folder);
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_grid *grid = NULL;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_grid_free(grid);
        grid = NULL;
        shortage_begin(i);
        luxel_status status = luxel_find_grid(scene, NULL, 0, NULL, &grid);
        shortage_end();
        assert_true(status == LUXEL_OK || (shortage_met() && status == LUXEL_ERROR_MEMORY && !grid));
    }
    assert_int_equal(grid->measured, 6);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        shortage_begin(i);
        luxel_status status = luxel_grids_write((const luxel_grid *const *)&grid, 1, path, NULL);
        shortage_end();
        assert_true(status == LUXEL_OK || shortage_met());
        assert_int_equal(unlink(path), status == LUXEL_OK ? 0 : -1);
    }
    luxel_grid_free(grid);
    assert_int_equal(rmdir(folder), 0);
    luxel_scene_free(scene);
    free(text);
}

/* The text of a variant. */
static void writing_variants(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        char *text = NULL;
        shortage_begin(i);
        luxel_status status = luxel_variant_text(5, NULL, &text);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        assert_int_equal(text == NULL, shortage_met());
        luxel_text_free(text);
    }
}

/* A right answer, and one that is explained by a pair of slips only after everything else was tried. */
static void judging_answers(void **state)
{
    (void)state;
    static const double answers[] = {2.7275906525546927, 0.2339910};
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    for (size_t k = 0; k < 2; k++) {
        for (long i = 0; i == 0 || shortage_met(); i += k == 0 || i < 200 ? 1 : 97) {
            luxel_judgement *judgement = NULL;
            shortage_begin(i);
            luxel_status status = luxel_judge_answer(scene, NULL, 0, 0, answers[k], 1e-3, 0, NULL, &judgement);
            shortage_end();
            assert_true(status == LUXEL_OK || (shortage_met() && status == LUXEL_ERROR_MEMORY));
            assert_true(status == LUXEL_OK || judgement == NULL);
            if (judgement)
                assert_int_equal(judgement->verdict, k == 0 ? LUXEL_ANSWER_RIGHT : LUXEL_ANSWER_CONVENTION);
            luxel_judgement_free(judgement);
        }
    }
    luxel_scene_free(scene);
}

/* Advice with its hints, each of which is tried on copies. */
static void advising_on_the_peak(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "surfaces[0].material.specular=0.02", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i += i < 300 ? 1 : 31) {
        luxel_diagnostics_clear(diagnostics);
        shortage_begin(i);
        luxel_status status = luxel_scene_advise(scene, diagnostics);
        if (status == LUXEL_OK)
            status = luxel_scene_advise_peak(scene, diagnostics);
        shortage_end();
        assert_true(status == LUXEL_OK || (shortage_met() && status == LUXEL_ERROR_MEMORY));
        assert_true(shortage_met() || luxel_diagnostics_count(diagnostics) == 3);
    }
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

static void finding_extrema(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    luxel_field *field;
    luxel_evaluator *evaluator;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_extrema extrema = {.maximum = {.value = -1}};
        shortage_begin(i);
        luxel_status status = luxel_find_extrema(evaluator, field, NULL, NULL, &extrema);
        shortage_end();
        assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        assert_true(shortage_met() ? extrema.maximum.value == -1 : extrema.maximum.exists);
    }
    luxel_evaluator_free(evaluator);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Where a file itself is short of memory the others are written; else none is. */
static void rendering_to_files(void **state)
{
    (void)state;
    char folder[] = "/tmp/luxel-shortage-XXXXXX", paths[5][64];
    static const char *const endings[] = {".png", ".npy", ".pfm", ".csv", ".exr"};
    const char *names[5];
    luxel_scene *scene = NULL;
    luxel_settings settings;
    assert_non_null(mkdtemp(folder));
    for (size_t i = 0; i < 5; i++) {
        snprintf(paths[i], sizeof paths[i], "%s/a%s", folder, endings[i]);
        names[i] = paths[i];
    }
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_statistics statistics = {.mean = -1};
        shortage_begin(i);
        luxel_status status = luxel_render_files(scene, &settings, names, 5, NULL, NULL, &statistics);
        shortage_end();
        size_t written = 0;
        for (size_t k = 0; k < 5; k++)
            written += unlink(paths[k]) == 0;
        assert_true(status == LUXEL_OK || (shortage_met() && status == LUXEL_ERROR_MEMORY));
        const bool is_computed = statistics.mean != -1;
        assert_int_equal(written, status == LUXEL_OK ? 5 : is_computed ? 4 : 0);
    }
    assert_int_equal(rmdir(folder), 0);
    luxel_scene_free(scene);
}

/* A picture that is shaded by panels, under a lamp with a highlight. */
static void rendering_in_panels(void **state)
{
    (void)state;
    luxel_scene *scene;
    luxel_settings settings;
    assert_int_equal(load("luxel: 1\n"
                          "screen: {width: 200, height: 50, resolution: [256, 64]}\n"
                          "observer: {z: 3000}\n"
                          "surfaces: [{type: sphere, center: [0, 0, 500], radius: 400}]\n"
                          "lights:\n"
                          "  - {type: point, position: [900, 300, 1700], intensity: 2}\n"
                          "  - {type: planar, radiance: 8, disk: {center: [0, 600, 1900], radius: 100}}\n",
                          NULL, &scene),
                     LUXEL_OK);
    luxel_settings_init(&settings);
    settings.threads = 1;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_field *field = NULL;
        shortage_begin(i);
        luxel_status status = luxel_render(scene, &settings, NULL, &field);
        shortage_end();
        assert_true(shortage_met() ? status == LUXEL_ERROR_MEMORY : status == LUXEL_OK && field != NULL);
        luxel_field_free(field);
    }
    luxel_scene_free(scene);
}

/* Points that are clustered, by a law and a pattern, with another surface in the way. */
static void clustering(void **state)
{
    (void)state;
    luxel_scene *scene;
    luxel_settings settings;
    char *text =
        changed("lights:\n", "  - {type: sphere, center: [100, 100, 1400], radius: 40}\nlights:\n"
                             "  - {type: planar, disk: {center: [0, 0, 2500], radius: 90}, power: 3, parts: 20}\n"
                             "  - {type: volume, box: {center: [500, 0, 2500], size: [90, 90, 90]}, power: 3, "
                             "attenuation: none, parts: 9}\n");
    assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
    luxel_settings_init(&settings);
    settings.light_error = 0.05;
    settings.threads = 1;
    settings.stride = 40;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        luxel_field *field = NULL;
        shortage_begin(i);
        luxel_status status = luxel_render(scene, &settings, NULL, &field);
        shortage_end();
        assert_true(status == LUXEL_OK ? field != NULL : shortage_met() && status == LUXEL_ERROR_MEMORY);
        luxel_field_free(field);
    }
    luxel_scene_free(scene);
    free(text);
}

/* Either kind of luminaire file, with texts that go on, lamps and factors for tilt. */
static void reading_luminaires(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "IESNA95\n[TEST] 1\n[MORE] 2\nTILT=INCLUDE\n1 2 0 90 1 .9\n2 1000 1 3 3 1 2 .1 .2 0 1 1 10\n"
        "0 45 90\n0 45 90\n1 2 3 4 5 6 7 8 9 10\n",
        "a\n1\n3\n4\n0\n2\n0\n\nb\n\n\n\n9\n9\n9\n9\n0\n1\n1\n1\n1\n90\n80\n1\n0\n1\n1\nLED\n1000\n\n\n10\n"
        "0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n90\n180\n270\n0\n90\n1\n2\n3\n4\n5\n6\n"};
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++)
        for (long i = 0; i == 0 || shortage_met(); i++) {
            luxel_photometry *photometry = NULL;
            shortage_begin(i);
            luxel_status status = luxel_photometry_read_bytes(texts[k], strlen(texts[k]), "a", NULL, &photometry);
            shortage_end();
            assert_int_equal(status, shortage_met() ? LUXEL_ERROR_MEMORY : LUXEL_OK);
            luxel_photometry_free(photometry);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clustering),
        cmocka_unit_test(rendering_in_panels),
        cmocka_unit_test(reading_luminaires),
        cmocka_unit_test(loading),
        cmocka_unit_test(loading_lights_of_some_size),
        cmocka_unit_test(setting),
        cmocka_unit_test(copying_and_writing),
        cmocka_unit_test(changing_elements),
        cmocka_unit_test(getting),
        cmocka_unit_test(reporting),
        cmocka_unit_test(advising),
        cmocka_unit_test(listing_parameters),
        cmocka_unit_test(telling_of_lights),
        cmocka_unit_test(writing_the_schema),
        cmocka_unit_test(measuring),
        cmocka_unit_test(finding_extrema),
        cmocka_unit_test(rendering_to_files),
        cmocka_unit_test(writing_variants),
        cmocka_unit_test(judging_answers),
        cmocka_unit_test(advising_on_the_peak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
