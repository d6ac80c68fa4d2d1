/* SPDX-License-Identifier: MIT */
/*
 * Groups of lights, which settings name: pictures, probes, evaluators, grids, texts and what is carried are, byte for
 * byte, those of the scene with these lights enabled and all others not; groups that have each light once add up to
 * the whole; what surfaces reflect is kept for the group that it was found for; wrong groups are refused.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

enum { MOST_LIGHTS = 16, WORDS = 64 };

static const char room[] = "luxel: 1\nreflections: all\nscreen: {width: 3000, height: 3000, resolution: [8, 8]}\n"
                           "observer: {z: 9000, projection: perspective}\n"
                           "surfaces: [{type: room, center: [0, 0, 2000], size: [4000, 4000, 4000],"
                           " material: {model: lambert, diffuse: 0.5, over_pi: true}}]\n"
                           "lights: [{type: point, position: [500, 0, 2000], intensity: 10},"
                           " {type: point, position: [-900, 300, 1500], intensity: 20},"
                           " {type: point, enabled: false, attenuation: none, position: [0, 0, 900], intensity: 1}]\n";

/* A group as settings name it and as a scene of its own. */
struct pair {
    luxel_scene *whole, *truth;
    luxel_settings settings, plain;
};

static void begin(struct pair *pair, const char *name, const char *resolution, const size_t *group, size_t count)
{
    char words[MOST_LIGHTS + 1][WORDS];
    const char *changes[MOST_LIGHTS + 1] = {resolution};
    pair->whole = opened_with(name, changes, 1);
    const size_t lights = luxel_scene_light_count(pair->whole);
    assert_in_range(lights, 1, MOST_LIGHTS);
    for (size_t i = 0; i < lights; i++) {
        bool is_on = false;
        for (size_t k = 0; k < count; k++)
            is_on = is_on || group[k] == i;
        snprintf(words[i], WORDS, "lights[%zu].enabled=%s", i, is_on ? "true" : "false");
        changes[i + 1] = words[i];
    }
    pair->truth = opened_with(name, changes, lights + 1);
    luxel_settings_init(&pair->plain);
    pair->settings = pair->plain;
    pair->settings.lights = group;
    pair->settings.light_count = count;
}

static void end(struct pair *pair)
{
    luxel_scene_free(pair->whole);
    luxel_scene_free(pair->truth);
}

static luxel_field *render(const luxel_scene *scene, const luxel_settings *settings)
{
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, settings, NULL, &field), LUXEL_OK);
    return field;
}

static void expect_same_picture(const luxel_field *field, const luxel_field *truth)
{
    const unsigned columns = luxel_field_columns(truth), rows = luxel_field_rows(truth);
    assert_memory_equal(luxel_field_mask(field), luxel_field_mask(truth), (size_t)columns * rows);
    for (unsigned row = 0; row < rows; row++)
        for (unsigned column = 0; column < columns; column++)
            if (luxel_field_value(field, column, row) != luxel_field_value(truth, column, row))
                fail_msg("pixel %u, %u: %.17g, not %.17g", column, row, luxel_field_value(field, column, row),
                         luxel_field_value(truth, column, row));
    assert_string_equal(luxel_field_unit(field), luxel_field_unit(truth));
    const luxel_extremum *reached = &luxel_field_statistics(field)->minimum_reached;
    const luxel_extremum *least = &luxel_field_statistics(truth)->minimum_reached;
    assert_int_equal(reached->exists, least->exists);
    assert_true(!least->exists || reached->value == least->value);
}

/* The scene that a picture carries is that of its group. */
static void expect_carried(const struct pair *pair, const luxel_field *field, const luxel_field *truth)
{
    luxel_scene *carried = NULL;
    assert_int_equal(load(luxel_field_scene(field), NULL, &carried), LUXEL_OK);
    for (size_t i = 0; i < luxel_scene_light_count(carried); i++)
        assert_int_equal(luxel_scene_light_enabled(carried, i), luxel_scene_light_enabled(pair->truth, i));
    luxel_field *again = render(carried, &pair->plain);
    expect_same_picture(again, truth);
    luxel_field_free(again);
    luxel_scene_free(carried);
}

