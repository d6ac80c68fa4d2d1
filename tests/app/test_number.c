/* SPDX-License-Identifier: MIT */
/* Numbers as people type and paste them, in any language, and writing them back. */
#include <math.h>
#include <string.h>

#include "../../app/base/number.h"
#include "scenes.h"

#define NBSP "\u00a0"
#define THIN "\u2009"
#define NARROW "\u202f"
#define MINUS "\u2212"

static void reads_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
    } cases[] = {
        {"0.45", 0.45},
        {"0,45", 0.45},
        {".5", 0.5},
        {",5", 0.5},
        {"5,", 5},
        {"+5", 5},
        {"-2", -2},
        {MINUS "2", -2},
        {MINUS "0,5", -0.5},
        {"1e3", 1000},
        {"1,5E" MINUS "2", 0.015},
        {"  7 ", 7},
        {"\t7" NBSP, 7},
        {NARROW "7", 7},
        {"10 000", 10000},
        {"10" NBSP "000" NBSP "000", 1e7},
        {"1" THIN "234,5", 1234.5},
        {"-1" NARROW "000", -1000},
        {"1e-400", 0},
        {"00012", 12},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double value = (double)NAN;
        if (!app_number_read(cases[i].text, &value))
            fail_msg("\"%s\" was refused", cases[i].text);
        assert_true(value == cases[i].value);
    }
}

static void refuses_the_rest(void **state)
{
    (void)state;
    static const char *const cases[] = {
        "",    " ",   "a",   "1a",  "1,2,3", "1.2.3", "1,000.5", "1.000,5", "1 2",  "10 00", "10 0000", "1  000", "- 5",
        "--5", "+-5", "1-2", "e5",  "1e",    "1e 5",  "0x10",    "inf",     "nan",  "NaN",   "1e999",   "-1e999", ".",
        ",",   "-",   MINUS, "1;2", "[1]",   "1_000", "1'000",   "\u0661",  "1\n2", "5 mm",  NBSP,      "1e5.5"};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double value = 42;
        if (app_number_read(cases[i], &value))
            fail_msg("\"%s\" was read as %g", cases[i], value);
        assert_true(value == 42);
    }
}

static void writes_what_reads_back(void **state)
{
    (void)state;
    GRand *random = g_rand_new_with_seed(2);
    char text[APP_NUMBER_SIZE];
    for (int i = 0; i < 100000; i++) {
        union {
            guint64 bits;
            double value;
        } any = {.bits = (guint64)g_rand_int(random) << 32 | g_rand_int(random)};
        double value = i % 2 ? any.value : g_rand_int_range(random, -1000000, 1000000) / 1000.0, read;
        if (!isfinite(value))
            continue;
        assert_ptr_equal(app_number_write(value, text), text);
        if (!app_number_read(text, &read) || read != value)
            fail_msg("%a became %s", value, text);
    }
    g_rand_free(random);
}

static void writes_short(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } cases[] = {{0.1, "0.1"},    {0.3, "0.3"},   {-0.0, "0"},        {150, "150"},
                 {1e-3, "0.001"}, {-2.5, "-2.5"}, {123456, "123456"}, {0.1 + 0.2, "0.30000000000000004"}};
    char text[APP_NUMBER_SIZE];
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++)
        assert_string_equal(app_number_write(cases[i].value, text), cases[i].text);
    assert_string_equal(app_number_round(0.30000000000000004, 12, text), "0.3");
    assert_string_equal(app_number_round(1234.5678, 3, text), "1.23e+03");
    assert_string_equal(app_number_round(99.96, 3, text), "100");
    assert_string_equal(app_number_round(-0.0, 3, text), "0");
}

/* ---- lists ---- */

static void expect_list(const char *text, gsize size, const double *expected, gsize wanted)
{
    gsize count = 0;
    char *fault = NULL;
    double *numbers = app_numbers_read(text, size, &count, &fault);
    if (!numbers)
        fail_msg("\"%s\": \"%s\" was refused", text, fault);
    assert_null(fault);
    assert_int_equal(count, wanted);
    for (gsize i = 0; i < count * size; i++)
        if (numbers[i] != expected[i])
            fail_msg("\"%s\": number %zu is %g", text, i, numbers[i]);
    g_free(numbers);
}

