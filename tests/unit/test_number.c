/* SPDX-License-Identifier: MIT */
/* Numbers as text: the grammar, the shortest form, and independence from the locale. */
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/number.h"

static void reads(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
    } good[] = {{"0", 0},
                {"-0", 0},
                {"12", 12},
                {"+3", 3},
                {"0.1", 0.1},
                {".5", 0.5},
                {"5.", 5},
                {"-1e3", -1e3},
                {"1E+3", 1e3},
                {"1.5e-3", 1.5e-3},
                {"007", 7},
                {"1e-999", 0},
                {"1.7976931348623157e308", DBL_MAX},
                {"5e-324", 4.9406564584124654e-324}};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        double value = -1;
        assert_true(lx_read_number(good[i].text, strlen(good[i].text), &value));
        assert_true(value == good[i].value);
    }
    static const char *const bad[] = {"",    "+",   "-",     ".",    "e5",   "1e",    "1e+",    "0x10", "1_000",
                                      "1,5", "nan", "inf",   ".nan", ".inf", "1e999", "-1e999", " 1",   "1 ",
                                      "1 2", "--1", "1.2.3", "0b1",  "1f",   "1:30",  "true"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        double value = 7;
        assert_false(lx_read_number(bad[i], strlen(bad[i]), &value));
        assert_true(value == 7);
    }
    double value;
    assert_true(lx_read_number("125", 2, &value)); /* only the first two */
    assert_true(value == 12);
}

static void reads_long_numbers(void **state)
{
    (void)state;
    char text[2000];
    memset(text, '0', sizeof text);
    text[1] = '.';
    text[1500] = '1';
    double value = 1;
    assert_true(lx_read_number(text, sizeof text, &value));
    assert_true(value == 0);
    memset(text, '9', sizeof text);
    assert_false(lx_read_number(text, sizeof text, &value));
    assert_true(lx_looks_like_number(text, sizeof text));
}

/* Around the greatest whole number below which all are float64 numbers, one rounding must do. */
static void reads_at_the_limit(void **state)
{
    (void)state;
    for (uint64_t digits = (UINT64_C(1) << 53) - 60; digits <= (UINT64_C(1) << 53) + 60; digits++)
        for (int places = 0; places <= 16; places++) {
            char text[64], whole[32];
            snprintf(whole, sizeof whole, "%llu", (unsigned long long)digits);
            snprintf(text, sizeof text, "%.*s.%se%d", 16 - places, whole, whole + (16 - places), places % 3 - 1);
            double value = -1;
            assert_true(lx_read_number(text, strlen(text), &value));
            if (value != strtod(text, NULL))
                fail_msg("%s: %.17g", text, value);
        }
}

/* Numbers of few and of many digits as the C library reads them, to the last bit. */
static void reads_as_the_library(void **state)
{
    (void)state;
    uint64_t bits = 88172645463325252u;
    for (int i = 0; i < 500000; i++) {
        char text[64];
        bits ^= bits << 13, bits ^= bits >> 7, bits ^= bits << 17;
        uint64_t digits = (bits >> 20) >> (bits % 44);
        int places = (int)(bits >> 8 & 15), exponent = (int)(bits >> 12 & 63) - 32;
        int used = snprintf(text, sizeof text, "%s%llu.%0*llu", bits & 64 ? "-" : "", (unsigned long long)digits,
                            places + 1, (unsigned long long)(bits & 63));
        if (bits & 128)
            snprintf(text + used, sizeof text - (size_t)used, "e%d", exponent);
        double value = 7, expected = strtod(text, NULL);
        assert_true(lx_read_number(text, strlen(text), &value));
        assert_memory_equal(&value, &expected, sizeof value);
    }
    static const char *const edges[] = {"9007199254740991",
                                        "9007199254740992",
                                        "9007199254740993",
                                        "9007199254740999",
                                        "900719925474099e1",
                                        "1e22",
                                        "1e23",
                                        "1e-22",
                                        "1e-23",
                                        "-0",
                                        "-0e99",
                                        "0.0e-400",
                                        "123456789012345e22"};
    for (size_t i = 0; i < sizeof edges / sizeof edges[0]; i++) {
        double value = 7, expected = strtod(edges[i], NULL);
        assert_true(lx_read_number(edges[i], strlen(edges[i]), &value));
        assert_memory_equal(&value, &expected, sizeof value);
    }
}

