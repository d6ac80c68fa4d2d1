/* SPDX-License-Identifier: MIT */
/* Repairs: a scene that was refused can be computed with what is offered, and is only changed where it must be. */
#include <string.h>

#include "../../app/form/repair.h"
#include "scenes.h"

/* Whether a picture can be made of the scene of a document. */
static gboolean is_good(const AppDocument *document, luxel_diagnostics *faults)
{
    luxel_scene *scene = app_document_copy_scene(document);
    const gboolean good =
        luxel_scene_commit(scene, faults) == LUXEL_OK && luxel_scene_check_view(scene, faults) == LUXEL_OK;
    luxel_scene_free(scene);
    return good;
}

/* The faults of a document that has some. */
static luxel_diagnostics *faults_of(const AppDocument *document)
{
    luxel_diagnostics *faults = luxel_diagnostics_new();
    if (is_good(document, faults))
        fail_msg("there is nothing wrong with it");
    return faults;
}

static void reads_hints(void **state)
{
    (void)state;
    AppRepair *repair = app_repair_of_hint("try -s 'screen.width=600' -s 'lights[0].position=[1, 2, 3]'");
    assert_int_equal(repair->len, 2);
    assert_string_equal(g_ptr_array_index(repair, 0), "screen.width=600");
    assert_string_equal(g_ptr_array_index(repair, 1), "lights[0].position=[1, 2, 3]");
    g_ptr_array_unref(repair);
    repair = app_repair_of_hint("expected: observer.z > 2920 mm, -s 'not closed");
    assert_int_equal(repair->len, 0);
    g_ptr_array_unref(repair);
}

/* Changes that make a scene one that cannot be computed. */
static const struct {
    const char *scene, *key, *value;
} spoiled[] = {
    {"report", "surfaces[0].center", "[0, 0, 2620]"}, /* the observer stands at 1500 */
    {"report", "surfaces[0].radius", "600"},
    {"report", "observer.z", "900"},
    {"desk", "surfaces[0].axis", "[0, 0, 0]"},
    {"desk", "observer.z", "1000"}, /* the ball reaches up to 1160 */
    {"report", "screen.resolution", "[360, 240]"},
    {"report", "picture.range", "[5, 3]"},
    {"report", "surfaces[0].material.shininess", "-3"},
    {"three-lights", "lights[1].intensity", "-1"},
};

static void mend(const luxel_parameters *parameters, const char *scene, const char *key, const char *value)
{
    AppDocument *document = document_of_builtin(scene);
    AppMoment *good = moment_of(document);
    set(document, key, value);
    char *text = g_strdup(app_document_text(document));
    luxel_diagnostics *faults = faults_of(document);
    AppRepair *repair = app_repair_find(document, faults, good->scene);
    if (!repair)
        fail_msg("nothing is offered for %s=%s", key, value);
    assert_string_equal(app_document_text(document), text); /* it was tried elsewhere */
    char *words = app_repair_words(repair, parameters);
    assert_true(strlen(words) > 5 && !strstr(words, "e+"));
    app_document_begin_gesture(document);
    assert_true(app_repair_make(repair, document));
    app_document_end_gesture(document);
    if (!is_good(document, NULL))
        fail_msg("%s does not mend %s=%s", words, key, value);
    assert_true(app_document_undo(document));
    assert_string_equal(app_document_text(document), text); /* one step of undo */
    g_free(words);
    g_free(text);
    g_ptr_array_unref(repair);
    luxel_diagnostics_free(faults);
    app_moment_unref(good);
    g_object_unref(document);
}

static void mends_what_was_spoiled(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    for (gsize i = 0; i < G_N_ELEMENTS(spoiled); i++)
        mend(parameters, spoiled[i].scene, spoiled[i].key, spoiled[i].value);
    luxel_parameters_free(parameters);
}

static void raises_the_observer(void **state)
{
    (void)state;
    luxel_parameters *parameters = luxel_parameters_new();
    AppDocument *document = document_of_builtin("report");
    set(document, "surfaces[0].center", "[0, 0, 2620]");
    luxel_diagnostics *faults = faults_of(document);
    AppRepair *repair = app_repair_find(document, faults, NULL);
    assert_non_null(repair);
    char *words = app_repair_words(repair, parameters);
    assert_string_equal(words, "Observer, Height z: 3000 mm");
    assert_true(app_repair_make(repair, document));
    assert_key(document, "observer.z", "3000");
    assert_key(document, "surfaces[0].center", "[0, 0, 2620]");
    g_free(words);
    g_ptr_array_unref(repair);
    luxel_diagnostics_free(faults);
    luxel_parameters_free(parameters);
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(reads_hints), cmocka_unit_test(mends_what_was_spoiled),
                                       cmocka_unit_test(raises_the_observer)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
