/* SPDX-License-Identifier: MIT */
/* Documents: every change undone and redone, what is one step, what is saved, and nothing changed by what fails. */
#include <glib/gstdio.h>
#include <malloc.h>
#include <string.h>

#include "scenes.h"

static void count_signal(AppDocument *document, int *count)
{
    (void)document;
    ++*count;
}

/* ---- a long way, beside a plain list of texts ---- */

typedef struct Walk {
    AppDocument *document;
    GRand *random;
    GPtrArray *texts; /* of all steps */
    guint present;
    int changes; /* signals */
} Walk;

static void expect_present(const Walk *walk)
{
    const AppHistory *history = app_document_history(walk->document);
    const char *text = g_ptr_array_index(walk->texts, walk->present);
    assert_string_equal(app_document_text(walk->document), text);
    assert_int_equal(app_history_can_undo(history), walk->present > 0);
    assert_int_equal(app_history_can_redo(history), walk->present + 1 < walk->texts->len);
    assert_int_equal(app_document_is_modified(walk->document), strcmp(text, g_ptr_array_index(walk->texts, 0)) != 0);
}

/* The scene is that of the text, not only the text. */
static void expect_scene_of_text(const AppDocument *document)
{
    AppDocument *anew = document_of_text(app_document_text(document));
    char *lights = app_document_get(document, "lights", NULL), *expected = app_document_get(anew, "lights", NULL);
    assert_string_equal(lights, expected);
    assert_int_equal(app_document_size(document, "lights"), app_document_size(anew, "lights"));
    g_free(lights);
    g_free(expected);
    g_object_unref(anew);
}

/* An edit at random; its texts are in `key` and `value`. */
static AppEdit random_edit(Walk *walk, char key[64], char value[64])
{
    const gint32 lights = (gint32)app_document_size(walk->document, "lights");
    const gsize one = lights > 0 ? (gsize)g_rand_int_range(walk->random, 0, lights) : 0;
    const gsize other = lights > 0 ? (gsize)g_rand_int_range(walk->random, 0, lights) : 0;
    const int choice = g_rand_int_range(walk->random, 0, lights > 0 ? 7 : 2);
    g_snprintf(value, 64, "%d", g_rand_int_range(walk->random, 1, 50));
    g_snprintf(key, 64, "lights[%zu].name", one);
    if (choice == 0) {
        g_strlcpy(key, "surfaces[0].radius", 64);
    } else if (choice == 1) {
        g_strlcpy(key, "lights", 64);
        g_snprintf(value, 64, "{type: ambient, irradiance: %d}", g_rand_int_range(walk->random, 1, 9));
        return (AppEdit){.kind = APP_EDIT_INSERT, .key = key, .value = value, .index = one};
    } else if (choice == 2 && lights > 2) {
        g_snprintf(key, 64, "lights[%zu]", one);
        return (AppEdit){.kind = APP_EDIT_REMOVE, .key = key};
    } else if (choice == 3) {
        g_strlcpy(key, "lights", 64);
        return (AppEdit){.kind = APP_EDIT_MOVE, .key = key, .index = one, .to = other};
    } else if (choice == 4) {
        return (AppEdit){.kind = APP_EDIT_REMOVE, .key = key};
    } else {
        g_snprintf(value, 64, "\u043b\u0430\u043c\u043f\u0430 %d", g_rand_int_range(walk->random, 1, 9));
    }
    return (AppEdit){.kind = APP_EDIT_SET, .key = key, .value = value};
}

static void change(Walk *walk)
{
    char key[64], value[64];
    AppEdit edit = random_edit(walk, key, value);
    const int changes = walk->changes;
    const guint64 serial = app_document_serial(walk->document);
    app_document_begin_gesture(walk->document);
    assert_true(app_document_edit(walk->document, &edit, 1, NULL, NULL));
    app_document_end_gesture(walk->document);
    const char *text = app_document_text(walk->document);
    if (strcmp(text, g_ptr_array_index(walk->texts, walk->present)) == 0) {
        assert_int_equal(walk->changes, changes);
        return;
    }
    assert_int_equal(walk->changes, changes + 1);
    assert_true(app_document_serial(walk->document) > serial);
    assert_string_equal(app_history_undo_topic(app_document_history(walk->document)), key);
    g_ptr_array_set_size(walk->texts, (int)++walk->present);
    g_ptr_array_add(walk->texts, g_strdup(text));
}

