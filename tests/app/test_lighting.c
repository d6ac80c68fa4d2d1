/* SPDX-License-Identifier: MIT */
/* Grids and observers are measured and judged as the library does it, in the scene as it was last. */
#include "../../app/picture/lighting.h"

#include <math.h>
#include <string.h>

#include "scenes.h"

/* A lamp 1 m above the middle of a grid of 3 x 3 cells of 1 m: in its middle 100 lx. */
static const char scene[] =
    "luxel: 1\nunits: photometric\nreflections: 1\n"
    "screen: {width: 3000, height: 3000, resolution: [8, 8]}\nobserver: {z: 9000}\n"
    "surfaces:\n  - {type: rectangle, center: [0, 0, 0], size: [3000, 3000], "
    "material: {model: lambert, diffuse: 0.5, over_pi: true}}\n"
    "lights: [{type: point, position: [0, 0, 1000], intensity: 100}]\n"
    "grids:\n  - {name: floor, center: [0, 0, 0], size: [3000, 3000], n: [3, 3], "
    "limits: {minimum: 20, average: 30, maximum: 99, uniformity: 0.4}}\n"
    "  - {center: [0, 0, 0], size: [1000, 1000], n: [1, 1], surround: 500, limits: {average: 100}}\n"
    "observers:\n  - {eye: [0, -900, 1200], view: [0, 1, 0], limits: {ugr: 19}}\n"
    "  - {name: seats, eye: [0, 0, 1200], size: [2000, 2000], n: [2, 1], limits: {ugr: 19}}\n";

static luxel_settings settings_of(const AppMoment *moment)
{
    luxel_settings settings;
    luxel_settings_init(&settings);
    app_moment_light(moment, &settings);
    return settings;
}

static void test_grids(void **state)
{
    (void)state;
    AppDocument *document = document_of_text(scene);
    AppMoment *moment = moment_of(document);
    const luxel_settings settings = settings_of(moment);
    AppGrids *grids = app_grids_new(moment, &settings);
    assert_non_null(grids);
    assert_int_equal(grids->count, 2);
    const AppGrid *grid = &grids->list[0];
    assert_true(fabs(grid->grid->values[4] - 100) < 1e-9 && fabs(grids->most - 100) < 1e-9);
    assert_true(fabs(grid->grid->values[0] - 100 / pow(3, 1.5)) < 1e-9);
    static const luxel_verdict wanted[] = {LUXEL_PASS, LUXEL_FAIL, LUXEL_FAIL, LUXEL_PASS};
    static const char *const names[] = {"average", "minimum", "maximum", "uniformity"};
    assert_int_equal(grid->limit_count, 4);
    for (int i = 0; i < 4; i++) {
        assert_string_equal(grid->limits[i].name, names[i]);
        assert_int_equal(grid->limits[i].verdict, wanted[i]);
    }
    assert_int_equal(app_limits_verdict(grid->limits, 1), LUXEL_PASS);
    assert_int_equal(app_limits_verdict(grid->limits, 4), LUXEL_FAIL);
    assert_int_equal(app_limits_verdict(grid->limits, 0), LUXEL_PASS);
    /* 100 lx are asked for, and there are 100 within the bound of rounding: it is not decided; the areas follow */
    assert_int_equal(grids->list[1].limits[0].verdict, LUXEL_UNDECIDED);
    assert_true(grids->list[1].limit_count > 1 && grids->list[1].grid->surround);
    char *first = app_grid_name(grids, 0), *second = app_grid_name(grids, 1);
    assert_string_equal(first, "floor");
    assert_string_equal(second, "grid 2");
    g_free(first);
    g_free(second);
    app_grids_unref(grids);
    app_moment_unref(moment);
    g_object_unref(document);
}

/* The cell under a place, from above; on edge there is none. */
static void test_cells(void **state)
{
    (void)state;
    AppDocument *document = document_of_text(scene);
    AppMoment *moment = moment_of(document);
    const luxel_settings settings = settings_of(moment);
    AppGrids *grids = app_grids_new(moment, &settings);
    const luxel_grid *grid = grids->list[0].grid;
    for (gsize i = 0; i < 9; i++) {
        double place_mm[3];
        gsize cell = 99;
        luxel_grid_position(grid, (unsigned)i % 3, (unsigned)i / 3, place_mm);
        place_mm[0] += 480;
        place_mm[1] -= 480;
        assert_true(app_grid_find_cell(grid, 1, place_mm, &cell));
        assert_int_equal(cell, i);
        assert_false(app_grid_find_cell(grid, 2, place_mm, &cell));
    }
    gsize cell;
    assert_false(app_grid_find_cell(grid, 1, (const double[3]){1501, 0, 0}, &cell));
    /* the middle of the surrounding area is no part of it */
    assert_false(app_grid_find_cell(grids->list[1].grid->surround, 1, (const double[3]){0, 0, 0}, &cell));
    assert_true(app_grid_find_cell(grids->list[1].grid->surround, 1, (const double[3]){900, 0, 0}, &cell));
    app_grids_unref(grids);
    app_moment_unref(moment);
    g_object_unref(document);
}

static void test_eyes(void **state)
{
    (void)state;
    AppDocument *document = document_of_text(scene);
    AppMoment *moment = moment_of(document);
    const luxel_settings settings = settings_of(moment);
    AppEyes *eyes = app_eyes_new(moment, &settings);
    assert_non_null(eyes);
    assert_int_equal(eyes->count, 2);
    assert_int_equal(eyes->list[0].places, 1);
    assert_int_equal(eyes->list[1].places, 8); /* four views from each of two seats */
    for (gsize i = 0; i < 2; i++)
        assert_int_equal(eyes->list[i].limit_count, 1);
    char *first = app_eye_name(eyes, 0), *second = app_eye_name(eyes, 1);
    assert_string_equal(first, "observer 1");
    assert_string_equal(second, "seats");
    g_free(first);
    g_free(second);
    app_eyes_unref(eyes);
    app_moment_unref(moment);
    g_object_unref(document);
}

/* ---- the thread ---- */

typedef struct Told {
    guint64 serial;
    double most;
    int grids, eyes;
} Told;

static void tell(AppGrids *grids, AppEyes *eyes, guint64 serial, gpointer owner)
{
    Told *told = owner;
    assert_true(!grids != !eyes);
    told->serial = serial;
    told->grids += grids != NULL;
    told->eyes += eyes != NULL;
    told->most = grids ? grids->most : told->most;
}

static gboolean is_whole(gpointer data)
{
    const Told *told = data;
    return told->serial == 7 && told->eyes > 0;
}

/* The last one of many scenes is told of, grids before eyes; what is refused is passed over. */
static void test_survey(void **state)
{
    (void)state;
    AppDocument *document = document_of_text(scene);
    Told told = {0};
    AppSurvey *survey = app_survey_new(tell, &told);
    for (guint64 serial = 1; serial <= 6; serial++)
        app_survey_ask(survey, app_document_copy_scene(document), serial, -1);
    luxel_scene *refused = app_document_copy_scene(document);
    assert_int_equal(luxel_scene_set(refused, "observer.z=-5", NULL), LUXEL_OK);
    app_survey_ask(survey, refused, 6, -1);
    set(document, "lights[0].intensity", "200");
    app_survey_ask(survey, app_document_copy_scene(document), 7, -1);
    wait_until(is_whole, &told);
    assert_true(fabs(told.most - 200) < 1e-9 && told.grids > 0);
    app_survey_free(survey);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_grids),
        cmocka_unit_test(test_cells),
        cmocka_unit_test(test_eyes),
        cmocka_unit_test(test_survey),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
