/* SPDX-License-Identifier: MIT */
/* Texts for people: escaping, UTF-8, likeness of words, and what YAML makes of plain words. */
#include <stdlib.h>
#include <string.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/text.h"
#include "parameter/plain.h"

static void escapes(void **state)
{
    (void)state;
    static const struct {
        const char *raw, *escaped;
    } cases[] = {
        {"plain é 字", "plain é 字"},
        {"\x1B[31m", "\\x1B[31m"},
        {"a\tb\n\r", "a\\tb\\n\\r"},
        {"\x7F", "\\x7F"},
        {"\xC2\x9B", "\\x9B"},
        {"\xFF\xC0\x80", "\\xFF\\xC0\\x80"},
        {"\xED\xA0\x80", "\\xED\\xA0\\x80"},
        {"\xE2\x80\xAE", "\\u202E"},
        {"\xEF\xBB\xBF", "\\uFEFF"},
        {"\xF3\xA0\x80\x81", "\\U000E0001"},
        {"\xE2\x80", "\\xE2\\x80"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct lx_text text = {0};
        lx_text_add_escaped(&text, cases[i].raw, strlen(cases[i].raw));
        char *escaped = lx_text_take(&text);
        assert_string_equal(escaped, cases[i].escaped);
        assert_int_equal(lx_is_printable(cases[i].raw, strlen(cases[i].raw)), i == 0);
        free(escaped);
    }
    struct lx_text text = {0};
    assert_int_equal(lx_text_add_escaped(&text, "é\x01z", 4), 6); /* columns, not bytes */
    lx_text_clear(&text);
}

static void grows(void **state)
{
    (void)state;
    struct lx_text text = {0};
    for (int i = 0; i < 1000; i++)
        lx_text_printf(&text, "%d,", i);
    lx_text_fill(&text, '=', 3);
    assert_int_equal(text.length, 10 * 2 + 90 * 3 + 900 * 4 + 3);
    char *bytes = lx_text_take(&text);
    assert_string_equal(bytes + strlen(bytes) - 7, "999,===");
    free(bytes);
    assert_null(text.bytes);
    bytes = lx_text_take(&text);
    assert_string_equal(bytes, "");
    free(bytes);
}

static unsigned distance(const char *a, const char *b)
{
    return lx_word_distance(a, strlen(a), b);
}

static void measures_words(void **state)
{
    (void)state;
    assert_int_equal(distance("radius", "radius"), 0);
    assert_int_equal(distance("RADIUS", "radius"), 0);
    assert_int_equal(distance("raduis", "radius"), 1);
    assert_int_equal(distance("centre", "center"), 1);
    assert_int_equal(distance("radus", "radius"), 1);
    assert_int_equal(distance("", "radius"), 6);
    assert_int_equal(distance("kitten", "sitting"), 3);
    char longest[200];
    memset(longest, 'a', sizeof longest);
    assert_true(lx_word_distance(longest, sizeof longest, "a") > 50);
}

static const char *nearest(const char *word)
{
    static const char *const words[] = {"width", "height", "resolution", "sampling", "z", "k", "center", "diffuse"};
    struct lx_nearest search = {.word = word, .length = strlen(word)};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        lx_nearest_offer(&search, words[i]);
    return search.best;
}

static void finds_the_nearest(void **state)
{
    (void)state;
    assert_string_equal(nearest("widht"), "width");
    assert_string_equal(nearest("hight"), "height");
    assert_string_equal(nearest("Resolution"), "resolution");
    assert_string_equal(nearest("res"), "resolution");
    assert_string_equal(nearest("centre"), "center");
    assert_string_equal(nearest("difuse"), "diffuse");
    assert_null(nearest("zebra"));
    assert_null(nearest("x"));
    assert_null(nearest(""));
}

static void tells_texts_from_numbers(void **state)
{
    (void)state;
    static const char *const no_texts[] = {"",   "~",    "null", "true", "False", "5",    "-1.5e3",
                                           ".5", "0x1F", "0o17", ".nan", "-.inf", "+.Inf"};
    static const char *const texts[] = {"none", "a", "nan", "5mm", "1_000", "yes", "Null?", "0x", "-", "point"};
    for (size_t i = 0; i < sizeof no_texts / sizeof no_texts[0]; i++)
        assert_false(lx_plain_is_text(no_texts[i]));
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        assert_true(lx_plain_is_text(texts[i]));
    static const char *const unsafe[] = {"",         "5",  "yes", "On", "null", "~",  "a: b",  "a #b",
                                         "- a",      "[a", "a,b", " a", "a ",   "*a", "\"a\"", "a\nb",
                                         "\xC2\x85", "n",  "1e3", ".a", "@a",   "!a"};
    static const char *const safe[] = {"point", "blinn-phong", "key light 2", "лампа", "a.b", "none", "lamp (left)"};
    for (size_t i = 0; i < sizeof unsafe / sizeof unsafe[0]; i++)
        assert_false(lx_plain_is_safe(unsafe[i]));
    for (size_t i = 0; i < sizeof safe / sizeof safe[0]; i++)
        assert_true(lx_plain_is_safe(safe[i]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(escapes),
        cmocka_unit_test(grows),
        cmocka_unit_test(measures_words),
        cmocka_unit_test(finds_the_nearest),
        cmocka_unit_test(tells_texts_from_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
