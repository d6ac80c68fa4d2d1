/* SPDX-License-Identifier: MIT */
/* Curves are the profiles that the library finds, and their differences the differences of its values. */
#include <math.h>
#include <string.h>

#include "../../app/picture/curve.h"
#include "scenes.h"

static luxel_profile *profile_of(const AppMoment *moment)
{
    const luxel_profile_path path = {
        .type = LUXEL_PATH_LINE, .samples = 101, .from_mm = {-250, 20}, .to_mm = {250, 20}};
    luxel_evaluator *evaluator;
    luxel_profile *profile;
    assert_int_equal(luxel_evaluator_new(moment->scene, NULL, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_profile(evaluator, &path, NULL, &profile), LUXEL_OK);
    luxel_evaluator_free(evaluator);
    return profile;
}

static void keeps_profiles(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("three-lights");
    AppMoment *moment = moment_of(document);
    luxel_profile *expected = profile_of(moment);
    AppCurve *curve = app_curve_new(profile_of(moment), NULL);
    assert_false(curve->is_difference);
    assert_int_equal(curve->profile.count, expected->count);
    assert_int_equal(curve->profile.lights, 3);
    for (gsize i = 0; i < expected->count; i++)
        assert_true(curve->profile.samples[i].value == expected->samples[i].value);
    assert_memory_equal(curve->profile.shares, expected->shares, expected->count * 3 * sizeof *expected->shares);
    app_curve_free(curve);
    luxel_profile_free(expected);
    app_moment_unref(moment);
    g_object_unref(document);
}

static void takes_one_off_the_other(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    set(document, "screen.width", "700");
    set(document, "screen.height", "700");
    AppMoment *before = moment_of(document);
    set(document, "lights[0].intensity", "25");
    set(document, "surfaces[0].center", "[120, 0, 1000]"); /* off the one sphere is not off the other */
    AppMoment *after = moment_of(document);
    luxel_profile *a = profile_of(before), *b = profile_of(after);
    AppCurve *curve = app_curve_new(profile_of(after), a);
    double largest = 0;
    gsize without = 0;
    assert_true(curve->is_difference && curve->profile.lights == 0 && !curve->profile.shares);
    for (gsize i = 0; i < a->count; i++) {
        const luxel_profile_sample *sample = &curve->profile.samples[i];
        assert_int_equal(sample->has_value, a->samples[i].has_value && b->samples[i].has_value);
        without += a->samples[i].has_value && !sample->has_value;
        if (!sample->has_value)
            continue;
        assert_true(sample->value == b->samples[i].value - a->samples[i].value);
        assert_true(sample->error >= a->samples[i].error);
        largest = fmax(largest, fabs(sample->value));
    }
    assert_true(largest > 5 && without > 5);
    assert_true(curve->low == -curve->high && curve->high > largest);
    app_curve_free(curve);
    app_curve_free(NULL);
    luxel_profile_free(a);
    luxel_profile_free(b);
    app_moment_unref(before);
    app_moment_unref(after);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(keeps_profiles), cmocka_unit_test(takes_one_off_the_other)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
