/* SPDX-License-Identifier: MIT */
/*
 * Unsaved work: what a program leaves that is killed, and nothing where work was saved, given up or still goes on.
 * Run with an argument it is such a program itself, which changes something and says so when it was written.
 */
#include <glib/gstdio.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../../app/files/recovery.h"
#include "scenes.h"

static char *program, *state_folder, *folder; /* folder: where work is kept */

/* How many entries the folder has whose names hold `part`. */
static guint entries(const char *part)
{
    guint count = 0;
    GDir *all = g_dir_open(folder, 0, NULL);
    for (const char *name; all && (name = g_dir_read_name(all));)
        count += strstr(name, part) ? 1 : 0;
    if (all)
        g_dir_close(all);
    return count;
}

/* Whether a file is on its way: it gets its name when it is whole. */
static gboolean is_being_written(gpointer data)
{
    (void)data;
    return entries(".unsaved.") > entries(".lock");
}

static gboolean is_written(gpointer data)
{
    return !is_being_written(data);
}

static int remove_entries(void **state)
{
    (void)state;
    GDir *all = g_dir_open(folder, 0, NULL);
    for (const char *name; all && (name = g_dir_read_name(all));) {
        char *file = g_build_filename(folder, name, NULL);
        g_unlink(file);
        g_free(file);
    }
    if (all)
        g_dir_close(all);
    return 0;
}

/* ---- other programs ---- */

/* Whether a file of work holds a text; its lock and what is on its way to it do not count. */
static gboolean is_kept(gpointer words)
{
    gboolean found = FALSE;
    GDir *all = g_dir_open(folder, 0, NULL);
    for (const char *name; all && !found && (name = g_dir_read_name(all));) {
        char *file = g_build_filename(folder, name, NULL), *contents = NULL;
        found = g_str_has_suffix(name, ".unsaved") && g_file_get_contents(file, &contents, NULL, NULL) &&
                strstr(contents, words);
        g_free(contents);
        g_free(file);
    }
    if (all)
        g_dir_close(all);
    return found;
}

/* Changes something, waits until that is kept, says so, and goes on for ever. */
static int work(const char *intensity)
{
    AppDocument *document = document_of_builtin("spot");
    AppRecovery *recovery = app_recovery_new(document);
    char *words = g_strconcat("intensity: ", intensity, NULL);
    set(document, "lights[0].intensity", intensity);
    wait_until(is_kept, words);
    g_free(words);
    if (write(STDOUT_FILENO, "w", 1) != 1)
        return 1;
    for (;;)
        pause();
    app_recovery_free(recovery);
    return 0;
}

/* Starts one, and waits until its work is kept. */
static pid_t start(const char *intensity)
{
    int ends[2];
    char said = 0;
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        execl(program, program, intensity, (char *)NULL);
        _exit(1);
    }
    close(ends[1]);
    assert_true(child > 0);
    assert_int_equal(read(ends[0], &said, 1), 1);
    assert_int_equal(said, 'w');
    close(ends[0]);
    return child;
}

