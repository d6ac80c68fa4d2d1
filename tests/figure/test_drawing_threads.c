/* SPDX-License-Identifier: MIT */
/*
 * Drawing in several threads at once, each on a context of its own: a bar, a profile and a histogram, which all share,
 * look as they do alone, while another thread evaluates the scene that they are of.  And figures and reports of one
 * scene, written by several threads at once: each file has the bytes that it has alone.
 */
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>
#include <luxel/drawing.h>
#include <luxel/figure.h>
#include <luxel/luxel.h>

#include "take_file.h"

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
    const luxel_color_bar bar = {.low = 0, .high = 10, .label = "brightness"};
    luxel_draw_color_bar(cairo, &style, &bar, WIDTH, HEIGHT);
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
    luxel_value first, again;
    luxel_evaluate_screen(shared->evaluator, 10, 20, &first, NULL);
    void *changed = NULL;
    while (!atomic_load(&shared->done)) {
        luxel_evaluate_screen(shared->evaluator, 10, 20, &again, NULL);
        if (again.value != first.value)
            changed = shared;
    }
    return changed;
}

static void test_threads(void **state)
{
    (void)state;
    const luxel_profile_path path = {.from_mm = {-200, 0}, .to_mm = {200, 0}, .samples = 50};
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
    assert_int_equal(luxel_field_histogram(field, NULL, LUXEL_HISTOGRAM_LINEAR, (double)NAN, (double)NAN, 20, NULL,
                                           &shared.histogram),
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

/* -- files -- */

static const char *const names[] = {"f.png", "f.svg", "f.pdf", "r.md", "r.html", "r.pdf"};
enum { NAMES = sizeof names / sizeof *names };

struct written {
    char *bytes[NAMES];
    size_t lengths[NAMES];
};

struct writer {
    const luxel_scene *scene;
    char folder[32];
    struct written written;
    bool fails;
    pthread_t thread;
};

/* Takes the numbers away that Cairo gives images and surfaces in SVG: they go on from one drawing to the next. */
static size_t drop_numbers(char *bytes, size_t length)
{
    static const char *const words[] = {"image", "surface"};
    size_t kept = 0;
    for (size_t i = 0; i < length; i++) {
        bytes[kept++] = bytes[i];
        for (int w = 0; w < 2; w++) {
            const size_t word = strlen(words[w]);
            if (kept >= word && memcmp(bytes + kept - word, words[w], word) == 0)
                while (i + 1 < length && bytes[i + 1] >= '0' && bytes[i + 1] <= '9')
                    i++;
        }
    }
    return kept;
}

/* Assertions are for the main thread alone. */
static void *write_all(void *argument)
{
    struct writer *writer = argument;
    for (int i = 0; i < NAMES; i++) {
        char path[64];
        snprintf(path, sizeof path, "%s/%s", writer->folder, names[i]);
        luxel_status status = names[i][0] == 'f' ? luxel_figure_write(writer->scene, NULL, NULL, path, NULL)
                                                 : luxel_report_write(writer->scene, NULL, NULL, path, NULL);
        writer->written.bytes[i] = status == LUXEL_OK ? take_file(path, &writer->written.lengths[i]) : NULL;
        writer->fails |= !writer->written.bytes[i];
        if (writer->written.bytes[i] && !strstr(names[i], ".p"))
            writer->written.lengths[i] = drop_numbers(writer->written.bytes[i], writer->written.lengths[i]);
    }
    return NULL;
}

static void open_writer(const luxel_scene *scene, struct writer *writer)
{
    *writer = (struct writer){.scene = scene, .folder = "/tmp/luxel-writers-XXXXXX"};
    assert_non_null(mkdtemp(writer->folder));
}

static void close_writer(struct writer *writer)
{
    for (int i = 0; i < NAMES; i++)
        free(writer->written.bytes[i]);
    assert_int_equal(rmdir(writer->folder), 0); /* nothing is left over */
}

static void test_files(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    struct writer alone, writers[THREADS];
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "screen.resolution=[90,90]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    open_writer(scene, &alone);
    write_all(&alone);
    assert_false(alone.fails);
    for (int i = 0; i < THREADS; i++) {
        open_writer(scene, &writers[i]);
        assert_int_equal(pthread_create(&writers[i].thread, NULL, write_all, &writers[i]), 0);
    }
    for (int i = 0; i < THREADS; i++)
        pthread_join(writers[i].thread, NULL);
    for (int i = 0; i < THREADS; i++) {
        assert_false(writers[i].fails);
        for (int k = 0; k < NAMES; k++) {
            assert_int_equal(writers[i].written.lengths[k], alone.written.lengths[k]);
            assert_memory_equal(writers[i].written.bytes[k], alone.written.bytes[k], alone.written.lengths[k]);
        }
        close_writer(&writers[i]);
    }
    close_writer(&alone);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_threads), cmocka_unit_test(test_files)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