static void step(Walk *walk)
{
    const guint64 serial = app_document_serial(walk->document);
    int choice = g_rand_int_range(walk->random, 0, 6);
    if (choice == 0) {
        gboolean can = walk->present > 0;
        assert_int_equal(app_document_undo(walk->document), can);
        walk->present -= can ? 1 : 0;
        assert_true(!can || app_document_serial(walk->document) > serial);
    } else if (choice == 1) {
        gboolean can = walk->present + 1 < walk->texts->len;
        assert_int_equal(app_document_redo(walk->document), can);
        walk->present += can ? 1 : 0;
    } else if (choice == 2) {
        assert_false(app_document_set(walk->document, "lights[0].colour", "red", NULL));
        assert_int_equal(app_document_serial(walk->document), serial);
    } else {
        change(walk);
    }
}

static void undoes_and_redoes_a_long_way(void **state)
{
    (void)state;
    Walk walk = {document_of_builtin("three-lights"), g_rand_new_with_seed(3), g_ptr_array_new_with_free_func(g_free),
                 0, 0};
    g_signal_connect(walk.document, "changed", G_CALLBACK(count_signal), &walk.changes);
    g_ptr_array_add(walk.texts, g_strdup(app_document_text(walk.document)));
    for (int i = 0; i < 1500; i++) {
        step(&walk);
        expect_present(&walk);
        if (i % 100 == 0)
            expect_scene_of_text(walk.document);
    }
    for (; app_document_undo(walk.document); expect_present(&walk))
        walk.present--;
    assert_int_equal(walk.present, 0);
    for (; app_document_redo(walk.document); expect_present(&walk))
        walk.present++;
    assert_int_equal(walk.present, walk.texts->len - 1);
    expect_scene_of_text(walk.document);
    g_ptr_array_unref(walk.texts);
    g_rand_free(walk.random);
    g_object_unref(walk.document);
}

/* ---- one step ---- */

static void set_in_gesture(AppDocument *document, const char *key, int from, int to)
{
    char value[16];
    app_document_begin_gesture(document);
    for (int i = from; i != to; i += from < to ? 1 : -1) {
        g_snprintf(value, sizeof value, "%d", i + (from < to ? 1 : -1));
        assert_true(app_document_set(document, key, value, NULL));
    }
    app_document_end_gesture(document);
}

static void makes_a_gesture_one_step(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    set_in_gesture(document, "lights[0].intensity", 10, 30);
    set_in_gesture(document, "lights[0].intensity", 30, 20);
    assert_key(document, "lights[0].intensity", "20");
    assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "30");
    assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "10");
    assert_false(app_document_undo(document));
    assert_true(app_document_redo(document));
    assert_key(document, "lights[0].intensity", "30");
    g_object_unref(document);
}

/* What changes nothing, first or last, and a way through the beginning: they are steps of their own nevertheless. */
static void keeps_gestures_apart(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    set_in_gesture(document, "lights[0].intensity", 10, 12);
    app_document_begin_gesture(document);
    assert_true(app_document_set(document, "lights[0].intensity", "12", NULL));
    assert_true(app_document_set(document, "lights[0].intensity", "13", NULL));
    assert_true(app_document_set(document, "lights[0].intensity", "12", NULL));
    assert_true(app_document_set(document, "lights[0].intensity", "11", NULL));
    app_document_end_gesture(document);
    assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "12");
    assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "10");
    g_object_unref(document);
}

static void makes_a_gesture_of_two_topics_two_steps(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    app_document_begin_gesture(document);
    app_document_begin_gesture(document); /* one within the other */
    assert_true(app_document_set(document, "lights[0].intensity", "11", NULL));
    assert_true(app_document_set(document, "lights[0].intensity", "12", NULL));
    app_document_end_gesture(document);
    assert_true(app_document_set(document, "lights[0].intensity", "13", NULL));
    assert_true(app_document_set(document, "surfaces[0].radius", "200", NULL));
    assert_true(app_document_set(document, "surfaces[0].radius", "210", NULL));
    app_document_end_gesture(document);
    app_document_end_gesture(document); /* one too many is harmless */
    assert_true(app_document_undo(document));
    assert_key(document, "surfaces[0].radius", "300");
    assert_key(document, "lights[0].intensity", "13");
    assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "10");
    assert_false(app_document_undo(document));
    g_object_unref(document);
}

/* Keys held down: no gesture, but changes of the same key at once. */
static void merges_quick_changes(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    assert_true(app_document_set(document, "lights[0].intensity", "11", NULL));
    assert_true(app_document_set(document, "lights[0].intensity", "12", NULL));
    assert_true(app_document_set(document, "surfaces[0].radius", "200", NULL));
    assert_true(app_document_undo(document));
    assert_key(document, "surfaces[0].radius", "300");
    g_object_unref(document);
}

