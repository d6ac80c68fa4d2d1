/* SPDX-License-Identifier: MIT */
/*
 * Memory that runs out while pictures are computed, written, read and measured: every allocation fails once, and each
 * time the call ends with LUXEL_ERROR_MEMORY or does without; no file is left that is not whole.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "scenes.h"
#include "shortage.h"

/* What the attempts work on: a scene and its picture. */
static struct {
    char folder[32], cloud[64], path[64];
    luxel_settings settings; /* of one thread: the others would share the countdown */
    luxel_scene *scene;
    luxel_field *field;
    luxel_evaluator *evaluator;
} work;

static void take_scene(const char *text)
{
    assert_int_equal(load(text, NULL, &work.scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(work.scene, "screen.resolution=[6, 6]", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(work.scene, NULL), LUXEL_OK);
    luxel_settings_init(&work.settings);
    work.settings.threads = 1;
    work.settings.tolerance = 1e-2;
    assert_int_equal(luxel_render(work.scene, &work.settings, NULL, &work.field), LUXEL_OK);
    assert_int_equal(luxel_evaluator_new(work.scene, &work.settings, NULL, &work.evaluator), LUXEL_OK);
}

/* Sources that are points; what is measured takes long with others. */
static int begin_simple(void **state)
{
    (void)state;
    strcpy(work.folder, "/tmp/luxel-shortage-XXXXXX");
    assert_non_null(mkdtemp(work.folder));
    take_scene(good_scene);
    return 0;
}

/* A cloud, extended sources, a highlight, and a surface in the way. */
static int begin_rich(void **state)
{
    static const char head[] = "\x93NUMPY\1\0@\0{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }     ";
    static const double rows[] = {0, 0, 2000, 1, 500, 0, 2000, 2, -500, 0, 2500, 3};
    char words[512];
    (void)state;
    strcpy(work.folder, "/tmp/luxel-shortage-XXXXXX");
    assert_non_null(mkdtemp(work.folder));
    snprintf(work.cloud, sizeof work.cloud, "%s/cloud.npy", work.folder);
    FILE *file = fopen(work.cloud, "w");
    assert_true(file && fwrite(head, sizeof head - 1, 1, file) == 1 && fwrite(rows, sizeof rows, 1, file) == 1 &&
                fclose(file) == 0);
    snprintf(
        words, sizeof words,
        "  - {type: sphere, center: [100, 100, 1400], radius: 40}\nlights:\n  - {type: points, file: %s}\n"
        "  - {type: planar, rectangle: {center: [0, 0, 1800], size: [90, 50]}, power: 1}\n"
        "  - {type: volume, sphere: {center: [0, 300, 1800], radius: 9}, power: 1, attenuation: practical, k: 9}\n",
        work.cloud);
    char *text = changed("lights:\n", words);
    take_scene(text);
    free(text);
    return 0;
}

static int end_work(void **state)
{
    (void)state;
    luxel_evaluator_free(work.evaluator);
    luxel_field_free(work.field);
    luxel_scene_free(work.scene);
    unlink(work.cloud);
    return rmdir(work.folder); /* fails where a file was left */
}

/* Makes the attempt once for each of its allocations, which fails, and once more. */
static void assert_survives(luxel_status (*attempt)(void))
{
    luxel_status status = LUXEL_OK;
    for (long i = 0; i == 0 || shortage_met(); i++) {
        shortage_begin(i);
        status = attempt();
        shortage_end();
        if (status != LUXEL_OK && !(shortage_met() && status == LUXEL_ERROR_MEMORY))
            fail_msg("status %d at allocation %ld", (int)status, i);
    }
    assert_int_equal(status, LUXEL_OK);
}

static luxel_status render(void)
{
    luxel_field *field = NULL;
    luxel_status status = luxel_render(work.scene, &work.settings, NULL, &field);
    assert_true((field != NULL) == (status == LUXEL_OK));
    luxel_field_free(field);
    return status;
}

static luxel_status probe(void)
{
    luxel_probe *made = NULL;
    luxel_status status = luxel_probe_screen(work.scene, &work.settings, 10, 20, NULL, &made);
    assert_true((made != NULL) == (status == LUXEL_OK));
    luxel_probe_free(made);
    return status;
}

static luxel_status make_evaluator(void)
{
    luxel_evaluator *made = NULL;
    luxel_status status = luxel_evaluator_new(work.scene, &work.settings, NULL, &made);
    assert_true((made != NULL) == (status == LUXEL_OK));
    luxel_evaluator_free(made);
    return status;
}

static luxel_status find_isophotes(void)
{
    const luxel_statistics *statistics = luxel_field_statistics(work.field);
    const double levels[] = {statistics->maximum.value / 2, statistics->maximum.value / 4};
    luxel_isophotes *made = NULL;
    luxel_status status = luxel_find_isophotes(work.field, work.evaluator, levels, 2, NULL, &made);
    assert_true((made != NULL) == (status == LUXEL_OK));
    luxel_isophotes_free(made);
    return status;
}

static luxel_status explain(void)
{
    luxel_document *made = NULL;
    luxel_status status = luxel_explain(work.scene, &work.settings, 10, 20, NULL, NULL, &made);
    char *text = status == LUXEL_OK ? luxel_document_write_text(made, LUXEL_DOCUMENT_TEXT) : NULL;
    if (status == LUXEL_OK && !text)
        status = LUXEL_ERROR_MEMORY;
    luxel_text_free(text);
    luxel_document_free(made);
    return status;
}

static luxel_status find_profile(void)
{
    const luxel_profile_path line = {.from_mm = {-200, 0}, .to_mm = {200, 50}, .samples = 9};
    luxel_profile *exact = NULL, *read_off = NULL;
    luxel_status status = luxel_find_profile(work.evaluator, &line, NULL, &exact);
    if (status == LUXEL_OK)
        status = luxel_field_profile(work.field, &line, NULL, &read_off);
    luxel_profile_free(exact);
    luxel_profile_free(read_off);
    return status;
}

static luxel_status summarize(void)
{
    luxel_histogram *histogram = NULL;
    luxel_summary summary;
    luxel_status status = luxel_field_summary(work.field, NULL, NULL, &summary);
    if (status == LUXEL_OK)
        status = luxel_field_histogram(work.field, NULL, LUXEL_HISTOGRAM_LINEAR, (double)NAN, (double)NAN, 4, NULL,
                                       &histogram);
    luxel_histogram_free(histogram);
    return status;
}

static luxel_status compare(void)
{
    luxel_comparison comparison;
    luxel_field *difference = NULL;
    luxel_status status = luxel_compare(work.field, work.field, NULL, &comparison, &difference);
    assert_true((difference != NULL) == (status == LUXEL_OK));
    luxel_field_free(difference);
    return status;
}

/* The file is there when all went well, and nothing else ever. */
static luxel_status write_field(void)
{
    luxel_status status = luxel_field_write(work.field, work.path, NULL);
    assert_int_equal(access(work.path, F_OK), status == LUXEL_OK ? 0 : -1);
    unlink(work.path);
    return status;
}

static luxel_status read_field(void)
{
    luxel_field *field = NULL;
    luxel_status status = luxel_field_read(work.path, NULL, &field);
    assert_true((field != NULL) == (status == LUXEL_OK));
    luxel_field_free(field);
    return status;
}

static luxel_status read_scene(void)
{
    luxel_scene *scene = NULL;
    luxel_status status = luxel_scene_read_file(work.path, NULL, &scene);
    assert_true((scene != NULL) == (status == LUXEL_OK));
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, NULL);
    luxel_scene_free(scene);
    return status;
}

static luxel_status write_scene(void)
{
    luxel_status status = luxel_scene_write_file(work.scene, work.path, NULL);
    assert_int_equal(access(work.path, F_OK), status == LUXEL_OK ? 0 : -1);
    unlink(work.path);
    return status;
}

static void test_computing(void **state)
{
    (void)state;
    assert_survives(render);
    assert_survives(probe);
    assert_survives(make_evaluator);
}

/* Pictures that are shaded by panels. */
static void test_smooth(void **state)
{
    (void)state;
    assert_int_equal(luxel_scene_set(work.scene, "screen={width: 10, height: 10, resolution: [128, 128]}", NULL),
                     LUXEL_OK);
    assert_int_equal(luxel_scene_commit(work.scene, NULL), LUXEL_OK);
    assert_survives(render);
    assert_survives(probe);
}

static void test_measuring(void **state)
{
    (void)state;
    assert_survives(find_isophotes);
    assert_survives(find_profile);
    assert_survives(explain);
    assert_survives(summarize);
    assert_survives(compare);
}

static void test_files(void **state)
{
    const char *ending;
    (void)state;
    for (size_t i = 0; (ending = luxel_field_output_ending(i)) != NULL; i++) {
        snprintf(work.path, sizeof work.path, "%s/a%s", work.folder, ending);
        assert_survives(write_field);
        assert_int_equal(luxel_field_write(work.field, work.path, NULL), LUXEL_OK);
        if (strcmp(ending, ".png") != 0)
            assert_survives(read_field);
        if (strcmp(ending, ".png") == 0 || strcmp(ending, ".exr") == 0)
            assert_survives(read_scene);
        unlink(work.path);
    }
    snprintf(work.path, sizeof work.path, "%s/a.yaml", work.folder);
    assert_survives(write_scene);
    assert_int_equal(luxel_scene_write_file(work.scene, work.path, NULL), LUXEL_OK);
    assert_survives(read_scene);
    unlink(work.path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_computing, begin_rich, end_work),
        cmocka_unit_test_setup_teardown(test_smooth, begin_simple, end_work),
        cmocka_unit_test_setup_teardown(test_measuring, begin_simple, end_work),
        cmocka_unit_test_setup_teardown(test_files, begin_rich, end_work),
    };
    return cmocka_run_group_tests_name("pictures short of memory", tests, NULL, NULL);
}
