/* SPDX-License-Identifier: MIT */
/* Position indices: the table of CIE 117 against the fit to the same measurements, its course, and where both end. */
#include <math.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/glare.h"

static void is_near_the_fit(void **state)
{
    (void)state;
    double worst = 0;
    for (double aside = 0; aside <= 3; aside += 0.01)
        for (double above = 0; above <= 1.7; above += 0.01) {
            double of_table = lx_position_index_of_table(1, aside, above);
            worst = fmax(worst, fabs(of_table / lx_position_index(1, aside, above) - 1));
            assert_true(of_table == lx_position_index_of_table(1, -aside, above));
        }
    assert_true(worst > 0.05 && worst < 0.105);
    assert_true(lx_position_index_of_table(1, 0.3, 0.3) < 1.9 && lx_position_index_of_table(1, 2.7, 0.6) < 7.1);
    assert_true(fabs(lx_position_index_of_table(2, 1, 2) - 6.4) < 1e-14);
    assert_true(fabs(lx_position_index_of_table(2, 1, 2.1) - 6.85) < 1e-14);
}

/* A number that were misread would break the course of its row or of its column. */
static void goes_on_evenly(void **state)
{
    (void)state;
    for (int i = 0; i <= 30; i++)
        for (int j = 1; j <= 16; j++) {
            double before = lx_position_index_of_table(10, i, j - 1), here = lx_position_index_of_table(10, i, j),
                   after = lx_position_index_of_table(10, i, j + 1);
            assert_true(before < here && here < after);
            assert_true(fabs(before - 2 * here + after) < 0.1 * here);
        }
    for (int j = 0; j <= 17; j++)
        for (int i = 1; i <= 29; i++) {
            double before = lx_position_index_of_table(10, i - 1, j), here = lx_position_index_of_table(10, i, j),
                   after = lx_position_index_of_table(10, i + 1, j);
            assert_true(fabs(before - 2 * here + after) < 0.1 * here);
        }
}

static void ends(void **state)
{
    (void)state;
    assert_true(lx_position_index_of_table(1, 0, 0) == 1);
    assert_true(isnan(lx_position_index_of_table(0, 0, 1)));
    assert_true(isnan(lx_position_index_of_table(-1, 0, 0.5)));
    assert_true(isnan(lx_position_index_of_table(1, 0, -0.1)));
    assert_true(isnan(lx_position_index_of_table(1, 3.01, 0)) && isnan(lx_position_index(1, 3.01, 0)));
    assert_true(isnan(lx_position_index_of_table(1, 2, 1.91)) && isnan(lx_position_index(1, 2, 1.91)));
    assert_true(fabs(lx_position_index_of_table(1, 3, 1.9) - 16) < 1e-13);
    assert_true(fabs(lx_position_index_of_table(1, 0, 1.7) - 16.2) < 1e-13);
    assert_true(isnan(lx_position_index_of_table(1, 0, 1.75))); /* the table leaves these out */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(is_near_the_fit), cmocka_unit_test(goes_on_evenly),
                                       cmocka_unit_test(ends)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
