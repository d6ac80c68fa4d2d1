/* SPDX-License-Identifier: MIT */
/*
 * What structures reserve for later versions: what goes in is refused unless it is NULL there, what comes out is NULL
 * there whatever stood in the caller's memory.
 */
#include <math.h>
#include <string.h>

#include <luxel/luxel.h>

#include "scenes.h"

/* What the caller's memory holds before the library fills it. */
#define GARBAGE(thing) memset(&(thing), 0xa5, sizeof(thing))

static void expect_null(void *const *reserved, size_t count)
{
    for (size_t i = 0; i < count; i++)
        assert_null(reserved[i]);
}

#define EXPECT_NULL(of) expect_null((of)->reserved, sizeof(of)->reserved / sizeof *(of)->reserved)

#define REFUSED(call)                                                                                                  \
    do {                                                                                                               \
        assert_int_equal(call, LUXEL_ERROR_ARGUMENT);                                                                  \
        expect_entry(diagnostics, 0, WANTED(.id = "reserved-not-null", .hint = "_init"));                              \
        luxel_diagnostics_clear(diagnostics);                                                                          \
    } while (0)

static void refused(void **state)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = builtin("report");
    luxel_evaluator *evaluator = NULL;
    luxel_field *field = NULL;
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);

    for (int i = 0; i < 3; i++) {
        luxel_place place = {.is_element = i == 1, .position_mm = {0, 0, 1400}, .normal = {0, 0, 1}};
        luxel_probe *probe;
        luxel_value value;
        assert_int_equal(luxel_probe_place(scene, NULL, &place, diagnostics, &probe), LUXEL_OK);
        luxel_probe_free(probe);
        luxel_evaluate_place(evaluator, &place, &value, NULL);
        assert_true(value.on_surface && value.has_value);
        place.reserved[i] = state;
        REFUSED(luxel_probe_place(scene, NULL, &place, diagnostics, &probe));
        luxel_evaluate_place(evaluator, &place, &value, NULL);
        assert_false(value.on_surface);
        assert_int_equal(luxel_evaluate_places(evaluator, &place, 1, &value, NULL), LUXEL_OK);
        assert_false(value.on_surface);
    }
    for (int type = LUXEL_REGION_ALL; type <= LUXEL_REGION_CIRCLE; type++) {
        const luxel_region region = {
            .type = (luxel_region_type)type, .size_mm = {9, 9}, .radius_mm = 9, .reserved = {[3] = state}};
        luxel_summary summary;
        luxel_extrema extrema;
        luxel_histogram *histogram;
        REFUSED(luxel_field_summary(field, &region, diagnostics, &summary));
        REFUSED(luxel_field_histogram(field, &region, LUXEL_HISTOGRAM_LINEAR, (double)NAN, (double)NAN, 9, diagnostics,
                                      &histogram));
        REFUSED(luxel_find_extrema(evaluator, field, &region, diagnostics, &extrema));
    }
    const luxel_profile_path path = {.to_mm = {9, 9}, .samples = 5, .reserved = {state}};
    luxel_profile *profile;
    REFUSED(luxel_find_profile(evaluator, &path, diagnostics, &profile));
    REFUSED(luxel_field_profile(field, &path, diagnostics, &profile));
    const luxel_glare_sight sight = {.view = {1, 0, 0}, .reserved = {state}};
    luxel_glare *glare;
    REFUSED(luxel_find_glare(scene, NULL, &sight, diagnostics, &glare));
    const luxel_table_column column = {.names = (const char *const[]){"x", NULL}, .reserved = {[1] = state}};
    luxel_table *table;
    REFUSED(luxel_table_open("none.csv", &column, 1, true, diagnostics, &table));
    const luxel_language language = {.reserved = {state}};
    luxel_document *document;
    REFUSED(luxel_explain(scene, NULL, 0, 0, &language, diagnostics, &document));
    const luxel_conventions_use use = {.screen = true, .reserved = {state}};
    luxel_conventions *conventions;
    assert_int_equal(luxel_find_conventions(scene, &use, &conventions), LUXEL_ERROR_ARGUMENT);

    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
}

