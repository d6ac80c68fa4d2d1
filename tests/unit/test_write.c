/* SPDX-License-Identifier: MIT */
/* Writing scenes anew: what is written reads back as the same scene, and looks as people write it. */
#include <stdlib.h>
#include <string.h>

#include "scene/object.h"
#include "scene/tidy.h"
#include "scenes.h"

static bool same_node(const struct lx_document *a, lx_node_id i, const struct lx_document *b, lx_node_id j)
{
    const struct lx_node *one = lx_document_node(a, i), *other = lx_document_node(b, j);
    if (one->kind != other->kind)
        return false;
    if (one->kind == LX_SCALAR && lx_document_is_null(a, i) && lx_document_is_null(b, j))
        return true;
    if (one->kind == LX_SCALAR && strcmp(lx_document_text(a, i), lx_document_text(b, j)) != 0)
        return false;
    for (i = one->first, j = other->first; i && j; i = lx_document_node(a, i)->next, j = lx_document_node(b, j)->next)
        if ((one->kind == LX_MAPPING && strcmp(lx_document_key(a, i), lx_document_key(b, j)) != 0) ||
            !same_node(a, i, b, j))
            return false;
    return !i && !j;
}

/* Writes tidily, reads back, compares the trees, and writes again; frees the scene. */
static void expect_round_trip(luxel_scene *scene)
{
    struct lx_text tidy = {0};
    char *text, *again = NULL;
    luxel_scene *back = NULL;
    lx_write_tidy(&tidy, &scene->document);
    text = lx_text_take(&tidy);
    assert_non_null(text);
    if (luxel_scene_read_text(text, strlen(text), "written", NULL, &back) != LUXEL_OK)
        fail_msg("does not read back:\n%s", text);
    if (!same_node(&scene->document, scene->document.root, &back->document, back->document.root))
        fail_msg("another scene:\n%s", text);
    assert_int_equal(luxel_scene_commit(scene, NULL), luxel_scene_commit(back, NULL));
    lx_write_tidy(&tidy, &back->document);
    again = lx_text_take(&tidy);
    assert_string_equal(text, again);
    free(again);
    assert_int_equal(luxel_scene_write_text(back, &again), LUXEL_OK); /* nothing was changed */
    assert_string_equal(text, again);
    luxel_text_free(again);
    free(text);
    luxel_scene_free(back);
    luxel_scene_free(scene);
}

static void writes_builtin_scenes(void **state)
{
    (void)state;
    assert_true(luxel_builtin_scene_count() >= 4);
    assert_string_equal(luxel_builtin_scene_name(0), "report");
    assert_null(luxel_builtin_scene_name(luxel_builtin_scene_count()));
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++) {
        luxel_scene *scene;
        assert_true(strlen(luxel_builtin_scene_title(i)) > 10);
        assert_int_equal(luxel_scene_open_builtin(luxel_builtin_scene_name(i), NULL, &scene), LUXEL_OK);
        assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
        expect_round_trip(scene);
    }
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    luxel_scene *scene = NULL;
    assert_int_equal(luxel_scene_open_builtin("reprot", diagnostics, &scene), LUXEL_ERROR_ARGUMENT);
    expect_entry(diagnostics, 0, WANTED("no-builtin", .hint = "\"report\""));
    luxel_diagnostics_free(diagnostics);
}

static void writes_tidily(void **state)
{
    (void)state;
    luxel_scene *scene;
    struct lx_text text = {0};
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    lx_write_tidy(&text, &scene->document);
    assert_string_equal(text.bytes, good_scene);
    lx_text_clear(&text);
    luxel_scene_free(scene);
}

static void writes_anything(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "{}",
        "a:\nb: ~\nc: null\nd: \"\"\ne: ''\nf: \"null\"\n",
        "a: \"5\"\nb: '1e3'\nc: \"true\"\nd: \"yes\"\ne: '~'\nf: \"0x10\"\ng: \".inf\"\n",
        "a: \"x\\ny\\t\\\"z\\\\ \\e[31m \\u202e \\x9b \\U0001F600\"\n",
        "a: one, two\nb: it's [not] a {list}\nc: a#b\nd: \"a #b\"\ne: \"a: b\"\nf: \"- a\"\ng: '*a'\nh: \"&a\"\n",
        "a: multi\n  line\n  plain\nb: |\n  literal\n   text\nc: >-\n  folded\n  text\n",
        "\"5\": 1\n\"a b\": 2\n\"\": 3\n\"#\": 4\nключ: лампа\n",
        "a: [[], {}, [[1, 2], [3]], {b: [{c: {}}]}]\nb: {}\nc: []\n",
        "- ignored\n",
        "a:\n  - - - 1\n      - b: [1]\n  - c:\n      d:\n        - 1\n",
        "a: -5\nb: +.5\nc: 1_000\nd: 0x1F\ne: .nan\nf: 12:30\ng: 2001-01-01\nh: --\ni: -\n",
        "a: \" leading\"\nb: \"trailing \"\nc: \" \"\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        luxel_scene *scene = NULL;
        if (texts[i][0] == '-')
            continue;
        if (luxel_scene_read_text(texts[i], strlen(texts[i]), "a", NULL, &scene) == LUXEL_OK)
            expect_round_trip(scene);
        else if (i != 10) /* the last line of that one is no YAML */
            fail_msg("not read: %s", texts[i]);
    }
}

static void breaks_long_lines(void **state)
{
    (void)state;
    luxel_scene *scene;
    assert_int_equal(load(good_scene, NULL, &scene), LUXEL_OK);
    char assignment[10000] = "points=[";
    for (int i = 0; i < 300; i++)
        strcat(assignment, "[1000, -1000], ");
    strcat(assignment, "]");
    assert_int_equal(luxel_scene_set(scene, assignment, NULL), LUXEL_OK);
    struct lx_text tidy = {0};
    lx_write_tidy(&tidy, &scene->document);
    char *text = lx_text_take(&tidy);
    assert_non_null(text);
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1)
        assert_true(end - line <= 120);
    assert_non_null(strstr(text, "\npoints:\n  - [1000, -1000]\n"));
    free(text);
    expect_round_trip(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(writes_builtin_scenes),
        cmocka_unit_test(writes_tidily),
        cmocka_unit_test(writes_anything),
        cmocka_unit_test(breaks_long_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
