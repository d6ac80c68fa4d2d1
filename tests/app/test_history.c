/* SPDX-License-Identifier: MIT */
/* The history of a text: every step back and forth, what becomes one step, and what it is about. */
#include <string.h>

#include "../../app/files/history.h"
#include "scenes.h"

enum { STEPS = 3000, LONGEST = 60 };

/* Takes the text over and gives the next one. */
static char *back(AppHistory *history, char *text)
{
    char *next = app_history_undo(history, text);
    assert_non_null(next);
    g_free(text);
    return next;
}

static char *forth(AppHistory *history, char *text)
{
    char *next = app_history_redo(history, text);
    assert_non_null(next);
    g_free(text);
    return next;
}

/* A text with another piece in it somewhere, whole characters or not. */
static char *mutate(GRand *random, const char *text)
{
    static const char *const pieces[] = {"", "a", "aa", "\u044f", "\u044e", "intensity: 10", "\n", "-", "[0, 0]"};
    const gsize length = strlen(text), from = (gsize)g_rand_int_range(random, 0, (gint32)length + 1);
    const gsize to = (gsize)g_rand_int_range(random, (gint32)from, (gint32)MIN(length, from + 9) + 1);
    GString *changed = g_string_new_len(text, (gssize)from);
    if (length < LONGEST)
        g_string_append(changed, pieces[g_rand_int_range(random, 0, G_N_ELEMENTS(pieces))]);
    g_string_append(changed, text + to);
    return g_string_free(changed, FALSE);
}

static void goes_back_and_forth(void **state)
{
    (void)state;
    GRand *random = g_rand_new_with_seed(1);
    AppHistory *history = app_history_new();
    GPtrArray *texts = g_ptr_array_new_with_free_func(g_free);
    g_ptr_array_add(texts, g_strdup(""));
    guint present = 0;
    char *text = g_strdup("");
    for (int i = 0; i < STEPS; i++) {
        int choice = g_rand_int_range(random, 0, 5);
        if (choice == 0 && present > 0) {
            text = back(history, text);
            present--;
        } else if (choice == 1 && present + 1 < texts->len) {
            text = forth(history, text);
            present++;
        } else {
            char *after = mutate(random, text);
            app_history_add(history, text, after, "topic", FALSE);
            if (strcmp(after, text) != 0) {
                g_ptr_array_set_size(texts, (int)++present);
                g_ptr_array_add(texts, g_strdup(after));
            } else {
                g_ptr_array_set_size(texts, (int)present + 1);
            }
            g_free(text);
            text = after;
        }
        assert_string_equal(text, g_ptr_array_index(texts, present));
        assert_int_equal(app_history_can_undo(history), present > 0);
        assert_int_equal(app_history_can_redo(history), present + 1 < texts->len);
    }
    while (app_history_can_undo(history))
        text = back(history, text);
    assert_string_equal(text, "");
    while (app_history_can_redo(history))
        text = forth(history, text);
    assert_string_equal(text, g_ptr_array_index(texts, texts->len - 1));
    g_free(text);
    g_ptr_array_unref(texts);
    app_history_free(history);
    g_rand_free(random);
}

static void has_nothing_at_first(void **state)
{
    (void)state;
    AppHistory *history = app_history_new();
    assert_false(app_history_can_undo(history));
    assert_false(app_history_can_redo(history));
    assert_null(app_history_undo(history, "a"));
    assert_null(app_history_redo(history, "a"));
    assert_null(app_history_undo_topic(history));
    assert_null(app_history_redo_topic(history));
    app_history_add(history, "a", "b", "x", FALSE);
    app_history_clear(history);
    assert_null(app_history_undo(history, "b"));
    app_history_free(history);
    app_history_free(NULL);
}

static void knows_topics(void **state)
{
    (void)state;
    AppHistory *history = app_history_new();
    app_history_add(history, "a", "b", "one", FALSE);
    app_history_add(history, "b", "c", "two", FALSE);
    assert_string_equal(app_history_undo_topic(history), "two");
    assert_null(app_history_redo_topic(history));
    g_free(app_history_undo(history, "c"));
    assert_string_equal(app_history_undo_topic(history), "one");
    assert_string_equal(app_history_redo_topic(history), "two");
    app_history_add(history, "b", "d", "three", FALSE);
    assert_false(app_history_can_redo(history));
    app_history_free(history);
}

static void expect_undo(AppHistory *history, const char *text, const char *before)
{
    char *found = app_history_undo(history, text);
    assert_non_null(found);
    assert_string_equal(found, before);
    g_free(found);
}

static void merges_what_belongs_together(void **state)
{
    (void)state;
    AppHistory *history = app_history_new();
    app_history_add(history, "x: 1, y: 1", "x: 2, y: 1", "x", FALSE);
    app_history_add(history, "x: 2, y: 1", "x: 33, y: 1", "x", TRUE);
    app_history_add(history, "x: 33, y: 1", "x: 4, y: 7", "x", TRUE);
    app_history_add(history, "x: 4, y: 7", "x: 4, y: 8", "y", TRUE); /* another topic */
    expect_undo(history, "x: 4, y: 8", "x: 4, y: 7");
    app_history_add(history, "x: 4, y: 7", "x: 5, y: 7", "x", TRUE); /* something was undone since */
    expect_undo(history, "x: 5, y: 7", "x: 4, y: 7");
    expect_undo(history, "x: 4, y: 7", "x: 1, y: 1");
    assert_false(app_history_can_undo(history));
    app_history_free(history);
}

/* A drag that passes its beginning is still not one with the drag before. */
static void keeps_drags_apart(void **state)
{
    (void)state;
    AppHistory *history = app_history_new();
    app_history_add(history, "1", "2", "x", FALSE);
    app_history_add(history, "2", "3", "x", FALSE);
    app_history_add(history, "3", "2", "x", TRUE);
    assert_string_equal(app_history_undo_topic(history), "x");
    app_history_add(history, "2", "4", "x", TRUE);
    app_history_add(history, "4", "5", "x", TRUE);
    expect_undo(history, "5", "2");
    expect_undo(history, "2", "1");
    assert_false(app_history_can_undo(history));
    app_history_free(history);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_back_and_forth), cmocka_unit_test(has_nothing_at_first),
        cmocka_unit_test(knows_topics),        cmocka_unit_test(merges_what_belongs_together),
        cmocka_unit_test(keeps_drags_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