static void expect_pictures(const char *name, const char *resolution, const size_t *group, size_t count)
{
    struct pair pair;
    begin(&pair, name, resolution, group, count);
    for (int k = 0; k < 2; k++) {
        pair.settings.minimum_reached = pair.plain.minimum_reached = k == 0;
        pair.settings.precision = pair.plain.precision = k == 0 ? LUXEL_SINGLE : LUXEL_DOUBLE;
        luxel_field *field = render(pair.whole, &pair.settings), *truth = render(pair.truth, &pair.plain);
        expect_same_picture(field, truth);
        if (k == 0 && count > 0)
            expect_carried(&pair, field, truth);
        luxel_field_free(field);
        luxel_field_free(truth);
    }
    end(&pair);
}

static void pictures_are_those_of_the_lights_alone(void **state)
{
    (void)state;
    static const size_t groups[][2] = {{0, 0}, {1, 1}, {2, 0}};
    for (size_t i = 0; i < 3; i++) {
        expect_pictures("three-lights", "screen.resolution=[90,72]", groups[i], 2); /* named twice is named once */
        expect_pictures("all-sources", "screen.resolution=[40,40]", groups[i], 2);
    }
    expect_pictures("three-lights", "screen.resolution=[40,32]", groups[0], 0); /* all is dark */
}

/* A light that is not enabled shines in its group. */
static void takes_what_is_turned_off(void **state)
{
    (void)state;
    static const size_t second[] = {1};
    static const char *const changes[] = {"lights[1].enabled=false", "screen.resolution=[40,32]"};
    static const char *const alone[] = {"lights[0].enabled=false", "lights[2].enabled=false",
                                        "screen.resolution=[40,32]"};
    luxel_scene *scene = opened_with("three-lights", changes, 2), *truth = opened_with("three-lights", alone, 3);
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.lights = second;
    settings.light_count = 1;
    luxel_field *field = render(scene, &settings), *expected = render(truth, NULL);
    expect_same_picture(field, expected);
    assert_true(luxel_field_statistics(field)->maximum.value > 0);
    luxel_field_free(field);
    luxel_field_free(expected);
    luxel_scene_free(scene);
    luxel_scene_free(truth);
}

/* `bound`: of each picture, relative to its maximum. */
static void expect_sum(const char *name, double bound)
{
    static const char *const changes[] = {"screen.width=900", "screen.height=900", "screen.resolution=[60,60]"};
    luxel_scene *scene = opened_with(name, changes, 3);
    const size_t lights = luxel_scene_light_count(scene);
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.precision = LUXEL_DOUBLE;
    luxel_field *whole = render(scene, &settings);
    const unsigned columns = luxel_field_columns(whole), rows = luxel_field_rows(whole);
    double *sums = calloc((size_t)columns * rows, sizeof *sums);
    double bounds = 0;
    assert_non_null(sums);
    for (size_t i = 0; i < lights; i++) {
        settings.lights = &i;
        settings.light_count = 1;
        luxel_field *part = render(scene, &settings);
        for (unsigned pixel = 0; pixel < columns * rows; pixel++)
            sums[pixel] += luxel_field_value(part, pixel % columns, pixel / columns);
        bounds += luxel_field_statistics(part)->maximum.value;
        luxel_field_free(part);
    }
    bounds += luxel_field_statistics(whole)->maximum.value;
    for (unsigned pixel = 0; pixel < columns * rows; pixel++)
        assert_true(fabs(sums[pixel] - luxel_field_value(whole, pixel % columns, pixel / columns)) <= bound * bounds);
    free(sums);
    luxel_field_free(whole);
    luxel_scene_free(scene);
}

static void groups_add_up(void **state)
{
    (void)state;
    expect_sum("three-lights", 1e-11);
    expect_sum("all-sources", 1e-3); /* highlights of extended sources are no more exact than that in pictures */
}

