/* SPDX-License-Identifier: MIT */
/* Dates have days and times; another time of a day leaves what else is written as it was. */
#include "../../app/base/date.h"

#include "scenes.h"

static void test_days(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"2026-03-21T12:00+01:00", "2026-03-21+01:00"},
                                           {"2026-03-21T12:00-03:30", "2026-03-21-03:30"},
                                           {"2026-03-21T12:00", "2026-03-21"},
                                           {"2026-03-21T12:00Z", "2026-03-21"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        char *day = app_date_day(cases[i][0]);
        assert_string_equal(day, cases[i][1]);
        g_free(day);
    }
}

static void test_times(void **state)
{
    (void)state;
    static const struct {
        const char *date;
        int minutes, to;
        const char *moved;
    } cases[] = {
        {"2026-03-21T12:05+01:00", 725, 0, "2026-03-21T00:00+01:00"},
        {"2026-03-21 09:30:45-03:30", 570, 1439, "2026-03-21 23:59-03:30"},
        {"2026-03-21T00:00Z", 0, 61, "2026-03-21T01:01Z"},
        {"2026-03-21T23:59", 1439, 600, "2026-03-21T10:00"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        char *moved = app_date_at(cases[i].date, cases[i].to);
        assert_int_equal(app_date_minutes(cases[i].date), cases[i].minutes);
        assert_string_equal(moved, cases[i].moved);
        g_free(moved);
    }
    static const char *const none[] = {"", "2026-03-21", "2026-03-21+01:00", "noon", "21.3.2026 12:00", "2026-03-21T"};
    for (gsize i = 0; i < G_N_ELEMENTS(none); i++)
        assert_true(app_date_minutes(none[i]) < 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_days), cmocka_unit_test(test_times)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
