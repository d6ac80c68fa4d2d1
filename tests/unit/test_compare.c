/* SPDX-License-Identifier: MIT */
/* Comparing fields: numbers known by hand, masks that differ, the field of differences, and what is refused. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_numbers),
        cmocka_unit_test(test_symmetry),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
