/* SPDX-License-Identifier: MIT */
/* The part of an explanation that is about a light, as the library writes it. */
#include "../../app/numbers/explained.h"

#include <string.h>

#include "scenes.h"

static char *explanation_of(const char *scene)
{
    AppDocument *document = document_of_builtin(scene);
    AppMoment *moment = moment_of(document);
    luxel_document *explained;
    assert_int_equal(luxel_explain(moment->scene, NULL, 40, 20, NULL, NULL, &explained), LUXEL_OK);
    char *text = luxel_document_write_text(explained, LUXEL_DOCUMENT_TEXT), *copy = g_strdup(text);
    luxel_text_free(text);
    luxel_document_free(explained);
    app_moment_unref(moment);
    g_object_unref(document);
    return copy;
}

/* Each light has its own, with its place, its angle and no word of the next one. */
static void test_lights(void **state)
{
    (void)state;
    char *text = explanation_of("three-lights");
    char *parts[3];
    for (gsize i = 0; i < 3; i++) {
        parts[i] = app_explained_light(text, i);
        assert_non_null(parts[i]);
        assert_non_null(strstr(text, "N · L = "));
        assert_non_null(strstr(parts[i], "N · L = "));
        assert_null(strstr(parts[i], "lights["));
        assert_null(strstr(parts[i], "\n\n"));
        assert_null(strstr(parts[i], "─"));
    }
    assert_string_not_equal(parts[0], parts[1]);
    assert_non_null(strstr(parts[0], "(−1200, 1000, 2600)"));
    for (gsize i = 0; i < 3; i++)
        g_free(parts[i]);
    assert_null(app_explained_light(text, 3));
    assert_null(app_explained_light("", 0));
    g_free(text);
}

/* A number that begins with another one is not that one. */
static void test_numbers(void **state)
{
    (void)state;
    static const char text[] = "lights[10]: a\n─────\n\nten\n\nlights[1]: b\n─────\n\none\n\nThe sum\n═══\nall\n";
    char *one = app_explained_light(text, 1), *ten = app_explained_light(text, 10);
    assert_string_equal(one, "one");
    assert_string_equal(ten, "ten");
    g_free(one);
    g_free(ten);
}

/* A heading that is too long for a line is one all the same. */
static void test_long_heading(void **state)
{
    (void)state;
    static const char text[] = "lights[0] a: a source of\nlight\n─────\n\none\n\nlights[1] b: a\nb\n──\n\ntwo\n";
    char *one = app_explained_light(text, 0), *two = app_explained_light(text, 1);
    assert_string_equal(one, "one");
    assert_string_equal(two, "two");
    g_free(one);
    g_free(two);
    char *room = explanation_of("room"), *ceiling = app_explained_light(room, 0);
    assert_non_null(ceiling);
    g_free(ceiling);
    g_free(room);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lights), cmocka_unit_test(test_numbers),
                                       cmocka_unit_test(test_long_heading)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
