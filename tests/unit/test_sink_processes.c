/* SPDX-License-Identifier: MIT */
/*
 * The sink among processes: whenever one dies, and however many write the same file, it is whole and nothing else
 * is left, or what is left is removed by the next.  The disk that fills up needs a process of its own, too.
 */
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include "place.h"

static int rename_dies(int folder, const char *from, const char *to)
{
    (void)folder;
    (void)from;
    (void)to;
    raise(SIGKILL);
    return -1;
}

/* ---- processes that die, and processes that meet ---- */

static void die_writing(const struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    struct lx_sink *sink;
    char bytes[70000] = "";

    if (lx_sink_open(place->file, &system, NULL, &sink) == LUXEL_OK) {
        lx_sink_write(sink, bytes, sizeof bytes);
        raise(SIGKILL);
    }
}

static void die_writing_unnamed(const struct place *place)
{
    die_writing(place, true);
}

static void die_writing_hidden(const struct place *place)
{
    die_writing(place, false);
}

static void die_renaming(const struct place *place)
{
    struct lx_sink_system system = make_system(true);

    system.rename = rename_dies;
    sink_text(place->file, &system, "new", NULL);
}

static void assert_killed(int status)
{
    assert_true(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

static void test_killed_unnamed(void **state)
{
    struct place *place = *state;

    put(place->file, "old");
    assert_killed(in_child(die_writing_unnamed, place));
    assert_content(place->file, "old");
    assert_int_equal(entries(place), 1);
}

/* Where the dead could not clean up, the next one does. */
static void test_leftovers(void **state)
{
    struct place *place = *state;

    put(place->file, "old");
    for (int i = 0; i < 2; i++) {
        assert_killed(in_child(i == 0 ? die_writing_hidden : die_renaming, place));
        assert_content(place->file, "old");
        assert_int_equal(entries(place), 2);

        struct lx_sink *sink;
        assert_int_equal(lx_sink_open(place->file, NULL, NULL, &sink), LUXEL_OK);
        lx_sink_abort(sink);
        assert_int_equal(entries(place), 1);
    }
}

/* One of many that write the same file over and over: 3000 times the same letter. */
static void compete(const struct place *place, bool unnamed, char letter)
{
    struct lx_sink_system system = make_system(unnamed);
    char bytes[3000];

    memset(bytes, letter, sizeof bytes);
    for (int i = 0; i < 20; i++) {
        struct lx_sink *sink;

        if (lx_sink_open(place->file, &system, NULL, &sink) != LUXEL_OK) {
            _exit(1);
        }
        lx_sink_write(sink, bytes, sizeof bytes);
        if (lx_sink_commit(sink) != LUXEL_OK) {
            _exit(2);
        }
    }
    _exit(0);
}

static void contest(struct place *place, bool unnamed)
{
    enum { COMPETITORS = 12 }; /* more than there are hidden names */
    char bytes[4096];
    int running = COMPETITORS, status;

    for (int i = 0; i < COMPETITORS; i++) {
        pid_t child = fork();
        if (child == 0) {
            compete(place, unnamed, (char)('a' + i));
        }
        assert_true(child > 0);
    }
    while (running > 0) {
        FILE *file = fopen(place->file, "r");
        if (file != NULL) {
            assert_int_equal(fread(bytes, 1, sizeof bytes, file), 3000);
            fclose(file);
            for (int i = 1; i < 3000; i++) {
                assert_int_equal(bytes[i], bytes[0]);
            }
        }
        while (waitpid(-1, &status, WNOHANG) > 0) {
            assert_int_equal(status, 0);
            running--;
        }
    }
    assert_int_equal(entries(place), 1);
}

BOTH_WAYS(contest)

/* ---- a disk that fills up ---- */

/* Puts a file system of 64 kB on the folder, in a name space of this process alone. */
static bool mount_small(const struct place *place)
{
    return unshare(CLONE_NEWNS) == 0 && mount("none", "/", "none", MS_REC | MS_PRIVATE, NULL) == 0 &&
           mount("luxel", place->folder, "tmpfs", 0, "size=64k") == 0;
}

static void fill_disk(const struct place *place)
{
    char bytes[4096] = "";
    struct lx_sink *sink;
    luxel_status status = LUXEL_OK;
    char path[128];

    if (!mount_small(place)) {
        _exit(CANNOT_TRY);
    }
    snprintf(path, sizeof path, "%s/old.png", place->folder);
    if (sink_text(path, NULL, "old", NULL) != LUXEL_OK || lx_sink_open(path, NULL, NULL, &sink) != LUXEL_OK) {
        _exit(1);
    }
    for (int i = 0; i < 64; i++) {
        status = lx_sink_write(sink, bytes, sizeof bytes);
    }
    if (status != LUXEL_ERROR_FILE || lx_sink_commit(sink) != LUXEL_ERROR_FILE || entries(place) != 1) {
        _exit(2);
    }
    FILE *file = fopen(path, "r");
    _exit(fread(bytes, 1, sizeof bytes, file) == 3 && memcmp(bytes, "old", 3) == 0 ? 0 : 3);
}

static void test_full_disk(void **state)
{
    assert_int_equal(in_child(fill_disk, *state), 0);
}

/* ---- what this machine can try ---- */

static void try_mount(const struct place *place)
{
    _exit(mount_small(place) ? 0 : CANNOT_TRY);
}

static void try_unnamed(const struct place *place)
{
    int folder = open(place->folder, O_RDONLY | O_DIRECTORY);

    _exit(lx_sink_real_system.open_unnamed(folder, 0600) >= 0 ? 0 : CANNOT_TRY);
}

/* Whether a test makes sense here; one that does not is left out, so that it does not count as passed. */
static bool possible(void (*part)(const struct place *), const char *test)
{
    void *place;

    make_place(&place);
    bool works = in_child(part, place) == 0;
    remove_place(&place);
    if (!works) {
        printf("# SKIP %s: not possible on this machine\n", test);
        fflush(stdout);
    }
    return works;
}

int main(void)
{
    struct CMUnitTest tests[] = {CASE(leftovers), CASES(contest), CASE(full_disk), CASE(killed_unnamed)};
    const struct CMUnitTest last = tests[sizeof tests / sizeof tests[0] - 1];
    size_t count = sizeof tests / sizeof tests[0] - 2;

    if (possible(try_mount, "full_disk")) {
        count++;
    }
    if (possible(try_unnamed, "killed_unnamed")) {
        tests[count++] = last;
    }
    return _cmocka_run_group_tests("sink processes", tests, count, NULL, NULL);
}
