/* SPDX-License-Identifier: MIT */
/* Texts become YAML scalars and come back, whatever is in them. */
#include "../../app/base/scalar.h"
#include "scenes.h"

static void goes_there_and_back(void **state)
{
    (void)state;
    static const char *const texts[] = {"", "key", "a \"b\"", "C:\\new", "tab\there", "свет", "it's", "x: y # z"};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        char *yaml = app_yaml_quote(texts[i]), *back = app_yaml_unquote(yaml);
        assert_string_equal(back, texts[i]);
        AppDocument *document = document_of_builtin("report");
        set(document, "lights[0].name", yaml);
        app_moment_unref(moment_of(document)); /* the library reads it as well */
        g_object_unref(document);
        g_free(yaml);
        g_free(back);
    }
}

static void reads_what_others_write(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"key", "key"}, {"'it''s'", "it's"}, {"\"", "\""}, {"\"\\u0041\"", "A"}, {"\"\\u0441\"", "с"}};
    for (gsize i = 0; i < G_N_ELEMENTS(pairs); i++) {
        char *text = app_yaml_unquote(pairs[i][0]);
        assert_string_equal(text, pairs[i][1]);
        g_free(text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(goes_there_and_back),
                                       cmocka_unit_test(reads_what_others_write)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
