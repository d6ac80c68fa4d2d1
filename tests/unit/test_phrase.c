/* SPDX-License-Identifier: MIT */
/* Phrases: rendering in a language, nesting, and that nobody's text can be taken for one. */
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/diagnostics.h"

/* A language of a few words. */
static const char *translate(const char *english, void *data)
{
    static const char *const words[][2] = {
        {"mm", "мм"},
        {"{0} to {1}", "от {0} до {1}"},
        {"in {0}", "в {0}"},
        {"{1} before {0}", "{0} после {1}"},
        {"{0} must be {1}, not {2}", "{0}: нужно {1}, а не {2}"},
        {"Is a directory", "это каталог"},
        {"cannot read {0}: {1}", "не читается {0}: {1}"},
        {"", "the header of a catalogue"},
    };
    ++*(unsigned *)data;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcmp(words[i][0], english) == 0)
            return words[i][1];
    return english;
}

static void assert_renders(struct lx_text *text, const char *english, const char *russian)
{
    unsigned calls = 0;
    struct lx_text copy = {0};
    lx_text_puts(&copy, text->bytes ? text->bytes : "");
    char *plain = lx_text_render(text, NULL, NULL), *translated = lx_text_render(&copy, translate, &calls);
    assert_string_equal(plain, english);
    assert_string_equal(translated, russian);
    free(plain);
    free(translated);
}

static void renders(void **state)
{
    (void)state;
    struct lx_text text = {0};
    assert_renders(&text, "", "");
    lx_add_phrase(&text, "", NULL);
    assert_renders(&text, "", "");
    lx_text_puts(&text, "x ");
    lx_add_phrase(&text, "{0} to {1}", LX_ARGS("1", "2"));
    lx_text_puts(&text, " ");
    lx_add_phrase(&text, "mm", NULL);
    assert_renders(&text, "x 1 to 2 mm", "x от 1 до 2 мм");
    lx_add_phrase(&text, "{1} before {0}", LX_ARGS("{1}", "{0}"));
    assert_renders(&text, "{0} before {1}", "{1} после {0}");
    lx_add_phrase(&text, "{2} {x} {", LX_ARGS("a"));
    assert_renders(&text, "{2} {x} {", "{2} {x} {");
}

static void nests(void **state)
{
    (void)state;
    struct lx_text inner = {0}, middle = {0}, outer = {0};
    lx_add_phrase(&inner, "mm", NULL);
    lx_add_phrase(&middle, "in {0}", LX_ARGS(inner.bytes));
    lx_add_phrase(&outer, "{1} before {0}", LX_ARGS(middle.bytes, inner.bytes));
    assert_renders(&outer, "mm before in mm", "в мм после мм");
    lx_text_clear(&inner);
    lx_text_clear(&middle);
}

static void assert_says(const luxel_diagnostics *diagnostics, size_t i, const char *english, const char *russian)
{
    unsigned calls = 0;
    char *plain = luxel_diagnostics_message(diagnostics, i, NULL, NULL);
    char *translated = luxel_diagnostics_message(diagnostics, i, translate, &calls);
    assert_string_equal(plain, english);
    assert_string_equal(translated, russian);
    luxel_text_free(plain);
    luxel_text_free(translated);
}

static void translates_arguments(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_text range = {0};
    lx_add_phrase(&range, "{0} to {1}", LX_ARGS("0", "90"));
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_OUT_OF_RANGE,
              LX_ARGS("inner", LX_WORDS(range.bytes), "95"));
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ, LX_ARGS("mm", LX_TERM("Is a directory")));
    assert_says(diagnostics, 0, "inner must be 0 to 90, not 95", "inner: нужно от 0 до 90, а не 95");
    assert_says(diagnostics, 1, "cannot read mm: Is a directory", "не читается mm: это каталог");
    lx_text_clear(&range);
    luxel_diagnostics_free(diagnostics);
}

/* What a user wrote is neither translated nor rendered, whatever characters it has. */
static void resists_forgery(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_text forged = {0};
    lx_add_phrase(&forged, "mm", NULL);
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ, LX_ARGS(forged.bytes, "{0}"));
    assert_says(diagnostics, 0, "cannot read \\x02mm\\x03: {0}", "не читается \\x02mm\\x03: {0}");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ, LX_ARGS("a", LX_TERM(forged.bytes)));
    assert_says(diagnostics, 1, "cannot read a: \\x02mm\\x03", "не читается a: \\x02mm\\x03");
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_FILE_NOT_READ,
              LX_ARGS("a", LX_WORDS("\x03\x1f\x02"
                                    "b\n")));
    assert_says(diagnostics, 2, "cannot read a: b\\n", "не читается a: b\\n");
    lx_text_clear(&forged);
    luxel_diagnostics_free(diagnostics);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(renders),
        cmocka_unit_test(nests),
        cmocka_unit_test(translates_arguments),
        cmocka_unit_test(resists_forgery),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