/* Exact values add up within their bounds, and the shares of a group are those of its lights. */
static void probes_add_up(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("all-sources");
    const size_t lights = luxel_scene_light_count(scene);
    luxel_probe *whole = NULL, *part = NULL;
    double sum = 0, error = 0;
    assert_int_equal(luxel_probe_screen(scene, NULL, 10, 20, NULL, &whole), LUXEL_OK);
    assert_true(whole->has_value && whole->share_count == lights);
    for (size_t i = 0; i < lights; i++) {
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.lights = &i;
        settings.light_count = 1;
        assert_int_equal(luxel_probe_screen(scene, &settings, 10, 20, NULL, &part), LUXEL_OK);
        assert_int_equal(part->share_count, 1);
        assert_int_equal(part->shares[0].light, i);
        assert_true(part->shares[0].irradiance == whole->shares[i].irradiance);
        sum += part->value;
        error += part->error;
        luxel_probe_free(part);
    }
    assert_true(whole->value > 0 && fabs(sum - whole->value) <= error + whole->error);
    luxel_probe_free(whole);
    luxel_scene_free(scene);
}

/* An evaluator needs the list no longer than it takes to make it; sections and extrema are those of the group. */
static void evaluators_keep_their_group(void **state)
{
    (void)state;
    static const size_t group[] = {2};
    struct pair pair;
    begin(&pair, "three-lights", "screen.resolution=[60,48]", group, 1);
    size_t *list = malloc(sizeof *list);
    luxel_evaluator *evaluator = NULL, *truth = NULL;
    assert_non_null(list);
    *list = group[0];
    pair.settings.lights = list;
    assert_int_equal(luxel_evaluator_new(pair.whole, &pair.settings, NULL, &evaluator), LUXEL_OK);
    free(list);
    pair.settings.lights = group;
    assert_int_equal(luxel_evaluator_new(pair.truth, NULL, NULL, &truth), LUXEL_OK);
    for (double x_mm = -200; x_mm <= 200; x_mm += 37) {
        double shares[MOST_LIGHTS], expected[MOST_LIGHTS];
        luxel_value value;
        luxel_evaluate_screen(evaluator, x_mm, 11, &value, shares);
        luxel_value wanted;
        luxel_evaluate_screen(truth, x_mm, 11, &wanted, expected);
        assert_true(value.has_value == wanted.has_value && value.value == wanted.value);
        for (size_t i = 0; i < luxel_scene_light_count(pair.whole); i++)
            assert_true(shares[i] == expected[i]);
    }
    luxel_field *field = render(pair.whole, &pair.settings);
    luxel_extrema extrema, wanted;
    assert_int_equal(luxel_find_extrema(evaluator, field, NULL, NULL, &extrema), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(truth, field, NULL, NULL, &wanted), LUXEL_OK);
    assert_true(extrema.maximum.exists && extrema.maximum.value == wanted.maximum.value);
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_evaluator_free(truth);
    end(&pair);
}

