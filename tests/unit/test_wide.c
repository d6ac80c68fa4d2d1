/* SPDX-License-Identifier: MIT */
/* Wide numbers: each operation against results with twice its digits (wide_cases.h), quadrants, zeros, vectors. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/wide.h"

#include "wide_cases.h"

static lx_wide compute(const struct wide_case *entry)
{
    switch (entry->operation) {
    case ADD: return lx_wide_add(entry->a, entry->b);
    case SUB: return lx_wide_sub(entry->a, entry->b);
    case MUL: return lx_wide_mul(entry->a, entry->b);
    case DIV: return lx_wide_div(entry->a, entry->b);
    case SQRT: return lx_wide_sqrt(entry->a);
    case ATAN2: return lx_wide_atan2(entry->a, entry->b);
    case LOG: return lx_wide_log(entry->a);
    case ATANH: break;
    }
    return lx_wide_atanh(entry->a);
}

/* |a - b| where both are nearly the same, all parts taken into account. */
static double distance(lx_wide a, const double b[3])
{
    return fabs(((a.high - b[0]) + (a.low - b[1])) - b[2]);
}

static void operations(void **unused)
{
    (void)unused;
    for (size_t i = 0; i < sizeof wide_cases / sizeof *wide_cases; i++) {
        const struct wide_case *entry = &wide_cases[i];
        lx_wide found = compute(entry);
        double off = distance(found, entry->result);
        if (!(off <= LX_WIDE_ROUNDING * fabs(entry->result[0])))
            fail_msg("case %zu, operation %d: off by 2^%g of the result", i, (int)entry->operation,
                     log2(off / fabs(entry->result[0])));
        /* the parts do not overlap */
        assert_true(found.high + found.low == found.high);
    }
}

static void assert_angle(double y, double x, lx_wide expected)
{
    lx_wide found = lx_wide_atan2(lx_wide_of(y), lx_wide_of(x));
    assert_true(distance(found, (const double[]){expected.high, expected.low, 0}) <=
                LX_WIDE_ROUNDING * fabs(expected.high));
}

static void quadrants(void **unused)
{
    lx_wide pi = lx_wide_pi(), half = lx_wide_scale(pi, 0.5), quarter = lx_wide_scale(pi, 0.25);
    (void)unused;
    assert_true(pi.high == 0x1.921fb54442d18p+1 && pi.low == 0x1.1a62633145c07p-53);
    assert_angle(0, 0, lx_wide_of(0));
    assert_angle(0, 1, lx_wide_of(0));
    assert_angle(0, -1, pi);
    assert_angle(1, 0, half);
    assert_angle(-1, 0, lx_wide_negate(half));
    assert_angle(1, 1, quarter);
    assert_angle(-1, 1, lx_wide_negate(quarter));
    assert_angle(1, -1, lx_wide_add(half, quarter));
    assert_angle(-1, -1, lx_wide_negate(lx_wide_add(half, quarter)));
    assert_angle(1e-120, 1, lx_wide_of(1e-120));
    assert_angle(-1e-120, 1e120, lx_wide_div(lx_wide_of(-1e-120), lx_wide_of(1e120)));
    assert_angle(1e-120, -1, pi);
    assert_angle(1, -1e-120, half);
}

static void zeros_and_order(void **unused)
{
    lx_wide zero = lx_wide_of(0), one = lx_wide_of(1), more = {1, 0x1p-80};
    (void)unused;
    assert_true(lx_wide_sqrt(zero).high == 0 && lx_wide_sqrt(lx_wide_of(-1)).high == 0);
    assert_true(lx_wide_log(one).high == 0 && lx_wide_log(one).low == 0);
    assert_true(lx_wide_atanh(zero).high == 0);
    assert_true(lx_wide_add(one, lx_wide_negate(one)).high == 0);
    assert_int_equal(lx_wide_compare(one, more), -1);
    assert_int_equal(lx_wide_compare(more, one), 1);
    assert_int_equal(lx_wide_compare(more, more), 0);
    assert_true(lx_wide_value(lx_wide_scale(more, 0.25)) == 0.25);
    assert_true(lx_wide_sub(more, one).high == 0x1p-80);
}

static void vectors(void **unused)
{
    (void)unused;
    lx_wide3 a = lx_wide3_of((const double[]){0.1, -2.5, 1e-7}), b = lx_wide3_of((const double[]){3, 0.7, -11});
    lx_wide3 c = lx_wide3_cross(a, b);
    double size = lx_wide3_length(a).high * lx_wide3_length(b).high;
    assert_true(fabs(lx_wide3_dot(a, c).high) <= 8 * LX_WIDE_ROUNDING * size * lx_wide3_length(a).high);
    assert_true(fabs(lx_wide3_dot(b, c).high) <= 8 * LX_WIDE_ROUNDING * size * lx_wide3_length(b).high);
    /* |a x b|^2 + (a.b)^2 = |a|^2 |b|^2 */
    lx_wide dot = lx_wide3_dot(a, b), left = lx_wide_add(lx_wide3_dot(c, c), lx_wide_mul(dot, dot));
    lx_wide right = lx_wide_mul(lx_wide3_dot(a, a), lx_wide3_dot(b, b));
    assert_true(fabs(lx_wide_sub(left, right).high) <= 32 * LX_WIDE_ROUNDING * size * size);
    lx_wide3 unit = lx_wide3_unit(a);
    assert_true(fabs(lx_wide_sub(lx_wide3_length(unit), lx_wide_of(1)).high) <= 8 * LX_WIDE_ROUNDING);
    lx_wide3 back = lx_wide3_sub(lx_wide3_add(lx_wide3_mul(unit, lx_wide3_length(a)), b), b);
    assert_true(lx_wide3_length(lx_wide3_sub(back, a)).high <= 0x1p-90);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations),
        cmocka_unit_test(quadrants),
        cmocka_unit_test(zeros_and_order),
        cmocka_unit_test(vectors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
