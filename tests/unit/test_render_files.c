/* SPDX-License-Identifier: MIT */
/*
 * Pictures that go to their files strip by strip: the same bytes and statistics as the whole field gives, in every
 * format; and whatever ends the work, a file stands there whole or not at all.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "files.h"
#include "scenes.h"

static const char *const ENDINGS[] = {".png", ".npy", ".pfm", ".csv", ".exr"};
enum { ENDING_COUNT = 5 };

/* Narrow and high: of several strips by one thread, which holds some four million bytes at a time. */
static const char HIGH[] = "screen={width: 60, height: 3500, resolution: [120, 7000]}";

static luxel_scene *changed_scene(const char *name, const char *const *assignments)
{
    luxel_scene *scene = builtin(name);
    for (size_t i = 0; assignments[i]; i++)
        assert_int_equal(luxel_scene_set(scene, assignments[i], NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static void name_file(const struct files *files, const char *stem, const char *ending, char path[128])
{
    snprintf(path, 128, "%s/%s%s", files->folder, stem, ending);
}

static void assert_same_file(const char *path, const char *other)
{
    size_t length, other_length;
    unsigned char *bytes = file_bytes(path, &length), *other_bytes = file_bytes(other, &other_length);
    if (length != other_length || memcmp(bytes, other_bytes, length) != 0)
        fail_msg("%s differs from %s", path, other);
    free(bytes);
    free(other_bytes);
}

static void assert_same_extremum(const luxel_extremum *a, const luxel_extremum *b)
{
    assert_true(a->exists == b->exists && a->value == b->value && a->column == b->column && a->row == b->row);
    assert_true(a->x_mm == b->x_mm && a->y_mm == b->y_mm);
}

static void assert_same_statistics(const luxel_statistics *a, const luxel_statistics *b)
{
    assert_same_extremum(&a->maximum, &b->maximum);
    assert_same_extremum(&a->minimum, &b->minimum);
    assert_true(a->has_surface == b->has_surface && a->surface_pixels == b->surface_pixels);
    assert_true(a->mean == b->mean && a->lit == b->lit);
}

/* Every format on its own and all at once, against the field's. */
static void compare(const struct files *files, const luxel_scene *scene, const luxel_settings *settings, unsigned bits)
{
    const luxel_field_output how = {.bits = bits};
    char whole[ENDING_COUNT][128], together[ENDING_COUNT][128], alone[128];
    const char *paths[ENDING_COUNT];
    const char *const one = alone;
    luxel_field *field = NULL;
    luxel_statistics statistics;

    assert_int_equal(luxel_render(scene, settings, NULL, &field), LUXEL_OK);
    for (size_t i = 0; i < ENDING_COUNT; i++) {
        name_file(files, "whole", ENDINGS[i], whole[i]);
        name_file(files, "together", ENDINGS[i], together[i]);
        paths[i] = together[i];
        assert_int_equal(luxel_field_write_as(field, whole[i], &how, NULL), LUXEL_OK);
    }
    assert_int_equal(luxel_render_files(scene, settings, paths, ENDING_COUNT, &how, NULL, &statistics), LUXEL_OK);
    assert_same_statistics(&statistics, luxel_field_statistics(field));
    for (size_t i = 0; i < ENDING_COUNT; i++) {
        name_file(files, "alone", ENDINGS[i], alone);
        assert_int_equal(luxel_render_files(scene, settings, &one, 1, &how, NULL, NULL), LUXEL_OK);
        assert_same_file(together[i], whole[i]);
        assert_same_file(alone, whole[i]);
    }
    memset(&statistics, 0, sizeof statistics);
    assert_int_equal(luxel_render_files(scene, settings, NULL, 0, NULL, NULL, &statistics), LUXEL_OK);
    assert_same_statistics(&statistics, luxel_field_statistics(field));
    luxel_field_free(field);
}

static void test_small(void **state)
{
    static const char *const sizes[] = {"screen={width: 500, height: 500, resolution: [1, 1]}",
                                        "screen={width: 500, height: 5, resolution: [100, 1]}",
                                        "screen={width: 5, height: 500, resolution: [1, 100]}",
                                        "screen={width: 500, height: 350, resolution: [130, 91], sampling: nodes}"};
    static const char *const ranges[] = {"picture.range=max", "picture.range=minmax", "picture.range=log",
                                         "picture.range=[0.5, 9]"};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (unsigned k = (unsigned)i; k < 8; k += 4) {
            luxel_scene *scene = changed_scene("two-spheres", (const char *const[]){sizes[i], ranges[k % 4], NULL});
            luxel_settings settings;
            luxel_settings_init(&settings);
            settings.precision = k < 4 ? LUXEL_SINGLE : LUXEL_DOUBLE;
            settings.quantity = k % 2 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
            settings.stride = 1 + k % 3;
            compare(*state, scene, &settings, k < 4 ? 8 : 16);
            luxel_scene_free(scene);
        }
}

/* Several strips; grey levels that wait for all of them need more, and are below. */
static void test_strips(void **state)
{
    static const char *const names[] = {"report", "three-lights", "window"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        luxel_scene *scene = changed_scene(names[i], (const char *const[]){HIGH, "picture.range=[0, 9]", NULL});
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.threads = 1;
        settings.precision = i == 0 ? LUXEL_SINGLE : LUXEL_DOUBLE;
        settings.quantity = i == 2 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS;
        compare(*state, scene, &settings, i == 1 ? 16 : 8);
        luxel_scene_free(scene);
    }
}

/* Where points are clustered a pixel depends on its tile, and strips have whole ones. */
static void test_clustered_strips(void **state)
{
    static const char lights[] = "lights=[{type: planar, rectangle: {center: [200, 0, 2500], size: [400, 400]}, "
                                 "power: 90, parts: 20}]";
    static const char all_of_it[] = "screen={width: 6.5, height: 350, resolution: [130, 7000]}"; /* shows the sphere */
    luxel_scene *scene =
        changed_scene("report", (const char *const[]){all_of_it, lights, "picture.range=[0, 9]", NULL});
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = 1;
    settings.precision = LUXEL_DOUBLE;
    settings.light_error = 0.003;
    compare(*state, scene, &settings, 8);
    luxel_scene_free(scene);
}

/* Panels go on from one strip to the next as in the whole picture. */
static void test_strips_of_panels(void **state)
{
    static const char fine[] = "screen={width: 11.25, height: 700, resolution: [135, 8400]}";
    luxel_scene *scene = changed_scene("report", (const char *const[]){fine, "picture.range=[0, 9]", NULL});
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = 1;
    compare(*state, scene, &settings, 8);
    luxel_scene_free(scene);
}

/* A picture too large for its grey levels to wait in memory, beside a file that does not. */
static void test_waiting(void **state)
{
    static const char *const ranges[] = {"picture.range=minmax", "picture.range=log"};
    const struct files *files = *state;
    for (size_t i = 0; i < 2; i++) {
        luxel_scene *scene =
            changed_scene("report", (const char *const[]){"screen.resolution=[4000, 4000]", ranges[i], NULL});
        const luxel_field_output how = {.bits = 8 + 8 * (unsigned)i};
        char whole[128], strips[128], values[128];
        luxel_settings settings;
        luxel_field *field = NULL;

        name_file(files, "whole", ".png", whole);
        name_file(files, "strips", ".png", strips);
        name_file(files, "values", ".pfm", values);
        luxel_settings_init(&settings);
        settings.precision = LUXEL_DOUBLE;
        assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
        assert_int_equal(luxel_field_write_as(field, whole, &how, NULL), LUXEL_OK);
        const char *const paths[] = {strips, values};
        assert_int_equal(luxel_render_files(scene, &settings, paths, 2, &how, NULL, NULL), LUXEL_OK);
        assert_same_file(strips, whole);
        luxel_field_free(field);
        luxel_scene_free(scene);
    }
}

/* Cancels once a share of the work is done, or once a file is there. */
struct stopper {
    double share;
    const char *path; /* NULL: by share */
    double last;
    bool falls;
};

static bool stop_there(double done, void *data)
{
    struct stopper *stopper = data;
    stopper->falls = stopper->falls || done < stopper->last || done > 1;
    stopper->last = done;
    return stopper->path ? access(stopper->path, F_OK) != 0 : done < stopper->share;
}

static bool exists(const struct files *files, const char *name)
{
    char path[128];
    name_file(files, name, "", path);
    return access(path, F_OK) == 0;
}

/* Ended at any share of the work nothing is left; between two files that are complete, the first. */
static void test_cancelled(void **state)
{
    const struct files *files = *state;
    luxel_scene *scene =
        changed_scene("report", (const char *const[]){"screen.resolution=[5500, 5500]", NULL}); /* the .png waits */
    char picture[128], values[128];
    const char *const paths[] = {picture, values};
    name_file(files, "a", ".png", picture);
    name_file(files, "b", ".exr", values);
    for (int i = 0; i <= 5; i++) {
        struct stopper stopper = {.share = 0.25 * i, .path = i == 5 ? picture : NULL};
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        luxel_settings settings;
        luxel_settings_init(&settings);
        settings.progress = stop_there;
        settings.progress_data = &stopper;
        assert_int_equal(luxel_render_files(scene, &settings, paths, 2, NULL, diagnostics, NULL), LUXEL_CANCELLED);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
        assert_false(stopper.falls);
        assert_true(exists(files, "a.png") == (i == 5) && !exists(files, "b.exr"));
        luxel_diagnostics_free(diagnostics);
    }
    luxel_scene_free(scene);
}

static void expect_refusal(const luxel_scene *scene, const char *const *paths, const luxel_field_output *how,
                           luxel_status expected, const char *id)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_statistics statistics = {.mean = -1};
    assert_int_equal(luxel_render_files(scene, NULL, paths, 2, how, diagnostics, &statistics), expected);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    assert_true((statistics.mean != -1) == (expected == LUXEL_ERROR_FILE));
    luxel_diagnostics_free(diagnostics);
}

/* What cannot go leaves nothing; a file that fails costs neither the others nor the statistics. */
static void test_refused(void **state)
{
    const struct files *files = *state;
    char good[128], bad[128], gone[128], full[128];
    luxel_scene *scene = changed_scene("report", (const char *const[]){HIGH, NULL});
    luxel_scene *bright = changed_scene("report", (const char *const[]){HIGH, "lights[0].intensity=1e39", NULL});
    name_file(files, "good", ".npy", good);
    name_file(files, "bad", ".gif", bad);
    name_file(files, "gone", "/a.exr", gone);
    name_file(files, "full", ".png", full);
    assert_int_equal(symlink("/dev/full", full), 0);

    expect_refusal(scene, NULL, NULL, LUXEL_ERROR_ARGUMENT, "missing-argument");
    expect_refusal(scene, (const char *const[]){good, bad}, NULL, LUXEL_ERROR_ARGUMENT, "unknown-ending");
    expect_refusal(scene, (const char *const[]){good, full}, &(luxel_field_output){.bits = 12}, LUXEL_ERROR_ARGUMENT,
                   "setting-out-of-range");
    expect_refusal(bright, (const char *const[]){good, full}, NULL, LUXEL_ERROR_RANGE, "value-too-large");
    assert_false(exists(files, "good.npy"));
    expect_refusal(scene, (const char *const[]){gone, good}, NULL, LUXEL_ERROR_FILE, "file-not-created");
    assert_true(exists(files, "good.npy") && unlink(good) == 0);
    expect_refusal(scene, (const char *const[]){good, full}, NULL, LUXEL_ERROR_FILE, "file-not-written");
    assert_true(exists(files, "good.npy"));
    luxel_scene_free(scene);
    luxel_scene_free(bright);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        FILES_CASE(small),   FILES_CASE(strips),    FILES_CASE(clustered_strips), FILES_CASE(strips_of_panels),
        FILES_CASE(waiting), FILES_CASE(cancelled), FILES_CASE(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
