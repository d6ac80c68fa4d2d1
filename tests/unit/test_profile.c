/* SPDX-License-Identifier: MIT */
/*
 * Profiles: each sample is what a probe gives, arcs are great circles, the picture's are its pixels, lines across the
 * screen, and what is refused.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "csv_field.h"
#include "scenes.h"

static luxel_evaluator *evaluator_of(const luxel_scene *scene, unsigned threads)
{
    luxel_settings settings;
    luxel_evaluator *evaluator = NULL;
    luxel_settings_init(&settings);
    settings.threads = threads;
    assert_int_equal(luxel_evaluator_new(scene, &settings, NULL, &evaluator), LUXEL_OK);
    return evaluator;
}

static luxel_profile *profile_of(const luxel_evaluator *evaluator, luxel_profile_path path)
{
    luxel_profile *profile = NULL;
    assert_int_equal(luxel_find_profile(evaluator, &path, NULL, &profile), LUXEL_OK);
    assert_int_equal(profile->count, path.samples);
    assert_int_equal(profile->type, path.type);
    return profile;
}

/* To the last bit what is evaluated at its place, and the lights' shares make up the whole. */
static void test_line(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("three-lights");
    luxel_evaluator *evaluator = evaluator_of(scene, 1);
    luxel_profile *profile =
        profile_of(evaluator, (luxel_profile_path){LUXEL_PATH_LINE, {-400, 100}, {350, -180}, .samples = 301});
    const double length = hypot(750, 280);
    size_t valued = 0;
    assert_int_equal(profile->lights, 3);
    for (size_t i = 0; i < profile->count; i++) {
        const luxel_profile_sample *sample = &profile->samples[i];
        double shares[3], sum = 0;
        luxel_value value;
        luxel_evaluate_screen(evaluator, sample->x_mm, sample->y_mm, &value, shares);
        assert_true(fabs(sample->abscissa - length * (double)i / 300) <= 1e-12);
        assert_true(fabs(hypot(sample->x_mm + 400, sample->y_mm - 100) - sample->abscissa) < 1e-11);
        assert_int_equal(sample->has_value, value.has_value);
        assert_true(sample->value == (value.has_value ? value.value : 0));
        assert_memory_equal(&profile->shares[i * 3], shares, sizeof shares);
        for (int k = 0; k < 3; k++)
            sum += shares[k];
        assert_true(fabs(sum - sample->value) <= sample->error);
        valued += sample->has_value;
    }
    assert_in_range(valued, 200, 299); /* both ends are beside the sphere */
    assert_true(profile->samples[0].x_mm == -400 && profile->samples[300].x_mm == 350);
    luxel_profile_free(profile);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* The line there and back is the same backwards; so is it for any number of threads. */
static void test_ways(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("two-spheres");
    luxel_evaluator *one = evaluator_of(scene, 1), *four = evaluator_of(scene, 4);
    const luxel_profile_path there = {LUXEL_PATH_LINE, {-500, 37}, {500, 211}, .samples = 1001};
    const luxel_profile_path back = {LUXEL_PATH_LINE, {500, 211}, {-500, 37}, .samples = 1001};
    luxel_profile *a = profile_of(one, there), *b = profile_of(four, there), *c = profile_of(one, back);
    assert_memory_equal(a->shares, b->shares, a->count * a->lights * sizeof *a->shares);
    for (size_t i = 0; i < a->count; i++) {
        const luxel_profile_sample *from = &a->samples[i], *to = &c->samples[a->count - 1 - i];
        assert_true(from->value == b->samples[i].value && from->has_value == b->samples[i].has_value);
        assert_true(fabs(from->x_mm - to->x_mm) < 1e-12);
        assert_true(from->has_value == to->has_value && fabs(from->value - to->value) < 1e-10);
    }
    luxel_profile_free(a);
    luxel_profile_free(b);
    luxel_profile_free(c);
    luxel_evaluator_free(one);
    luxel_evaluator_free(four);
    luxel_scene_free(scene);
}

/* Equal steps of the angle along a great circle: between the normals of the two places, on the plane through both. */
static void test_arc(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_evaluator *evaluator = evaluator_of(scene, 2);
    const luxel_profile_path path = {LUXEL_PATH_ARC, {-100, 60}, {150, 90}, .samples = 91};
    luxel_profile *profile = profile_of(evaluator, path);
    luxel_value first, last;
    luxel_evaluate_screen(evaluator, -100, 60, &first, NULL);
    luxel_evaluate_screen(evaluator, 150, 90, &last, NULL);
    const double *a = first.normal, *b = last.normal;
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double whole = acos(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / M_PI;
    for (size_t i = 0; i < profile->count; i++) {
        const luxel_profile_sample *sample = &profile->samples[i];
        luxel_value value;
        luxel_evaluate_screen(evaluator, sample->x_mm, sample->y_mm, &value, NULL);
        const double *n = value.normal;
        double angle = acos(fmin(1, n[0] * a[0] + n[1] * a[1] + n[2] * a[2])) * 180 / M_PI;
        assert_true(fabs(sample->abscissa - whole * (double)i / 90) < 1e-10);
        assert_true(fabs(angle - sample->abscissa) < (i == 0 ? 1e-5 : 1e-10));
        assert_true(fabs(n[0] * cross[0] + n[1] * cross[1] + n[2] * cross[2]) < 1e-14);
        assert_true(fabs(sample->value - value.value) < 1e-11);
    }
    assert_true(fabs(profile->samples[90].x_mm - 150) < 1e-10 && fabs(profile->samples[90].y_mm - 90) < 1e-10);
    luxel_profile_free(profile);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

/* Pixels are squares about their places; beyond the picture there is no value. */
static void test_picture(void **state)
{
    (void)state;
    const double values[] = {1, 2, 3, 4, (double)NAN, 6};
    luxel_field *field = csv_field(values, 2, 3); /* x 0 1 2, y 1 0 */
    const luxel_profile_path path = {LUXEL_PATH_LINE, {-1, 0.75}, {3, 0.75}, .samples = 17};
    const double top[17] = {0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 3, 0, 0};
    luxel_profile *profile = NULL;
    assert_int_equal(luxel_field_profile(field, &path, NULL, &profile), LUXEL_OK);
    assert_true(profile->lights == 0 && !profile->shares);
    for (size_t i = 0; i < 17; i++) {
        assert_true(profile->samples[i].value == top[i]);
        assert_int_equal(profile->samples[i].has_value, top[i] > 0);
    }
    luxel_profile_free(profile);
    const luxel_profile_path low = {LUXEL_PATH_LINE, {0, 0}, {2, 0}, .samples = 3};
    assert_int_equal(luxel_field_profile(field, &low, NULL, &profile), LUXEL_OK);
    assert_true(profile->samples[0].value == 4 && profile->samples[2].value == 6 && !profile->samples[1].has_value);
    luxel_profile_free(profile);
    luxel_field_free(field);
}

static void assert_across(const luxel_scene *scene, double x, double y, double degrees, const double ends[4])
{
    const double through[2] = {x, y};
    double from[2], to[2];
    assert_int_equal(luxel_profile_line(scene, through, degrees, NULL, from, to), LUXEL_OK);
    for (int i = 0; i < 2; i++)
        assert_true(fabs(from[i] - ends[i]) < 1e-11 && fabs(to[i] - ends[2 + i]) < 1e-11);
}

static void test_across_screen(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report"); /* 500 x 500 mm */
    double from[2], to[2];
    assert_across(scene, 10, 20, 0, (const double[]){-250, 20, 250, 20});
    assert_across(scene, 10, 20, 90, (const double[]){10, -250, 10, 250});
    assert_across(scene, 10, 20, 180, (const double[]){250, 20, -250, 20});
    assert_across(scene, 10, 20, -90, (const double[]){10, 250, 10, -250});
    const double flat = 250 * tan(M_PI / 180);
    assert_across(scene, 0, 0, 1, (const double[]){-250, -flat, 250, flat});
    assert_across(scene, 0, 0, 91, (const double[]){flat, -250, -flat, 250});
    assert_across(scene, 0, 0, 45, (const double[]){-250, -250, 250, 250});
    assert_across(scene, 300, 100, 45, (const double[]){-50, -250, 250, 50}); /* the point itself is outside */
    assert_across(scene, 0, 0, 360 + 135, (const double[]){250, -250, -250, 250});
    const double inside[2] = {10.1, 20.1};
    for (int quarters = -4; quarters <= 4; quarters++) { /* along an axis without rounding */
        assert_int_equal(luxel_profile_line(scene, inside, 90 * quarters, NULL, from, to), LUXEL_OK);
        const int kept = quarters % 2 == 0 ? 1 : 0;
        assert_true(from[kept] == inside[kept] && to[kept] == inside[kept]);
    }
    const double outside[2] = {300, 0}, nowhere[2] = {(double)NAN, 0};
    assert_int_equal(luxel_profile_line(scene, outside, 90, NULL, from, to), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_line(scene, nowhere, 0, NULL, from, to), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_profile_line(scene, outside, HUGE_VAL, NULL, from, to), LUXEL_ERROR_ARGUMENT);
    luxel_scene_free(scene);
}

static void test_refused(void **state)
{
    (void)state;
    const luxel_profile_path bad[] = {
        {LUXEL_PATH_LINE, {1, 1}, {1, 1}, .samples = 5},              /* no length */
        {LUXEL_PATH_LINE, {0, 0}, {1, 1}, .samples = 1},              /* one sample */
        {LUXEL_PATH_LINE, {0, 0}, {1, 1}, .samples = 10000001},       /* too many */
        {LUXEL_PATH_LINE, {(double)NAN, 0}, {1, 1}, .samples = 5},    /* nowhere */
        {LUXEL_PATH_LINE, {0, 0}, {HUGE_VAL, 1}, .samples = 5},       /* to nowhere */
        {LUXEL_PATH_ARC, {0, 0}, {480, 0}, .samples = 5},             /* beside the spheres */
        {LUXEL_PATH_ARC, {-100, 0}, {210, 130}, .samples = 5},        /* from one sphere to the other */
        {LUXEL_PATH_ARC, {-100, 0}, {-100 + 1e-13, 0}, .samples = 5}, /* nearly the same place */
    };
    luxel_scene *scene = builtin("two-spheres");
    luxel_evaluator *evaluator = evaluator_of(scene, 1);
    luxel_profile *profile = NULL;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        luxel_diagnostics *diagnostics = luxel_diagnostics_new();
        assert_int_equal(luxel_find_profile(evaluator, &bad[i], diagnostics, &profile), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
        luxel_diagnostics_free(diagnostics);
    }
    const double values[] = {1, 2};
    luxel_field *field = csv_field(values, 1, 2);
    const luxel_profile_path arc = {LUXEL_PATH_ARC, {0, 0}, {1, 0}, .samples = 5};
    assert_int_equal(luxel_field_profile(field, &arc, NULL, &profile), LUXEL_ERROR_ARGUMENT);
    assert_null(profile);
    luxel_field_free(field);
    luxel_evaluator_free(evaluator);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_line),    cmocka_unit_test(test_ways),          cmocka_unit_test(test_arc),
        cmocka_unit_test(test_picture), cmocka_unit_test(test_across_screen), cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