static void reads_lists(void **state)
{
    (void)state;
    const double whole[] = {1, 2, 3, 4, 5, 6}, halves[] = {0.5, -1.5, 2, 3.5, 4.25, 5};
    static const char *const of_whole[] = {
        "1,2,3; 4,5,6",     "1, 2, 3;4, 5, 6;", "1,2,3\n4,5,6\n",       "\n\n1,2,3\r\n4,5,6\r\n\r\n",
        "1 2 3\n4 5 6",     "1\t2\t3\n4\t5\t6", "[1, 2, 3]; [4, 5, 6]", "[[1, 2, 3];\n[4, 5, 6]]",
        "(1 2 3)\n(4 5 6)", "1;2;3\n4;5;6",     "{1,2,3};{4,5,6}",
    };
    static const char *const of_halves[] = {
        "0.5,-1.5,2; 3.5,4.25,5",     "0,5 -1,5 2; 3,5 4,25 5",           "0,5\t-1,5\t2\n3,5\t4,25\t5",
        "0,5; -1,5; 2\n3,5; 4,25; 5", "0,5;" MINUS "1,5;2\n3,5;4,25;5\n", "0.5 " MINUS "1.5 2.0\n3.5 4.25 5e0",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(of_whole); i++)
        expect_list(of_whole[i], 3, whole, 2);
    for (gsize i = 0; i < G_N_ELEMENTS(of_halves); i++)
        expect_list(of_halves[i], 3, halves, 2);
    const double pairs[] = {1000, -2, 3, 4};
    expect_list("1000, -2; 3, 4", 2, pairs, 2);
    expect_list("1" NBSP "000, -2\n3 4", 2, pairs, 2);
    expect_list("1000;-2\n3;4", 2, pairs, 2);
    expect_list("1000", 1, pairs, 1);
}

static void names_the_fault_of_a_list(void **state)
{
    (void)state;
    static const struct {
        const char *text, *fault;
        gsize size;
    } cases[] = {
        {"1,2,3; 4,5", "4,5", 3},
        {"1,2,3; 4,5,6,7", "4,5,6,7", 3},
        {"1,2; 3,x; 5,6", "3,x", 2},
        {"", "", 2},
        {" ;\n; ", "", 2},
        {"word", "word", 1},
        {"1,2,3\n[4, nan, 6]", "4, nan, 6", 3},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        gsize count = 7;
        char *fault = NULL;
        assert_null(app_numbers_read(cases[i].text, cases[i].size, &count, &fault));
        assert_non_null(fault);
        assert_string_equal(fault, cases[i].fault);
        g_free(fault);
    }
}

static void reads_pairs(void **state)
{
    (void)state;
    static const char *const good[] = {"1.5, -20",   "1.5 -20", "1,5 -20",           "1,5; -20",     "1.5;-20",
                                       "[1.5, -20]", "1.5,-20", "(1,5 " MINUS "20)", " 1,5 ;  -20 ", "1.5\t-20"};
    static const char *const bad[] = {"", "1", "1, 2, 3", "1; 2; 3", "a, b", "1.5, ", "1 2 3", ";", "1;", "1, nan"};
    double pair[2] = {0};
    for (gsize i = 0; i < G_N_ELEMENTS(good); i++) {
        if (!app_pair_read(good[i], pair))
            fail_msg("\"%s\" was refused", good[i]);
        assert_true(pair[0] == 1.5 && pair[1] == -20);
    }
    for (gsize i = 0; i < G_N_ELEMENTS(bad); i++) {
        double kept[2] = {7, 7};
        if (app_pair_read(bad[i], kept))
            fail_msg("\"%s\" was read as %g, %g", bad[i], kept[0], kept[1]);
        assert_true(kept[0] == 7 && kept[1] == 7);
    }
    /* 60.5, or 60 and 5?  Who types it is asked */
    assert_true(!app_pair_read("60,5", pair) && !app_pair_read(" -60,5", pair) && !app_pair_read("[1,5]", pair));
    assert_true(app_pair_read("60.5,5", pair) && pair[0] == 60.5 && pair[1] == 5);
}

