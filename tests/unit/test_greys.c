/* SPDX-License-Identifier: MIT */
/* Grey levels: every range and rounding, 8 and 16 bits, either precision, off the surface and beyond the ends. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "field/field.h"

enum { COLUMNS = 5, ROWS = 2, PIXELS = COLUMNS * ROWS };

/* The last but one is off the surface. */
static double values[PIXELS] = {0.02, 7, 3.5, 0.35, 0.0007, 1.9, 0.00035, 6.99, 100, 0.25};
static float singles[PIXELS];
static uint8_t mask[PIXELS] = {1, 1, 1, 1, 1, 1, 1, 1, 0, 1};

static struct luxel_field field_of(struct lx_choice_or_pair range, int rounding, bool is_double)
{
    for (int i = 0; i < PIXELS; i++)
        singles[i] = (float)values[i];
    return (struct luxel_field){.columns = COLUMNS,
                                .rows = ROWS,
                                .precision = is_double ? LUXEL_DOUBLE : LUXEL_SINGLE,
                                .values = is_double ? (void *)values : (void *)singles,
                                .mask = mask,
                                .picture = {.range = range, .rounding = rounding},
                                .statistics = {.maximum = {.exists = true, .value = 7}}};
}

/* The share of white, by the manual. */
static double share_of(struct lx_choice_or_pair range, double value)
{
    switch (range.choice) {
    case LX_RANGE_MAX: return value / 7;
    case LX_RANGE_MINMAX: return (value - 0.00035) / (7 - 0.00035);
    case LX_RANGE_LOG: return (log10(value) - log10(7 / 1e4)) / 4; /* four decades */
    default: return (value - range.low) / (range.high - range.low);
    }
}

static void levels(void **state)
{
    static const struct lx_choice_or_pair ranges[] = {{.choice = LX_RANGE_MAX},
                                                      {.choice = LX_RANGE_MINMAX},
                                                      {.choice = LX_RANGE_LOG},
                                                      {.choice = -1, .low = 0.3, .high = 5},
                                                      {.choice = -1, .low = 0, .high = 20}};
    (void)state;
    for (size_t r = 0; r < sizeof ranges / sizeof *ranges; r++)
        for (int nearest = 0; nearest < 2; nearest++)
            for (int is_double = 0; is_double < 2; is_double++) {
                struct luxel_field field = field_of(ranges[r], nearest ? LX_NEAREST : LX_TRUNCATE, is_double);
                uint8_t bytes[PIXELS];
                uint16_t words[PIXELS];
                luxel_field_grey(&field, bytes);
                luxel_field_grey16(&field, words);
                for (int i = 0; i < PIXELS; i++) {
                    double share =
                        mask[i] ? fmin(fmax(share_of(ranges[r], is_double ? values[i] : (double)singles[i]), 0), 1) : 0;
                    double small = 255 * share, large = 65535 * share;
                    assert_int_equal(bytes[i], nearest ? (int)floor(small + 0.5) : (int)floor(small * (1 + 1e-12)));
                    assert_int_equal(words[i], nearest ? (int)floor(large + 0.5) : (int)floor(large * (1 + 1e-12)));
                }
                assert_int_equal(lx_greys_wait(&field), ranges[r].choice != -1);
            }
}

/* A range without width: what gives light is white. */
static void no_width(void **state)
{
    static const double dark[PIXELS] = {0}, alike[PIXELS] = {3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
    uint8_t bytes[PIXELS];
    (void)state;
    struct luxel_field field = field_of((struct lx_choice_or_pair){.choice = LX_RANGE_MINMAX}, LX_NEAREST, true);
    field.values = (void *)(uintptr_t)alike;
    field.statistics.maximum.value = 3;
    luxel_field_grey(&field, bytes);
    for (int i = 0; i < PIXELS; i++)
        assert_int_equal(bytes[i], mask[i] ? 255 : 0);
    for (int range = LX_RANGE_MAX; range <= LX_RANGE_LOG; range++) {
        field.picture.range.choice = range;
        field.values = (void *)(uintptr_t)dark;
        field.statistics.maximum.value = 0;
        luxel_field_grey(&field, bytes);
        for (int i = 0; i < PIXELS; i++)
            assert_int_equal(bytes[i], 0);
    }
}

/* The least value is that of a surface, and is looked for where black depends on it alone. */
static void least(void **state)
{
    (void)state;
    struct luxel_field field = field_of((struct lx_choice_or_pair){.choice = LX_RANGE_MINMAX}, LX_NEAREST, true);
    struct lx_strip strip = lx_whole_strip(&field);
    assert_true(lx_greys_least(&field, &strip) == 0.00035);
    strip.rows = 1;
    assert_true(lx_greys_least(&field, &strip) == 0.0007);
    field.picture.range.choice = LX_RANGE_MAX;
    assert_true(lx_greys_least(&field, &strip) == HUGE_VAL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels),
        cmocka_unit_test(no_width),
        cmocka_unit_test(least),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
