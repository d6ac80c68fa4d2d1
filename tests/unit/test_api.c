/* SPDX-License-Identifier: MIT */
/*
 * The public interface as a program uses it: what render and probe refuse and how they say so, cancelling, the same
 * bytes for any number of threads, separate objects in separate threads, and values beyond the range of numbers.
 */
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <luxel/luxel.h>

static luxel_scene *report_with(const char *const *assignments)
{
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    for (size_t i = 0; assignments && assignments[i]; i++)
        assert_int_equal(luxel_scene_set(scene, assignments[i], NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

#define REPORT_WITH(...) report_with((const char *const[]){__VA_ARGS__, NULL})

static void expect_error(luxel_status found, luxel_status expected, luxel_diagnostics *diagnostics, const char *id)
{
    assert_int_equal(found, expected);
    assert_true(luxel_diagnostics_count(diagnostics) > 0);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    luxel_diagnostics_clear(diagnostics);
}

static void test_refusals(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = report_with(NULL);
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_probe *probe = NULL;

    expect_error(luxel_render(NULL, NULL, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics, "not-committed");
    expect_error(luxel_render(scene, NULL, diagnostics, NULL), LUXEL_ERROR_ARGUMENT, diagnostics, "missing-argument");
    luxel_settings_init(&settings);
    settings.threads = 5000;
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    luxel_settings_init(&settings);
    settings.quantity = (luxel_quantity)7;
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    luxel_settings_init(&settings);
    settings.precision = (luxel_precision)7;
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    luxel_settings_init(&settings);
    settings.light_error = 1;
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    luxel_settings_init(&settings);
    settings.tolerance = nan("");
    expect_error(luxel_probe_screen(scene, &settings, 0, 0, diagnostics, &probe), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "setting-out-of-range");
    luxel_settings_init(&settings);
    settings.reserved[1] = &settings;
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "reserved-not-null");
    luxel_settings_init(&settings);
    settings.instruction_set = "z80";
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "no-instruction-set");
    expect_error(luxel_probe_screen(scene, NULL, HUGE_VAL, 0, diagnostics, &probe), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "bad-place");
    const double place[3] = {0, 0, 0}, zero[3] = {0, 0, 0};
    expect_error(luxel_probe_element(scene, NULL, place, zero, diagnostics, &probe), LUXEL_ERROR_ARGUMENT, diagnostics,
                 "bad-place");

    /* A change takes the readiness away. */
    assert_int_equal(luxel_scene_set(scene, "lights[0].intensity=3", NULL), LUXEL_OK);
    expect_error(luxel_render(scene, NULL, diagnostics, &field), LUXEL_ERROR_ARGUMENT, diagnostics, "not-committed");
    assert_null(field);
    assert_null(probe);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

static void test_range(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_probe *probe = NULL;
    luxel_settings_init(&settings);

    /* Beyond float32: pictures say so, and float64 holds it. */
    luxel_scene *scene = REPORT_WITH("lights[0].intensity=1e300");
    expect_error(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_RANGE, diagnostics,
                 "value-too-large");
    assert_int_equal(luxel_probe_screen(scene, &settings, 0, 0, diagnostics, &probe), LUXEL_OK);
    assert_true(probe->has_value && !probe->has_pixel_value && isfinite(probe->value) && isfinite(probe->error));
    luxel_probe_free(probe);
    settings.precision = LUXEL_DOUBLE;
    assert_int_equal(luxel_render(scene, &settings, diagnostics, &field), LUXEL_OK);
    luxel_field_free(field);
    luxel_scene_free(scene);

    /* Beyond float64: so do probes. */
    scene = REPORT_WITH("lights[0].intensity=1e308", "lights[0].attenuation=inverse-square",
                        "lights[0].position=[0,0,1300.001]");
    expect_error(luxel_probe_screen(scene, &settings, 0, 0, diagnostics, &probe), LUXEL_ERROR_RANGE, diagnostics,
                 "value-too-large");
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* A probe tells the value of its pixel as the picture has it, wherever the pixel stands in its block. */
static void test_pixels(void **state)
{
    (void)state;
    static const char *const names[] = {"report", "three-lights", "desk"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        for (int precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
            luxel_scene *scene = NULL;
            luxel_field *field = NULL;
            luxel_settings settings;
            luxel_settings_init(&settings);
            settings.precision = (luxel_precision)precision;
            assert_int_equal(luxel_scene_open_builtin(names[i], NULL, &scene), LUXEL_OK);
            assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
            assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
            unsigned columns = luxel_field_columns(field), rows = luxel_field_rows(field), seen = 0;
            for (unsigned k = 0; k < 25; k++) {
                unsigned column = (37 * k + 5) % columns, row = (53 * k + 11) % rows;
                luxel_probe *probe = NULL;
                assert_int_equal(luxel_probe_screen(scene, &settings, luxel_field_x_mm(field)[column],
                                                    luxel_field_y_mm(field)[row], NULL, &probe),
                                 LUXEL_OK);
                assert_true(probe->has_pixel && probe->column == column && probe->row == row);
                if (probe->on_surface) {
                    assert_true(probe->has_pixel_value);
                    assert_true(probe->pixel_value == luxel_field_value(field, column, row));
                    seen++;
                }
                luxel_probe_free(probe);
            }
            assert_true(seen > 5);
            luxel_field_free(field);
            luxel_scene_free(scene);
        }
}

/* Borders between pixels, in decimal numbers that are rounded themselves: the pixel is that of the formula
 * in real numbers, where half a pixel between nodes goes away from 0. */
static void test_borders(void **state)
{
    (void)state;
    static const struct {
        const char *screen;
        double x_mm, y_mm;
        unsigned column, row;
    } cases[] = {
        {"screen={width: 100.1, height: 100.1, resolution: [7, 7], sampling: nodes}", -25.025, 25.025, 2, 2},
        {"screen={width: 1.1, height: 1.1, resolution: [11, 11], sampling: nodes}", 0.275, -0.275, 8, 8},
        {"screen={width: 333.3, height: 333.3, resolution: [100, 100], sampling: centers}", 3.333, -3.333, 51, 51},
        {"screen={width: 500, height: 500, resolution: [360, 360], sampling: centers}", -75, 75, 126, 126},
        {"screen={width: 600, height: 600, resolution: [500, 500], sampling: centers}", -248.4, 248.4, 43, 43},
        {"screen={width: 600, height: 600, resolution: [500, 500], sampling: centers}", -248.400001, 248.4, 42, 43},
        {"screen={width: 600, height: 600, resolution: [500, 500], sampling: centers}", 300, -300, 499, 499},
        {"screen={width: 600, height: 600, resolution: [500, 500], sampling: nodes}", 300, -300, 499, 499},
        {"screen={width: 600, height: 600, resolution: [1, 1], sampling: nodes}", 300, -300, 0, 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        luxel_scene *scene = REPORT_WITH(cases[i].screen);
        luxel_probe *probe = NULL;
        assert_int_equal(luxel_probe_screen(scene, NULL, cases[i].x_mm, cases[i].y_mm, NULL, &probe), LUXEL_OK);
        assert_true(probe->has_pixel);
        assert_int_equal(probe->column, cases[i].column);
        assert_int_equal(probe->row, cases[i].row);
        luxel_probe_free(probe);
        luxel_scene_free(scene);
    }
}

/* A tolerance that is asked for is compared with the error; without one closed forms are not judged. */
static void test_tolerance(void **state)
{
    (void)state;
    luxel_scene *scene = report_with(NULL);
    static const struct {
        double tolerance;
        bool reached;
    } cases[] = {{0, true}, {1e-6, true}, {1e-9, true}, {1e-17, false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        luxel_settings settings;
        luxel_probe *probe = NULL;
        luxel_settings_init(&settings);
        settings.tolerance = cases[i].tolerance;
        assert_int_equal(luxel_probe_screen(scene, &settings, 30, 40, NULL, &probe), LUXEL_OK);
        assert_true(probe->error > 1e-17 * probe->value && probe->error < 1e-12 * probe->value);
        assert_int_equal(probe->tolerance_reached, cases[i].reached);
        luxel_probe_free(probe);
    }
    luxel_scene_free(scene);
}

/* Cancels the first time it is asked. */
static bool cancel(double done, void *data)
{
    unsigned *calls = data;
    assert_true(done >= 0 && done <= 1);
    ++*calls;
    return false;
}

static void test_cancel(void **state)
{
    (void)state;
    luxel_scene *scene = REPORT_WITH("screen.resolution=[3000,3000]");
    luxel_settings settings;
    luxel_field *field = NULL;
    unsigned calls = 0;
    luxel_settings_init(&settings);
    settings.progress = cancel;
    settings.progress_data = &calls;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_CANCELLED);
    assert_int_equal(calls, 1);
    assert_null(field);
    luxel_scene_free(scene);
}

/* Renders the scene in all its rows with one thread; compared with other numbers of threads. */
static void *render_alone(void *data)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_scene *scene = luxel_scene_copy(data);
    luxel_settings_init(&settings);
    settings.threads = 1;
    luxel_status status = luxel_render(scene, &settings, NULL, &field);
    luxel_scene_free(scene);
    return status == LUXEL_OK ? field : NULL;
}

static void assert_same_extremum(const luxel_extremum *a, const luxel_extremum *b)
{
    assert_true(a->exists == b->exists && a->value == b->value && a->column == b->column && a->row == b->row &&
                a->x_mm == b->x_mm && a->y_mm == b->y_mm);
}

static void assert_same_field(const luxel_field *a, const luxel_field *b)
{
    const luxel_statistics *of_a = luxel_field_statistics(a), *of_b = luxel_field_statistics(b);
    size_t pixels = (size_t)luxel_field_columns(a) * luxel_field_rows(a);
    assert_memory_equal(luxel_field_single(a), luxel_field_single(b), pixels * sizeof(float));
    assert_memory_equal(luxel_field_mask(a), luxel_field_mask(b), pixels);
    assert_same_extremum(&of_a->maximum, &of_b->maximum);
    assert_same_extremum(&of_a->minimum, &of_b->minimum);
    assert_true(of_a->mean == of_b->mean && of_a->lit == of_b->lit && of_a->surface_pixels == of_b->surface_pixels);
}

static void test_threads(void **state)
{
    (void)state;
    luxel_scene *scene = REPORT_WITH("screen.resolution=[301,301]", "lights[0].position=[900,-300,2100]");
    luxel_field *one = render_alone(scene);
    assert_non_null(one);
    static const unsigned counts[] = {2, 3, 7, 64};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        luxel_settings settings;
        luxel_field *field = NULL;
        luxel_settings_init(&settings);
        settings.threads = counts[i];
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        assert_same_field(one, field);
        luxel_field_free(field);
    }

    /* Copies of the scene, each rendered in a thread of the program's own. */
    pthread_t threads[4];
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, render_alone, scene), 0);
    for (size_t i = 0; i < 4; i++) {
        void *field;
        pthread_join(threads[i], &field);
        assert_non_null(field);
        assert_same_field(one, field);
        luxel_field_free(field);
    }
    luxel_field_free(one);
    luxel_scene_free(scene);
}

/* 51 x 25 faces of a million parts each: refused before room is made for them. */
static void test_too_many_parts(void **state)
{
    (void)state;
    luxel_scene *scene = REPORT_WITH("lights=[{type: volume, sphere: {center: [0, 0, 2000], radius: 10, facets: 51}, "
                                     "power: 1, parts: 1000}]");
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_field *field = NULL;
    luxel_probe *probe = NULL;
    assert_int_equal(luxel_render(scene, NULL, diagnostics, &field), LUXEL_ERROR_MEMORY);
    assert_int_equal(luxel_probe_screen(scene, NULL, 0, 0, diagnostics, &probe), LUXEL_ERROR_MEMORY);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 2);
    for (size_t i = 0; i < 2; i++)
        assert_string_equal(luxel_diagnostics_get(diagnostics, i)->id, "too-many-parts");
    assert_true(!field && !probe);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

static void test_dark(void **state)
{
    (void)state;
    luxel_scene *scene = REPORT_WITH("lights=[]");
    luxel_field *field = NULL;
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    const luxel_statistics *statistics = luxel_field_statistics(field);
    assert_true(statistics->maximum.exists && statistics->maximum.value == 0);
    assert_false(statistics->minimum.exists);
    assert_true(statistics->mean == 0 && statistics->lit == 0);
    size_t pixels = (size_t)luxel_field_columns(field) * luxel_field_rows(field);
    uint8_t *grey = malloc(pixels);
    assert_non_null(grey);
    luxel_field_grey(field, grey);
    for (size_t i = 0; i < pixels; i++)
        assert_int_equal(grey[i], 0);
    free(grey);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_refusals),  cmocka_unit_test(test_pixels),         cmocka_unit_test(test_borders),
        cmocka_unit_test(test_tolerance), cmocka_unit_test(test_range),          cmocka_unit_test(test_cancel),
        cmocka_unit_test(test_threads),   cmocka_unit_test(test_too_many_parts), cmocka_unit_test(test_dark),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
