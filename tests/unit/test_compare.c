/* SPDX-License-Identifier: MIT */
/* Comparing fields: numbers known by hand, masks that differ, the field of differences, and what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "csv_field.h"

#define NONE ((double)NAN)

static void test_known_numbers(void **state)
{
    (void)state;
    const double in_a[] = {1, 2, 3, 4}, in_b[] = {1, 5, 3, 0};
    luxel_field *a = csv_field(in_a, 2, 2), *b = csv_field(in_b, 2, 2), *difference = NULL;
    luxel_comparison made;
    assert_int_equal(luxel_compare(a, b, NULL, &made, &difference), LUXEL_OK);
    assert_int_equal(made.pixels, 4);
    assert_true(made.largest.value == 4 && made.largest.row == 1 && made.largest.column == 1);
    assert_true(made.largest.x_mm == 1 && made.largest.y_mm == 0);
    assert_true(made.a == 4 && made.b == 0);
    assert_true(made.mean == -0.25 && made.mean_magnitude == 1.75 && fabs(made.rms - 2.5) < 1e-15);
    assert_true(made.scale == 5 && made.largest_relative == 0.8 && fabs(made.rms_relative - 0.5) < 1e-15);
    const double away[] = {0, 3, 0, -4};
    for (unsigned i = 0; i < 4; i++)
        assert_true(luxel_field_value(difference, i % 2, i / 2) == away[i]);
    assert_true(luxel_field_x_mm(difference)[1] == 1 && luxel_field_y_mm(difference)[0] == 1);
    luxel_field_free(difference);

    assert_int_equal(luxel_compare(a, a, NULL, &made, NULL),
                     LUXEL_OK); /* the same: nothing apart, at the first pixel */
    assert_true(made.largest.exists && made.largest.value == 0 && made.rms == 0 && made.largest_relative == 0);
    assert_true(made.scale == 4);
    luxel_field_free(a);
    luxel_field_free(b);
}

/* Swapped, the signed mean changes its sign and nothing else changes. */
static void test_symmetry(void **state)
{
    (void)state;
    const double in_a[] = {1, 2, NONE, 4, 1e-300, 7}, in_b[] = {NONE, 5, 3, 0, 2, 1e200};
    luxel_field *a = csv_field(in_a, 2, 3), *b = csv_field(in_b, 2, 3);
    luxel_comparison there, back;
    assert_int_equal(luxel_compare(a, b, NULL, &there, NULL), LUXEL_OK);
    assert_int_equal(luxel_compare(b, a, NULL, &back, NULL), LUXEL_OK);
    assert_int_equal(there.pixels, 4);
    assert_true(there.only_a == 1 && there.only_b == 1 && back.only_a == 1 && back.only_b == 1);
    assert_true(there.mean == -back.mean && there.mean_magnitude == back.mean_magnitude && there.rms == back.rms);
    assert_true(there.largest.value == back.largest.value && there.a == back.b && there.b == back.a);
    assert_true(fabs(there.rms / 5e199 - 1) < 1e-15); /* squares of 1e200 are out of range */
    luxel_field_free(a);
    luxel_field_free(b);
}

/* The field by way of a file without a mask: which pixels show a surface is guessed, by their not being 0. */
static luxel_field *without_mask(const luxel_field *field)
{
    char path[] = "/tmp/luxel-field-XXXXXX.npy";
    luxel_field *read = NULL;
    int descriptor = mkstemps(path, 4);
    assert_true(descriptor >= 0 && close(descriptor) == 0);
    assert_int_equal(luxel_field_write(field, path, NULL), LUXEL_OK);
    assert_int_equal(luxel_field_read(path, NULL, &read), LUXEL_OK);
    unlink(path);
    return read;
}

/* Where one of the files knows what is a surface, dark pixels are not taken for none; two that guess agree. */
static void test_guesses(void **state)
{
    (void)state;
    const double values[] = {1, 0, NONE, 4};
    luxel_field *known = csv_field(values, 2, 2), *guessed = without_mask(known);
    const luxel_field *pairs[][2] = {{known, guessed}, {guessed, known}, {guessed, guessed}};
    for (int i = 0; i < 3; i++) {
        luxel_comparison made;
        luxel_field *difference;
        assert_int_equal(luxel_compare(pairs[i][0], pairs[i][1], NULL, &made, &difference), LUXEL_OK);
        assert_int_equal(made.pixels, i < 2 ? 3 : 2);
        assert_true(made.only_a == 0 && made.only_b == 0 && made.largest.value == 0);
        assert_int_equal(luxel_field_x_mm(difference) != NULL, i < 2); /* the places, too, are those that are known */
        assert_int_equal(isnan(made.largest.x_mm), i == 2);
        luxel_field_free(difference);
    }
    luxel_field_free(known);
    luxel_field_free(guessed);
}

/* Fields of the same size whose pixels lie elsewhere are not compared; roundings of their places do not matter. */
static void test_places(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "x_mm,y_mm,value_\n0,0,1\n1,0,2\n2,0,3\n", "x_mm,y_mm,value_\n1e-8,0,1\n1,0,2\n2,0,3\n",
        "x_mm,y_mm,value_\n1,0,1\n2,0,2\n3,0,3\n", "x_mm,y_mm,value_\n0,1,1\n1,1,2\n2,1,3\n",
        "x_mm,y_mm,value_\n0,0,1\n2,0,2\n4,0,3\n"};
    luxel_field *fields[5];
    for (int i = 0; i < 5; i++) {
        fields[i] = field_of_csv(texts[i]);
        luxel_status expected = i < 2 ? LUXEL_OK : LUXEL_ERROR_ARGUMENT;
        luxel_comparison made;
        assert_int_equal(luxel_compare(fields[0], fields[i], NULL, &made, NULL), expected);
        assert_int_equal(luxel_compare(fields[i], fields[0], NULL, &made, NULL), expected);
    }
    for (int i = 0; i < 5; i++)
        luxel_field_free(fields[i]);
}

