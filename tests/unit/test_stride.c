/* SPDX-License-Identifier: MIT */
/* Quick looks: a field with a stride has those pixels of the whole picture that it says, and is taken for no other. */
#include <stdlib.h>
#include <string.h>

#include "scenes.h"

static luxel_field *render(const luxel_scene *scene, unsigned stride, const char *instruction_set,
                           luxel_precision precision)
{
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_settings_init(&settings);
    assert_int_equal(settings.stride, 1);
    settings.stride = stride;
    settings.instruction_set = instruction_set;
    settings.precision = precision;
    assert_int_equal(luxel_render(scene, &settings, NULL, &field), LUXEL_OK);
    return field;
}

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

/* Every pixel of the quick look is that of the whole picture, within a share of the maximum; 0: bit for bit. */
static void compare(const luxel_field *whole, const luxel_field *quick, unsigned stride, double allowed)
{
    const luxel_statistics *statistics = luxel_field_statistics(quick);
    unsigned columns = luxel_field_columns(whole), rows = luxel_field_rows(whole);
    double bound = allowed * luxel_field_statistics(whole)->maximum.value, most = 0;
    assert_int_equal(luxel_field_columns(quick), (columns + stride - 1) / stride);
    assert_int_equal(luxel_field_rows(quick), (rows + stride - 1) / stride);
    for (unsigned row = 0; row < luxel_field_rows(quick); row++)
        for (unsigned column = 0; column < luxel_field_columns(quick); column++) {
            unsigned u = least(stride / 2 + column * stride, columns - 1);
            unsigned v = least(stride / 2 + row * stride, rows - 1);
            double value = luxel_field_value(quick, column, row), expected = luxel_field_value(whole, u, v);
            assert_true(luxel_field_x_mm(quick)[column] == luxel_field_x_mm(whole)[u]);
            assert_true(luxel_field_y_mm(quick)[row] == luxel_field_y_mm(whole)[v]);
            assert_int_equal(luxel_field_mask(quick)[row * luxel_field_columns(quick) + column],
                             luxel_field_mask(whole)[v * columns + u]);
            assert_true(value - expected <= bound && expected - value <= bound);
            most = value > most ? value : most;
        }
    assert_true(statistics->maximum.exists ? statistics->maximum.value == most : most == 0);
}

static void check_scene(const char *name, const char *instruction_set, double allowed)
{
    static const unsigned strides[] = {2, 3, 4, 8, 359, 65536};
    for (luxel_precision precision = LUXEL_SINGLE; precision <= LUXEL_DOUBLE; precision++) {
        luxel_scene *scene = builtin(name);
        assert_int_equal(luxel_scene_set(scene, "screen={width: 500, height: 350, resolution: [130, 91]}", NULL),
                         LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        luxel_field *whole = render(scene, 1, instruction_set, precision);
        luxel_field *same = render(scene, 0, instruction_set, precision);
        compare(whole, same, 1, 0);
        for (size_t i = 0; i < sizeof strides / sizeof strides[0]; i++) {
            luxel_field *quick = render(scene, strides[i], instruction_set, precision);
            compare(whole, quick, strides[i], allowed);
            luxel_field_free(quick);
        }
        luxel_field_free(same);
        luxel_field_free(whole);
        luxel_scene_free(scene);
    }
}

static void test_same_bits(void **state)
{
    (void)state;
    static const char *const names[] = {"report", "three-lights", "two-spheres", "spot"};
    for (size_t set = 0; luxel_instruction_set_name(set); set++)
        for (size_t i = 0; luxel_instruction_set_runs(set) && i < sizeof names / sizeof names[0]; i++)
            check_scene(names[i], luxel_instruction_set_name(set), 0);
}

/* How highlights of extended sources are summed depends on the pixels beside: each is within 1e-3 of the truth. */
static void test_extended(void **state)
{
    (void)state;
    check_scene("window", NULL, 2e-3);
    check_scene("ball-lamp", NULL, 2e-3);
}

/* It carries no scene, and what needs the whole picture refuses it; what goes by its places takes it. */
static void test_taken_for(void **state)
{
    (void)state;
    const double level = 1;
    luxel_scene *scene = builtin("report");
    luxel_field *quick = render(scene, 3, NULL, LUXEL_SINGLE);
    luxel_evaluator *evaluator = NULL;
    luxel_extrema extrema;
    luxel_isophotes *isophotes = NULL;
    luxel_profile *profile = NULL;
    const luxel_profile_path path = {.type = LUXEL_PATH_LINE, .from_mm = {-250, 0}, .to_mm = {250, 0}, .samples = 121};

    assert_null(luxel_field_scene(quick));
    assert_string_equal(luxel_field_unit(quick), "W/sr");
    assert_int_equal(luxel_evaluator_new(scene, NULL, NULL, &evaluator), LUXEL_OK);
    assert_int_equal(luxel_find_extrema(evaluator, quick, NULL, NULL, &extrema), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_isophotes(quick, evaluator, &level, 1, NULL, &isophotes), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_find_isophotes(quick, NULL, &level, 1, NULL, &isophotes), LUXEL_OK);
    assert_true(isophotes->count > 0);
    assert_int_equal(luxel_field_profile(quick, &path, NULL, &profile), LUXEL_OK);
    for (size_t i = 0; i < profile->count; i++)
        assert_true(profile->samples[i].has_value);
    assert_true(profile->samples[60].value == luxel_field_value(quick, 60, 60) ||
                profile->samples[60].value == luxel_field_value(quick, 60, 59));
    luxel_profile_free(profile);
    luxel_isophotes_free(isophotes);
    luxel_evaluator_free(evaluator);
    luxel_field_free(quick);
    luxel_scene_free(scene);
}

/* A stride out of its range is refused everywhere; in its range it says nothing to exact values. */
static void test_setting(void **state)
{
    (void)state;
    luxel_scene *scene = builtin("report");
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_settings settings;
    luxel_field *field = NULL;
    luxel_probe *probe = NULL, *other = NULL;

    luxel_settings_init(&settings);
    settings.stride = 65537;
    assert_int_equal(luxel_render(scene, &settings, diagnostics, &field), LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "setting-out-of-range");
    settings.stride = 65536;
    assert_int_equal(luxel_probe_screen(scene, &settings, 10, 20, NULL, &probe), LUXEL_OK);
    assert_int_equal(luxel_probe_screen(scene, NULL, 10, 20, NULL, &other), LUXEL_OK);
    assert_true(probe->value == other->value && probe->pixel_value == other->pixel_value);
    luxel_probe_free(probe);
    luxel_probe_free(other);
    luxel_diagnostics_free(diagnostics);
    luxel_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_same_bits),
        cmocka_unit_test(test_extended),
        cmocka_unit_test(test_taken_for),
        cmocka_unit_test(test_setting),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