static void writes_shortest(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},
                 {300, "300"},
                 {1e-7, "1e-07"},
                 {-2.5, "-2.5"},
                 {1.0 / 3, "0.3333333333333333"},
                 {0, "0"},
                 {DBL_MAX, "1.7976931348623157e+308"},
                 {4.9406564584124654e-324, "5e-324"},
                 {1e22, "1e+22"}};
    char buffer[LX_NUMBER_SIZE];
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_string_equal(lx_write_number(cases[i].value, buffer), cases[i].text);
    uint64_t bits = 88172645463325252u;
    for (int i = 0; i < 20000; i++) {
        bits ^= bits << 13, bits ^= bits >> 7, bits ^= bits << 17;
        double value, back = 0;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        lx_write_number(value, buffer);
        assert_true(lx_read_number(buffer, strlen(buffer), &back));
        assert_memory_equal(&value, &back, sizeof value);
    }
    assert_string_equal(lx_write_digits(11.7475312, 6, buffer), "11.7475");
    assert_true(strlen(lx_write_digits(-DBL_MIN, 1000, buffer)) < LX_NUMBER_SIZE);
}

static void ignores_the_locale(void **state)
{
    (void)state;
    static const char *const locales[] = {"de_DE.UTF-8", "ru_RU.UTF-8", "fr_FR.UTF-8"};
    char before[100], buffer[LX_NUMBER_SIZE];
    strncpy(before, setlocale(LC_ALL, NULL), sizeof before - 1);
    before[sizeof before - 1] = 0;
    for (size_t i = 0; i < sizeof locales / sizeof locales[0]; i++) {
        if (!setlocale(LC_ALL, locales[i]))
            continue;
        double value = 0;
        assert_true(lx_read_number("1.5", 3, &value));
        assert_true(value == 1.5);
        assert_false(lx_read_number("1,5", 3, &value));
        assert_string_equal(lx_write_number(0.25, buffer), "0.25");
    }
    setlocale(LC_ALL, before);
}

/* Digits of a bound are not below it, and no smaller ones would do. */
static void rounds_bounds_up(void **state)
{
    (void)state;
    static const struct {
        double error;
        const char *text;
    } cases[] = {{0.0853, "0.086"},   {0.0041, "0.0041"}, {0.00411, "0.0042"}, {0.0996, "0.1"},
                 {9.91e-13, "1e-12"}, {1, "1"},           {1.0000001, "1.1"},  {0, "0"},
                 {5e-324, "4.9e-324"}};
    char text[LX_NUMBER_SIZE];
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_string_equal(lx_write_bound(cases[i].error, 2, text), cases[i].text);
    assert_true(isinf(lx_round_up(HUGE_VAL, 2)));
    uint64_t seed = 1;
    for (int i = 0; i < 20000; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        const double error = pow(10, (double)(seed >> 11) * 0x1p-53 * 600 - 300);
        const int digits = 1 + i % 4;
        const double shown = strtod(lx_write_bound(error, digits, text), NULL);
        assert_true(shown >= error && shown <= error * (1 + 1.000001 * pow(10, 1 - digits)));
    }
    assert_true(fabs(lx_error_of_shown("2.73", 2.7275, 0.001) - 0.0035) < 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads),
        cmocka_unit_test(reads_long_numbers),
        cmocka_unit_test(reads_at_the_limit),
        cmocka_unit_test(reads_as_the_library),
        cmocka_unit_test(writes_shortest),
        cmocka_unit_test(ignores_the_locale),
        cmocka_unit_test(rounds_bounds_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
