/* SPDX-License-Identifier: MIT */
/*
 * Memory that runs out while pictures are made, written, read and looked at: every allocation of the library fails
 * once, as in test_shortage.c, and each time the call ends with LUXEL_ERROR_MEMORY or does without, and loses nothing.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "scenes.h"
#include "shortage.h"

static const char small[] = "screen={width: 900, height: 900, resolution: [6, 6]}";

/* Once for each allocation of the call: with i for its number, until none fails. */
#define EACH_ALLOCATION(i) for (long i = 0; i == 0 || shortage_met(); i++)

static void assert_short(luxel_status status)
{
    if (status != LUXEL_OK && !(shortage_met() && status == LUXEL_ERROR_MEMORY))
        fail_msg("status %d", (int)status);
}

static luxel_scene *small_builtin(const char *name)
{
    luxel_scene *scene = builtin(name);
    assert_int_equal(luxel_scene_set(scene, small, NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    return scene;
}

static luxel_settings settings_of(luxel_quantity quantity)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    settings.threads = 2;
    settings.tolerance = 1e-4;
    settings.quantity = quantity;
    return settings;
}

static luxel_field *render(const luxel_scene *scene, luxel_precision precision)
{
    luxel_settings settings = settings_of(LUXEL_BRIGHTNESS);
    luxel_field *field = NULL;
    settings.precision = precision;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static void rendering_and_probing(void **state)
{
    (void)state;
    static const char *const names[] = {"all-sources", "lampshade", "two-spheres"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        luxel_scene *scene = small_builtin(names[k]);
        luxel_settings settings = settings_of(k == 0 ? LUXEL_IRRADIANCE : LUXEL_BRIGHTNESS);
        EACH_ALLOCATION(i)
        {
            luxel_field *field = NULL;
            shortage_begin(i);
            luxel_status status = luxel_render(scene, &settings, NULL, &field);
            shortage_end();
            assert_short(status);
            assert_int_equal(field != NULL, status == LUXEL_OK);
            luxel_field_free(field);
        }
        EACH_ALLOCATION(i)
        {
            luxel_probe *probe = NULL;
            shortage_begin(i);
            luxel_status status = luxel_probe_screen(scene, &settings, 0, 0, NULL, &probe);
            shortage_end();
            assert_short(status);
            assert_int_equal(probe != NULL, status == LUXEL_OK);
            luxel_probe_free(probe);
        }
        luxel_scene_free(scene);
    }
}

/* What is computed is there again after each failure. */
static void looking_at_pictures(void **state)
{
    (void)state;
    luxel_scene *scene = small_builtin("three-lights");
    luxel_settings settings = settings_of(LUXEL_BRIGHTNESS);
    luxel_field *field = render(scene, LUXEL_SINGLE), *precise = render(scene, LUXEL_DOUBLE);
    const double levels[] = {luxel_field_statistics(field)->maximum.value / 2, 0.1};
    const luxel_path line = {.from_mm = {-200, 0}, .to_mm = {200, 50}, .samples = 9};
    luxel_evaluator *evaluator;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    EACH_ALLOCATION(i)
    {
        luxel_evaluator *another = NULL;
        shortage_begin(i);
        assert_short(luxel_evaluator_new(scene, &settings, NULL, &another));
        shortage_end();
        luxel_evaluator_free(another);
    }
    for (int exact = 0; exact < 2; exact++)
        EACH_ALLOCATION(i)
        {
            luxel_isophotes *isophotes = NULL;
            luxel_profile *profile = NULL;
            shortage_begin(i);
            assert_short(luxel_find_isophotes(field, exact ? evaluator : NULL, levels, 2, NULL, &isophotes));
            assert_short(exact ? luxel_find_profile(evaluator, &line, NULL, &profile)
                               : luxel_field_profile(field, &line, NULL, &profile));
            shortage_end();
            luxel_isophotes_free(isophotes);
            luxel_profile_free(profile);
        }
    EACH_ALLOCATION(i)
    {
        luxel_histogram *histogram = NULL;
        luxel_summary summary;
        luxel_comparison comparison;
        luxel_field *difference = NULL;
        shortage_begin(i);
        assert_short(luxel_field_summary(field, NULL, NULL, &summary));
        assert_short(luxel_field_histogram(field, NULL, LUXEL_LINEAR, (double)NAN, (double)NAN, 4, NULL, &histogram));
        assert_short(luxel_compare(field, precise, NULL, &comparison, &difference));
        shortage_end();
        luxel_histogram_free(histogram);
        luxel_field_free(difference);
    }
    luxel_evaluator_free(evaluator);
    luxel_field_free(precise);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* A file that could not be written is not there; what is read back is the field, or nothing. */
static void writing_and_reading(void **state)
{
    (void)state;
    static const char *const endings[] = {"png", "npy", "pfm", "csv", "exr"};
    char folder[] = "/tmp/luxel-shortage-XXXXXX", path[64];
    luxel_scene *scene = small_builtin("report");
    luxel_field *field = render(scene, LUXEL_SINGLE);
    assert_non_null(mkdtemp(folder));
    for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++) {
        snprintf(path, sizeof path, "%s/a.%s", folder, endings[k]);
        EACH_ALLOCATION(i)
        {
            unlink(path);
            shortage_begin(i);
            luxel_status status = luxel_field_write(field, path, NULL);
            shortage_end();
            assert_true(status == LUXEL_OK || shortage_met());
            assert_int_equal(access(path, F_OK), status == LUXEL_OK ? 0 : -1);
        }
        EACH_ALLOCATION(i)
        {
            luxel_field *again = NULL;
            luxel_scene *carried = NULL;
            bool is_picture = k == 0;
            shortage_begin(i);
            luxel_status status =
                is_picture ? luxel_scene_read_file(path, NULL, &carried) : luxel_field_read(path, NULL, &again);
            shortage_end();
            assert_true(status == LUXEL_OK || shortage_met());
            assert_int_equal(is_picture ? carried != NULL : again != NULL, status == LUXEL_OK);
            luxel_field_free(again);
            luxel_scene_free(carried);
        }
        unlink(path);
    }
    assert_int_equal(rmdir(folder), 0);
    luxel_field_free(field);
    luxel_scene_free(scene);
}

/* Clouds of points in both formats: where one cannot be held the scene is not committed. */
static void reading_clouds(void **state)
{
    (void)state;
    static const char csv[] = "x;y;z;intensity\n0;0;2000;5\n100;50;1900;0\n";
    static const char head[] = "\x93NUMPY\1\0@\0{'descr': '<f8', 'fortran_order': True, 'shape': (1, 4), }      ";
    const double row[] = {0, 0, 2000, 5};
    char folder[] = "/tmp/luxel-shortage-XXXXXX", path[64], words[160];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/cloud", folder);
    snprintf(words, sizeof words, "lights:\n  - {type: points, file: %s, pattern: lambertian}\n", path);
    char *text = changed("lights:\n", words);
    for (int is_npy = 0; is_npy < 2; is_npy++) {
        FILE *file = fopen(path, "wb");
        assert_non_null(file);
        if (is_npy) {
            assert_int_equal(fwrite(head, 1, sizeof head - 1, file), 10 + '@');
            fwrite(row, 1, sizeof row, file);
        } else {
            fputs(csv, file);
        }
        assert_int_equal(fclose(file), 0);
        EACH_ALLOCATION(i)
        {
            luxel_scene *scene = NULL;
            shortage_begin(i);
            luxel_status status = load(text, NULL, &scene);
            shortage_end();
            assert_short(status);
            assert_true(!scene || luxel_scene_is_committed(scene) == (status == LUXEL_OK));
            luxel_scene_free(scene);
        }
    }
    assert_true(unlink(path) == 0 && rmdir(folder) == 0);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rendering_and_probing),
        cmocka_unit_test(looking_at_pictures),
        cmocka_unit_test(writing_and_reading),
        cmocka_unit_test(reading_clouds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