static void test_refused(void **state)
{
    (void)state;
    const double six[] = {1, 2, 3, 4, 5, 6};
    luxel_field *wide = csv_field(six, 2, 3), *tall = csv_field(six, 3, 2), *difference = NULL;
    luxel_comparison made;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    assert_int_equal(luxel_compare(wide, tall, diagnostics, &made, &difference), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_null(difference);
    luxel_diagnostics_free(diagnostics);
    luxel_field_free(wide);
    luxel_field_free(tall);
}

/* A .npy file, which knows neither places nor what is a surface, with these four values. */
static luxel_field *npy_field(const double *values)
{
    static const char head[] = "\x93NUMPY\1\0@\0{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }     ";
    char path[] = "/tmp/luxel-compare-XXXXXX.npy";
    int descriptor = mkstemps(path, 4);
    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, head, sizeof head - 1), 10 + '@');
    assert_int_equal(write(descriptor, values, 4 * sizeof *values), 4 * sizeof *values);
    close(descriptor);
    luxel_field *field = NULL;
    assert_int_equal(luxel_field_read(path, NULL, &field), LUXEL_OK);
    unlink(path);
    return field;
}

/* Files may hold what no rendering gives: NaN and infinity are told with their place, by all that reads values off. */
static void test_not_finite(void **state)
{
    (void)state;
    const double finite[] = {1, 2, 3, 4}, odd[] = {1, 2, (double)INFINITY, 4}, none[] = {1, NONE, 3, 4};
    luxel_field *good = npy_field(finite), *bad[] = {npy_field(odd), npy_field(none)};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_comparison made;
    luxel_summary summary;
    luxel_histogram *histogram = NULL;
    for (int i = 0; i < 2; i++) {
        assert_int_equal(luxel_compare(good, bad[i], diagnostics, &made, NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_compare(bad[i], good, diagnostics, &made, NULL), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_field_summary(bad[i], NULL, diagnostics, &summary), LUXEL_ERROR_ARGUMENT);
        assert_int_equal(
            luxel_field_histogram(bad[i], NULL, LUXEL_HISTOGRAM_LINEAR, NONE, NONE, 4, diagnostics, &histogram),
            LUXEL_ERROR_ARGUMENT);
        assert_int_equal(luxel_diagnostics_count(diagnostics), 4);
        for (size_t k = 0; k < 4; k++) {
            char *message = luxel_diagnostics_message(diagnostics, k, NULL, NULL);
            assert_string_equal(luxel_diagnostics_get(diagnostics, k)->id, "not-finite");
            assert_non_null(strstr(message, i == 0 ? "(0, 1)" : "(1, 0)"));
            luxel_text_free(message);
        }
        luxel_diagnostics_clear(diagnostics);
        luxel_field_free(bad[i]);
    }
    luxel_diagnostics_free(diagnostics);
    luxel_field_free(good);
}

/* Without places a region says nothing; pixels that lie elsewhere cannot be compared. */
static void test_no_places(void **state)
{
    (void)state;
    const double four[] = {1, 2, 3, 4};
    const luxel_region region = {.type = LUXEL_REGION_CIRCLE, .radius_mm = 5};
    luxel_field *nowhere = npy_field(four), *small = csv_field(four, 2, 2), *difference = NULL;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_comparison made;
    luxel_summary summary;
    assert_int_equal(luxel_field_summary(nowhere, &region, diagnostics, &summary), LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "no-places");
    assert_int_equal(luxel_compare(nowhere, small, NULL, &made, &difference), LUXEL_OK);
    assert_true(made.largest.value == 0 && luxel_field_x_mm(difference)[1] == 1);
    luxel_field_free(difference);

    luxel_diagnostics_clear(diagnostics);
    luxel_scene *scene = NULL;
    luxel_field *large = NULL;
    assert_int_equal(luxel_scene_open_builtin("report", NULL, &scene), LUXEL_OK);
    assert_int_equal(luxel_scene_set(scene, "screen={width: 50, height: 75, resolution: [2, 3]}", NULL), LUXEL_OK);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    assert_int_equal(luxel_render(scene, NULL, NULL, &large), LUXEL_OK);
    assert_int_equal(luxel_compare(large, small, diagnostics, &made, NULL), LUXEL_ERROR_ARGUMENT);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "not-comparable");
    char *words = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
    assert_string_equal(words, "the pictures differ in their resolution: 2 x 3 and 2 x 2 pixels");
    luxel_text_free(words);
    luxel_field_free(large);
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    luxel_field_free(small);
    luxel_field_free(nowhere);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_numbers), cmocka_unit_test(test_symmetry), cmocka_unit_test(test_guesses),
        cmocka_unit_test(test_places),        cmocka_unit_test(test_refused),  cmocka_unit_test(test_not_finite),
        cmocka_unit_test(test_no_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
