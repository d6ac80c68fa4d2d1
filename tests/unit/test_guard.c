/* SPDX-License-Identifier: MIT */
/* The guard before the YAML parser: which texts it refuses, by what, and where its limits lie, to the byte. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene/guard.h"
#include "scenes.h"

enum { LIMIT = 256 * 1024 };

/* The identifier of what is refused, and the byte where it stands; NULL: nothing is. */
static const char *refused(const char *text, size_t length, size_t start, size_t *at)
{
    static char id[40];
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    const struct lx_place place = {.text = text, .length = length, .start = start, .end = start};
    luxel_status status = lx_guard_text(&place, diagnostics);
    assert_int_equal(status, luxel_diagnostics_count(diagnostics) ? LUXEL_ERROR_SCENE : LUXEL_OK);
    id[0] = '\0';
    if (status != LUXEL_OK) {
        const luxel_diagnostic *entry = luxel_diagnostics_get(diagnostics, 0);
        snprintf(id, sizeof id, "%s", entry->id);
        /* the texts here have one byte for each column but for tabs and the like, and lines end with one byte */
        const char *line = text;
        for (unsigned i = 1; i < entry->line; i++)
            line = strchr(line, '\n') + 1;
        *at = (size_t)(line - text) + entry->column - 1;
    }
    luxel_diagnostics_free(diagnostics);
    return id[0] ? id : NULL;
}

static void expect(const char *text, size_t length, size_t start, const char *id, size_t at)
{
    size_t found_at = 0;
    const char *found = refused(text, length, start, &found_at);
    if (!found != !id || (id && (strcmp(found, id) != 0 || found_at != at)))
        fail_msg("%.40s: %s at %zu, expected %s at %zu", text, found ? found : "good", found_at, id ? id : "good", at);
}

/* -- characters and directives, in texts of any length -- */

static void characters(void **state)
{
    (void)state;
    for (int c = 0; c < 256; c++) {
        const char text[4] = {'a', (char)c, 'b', '\0'};
        bool good = c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c < 0x7F);
        expect(text, 3, 0, good ? NULL : c >= 0x80 ? "not-utf8" : "control-character", 1);
        expect(text, 3, 2, NULL, 0); /* what comes before does not matter */
    }
    static const struct {
        const char *text;
        bool good;
    } wide[] = {
        {"\xC2\x80", false},     {"\xC2\x84", false},     {"\xC2\x85", true},         {"\xC2\x86", false},
        {"\xC2\x9F", false},     {"\xC2\xA0", true},      {"\xD0\x96", true},         {"\xEF\xBF\xBD", true},
        {"\xEF\xBF\xBE", false}, {"\xEF\xBF\xBF", false}, {"\xF0\x9F\x92\xA1", true},
    };
    for (size_t i = 0; i < sizeof wide / sizeof *wide; i++)
        expect(wide[i].text, strlen(wide[i].text), 0, wide[i].good ? NULL : "control-character", 0);
}

