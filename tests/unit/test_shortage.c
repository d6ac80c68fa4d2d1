/* SPDX-License-Identifier: MIT */
/*
 * Memory that runs out: every allocation of the library fails once, and each time the call ends with
 * LUXEL_ERROR_MEMORY or does without, changes nothing and loses nothing.  The linker puts the functions below in
 * the place of malloc() and its kin (see meson.build).
 */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);

static bool armed;
static long countdown;
static bool failed;

static bool runs_out(void)
{
    if (!armed || countdown-- > 0)
        return false;
    armed = false;
    failed = true;
    return true;
}

void *__wrap_malloc(size_t size)
{
    return runs_out() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return runs_out() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *memory, size_t size)
{
    return runs_out() ? NULL : __real_realloc(memory, size);
}

static void arm(long number)
{
    countdown = number;
    failed = false;
    armed = true;
}

static void loading(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || failed; i++) {
        luxel_scene *scene = NULL;
        arm(i);
        luxel_status status = load(good_scene, NULL, &scene);
        armed = false;
        assert_int_equal(status, failed ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        luxel_scene_free(scene);
    }
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
        arm(i);
        luxel_status status = luxel_scene_set(scene, "surfaces[0].material.specular=0.25", NULL);
        armed = false;
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
    for (long i = 0; i == 0 || failed; i++) {
        arm(i);
        luxel_scene *copy = luxel_scene_copy(scene);
        armed = false;
        assert_true((copy == NULL) == failed);
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
        for (long i = 0; i == 0 || failed; i++) {
            char *text = NULL;
            arm(i);
            luxel_status status = luxel_scene_write_text(scene, &text);
            armed = false;
            assert_int_equal(status, failed ? LUXEL_ERROR_MEMORY : LUXEL_OK);
            luxel_text_free(text);
        }
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
    for (long i = 0; i == 0 || failed; i++) {
        luxel_scene *scene = NULL;
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        arm(i);
        luxel_status status = load(text, diagnostics, &scene);
        armed = false;
        assert_true(status == LUXEL_ERROR_SCENE || (failed && status == LUXEL_ERROR_MEMORY));
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
    for (long i = 0; i == 0 || failed; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        arm(i);
        luxel_status status = luxel_scene_advise(scene, diagnostics);
        armed = false;
        assert_true(status == LUXEL_OK || (failed && status == LUXEL_ERROR_MEMORY));
        luxel_diagnostics_free(diagnostics);
    }
    luxel_scene_free(scene);
    free(low);
}

static void listing_parameters(void **state)
{
    (void)state;
    for (long i = 0; i == 0 || failed; i++) {
        arm(i);
        luxel_parameters *parameters = luxel_parameters_new();
        armed = false;
        assert_true((parameters == NULL) == failed);
        luxel_parameters_free(parameters);
    }
}

static void writing_the_schema(void **state)
{
    (void)state;
    char *whole = NULL;
    assert_int_equal(luxel_scene_schema(&whole), LUXEL_OK);
    for (long i = 0; i == 0 || failed; i++) {
        char *text = NULL;
        arm(i);
        luxel_status status = luxel_scene_schema(&text);
        armed = false;
        assert_int_equal(status, failed ? LUXEL_ERROR_MEMORY : LUXEL_OK);
        if (text)
            assert_string_equal(text, whole);
        luxel_text_free(text);
    }
    luxel_text_free(whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(loading),
        cmocka_unit_test(setting),
        cmocka_unit_test(copying_and_writing),
        cmocka_unit_test(reporting),
        cmocka_unit_test(advising),
        cmocka_unit_test(listing_parameters),
        cmocka_unit_test(writing_the_schema),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