static void reads_yaml_lists(void **state)
{
    (void)state;
    double numbers[6] = {0};
    assert_int_equal(app_list_read("[0, -1.5, 1e3]", numbers, 6), 3);
    assert_true(numbers[0] == 0 && numbers[1] == -1.5 && numbers[2] == 1000);
    assert_int_equal(app_list_read("[[1, 2, 3], [4, 5, 6]]", numbers, 6), 6);
    assert_true(numbers[0] == 1 && numbers[5] == 6);
    assert_int_equal(app_list_read("[[1, 2, 3], [4, 5, 6]]", numbers, 4), 4);
    assert_int_equal(app_list_read("42", numbers, 6), 1);
    assert_true(numbers[0] == 42);
    assert_int_equal(app_list_read("max", numbers, 6), 0);
    assert_int_equal(app_list_read("", numbers, 6), 0);
    assert_int_equal(app_list_read(NULL, numbers, 6), 0);
}

/* Digits as far as the bound goes, which is rounded up and covers what was rounded off the number. */
static void writes_amounts(void **state)
{
    (void)state;
    static const struct {
        double value, error;
        const char *text;
    } cases[] = {{208.3341, 0.0853, "208.334 \u00b1 0.086"},
                 {1.5, 0, "1.5 \u00b1 0"},
                 {0.00004, 0.0031, "0 \u00b1 0.0032"},
                 {12345678, 1, "1.234568e+07 \u00b1 3"},
                 {0.123456, 0.009999, "0.1235 \u00b1 0.011"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        char text[APP_AMOUNT_SIZE];
        const char *bound = strstr(app_amount_write(cases[i].value, cases[i].error, text), "\u00b1 ");
        assert_non_null(bound);
        const double number = g_ascii_strtod(text, NULL), error = g_ascii_strtod(bound + strlen("\u00b1 "), NULL);
        assert_true(fabs(number - cases[i].value) + cases[i].error <= error * (1 + 1e-12));
        assert_string_equal(text, cases[i].text);
    }
}

/* What is shown has the mark of the language, and lists that can be read with it; the last test, as the mark stays. */
static void shows_with_the_mark(void **state)
{
    (void)state;
    static const char text[] = "N = (P − C) / R = (0.2, −0.06666667, 3), lights[0].axis = 1.5, 2.5; v. 2 (see 3, 4)";
    char number[APP_NUMBER_SIZE], amount[APP_AMOUNT_SIZE], *shown = app_text_show(text);
    assert_string_equal(shown, "N = (P − C) / R = (0.2, −0.06666667, 3), lights[0].axis = 1.5, 2.5; v. 2 (see 3, 4)");
    g_free(shown);
    app_number_set_mark(',');
    shown = app_text_show(text);
    assert_string_equal(shown, "N = (P − C) / R = (0,2; −0,06666667; 3), lights[0].axis = 1,5, 2,5; v. 2 (see 3; 4)");
    g_free(shown);
    assert_string_equal(app_number_show(2.5, 4, number), "2,5");
    assert_string_equal(app_number_show(13361.7, 4, number), "13360");
    assert_string_equal(app_number_show(-99.96, 2, number), "\u2212100");
    assert_string_equal(app_number_show(1.5e7, 4, number), "1,5e+07");
    assert_string_equal(app_number_show_all(-1e-7, number), "-1e-07"); /* of fields */
    shown = app_text_show("x = -3.5, y = 1e-07, 2026-03-21, (-1, -2)");
    assert_string_equal(shown, "x = \u22123,5, y = 1e-07, 2026-03-21, (\u22121; \u22122)");
    g_free(shown);
    assert_string_equal(app_number_place(-12.25, 500, number), "\u221212,25");
    assert_string_equal(app_amount_write(208.3341, 0.0853, amount), "208,334 \u00b1 0,086");
    assert_string_equal(app_number_write(0.5, number), "0.5"); /* of scenes */
    assert_string_equal(app_number_separator(), "; ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_numbers),
        cmocka_unit_test(refuses_the_rest),
        cmocka_unit_test(writes_short),
        cmocka_unit_test(writes_amounts),
        cmocka_unit_test(writes_what_reads_back),
        cmocka_unit_test(reads_lists),
        cmocka_unit_test(names_the_fault_of_a_list),
        cmocka_unit_test(reads_pairs),
        cmocka_unit_test(reads_yaml_lists),
        cmocka_unit_test(shows_with_the_mark),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