static void makes_edits_together_or_not_at_all(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    char *before = g_strdup(app_document_text(document));
    AppEdit edits[] = {{.kind = APP_EDIT_SET, .key = "lights[0].intensity", .value = "5"},
                       {.kind = APP_EDIT_INSERT, .key = "points", .value = "[1, 2]", .index = 0},
                       {.kind = APP_EDIT_REMOVE, .key = "lights[0].name"}, /* is not written */
                       {.kind = APP_EDIT_MOVE, .key = "points", .index = 0, .to = 9}};
    luxel_diagnostics *faults = luxel_diagnostics_new();
    assert_false(app_document_edit(document, edits, 4, "all", faults));
    assert_true(luxel_diagnostics_total(faults, LUXEL_SEVERITY_ERROR) > 0);
    assert_string_equal(app_document_text(document), before);
    assert_false(app_history_can_undo(app_document_history(document)));
    edits[3].to = 3;
    assert_true(app_document_edit(document, edits, 4, "all", NULL));
    assert_key(document, "lights[0].intensity", "5");
    assert_key(document, "points[3]", "[1, 2]");
    assert_string_equal(app_history_undo_topic(app_document_history(document)), "all");
    assert_true(app_document_undo(document));
    assert_string_equal(app_document_text(document), before);
    assert_true(app_document_edit(document, NULL, 0, NULL, NULL));
    assert_string_equal(app_document_text(document), before);
    luxel_diagnostics_free(faults);
    g_free(before);
    g_object_unref(document);
}

static void is_left_alone_by_what_fails(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    char *before = g_strdup(app_document_text(document));
    int signals = 0;
    g_signal_connect(document, "changed", G_CALLBACK(count_signal), &signals);
    g_signal_connect(document, "renamed", G_CALLBACK(count_signal), &signals);
    assert_false(app_document_set(document, "lights[9].intensity", "1", NULL));
    assert_false(app_document_set(document, "nothing", "1", NULL));
    assert_false(app_document_set(document, "lights[0].intensity", "[1, 2", NULL));
    assert_false(app_document_open_builtin(document, "nothing", NULL));
    assert_false(app_document_open_file(document, "/nowhere/scene.yaml", NULL));
    assert_false(app_document_open_unsaved(document, "lights: [", NULL, NULL));
    assert_false(app_document_save(document, "/nowhere/scene.yaml", NULL));
    assert_false(app_document_undo(document));
    assert_false(app_document_redo(document));
    assert_string_equal(app_document_text(document), before);
    assert_string_equal(app_document_name(document), "report");
    assert_null(app_document_path(document));
    assert_false(app_document_is_modified(document));
    assert_int_equal(signals, 0);
    g_free(before);
    g_object_unref(document);
}

/* ---- values and files ---- */

static void tells_values(void **state)
{
    (void)state;
    gboolean written = FALSE;
    AppDocument *document = document_of_builtin("report");
    char *value = app_document_get(document, "lights[0].intensity", &written);
    assert_string_equal(value, "10");
    assert_true(written);
    g_free(value);
    value = app_document_get(document, "lights[0].enabled", &written); /* by default */
    assert_string_equal(value, "true");
    assert_false(written);
    g_free(value);
    assert_null(app_document_get(document, "lights[0].colour", &written));
    assert_null(app_document_get(document, "lights[1].intensity", NULL));
    assert_int_equal(app_document_size(document, "points"), 3);
    assert_int_equal(app_document_size(document, "nothing"), 0);
    set(document, "lights[0].intensity", "20");
    set(document, "surfaces[0].name", "ball");
    value = app_document_get_opened(document, "lights[0].intensity");
    assert_string_equal(value, "10");
    g_free(value);
    assert_null(app_document_get_opened(document, "surfaces[0].name"));
    AppDocument *copy = app_document_copy(document);
    set(copy, "lights[0].intensity", "30");
    assert_key(document, "lights[0].intensity", "20");
    assert_string_equal(app_document_name(copy), "report");
    luxel_scene *scene = app_document_copy_scene(document);
    assert_false(luxel_scene_is_committed(scene));
    assert_int_equal(luxel_scene_commit(scene, NULL), LUXEL_OK);
    luxel_scene_free(scene);
    g_object_unref(copy);
    g_object_unref(document);
}

