/* SPDX-License-Identifier: MIT */
/*
 * Drawing in several threads at once, each on a context of its own: a bar, a profile and a histogram, which all share,
 * look as they do alone, while another thread evaluates the scene that they are of.
 */
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>
#include <luxel/drawing.h>
#include <luxel/luxel.h>

enum { THREADS = 4, ROUNDS = 3, WIDTH = 300, HEIGHT = 200 };

struct shared {
    luxel_evaluator *evaluator;
    luxel_profile *profile;
    luxel_histogram *histogram;
    cairo_surface_t *alone; /* how it looks */
    atomic_bool done;
};

struct painter {
    const struct shared *shared;
    bool differs;
    pthread_t thread;
};

static cairo_surface_t *draw(const struct shared *shared)
{
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, 3 * HEIGHT);
    cairo_t *cairo = cairo_create(image);
    luxel_drawing_style style;
    luxel_drawing_style_init(&style, false);
    const luxel_bar bar = {.low = 0, .high = 10, .label = "brightness"};
    luxel_draw_bar(cairo, &style, &bar, WIDTH, HEIGHT);
    cairo_translate(cairo, 0, HEIGHT);
    luxel_draw_profile(cairo, &style, shared->profile, NULL, WIDTH, HEIGHT);
    cairo_translate(cairo, 0, HEIGHT);
    luxel_draw_histogram(cairo, &style, shared->histogram, &bar, "value", "pixels", WIDTH, HEIGHT);
    cairo_destroy(cairo);
    cairo_surface_flush(image);
    return image;
}

static size_t bytes_of(cairo_surface_t *image)
{
    return (size_t)cairo_image_surface_get_stride(image) * 3 * HEIGHT;
}

static void *paint(void *argument)
{
    struct painter *painter = argument;
    for (int i = 0; i < ROUNDS; i++) {
        cairo_surface_t *image = draw(painter->shared), *alone = painter->shared->alone;
        painter->differs |=
            memcmp(cairo_image_surface_get_data(image), cairo_image_surface_get_data(alone), bytes_of(image)) != 0;
        cairo_surface_destroy(image);
    }
    return NULL;
}

/* Until the others are done; NULL, or something where a value changed. */
static void *evaluate(void *argument)
{
    struct shared *shared = argument;
    const double first = luxel_evaluate(shared->evaluator, 10, 20, NULL).value;
    void *changed = NULL;
    while (!atomic_load(&shared->done))
        if (luxel_evaluate(shared->evaluator, 10, 20, NULL).value != first)
            changed = shared;
    return changed;
}

static void test_threads(void **state)
{
    (void)state;
    const luxel_path path = {.from_mm = {-200, 0}, .to_mm = {200, 0}, .samples = 50};
    struct shared shared = {.evaluator = NULL};
    struct painter painters[THREADS];
    luxel_scene *scene = NULL;
    luxel_field *field = NULL;
    pthread_t evaluating;
    void *changed;
    assert_int_equal(luxel_scene_open_builtin("three-lights", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &shared.evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_profile(shared.evaluator, &path, NULL, &shared.profile), LUXEL_OK);
    assert_int_equal(
        luxel_field_histogram(field, NULL, LUXEL_LINEAR, (double)NAN, (double)NAN, 20, NULL, &shared.histogram),
        LUXEL_OK);
    shared.alone = draw(&shared);
    assert_int_equal(pthread_create(&evaluating, NULL, evaluate, &shared), 0);
    for (int i = 0; i < THREADS; i++) {
        painters[i] = (struct painter){.shared = &shared};
        assert_int_equal(pthread_create(&painters[i].thread, NULL, paint, &painters[i]), 0);
    }
    for (int i = 0; i < THREADS; i++)
        pthread_join(painters[i].thread, NULL);
    atomic_store(&shared.done, true);
    pthread_join(evaluating, &changed);
    for (int i = 0; i < THREADS; i++)
        assert_false(painters[i].differs);
    assert_null(changed);
    cairo_surface_destroy(shared.alone);
    luxel_histogram_free(shared.histogram);
    luxel_profile_free(shared.profile);
    luxel_evaluator_free(shared.evaluator);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_threads)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