/* What evaluators, probes and pictures give. */
static void set_to_null(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_evaluator *evaluator = NULL;
    luxel_field *field = NULL;
    luxel_probe *probe = NULL;
    const luxel_place places[3] = {
        {.screen_mm = {0, 0}}, {.screen_mm = {5000, 0}}, {.is_element = true, .normal = {0, 0, 1}}};
    luxel_value values[6];
    luxel_statistics statistics;
    luxel_summary summary;
    luxel_comparison comparison;
    luxel_extrema extrema;
    luxel_light_reach reach;
    GARBAGE(values), GARBAGE(statistics), GARBAGE(summary), GARBAGE(comparison), GARBAGE(extrema), GARBAGE(reach);
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    luxel_trace_screen(evaluator, 0, 0, &values[0]);
    luxel_evaluate_screen(evaluator, 0, 0, &values[1], NULL);
    luxel_evaluate_place(evaluator, &places[2], &values[2], NULL);
    assert_int_equal(luxel_evaluate_places(evaluator, places, 3, &values[3], NULL), LUXEL_OK);
    for (int i = 0; i < 6; i++)
        EXPECT_NULL(&values[i]);
    assert_int_equal(luxel_render(scene, NULL, NULL, &field), LUXEL_OK);
    assert_int_equal(luxel_render_files(scene, NULL, NULL, 0, NULL, NULL, &statistics), LUXEL_OK);
    assert_int_equal(luxel_field_summary(field, NULL, NULL, &summary), LUXEL_OK);
    assert_int_equal(luxel_compare(field, field, NULL, &comparison, NULL), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(evaluator, field, NULL, NULL, &extrema), LUXEL_OK);
    assert_int_equal(luxel_find_light_reach(scene, NULL, NULL, &reach), LUXEL_OK);
    EXPECT_NULL(&statistics);
    EXPECT_NULL(luxel_field_statistics(field));
    EXPECT_NULL(&summary);
    EXPECT_NULL(&comparison);
    EXPECT_NULL(&extrema);
    EXPECT_NULL(&extrema.maximum);
    EXPECT_NULL(&extrema.minimum);
    EXPECT_NULL(&reach);
    assert_int_equal(luxel_probe_screen(scene, NULL, 0, 0, NULL, &probe), LUXEL_OK);
    EXPECT_NULL(&probe->shares[0]);
    luxel_probe_free(probe);
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* What grids and luminaires give. */
static void set_to_null_in_rooms(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("office");
    luxel_grid_extrema extrema;
    GARBAGE(extrema);
    assert_int_equal(luxel_find_grid_extrema(scene, NULL, 0, NULL, &extrema), LUXEL_OK);
    EXPECT_NULL(&extrema);
    assert_true(extrema.minimum.rgb_error == 0 && extrema.maximum.rgb[2] == 0);
    luxel_scene_free(scene);

    static const char lamp[] = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0.2 0.2 0\n1 1 20\n0 90\n0\n300 100\n";
    luxel_photometry *photometry;
    luxel_photometry_figures figures;
    luxel_ugr_table table;
    GARBAGE(figures), GARBAGE(table);
    assert_int_equal(luxel_photometry_read_bytes(lamp, sizeof lamp - 1, "lamp", NULL, &photometry), LUXEL_OK);
    assert_int_equal(luxel_photometry_find_figures(photometry, &figures), LUXEL_OK);
    assert_int_equal(luxel_photometry_find_ugr_table(photometry, 0.25, &table), LUXEL_OK);
    EXPECT_NULL(&figures);
    EXPECT_NULL(&table);
    EXPECT_NULL(&photometry->lamp_sets[0]);
    luxel_photometry_free(photometry);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refused),
        cmocka_unit_test(set_to_null),
        cmocka_unit_test(set_to_null_in_rooms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