static void grids_and_texts_tell_of_the_group(void **state)
{
    (void)state;
    static const size_t group[] = {0};
    const luxel_language language = {.code = NULL};
    luxel_grid *grid = NULL, *expected = NULL;
    luxel_document *document = NULL, *wanted = NULL;
    struct pair pair;
    begin(&pair, "room", "screen.resolution=[12,8]", group, 1);
    const char *const plane = "grids=[{name: desk, center: [0, 900, 1500], size: [400, 300], axis: [0, 1, 0], "
                              "up: [0, 0, -1], n: [3, 2]}]";
    assert_int_equal(luxel_scene_set(pair.whole, plane, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_set(pair.truth, plane, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(pair.whole, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(pair.truth, NULL), LUXEL_OK);
    assert_int_equal(luxel_find_grid(pair.whole, &pair.settings, 0, NULL, &grid), LUXEL_OK);
    assert_int_equal(luxel_find_grid(pair.truth, NULL, 0, NULL, &expected), LUXEL_OK);
    for (size_t i = 0; i < 6; i++)
        assert_true(grid->values[i] == expected->values[i]);
    assert_true(grid->average.value > 0 && grid->flux.value == expected->flux.value);
    assert_int_equal(luxel_explain(pair.whole, &pair.settings, 0, -500, &language, NULL, &document), LUXEL_OK);
    assert_int_equal(luxel_explain(pair.truth, NULL, 0, -500, &language, NULL, &wanted), LUXEL_OK);
    char *text = luxel_document_write_text(document, LUXEL_DOCUMENT_TEXT);
    char *truth = luxel_document_write_text(wanted, LUXEL_DOCUMENT_TEXT);
    assert_string_equal(text, truth);
    luxel_text_free(text);
    luxel_text_free(truth);
    luxel_document_free(document);
    luxel_document_free(wanted);
    luxel_grid_free(grid);
    luxel_grid_free(expected);
    end(&pair);
}

/* What was found for one group is not taken for another one's. */
static void reflections_are_of_the_group(void **state)
{
    (void)state;
    static const size_t groups[][1] = {{0}, {1}};
    luxel_scene *scene = opened_with(room, NULL, 0);
    luxel_settings settings;
    luxel_probe *probe = NULL;
    double values[2][2];
    luxel_settings_init(&settings);
    settings.reflected_error = 0.02;
    for (int turn = 0; turn < 2; turn++)
        for (int i = 0; i < 2; i++) {
            settings.lights = groups[i];
            settings.light_count = 1;
            luxel_field *field = render(scene, &settings);
            values[turn][i] = luxel_field_statistics(field)->maximum.value;
            luxel_field_free(field);
        }
    assert_true(values[0][0] == values[1][0] && values[0][1] == values[1][1] && values[0][0] != values[0][1]);
    settings.lights = groups[1];
    assert_int_equal(luxel_probe_screen(scene, &settings, 0, -500, NULL, &probe), LUXEL_OK);
    assert_true(probe->has_reflected && probe->reflected_irradiance > 0);
    luxel_probe_free(probe);
    luxel_scene_free(scene);
}

static void expect_refused(luxel_scene *scene, size_t light, const char *id, const char *part)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    settings.lights = &light;
    settings.light_count = 1;
    assert_int_equal(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT);
    assert_null(field);
    expect_entry(diagnostics, 0, WANTED(.id = id, .message = part));
    luxel_diagnostics_free(diagnostics);
}

static void glare_is_of_the_group(void **state)
{
    (void)state;
    static const size_t group[] = {3, 4}; /* the last luminaire, and the light of the walls */
    const luxel_glare_sight sight = {.eye_mm = {0, 1200, 5300}, .view = {0, 0, -1}};
    struct pair pair;
    luxel_glare *found, *truth;
    begin(&pair, "office", "screen.resolution=[600, 400]", group, 2);
    assert_int_equal(luxel_find_glare(pair.whole, &pair.settings, &sight, NULL, &found), LUXEL_OK);
    assert_int_equal(luxel_find_glare(pair.truth, &pair.plain, &sight, NULL, &truth), LUXEL_OK);
    assert_true(truth->has_rating && found->has_rating);
    assert_true(found->rating.value == truth->rating.value && found->background.value == truth->background.value);
    assert_int_equal(found->source_count, 2);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(found->sources[i].light, group[i]);
        assert_true(found->sources[i].share == truth->sources[i].share);
    }
    luxel_glare_free(found);
    luxel_glare_free(truth);
    end(&pair);
}

static void refuses_wrong_groups(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("three-lights"), *walls = opened_with(room, NULL, 0);
    expect_refused(scene, 3, "no-such-light", "lights[3], but the scene has 3");
    expect_refused(walls, 2, "reflects-by-law", "lights[2].attenuation is none");
    luxel_scene_free(scene);
    luxel_scene_free(walls);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_those_of_the_lights_alone),
        cmocka_unit_test(takes_what_is_turned_off),
        cmocka_unit_test(groups_add_up),
        cmocka_unit_test(probes_add_up),
        cmocka_unit_test(evaluators_keep_their_group),
        cmocka_unit_test(grids_and_texts_tell_of_the_group),
        cmocka_unit_test(reflections_are_of_the_group),
        cmocka_unit_test(glare_is_of_the_group),
        cmocka_unit_test(refuses_wrong_groups),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