static void saves(void **state)
{
    (void)state;
    char *folder = g_dir_make_tmp("luxel-app-XXXXXX", NULL), *contents = NULL;
    char *path = g_build_filename(folder, "work.yaml", NULL);
    AppDocument *document = document_of_builtin("report");
    int renamed = 0;
    g_signal_connect(document, "renamed", G_CALLBACK(count_signal), &renamed);
    set(document, "lights[0].intensity", "20");
    assert_true(app_document_is_modified(document));
    assert_int_equal(renamed, 1);
    assert_true(app_document_save(document, path, NULL));
    assert_false(app_document_is_modified(document));
    assert_int_equal(renamed, 2);
    assert_string_equal(app_document_path(document), path);
    assert_string_equal(app_document_name(document), "work.yaml");
    assert_true(g_file_get_contents(path, &contents, NULL, NULL));
    assert_string_equal(contents, app_document_text(document));
    char *value = app_document_get_opened(document, "lights[0].intensity");
    assert_string_equal(value, "20");
    g_free(value);
    assert_true(app_document_undo(document)); /* back beyond what was saved */
    assert_true(app_document_is_modified(document));
    assert_true(app_document_redo(document));
    assert_false(app_document_is_modified(document));
    set(document, "lights[0].intensity", "25");
    assert_true(app_document_save(document, app_document_path(document), NULL));
    assert_string_equal(app_document_path(document), path);
    AppDocument *other = app_document_new();
    assert_true(app_document_open_file(other, path, NULL));
    assert_string_equal(app_document_text(other), app_document_text(document));
    assert_string_equal(app_document_path(other), path);
    assert_false(app_document_is_modified(other));
    assert_true(app_document_open_file(other, app_document_path(other), NULL));
    assert_string_equal(app_document_path(other), path);
    g_unlink(path);
    g_rmdir(folder);
    g_free(contents);
    g_free(folder);
    g_free(path);
    g_object_unref(other);
    g_object_unref(document);
}

/* A picture brings its scene, but is not what the scene is saved to. */
static void opens_pictures(void **state)
{
    (void)state;
    char *folder = g_dir_make_tmp("luxel-app-XXXXXX", NULL), *path = g_build_filename(folder, "Ball.PNG", NULL);
    char *lower = g_build_filename(folder, "ball.png", NULL);
    AppDocument *document = document_of_builtin("report"), *other = app_document_new();
    set(document, "screen.resolution", "[20, 20]");
    AppShot *shot = shot_of(document, LUXEL_BRIGHTNESS);
    assert_int_equal(luxel_field_write(shot->field, lower, NULL), LUXEL_OK);
    assert_int_equal(g_rename(lower, path), 0);
    assert_true(app_document_open_file(other, path, NULL));
    assert_null(app_document_path(other));
    assert_string_equal(app_document_name(other), "Ball.PNG");
    assert_false(app_document_is_modified(other));
    assert_key(other, "screen.resolution", "[20, 20]");
    g_unlink(path);
    g_rmdir(folder);
    g_free(lower);
    g_free(path);
    g_free(folder);
    app_shot_unref(shot);
    g_object_unref(other);
    g_object_unref(document);
}

static void takes_up_unsaved_work(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report"), *other = app_document_new();
    set(document, "lights[0].intensity", "20");
    assert_true(app_document_open_unsaved(other, app_document_text(document), "/tmp/some/where.yaml", NULL));
    assert_string_equal(app_document_text(other), app_document_text(document));
    assert_string_equal(app_document_path(other), "/tmp/some/where.yaml");
    assert_true(app_document_is_modified(other));
    assert_false(app_document_undo(other));
    g_object_unref(other);
    g_object_unref(document);
}

static void stays_small(void **state)
{
    (void)state;
    enum { CHANGES = 10000, MOST_BYTES = 4000000 };
    AppDocument *document = document_of_builtin("three-lights");
    char value[16];
    set(document, "lights[0].intensity", "1");
    const gsize before = mallinfo2().uordblks;
    for (int i = 0; i < CHANGES; i++) {
        g_snprintf(value, sizeof value, "%d", 2 + i % 7);
        set(document, i % 2 ? "lights[0].intensity" : "surfaces[0].material.shininess", value);
    }
    const gsize after = mallinfo2().uordblks; /* both 0 where another allocator is at work */
    if (after > before + MOST_BYTES)
        fail_msg("%zu bytes for %d changes", after - before, CHANGES);
    for (int i = 0; i < CHANGES; i++)
        assert_true(app_document_undo(document));
    assert_key(document, "lights[0].intensity", "1");
    g_object_unref(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(undoes_and_redoes_a_long_way),
        cmocka_unit_test(makes_a_gesture_one_step),
        cmocka_unit_test(keeps_gestures_apart),
        cmocka_unit_test(makes_a_gesture_of_two_topics_two_steps),
        cmocka_unit_test(merges_quick_changes),
        cmocka_unit_test(makes_edits_together_or_not_at_all),
        cmocka_unit_test(is_left_alone_by_what_fails),
        cmocka_unit_test(tells_values),
        cmocka_unit_test(saves),
        cmocka_unit_test(opens_pictures),
        cmocka_unit_test(takes_up_unsaved_work),
        cmocka_unit_test(stays_small),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
