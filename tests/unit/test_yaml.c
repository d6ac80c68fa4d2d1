/* SPDX-License-Identifier: MIT */
/* Reading texts: what is refused and where, and that hostile texts end at once. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "scenes.h"

static void refuses_what_is_no_mapping(void **state)
{
    (void)state;
    static const char *const texts[] = {"", "\n\n", "# only a comment\n", "hello\n", "5", "- 1\n- 2\n", "[]", "\"\""};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++)
        expect_text_error(texts[i], WANTED("no-mapping", 1, 1, .message = "expected a mapping"));
    expect_text_error("---\n", WANTED("no-mapping", 1, 4));
}

static void refuses_broken_syntax(void **state)
{
    (void)state;
    expect_error("    radius", "\tradius", WANTED("syntax", 8, 1, .message = "tab"));
    expect_error("picture: {range: max, rounding: truncate}\n", "picture: {range: [max,\n",
                 WANTED("not-closed", 13, 18));
    expect_error("units: radiometric", "units: \"radiometric", WANTED("syntax", 2, 8));
    expect_error("    radius: 300", "   radius: 300", WANTED("syntax", 8, 4));
    expect_error("radius: 300", "radius:300", WANTED("syntax", 8, 5));
    expect_error("radius: 300", "name: \"\\0\"", WANTED("bad-escape", 8, 11));
    expect_error("luxel: 1", "%FOO\n---\nluxel: 1", WANTED("no-directives", 1, 1));
}

/* Where each kind of error is seen to stand, whatever ends the lines. */
static void tells_where_syntax_is_broken(void **state)
{
    static const struct {
        const char *text;
        unsigned line, column;
    } cases[] = {
        {"a: 1\nb: \"x\n", 2, 5},
        {"a: 1\nb: @x\n", 2, 4},
        {"a:\n\t- 1\n", 2, 1},
        {"a: 1\n]\n", 2, 1},
        {"a: 1\n- b\n", 2, 1},
        {"a: 1\n\nb: [1,,2]\n", 3, 7},
        {"a: 1\nb: {1: 2, , }\n", 2, 11},
        {"a: b: c\n", 1, 5},
        {"a: 1\nb: \"abc\" def\n", 2, 10},
        {"a:\n  b: 1\n c: 2\n", 3, 2},
        {"a: |\n\tx\n", 2, 1},
        {"a: [b, c: [d, e}]\n", 1, 16},
        {"\n\na: 1\nb: }\n", 4, 4},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int ends = 0; ends < 2; ends++) {
            char text[80];
            size_t length = 0;
            for (const char *at = cases[i].text; *at; text[length++] = *at++)
                if (*at == '\n' && ends)
                    text[length++] = '\r';
            text[length] = '\0';
            expect_text_error(text, WANTED("syntax", cases[i].line, cases[i].column));
        }
    /* the bracket that is still open where the text ends, with blanks or without */
    expect_text_error("a: 1\nb: [1, 2", WANTED("not-closed", 2, 4));
    expect_text_error("a: 1\nb: [1, 2  \n\t \n", WANTED("not-closed", 2, 4));
    expect_text_error("a: 1\nb: [1, [2]\n", WANTED("not-closed", 2, 4));
    expect_text_error("a: {b: [c, d   \n \n", WANTED("not-closed", 1, 8));
    expect_text_error("a: {b   \n \n", WANTED("not-closed", 1, 4));
}

static void refuses_what_scenes_do_not_need(void **state)
{
    (void)state;
    expect_error("radius: 300", "radius: &a 300", WANTED("no-anchors", 8, 13));
    expect_error("radius: 300", "radius: *a", WANTED("no-anchors", 8, 13));
    expect_error("radius: 300", "radius: !!float 300", WANTED("no-anchors", 8, 13));
    expect_error("radius: 300", "radius: !x 300", WANTED("no-anchors", 8, 13));
    expect_error("radius: 300", "? [a]\n    : 1", WANTED("complex-key", 8, 7));
    expect_error("luxel: 1\n", "luxel: 1\n---\n", WANTED("more-documents", 2, 1));
    expect_error("luxel: 1\n", "luxel: 1\n...\n", WANTED("more-documents", 3));
}

static void refuses_bad_characters(void **state)
{
    (void)state;
    expect_error("radius: 300", "radius: 3\x01", WANTED("control-character", 8, 14, .message = "\\x01"));
    expect_error("radius: 300", "radius: \x7F", WANTED("control-character", 8, 13));
    expect_error("radius: 300", "radius: \xC2\x9B", WANTED("control-character", 8, 13, .message = "\\x9B"));
    expect_error("radius: 300", "# gr\xFC\xDF", WANTED("not-utf8", 8, 9, .message = "\\xFC"));
    expect_error("radius: 300", "# \xC0\x80", WANTED("not-utf8", 8, 7));
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text("luxel: 1\0", 9, "a", diagnostics, &scene), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("control-character", 1, 9, .message = "\\x00"));
    assert_null(scene);
    luxel_diagnostics_free(diagnostics);
}