static void directives(void **state)
{
    static const struct {
        const char *text;
        const char *id;
        size_t at;
    } cases[] = {
        {"%YAML 1.2\n---\na: 1\n", NULL, 0},
        {"%YAML 1\n", NULL, 0},
        {"%YAML 2\n", "no-directives", 0},
        {"%YAML \n", "no-directives", 0},
        {"%TAG ! x\n", "no-directives", 0},
        {"# a\n\n%YAML 1.2\n%X\n", "no-directives", 15},
        {"\n\n%X", "no-directives", 2},
        {"a: 1\n%X\n", NULL, 0},
        {" \n%X\n", NULL, 0},
        {"a: %X\n", NULL, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect(cases[i].text, strlen(cases[i].text), 0, cases[i].id, cases[i].at);
}

/* -- what the parser would look ahead for, in long texts -- */

/* A comment so long, then `head`, so many bytes of a list, `tail`. */
static void expect_long(const char *head, size_t filling, const char *tail, const char *id, size_t at)
{
    const size_t comment = LIMIT + 1, begin = strlen(head), end = strlen(tail);
    size_t length = comment + begin + filling + end;
    char *text = malloc(length + 1);
    assert_non_null(text);
    memset(text, '#', comment);
    text[comment - 1] = '\n';
    memcpy(text + comment, head, begin);
    for (size_t i = 0; i < filling; i++)
        text[comment + begin + i] = i % 2 ? ',' : '1';
    memcpy(text + comment + begin + filling, tail, end + 1);
    expect(text, length, 0, id, comment + at);
    free(text);
}

static void lists_that_may_be_keys(void **state)
{
    const size_t most = LIMIT - 2; /* with its brackets */
    (void)state;
    expect_long("a: 1\n[", most, "]: 2\n", NULL, 0);
    expect_long("a: 1\n[", most + 1, "]: 2\n", "long-list", 5);
    expect_long("a: 1\n{", most + 1, "}: 2\n", "long-list", 5);
    expect_long("[", most + 1, "]\n", NULL, 0); /* the first of all is none */
    expect_long("a: [", most + 1, "]\n", NULL, 0);
    expect_long("a:\n[", most + 1, "]\n", "long-list", 3);
    expect_long("- [", most + 1, "]\n", NULL, 0);
    expect_long("- 1\n- [", most + 1, "]\n", "long-list", 6);
    expect_long("a: [[", most + 1, "]]\n", "long-list", 4);
    expect_long("a: [b: [", most + 1, "]]\n", NULL, 0);
    expect_long("a: [b:\n [", most + 1, "]]\n", NULL, 0);
    expect_long("a: [b: 1, [", most + 1, "]]\n", "long-list", 10);
    expect_long("a: {\"b\":[", most + 1, "]}\n", NULL, 0);
    expect_long("\"a\": 1\n[", most + 1, "]\n", "long-list", 7);
    expect_long("a: b[", most + 1, "]\n", NULL, 0); /* within a text */
    expect_long("a: 'b[", most + 1, "]'\n", NULL, 0);
    expect_long("a: \"\\\"[", most + 1, "]\"\n", NULL, 0);
    expect_long("a: 1\n#[", most + 1, "]\n", NULL, 0);
    expect_long("a: 1 #[", most + 1, "]\n", NULL, 0);
    expect_long("a: 1\n[ #]\n", most + 1, "]\n", "long-list", 5);
    expect_long("? [", most + 1, "]\n", NULL, 0);
}

static void brackets_that_stay_open(void **state)
{
    (void)state;
    expect_long("a: 1\n[1, 2\n", 0, "", "not-closed", 5);
    expect_long("a: [1, 2\n", 0, "", NULL, 0); /* for the parser to find */
    expect_long("a: [1, [2\n", 0, "", "not-closed", 7);
    expect_long("a: [1, [2], {b: 1\n", 0, "", "not-closed", 12);
    expect_long("a: 'x\n[", 0, "", NULL, 0);
    expect_long("a: ]}\n", 0, "", NULL, 0);
    expect_long("a: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n", 0, "", NULL, 0);
    expect_long("a: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n", 0, "", "too-deep", 35);
}

static void anchors(void **state)
{
    (void)state;
    expect_long("a: &x 1\n", 0, "", "no-anchors", 3);
    expect_long("a: *x\n", 0, "", "no-anchors", 3);
    expect_long("a: !x 1\n", 0, "", "no-anchors", 3);
    expect_long("- &x\n", 0, "", "no-anchors", 2);
    expect_long("a: [1, *x]\n", 0, "", "no-anchors", 7);
    expect_long("a:\n  &x b\n", 0, "", "no-anchors", 5);
    expect_long("a: x &y *z !t\n", 0, "", NULL, 0);
    expect_long("a: '&x'\nb: \"*x\"\n", 0, "", NULL, 0);
    expect_long("a: x&y\n", 0, "", NULL, 0);
    expect_long("a-: -&x\n", 0, "", NULL, 0);
    expect_long("# &x\n", 0, "", NULL, 0);
    expect_long("a:&x\n", 0, "", NULL, 0);
    expect_long("a: 'it''s'\nb: 'x' # ' &y\nc: *z\n", 0, "", "no-anchors", 28);
}

/* A text so long may hold anything; one byte more, and it may not. */
static void short_texts(void **state)
{
    char *text = malloc(LIMIT + 2);
    (void)state;
    assert_non_null(text);
    memset(text, ' ', LIMIT + 1);
    memcpy(text, "a: &x 1\n", 8);
    text[LIMIT + 1] = '\0';
    expect(text, LIMIT, 0, NULL, 0);
    expect(text, LIMIT + 1, 0, "no-anchors", 3);
    expect(text, LIMIT + 1, 1, NULL, 0);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(characters),
        cmocka_unit_test(directives),
        cmocka_unit_test(lists_that_may_be_keys),
        cmocka_unit_test(brackets_that_stay_open),
        cmocka_unit_test(anchors),
        cmocka_unit_test(short_texts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
