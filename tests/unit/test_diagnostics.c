/* SPDX-License-Identifier: MIT */
/* The diagnostics object: what it keeps and counts, places, excerpts, translation. */
#include <stdio.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/diagnostics.h"

static struct lx_place place_of(const char *text, const char *part)
{
    const char *at = strstr(text, part);
    assert_non_null(at);
    size_t start = (size_t)(at - text);
    return (struct lx_place){"a.yaml", text, strlen(text), start, start + strlen(part), "some.key", 0, 0};
}

static void places(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_place place = place_of("one\r\ntwo\rthree é wrong!\nfour", "wrong");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_UNKNOWN_KEY, LX_ARGS("x", "y"));
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, 0);
    assert_string_equal(entry->id, "unknown-key");
    assert_string_equal(entry->source, "a.yaml");
    assert_string_equal(entry->key, "some.key");
    assert_int_equal(entry->line, 3);
    assert_int_equal(entry->column, 9);
    assert_string_equal(entry->excerpt, "three é wrong!");
    assert_int_equal(entry->mark_offset, 8);
    assert_int_equal(entry->mark_length, 5);
    luxel_diagnostics_free(diagnostics);
}

static void places_at_the_end(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_place empty = {"a", "", 0, 0, 0, NULL, 0, 0}, beyond = {"a", "x\n", 2, 50, 60, NULL, 0, 0};
    struct lx_place marked = {"a", "\xEF\xBB\xBFkey", 6, 3, 6, NULL, 0, 0};
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &empty, LX_MSG_NO_MAPPING, NULL);
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &beyond, LX_MSG_NO_MAPPING, NULL);
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &marked, LX_MSG_NO_MAPPING, NULL);
    static const unsigned wanted[3][3] = {{1, 1, 1}, {2, 1, 1}, {1, 1, 3}};
    for (size_t i = 0; i < 3; i++) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, i);
        assert_int_equal(entry->line, wanted[i][0]);
        assert_int_equal(entry->column, wanted[i][1]);
        assert_int_equal(entry->mark_length, wanted[i][2]);
    }
    luxel_diagnostics_free(diagnostics);
}

static void cuts_long_lines(void **state)
{
    (void)state;
    static char text[100001];
    memset(text, 'a', sizeof text - 1);
    memcpy(text + 50000, "wrong", 5);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_place place = place_of(text, "wrong");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_NO_MAPPING, NULL);
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, 0);
    assert_int_equal(entry->column, 50001);
    assert_true(strlen(entry->excerpt) < 130);
    assert_memory_equal(entry->excerpt, "…", 3);
    assert_memory_equal(entry->excerpt + 3 + entry->mark_offset - 1, "wrong", 5);
    luxel_diagnostics_free(diagnostics);
}

static void escapes_what_it_shows(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_place place = place_of("\tab\x1B[0m", "\x1B[0m");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_UNKNOWN_KEY, LX_ARGS("", "\x1B[2J"));
    const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, 0);
    assert_string_equal(entry->excerpt, "\\tab\\x1B[0m");
    assert_int_equal(entry->mark_offset, 4);
    assert_int_equal(entry->mark_length, 7);
    char *message = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
    assert_string_equal(message, "unknown key \"\\x1B[2J\"");
    luxel_text_free(message);
    luxel_diagnostics_free(diagnostics);
}

static void keeps_twenty(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    for (int i = 0; i < 50; i++) {
        char number[12];
        snprintf(number, sizeof number, "%d", i);
        lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_UNKNOWN_KEY, LX_ARGS("", number));
        lx_hint(diagnostics, LX_MSG_DID_YOU_MEAN, LX_ARGS(number));
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_NOT_USED, LX_ARGS("a", "b", "c"));
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR), 50);
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ADVICE), 1);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 21);
    assert_null(luxel_diagnostics_get(diagnostics, 21));
    assert_null(luxel_diagnostics_message(diagnostics, 21, NULL, NULL));
    char *hint = luxel_diagnostics_hint(diagnostics, 19, NULL, NULL);
    assert_string_equal(hint, "did you mean \"19\"?"); /* and not that of an entry that was not kept */
    luxel_text_free(hint);
    hint = luxel_diagnostics_hint(diagnostics, 20, NULL, NULL);
    assert_string_equal(hint, "");
    luxel_text_free(hint);
    luxel_diagnostics_clear(diagnostics);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 0);
    assert_int_equal(luxel_diagnostics_total(diagnostics, LUXEL_SEVERITY_ERROR), 0);
    luxel_diagnostics_free(diagnostics);
}

static const char *backwards(const char *english, void *data)
{
    assert_string_equal(english, "{0} has no effect with {1} {2}");
    return data;
}

static void translates(void **state)
{
    (void)state;
    char template[] = "{2} {1} -> {0}; {9} {x}";
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    lx_report(diagnostics, LUXEL_SEVERITY_ADVICE, NULL, LX_MSG_NOT_USED, LX_ARGS("k", "law", "{0}"));
    char *message = luxel_diagnostics_message(diagnostics, 0, backwards, template);
    assert_string_equal(message, "{0} law -> k; {9} {x}");
    luxel_text_free(message);
    luxel_diagnostics_free(diagnostics);
}

static void accepts_null(void **state)
{
    (void)state;
    lx_report(NULL, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_NO_MAPPING, NULL);
    lx_hint(NULL, LX_MSG_HINT_EXAMPLE, NULL);
    luxel_diagnostics_clear(NULL);
    luxel_diagnostics_free(NULL);
    assert_int_equal(luxel_diagnostics_count(NULL), 0);
    assert_int_equal(luxel_diagnostics_total(NULL, LUXEL_SEVERITY_ERROR), 0);
    assert_null(luxel_diagnostics_get(NULL, 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places),          cmocka_unit_test(places_at_the_end),
        cmocka_unit_test(cuts_long_lines), cmocka_unit_test(escapes_what_it_shows),
        cmocka_unit_test(keeps_twenty),    cmocka_unit_test(translates),
        cmocka_unit_test(accepts_null),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