static void accepts_what_is_well_formed(void **state)
{
    (void)state;
    static const char *const prefixes[] = {"\xEF\xBB\xBF", "%YAML 1.2\n---\n", "---\n", "# comment\n\n"};
    for (size_t i = 0; i < sizeof prefixes / sizeof prefixes[0]; i++) {
        char text[2000];
        luxel_scene *scene;
        snprintf(text, sizeof text, "%s%s", prefixes[i], good_scene);
        assert_int_equal(load(text, NULL, &scene), LUXEL_OK);
        luxel_scene_free(scene);
    }
    /* JSON, with tabs, and Windows line ends */
    luxel_scene *scene;
    assert_int_equal(
        load("{\r\n\t\"luxel\": 1,\r\n\t\"screen\": {\"width\": 1, \"height\":1,\"resolution\":[1, 1]},\r\n"
             "\t\"observer\": {\"z\": 5},\"surfaces\":[{\"type\":\"sphere\",\"center\":[0,0,0],"
             "\"radius\":1}],\"lights\":[]}",
             NULL, &scene),
        LUXEL_OK);
    luxel_scene_free(scene);
}

/* Reads `count` repetitions of a text behind another one; asserts that it ends in time, with this error. */
static void expect_bomb(const char *first, const char *repeated, size_t count, const char *id)
{
    size_t head = strlen(first), size = strlen(repeated), length = head + size * count;
    char *text = malloc(length);
    assert_non_null(text);
    memcpy(text, first, head);
    for (size_t i = 0; i < count; i++)
        memcpy(text + head + i * size, repeated, size);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    clock_t start = clock();
    luxel_status status = luxel_scene_read_text(text, length, "bomb", diagnostics, &scene);
    if (status == LUXEL_OK)
        status = luxel_scene_commit(scene, diagnostics);
    assert_int_equal(status, LUXEL_ERROR_SCENE);
    assert_true((clock() - start) / CLOCKS_PER_SEC < 20); /* with every sanitizer and slow machine */
    expect_entry(diagnostics, 0, WANTED(.id = id));
    luxel_scene_free(scene);
    luxel_diagnostics_free(diagnostics);
    free(text);
}

static void survives_bombs(void **state)
{
    (void)state;
    enum { MANY = 1000000 };
    expect_bomb("", "[", MANY, "too-deep");
    expect_bomb("", "[\n", MANY, "too-deep");
    expect_bomb("a: ", "{b: ", MANY, "too-deep");
    expect_bomb("", "- ", MANY, "too-deep");
    expect_bomb("a: ", "[", 33, "too-deep");
    expect_bomb("", "&a ", MANY, "no-anchors");
    expect_bomb("", "!a\n", MANY, "no-anchors");
    expect_bomb("", "%A b\n", MANY, "no-directives");
    expect_bomb("[", "[],", MANY, "not-closed");
    expect_bomb("a: 1\n", "? a\n", 10000, "unknown-key");
    expect_bomb("", "key: 1\n", 100000, "unknown-key");
    expect_bomb("a:\n  ", "[a,", MANY, "too-deep");
    expect_bomb("a:\n  [", "a, ", MANY, "not-closed");
    expect_bomb("a: [", "a, ", 3000, "not-closed");
    expect_bomb("\"", "a", MANY, "syntax");
    expect_bomb("", "\x80", MANY, "not-utf8");
    expect_bomb("", "a", (64 << 20) + 1, "text-too-large");
}

static void reads_files(void **state)
{
    (void)state;
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_file("/nonexistent/scene.yaml", diagnostics, &scene), LUXEL_ERROR_FILE);
    expect_entry(diagnostics, 0, WANTED("file-not-read", .message = "No such file"));
    luxel_diagnostics_clear(diagnostics);
    assert_int_equal(luxel_scene_read_file("/", diagnostics, &scene), LUXEL_ERROR_FILE);
    expect_entry(diagnostics, 0, WANTED("file-not-read", .message = "directory"));
    luxel_diagnostics_clear(diagnostics);
    assert_int_equal(luxel_scene_read_file("/dev/zero", diagnostics, &scene), LUXEL_ERROR_SCENE);
    expect_entry(diagnostics, 0, WANTED("text-too-large"));
    luxel_diagnostics_free(diagnostics);
    assert_null(scene);

    char name[] = "/tmp/luxel-test-XXXXXX";
    int file = mkstemp(name);
    assert_true(file >= 0);
    assert_int_equal(write(file, good_scene, strlen(good_scene)), strlen(good_scene));
    close(file);
    assert_int_equal(luxel_scene_read_file(name, NULL, &scene), LUXEL_OK);
    unlink(name);
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_scene_free(scene);
}

static void checks_its_arguments(void **state)
{
    (void)state;
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_read_text(NULL, 5, "a", NULL, &scene), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_read_text("a: 1", 4, NULL, NULL, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_read_file(NULL, NULL, &scene), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_open_builtin(NULL, NULL, &scene), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_commit(NULL, NULL), LUXEL_ERROR_ARGUMENT);
    assert_int_equal(luxel_scene_advise(NULL, NULL), LUXEL_ERROR_ARGUMENT);
    assert_null(luxel_scene_copy(NULL));
    luxel_scene_free(NULL);
    assert_null(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_what_is_no_mapping),
        cmocka_unit_test(refuses_broken_syntax),
        cmocka_unit_test(tells_where_syntax_is_broken),
        cmocka_unit_test(refuses_what_scenes_do_not_need),
        cmocka_unit_test(refuses_bad_characters),
        cmocka_unit_test(accepts_what_is_well_formed),
        cmocka_unit_test(survives_bombs),
        cmocka_unit_test(reads_files),
        cmocka_unit_test(checks_its_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
