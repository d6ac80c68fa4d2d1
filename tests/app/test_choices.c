/* SPDX-License-Identifier: MIT */
/* Every choice of every key, and every kind of light and surface, has a label: a list shows no bare key. */
#include <string.h>

#include "../../app/base/choices.h"
#include "scenes.h"

static void labels_every_choice(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    gsize count = 0;
    for (gsize i = 0; i < luxel_parameters_count(parameters); i++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, i);
        char **words = g_strsplit(parameter->choices ? parameter->choices : "", ", ", -1);
        for (gsize k = 0; words[k] && *words[k]; k++, count++)
            if (app_choice_label(words[k]) == words[k])
                fail_msg("%s of %s has no label in src/parameter/labels.c", words[k], parameter->path);
        g_strfreev(words);
    }
    for (gsize i = 0; i < luxel_parameters_kind_count(parameters); i++, count++) {
        char *name = g_strdup(luxel_parameters_kind(parameters, i)->name); /* equal literals may be one */
        if (app_choice_label(name) == name)
            fail_msg("%s has no label in src/parameter/labels.c", name);
        g_free(name);
    }
    assert_true(count > 40);
    luxel_parameters_free(parameters);
}

static void leaves_other_words(void **state)
{
    (void)state;
    static const char word[] = "viridis";
    assert_ptr_equal(app_choice_label(word), word);
    assert_null(app_choice_label(NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(labels_every_choice), cmocka_unit_test(leaves_other_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