static void end(pid_t child)
{
    int status;
    assert_int_equal(kill(child, SIGKILL), 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
}

/* ---- cases ---- */

static void finds_what_was_killed(void **state)
{
    (void)state;
    end(start("4321"));
    GPtrArray *found = app_unsaved_find();
    assert_int_equal(found->len, 1);
    const AppUnsaved *unsaved = g_ptr_array_index(found, 0);
    assert_non_null(strstr(unsaved->text, "intensity: 4321"));
    assert_null(unsaved->path);
    assert_true(unsaved->time > 1600000000);
    AppDocument *document = document_of_text(unsaved->text);
    assert_key(document, "lights[0].intensity", "4321");
    g_object_unref(document);
    app_unsaved_discard(unsaved);
    g_ptr_array_unref(found);
    found = app_unsaved_find();
    assert_int_equal(found->len, 0);
    g_ptr_array_unref(found);
    assert_int_equal(entries(""), 0);
}

static void leaves_the_living_alone(void **state)
{
    (void)state;
    pid_t one = start("11"), other = start("22");
    GPtrArray *found = app_unsaved_find();
    assert_int_equal(found->len, 0);
    g_ptr_array_unref(found);
    end(one);
    found = app_unsaved_find();
    assert_int_equal(found->len, 1);
    assert_non_null(strstr(((AppUnsaved *)g_ptr_array_index(found, 0))->text, "intensity: 11"));
    g_ptr_array_unref(found);
    end(other);
    found = app_unsaved_find();
    assert_int_equal(found->len, 2);
    g_ptr_array_unref(found);
}

static void keeps_what_is_closed_unsaved(void **state)
{
    (void)state;
    static const char odd[] = "# \\n \"odd\"\t= \u043b\u0430\u043c\u043f\u0430 [unsaved]; \n  # text=1\nluxel: 1\n"
                              "lights: [{type: ambient, irradiance: 1}]   \n\n";
    char *path = g_build_filename(state_folder, "\u0444\u0430\u0439\u043b = 1.yaml", NULL);
    AppDocument *document = app_document_new();
    assert_true(app_document_open_unsaved(document, odd, path, NULL));
    AppRecovery *recovery = app_recovery_new(document);
    GPtrArray *found = app_unsaved_find();
    assert_int_equal(found->len, 0);
    g_ptr_array_unref(found);
    app_recovery_free(recovery);
    found = app_unsaved_find();
    assert_int_equal(found->len, 1);
    const AppUnsaved *unsaved = g_ptr_array_index(found, 0);
    assert_string_equal(unsaved->text, odd);
    assert_string_equal(unsaved->path, path);
    assert_string_equal(unsaved->name, "\u0444\u0430\u0439\u043b = 1.yaml");
    GStatBuf about;
    assert_int_equal(g_stat(unsaved->file, &about), 0);
    assert_int_equal(about.st_mode & 077, 0); /* nobody else's business */
    g_ptr_array_unref(found);
    g_object_unref(document);
    g_free(path);
}

static void leaves_nothing_of_what_was_saved(void **state)
{
    (void)state;
    char *path = g_build_filename(state_folder, "saved.yaml", NULL);
    AppDocument *document = document_of_builtin("report");
    AppRecovery *recovery = app_recovery_new(document);
    set(document, "lights[0].intensity", "20");
    wait_until(is_kept, "intensity: 20");
    app_recovery_write(recovery);
    assert_true(app_document_save(document, path, NULL));
    app_recovery_free(recovery);
    assert_int_equal(entries(""), 0);
    recovery = app_recovery_new(document);
    app_recovery_free(recovery);
    assert_int_equal(entries(""), 0);
    app_recovery_free(NULL);
    g_unlink(path);
    g_object_unref(document);
    g_free(path);
}

static gboolean has_no_work(gpointer data)
{
    (void)data;
    return !is_kept("");
}

/* After saving, too, a second later at most, should it crash then. */
static void takes_back_what_was_saved(void **state)
{
    (void)state;
    char *path = g_build_filename(state_folder, "saved.yaml", NULL);
    AppDocument *document = document_of_builtin("report");
    AppRecovery *recovery = app_recovery_new(document);
    set(document, "lights[0].intensity", "20");
    app_recovery_write(recovery);
    assert_false(has_no_work(NULL));
    assert_true(app_document_save(document, path, NULL));
    wait_until(has_no_work, NULL);
    assert_true(app_document_undo(document));
    app_recovery_write(recovery);
    assert_false(has_no_work(NULL));
    assert_true(app_document_redo(document));
    wait_until(has_no_work, NULL);
    app_recovery_free(recovery);
    assert_int_equal(entries(""), 0);
    g_unlink(path);
    g_object_unref(document);
    g_free(path);
}

static void forgets_what_was_given_up(void **state)
{
    (void)state;
    AppDocument *document = document_of_builtin("report");
    AppRecovery *recovery = app_recovery_new(document);
    set(document, "lights[0].intensity", "20");
    app_recovery_write(recovery);
    assert_false(has_no_work(NULL));
    app_recovery_forget(recovery);
    wait_until(has_no_work, NULL);
    set(document, "lights[0].intensity", "21"); /* going on after all */
    app_recovery_write(recovery);
    assert_false(has_no_work(NULL));
    app_recovery_forget(recovery);
    app_recovery_free(recovery);
    assert_int_equal(entries(""), 0);
    g_object_unref(document);
}

/* What is being written when the work is given up must not come after that. */
static void is_not_overtaken(void **state)
{
    (void)state;
    enum { LINES = 400000 };
    GString *text = g_string_new(NULL);
    for (int i = 0; i < LINES; i++)
        g_string_append(text, "# so long that writing it takes a while\n");
    g_string_append(text, "lights: [{type: ambient, irradiance: 1}]\n");
    AppDocument *document = document_of_text(text->str);
    AppRecovery *recovery = app_recovery_new(document);
    set(document, "lights[0].irradiance", "2");
    wait_until(is_being_written, NULL);
    app_recovery_forget(recovery);
    app_recovery_free(recovery);
    wait_until(is_written, NULL);
    run_for(50);
    assert_int_equal(entries(""), 0);
    g_string_free(text, TRUE);
    g_object_unref(document);
}

/* Work as if a program had left it at that time. */
static void leave(const char *name, const char *contents)
{
    char *file = g_build_filename(folder, name, NULL);
    assert_true(g_file_set_contents(file, contents, -1, NULL));
    g_free(file);
}

static void lists_the_newest_first(void **state)
{
    (void)state;
    leave("a.unsaved", "[unsaved]\ntext=a\ntime=100\n");
    leave("b.unsaved", "[unsaved]\ntext=b\ntime=300\n");
    leave("c.unsaved", "[unsaved]\ntext=c\ntime=200\n");
    leave("broken.unsaved", "[unsav");
    leave("empty.unsaved", "");
    leave("textless.unsaved", "[unsaved]\ntime=400\n");
    leave("other.txt", "[unsaved]\ntext=x\ntime=400\n");
    GPtrArray *found = app_unsaved_find();
    assert_int_equal(found->len, 3);
    for (guint i = 0; i < 3; i++)
        assert_string_equal(((AppUnsaved *)g_ptr_array_index(found, i))->text, i == 0 ? "b" : i == 1 ? "c" : "a");
    g_ptr_array_unref(found);
}

int main(int count, char **arguments)
{
    program = arguments[0];
    if (count > 1) {
        folder = g_build_filename(g_get_user_state_dir(), "luxel", NULL);
        return work(arguments[1]);
    }
    state_folder = g_dir_make_tmp("luxel-app-XXXXXX", NULL);
    folder = g_build_filename(state_folder, "luxel", NULL);
    g_setenv("XDG_STATE_HOME", state_folder, TRUE);
    g_mkdir(folder, 0700);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(finds_what_was_killed, remove_entries),
        cmocka_unit_test_teardown(leaves_the_living_alone, remove_entries),
        cmocka_unit_test_teardown(keeps_what_is_closed_unsaved, remove_entries),
        cmocka_unit_test_teardown(leaves_nothing_of_what_was_saved, remove_entries),
        cmocka_unit_test_teardown(takes_back_what_was_saved, remove_entries),
        cmocka_unit_test_teardown(forgets_what_was_given_up, remove_entries),
        cmocka_unit_test_teardown(is_not_overtaken, remove_entries),
        cmocka_unit_test_teardown(lists_the_newest_first, remove_entries),
    };
    int failures = cmocka_run_group_tests(tests, NULL, NULL);
    g_rmdir(folder);
    g_rmdir(state_folder);
    g_free(folder);
    g_free(state_folder);
    return failures;
}
