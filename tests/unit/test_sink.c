/* SPDX-License-Identifier: MIT */
/*
 * The sink keeps its word: a file appears whole or not at all, whatever fails.  Each promise is tried with unnamed
 * files and with the hidden names that take their place elsewhere.  Processes that die are test_sink_processes.c's.
 */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "place.h"

/* ---- stand-ins for system calls ---- */

/* Takes a few bytes at a time, and is interrupted now and then. */
static ssize_t write_little(int file, const void *bytes, size_t count)
{
    static unsigned calls;
    size_t few = 1 + ++calls % 4999;

    if (calls % 3 == 0) {
        errno = EINTR;
        return -1;
    }
    return write(file, bytes, count < few ? count : few);
}

static ssize_t write_full_disk(int file, const void *bytes, size_t count)
{
    if (lseek(file, 0, SEEK_CUR) == 0) {
        return write(file, bytes, count / 2); /* half of it still fits */
    }
    errno = ENOSPC;
    return -1;
}

static ssize_t write_nothing(int file, const void *bytes, size_t count)
{
    (void)file;
    (void)bytes;
    (void)count;
    return 0;
}

static int sync_fails(int file)
{
    (void)file;
    errno = EIO;
    return -1;
}

static int rename_fails(int folder, const char *from, const char *to)
{
    (void)folder;
    (void)from;
    (void)to;
    errno = EACCES;
    return -1;
}

/* Opening or writing fails with one report of this id that names the path and has this reason. */
static void assert_fails(const char *path, const struct lx_sink_system *system, const char *id, const char *reason)
{
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();

    assert_int_equal(sink_text(path, system, "new", diagnostics), LUXEL_ERROR_FILE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, id);
    char *text = luxel_diagnostics_message(diagnostics, 0, NULL, NULL);
    assert_non_null(strstr(text, reason));
    assert_non_null(strstr(text, path));
    luxel_text_free(text);
    luxel_diagnostics_free(diagnostics);
}

/* ---- what works ---- */

static void new_file(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    struct stat status;
    mode_t old = umask(027);

    assert_int_equal(sink_text(place->file, &system, "sphere", NULL), LUXEL_OK);
    umask(old);
    assert_content(place->file, "sphere");
    assert_int_equal(stat(place->file, &status), 0);
    assert_int_equal(status.st_mode & 07777, 0640);
    assert_int_equal(entries(place), 1);
}

static void replaced_file(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    struct stat status;

    put(place->file, "a longer old content");
    assert_int_equal(chmod(place->file, 0604), 0);
    assert_int_equal(sink_text(place->file, &system, "new", NULL), LUXEL_OK);
    assert_content(place->file, "new");
    assert_int_equal(stat(place->file, &status), 0);
    assert_int_equal(status.st_mode & 07777, 0604);
    assert_int_equal(entries(place), 1);
}

static void aborted(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    struct lx_sink *sink;

    put(place->file, "old");
    assert_int_equal(lx_sink_open(place->file, &system, NULL, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "new", 3), LUXEL_OK);
    lx_sink_abort(sink);
    lx_sink_abort(NULL);
    assert_content(place->file, "old");
    assert_int_equal(entries(place), 1);
}

/* Many writes of many lengths around the buffer's, by a system that takes them in pieces. */
static void pieces(struct place *place, bool unnamed)
{
    static const size_t lengths[] = {0, 1, 65535, 1, 65536, 65537, 3, 0, 200000, 5};
    struct lx_sink_system system = make_system(unnamed);
    unsigned char *bytes = malloc(200000), *found = malloc(500000);
    struct lx_sink *sink;
    size_t at = 0;

    system.write = write_little;
    for (size_t i = 0; i < 200000; i++) {
        bytes[i] = (unsigned char)(i * i >> 7);
    }
    assert_int_equal(lx_sink_open(place->file, &system, NULL, &sink), LUXEL_OK);
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        assert_int_equal(lx_sink_write(sink, bytes, lengths[i]), LUXEL_OK);
    }
    assert_int_equal(lx_sink_commit(sink), LUXEL_OK);
    FILE *file = fopen(place->file, "rb");
    size_t length = fread(found, 1, 500000, file);
    fclose(file);
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        assert_memory_equal(found + at, bytes, lengths[i]);
        at += lengths[i];
    }
    assert_int_equal(length, at);
    free(bytes);
    free(found);
}

/* Written out of order, and read back before the file is complete. */
static void out_of_order(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    struct lx_sink *sink, *other;
    char found[7] = "";

    assert_int_equal(lx_sink_open(place->file, &system, NULL, &sink), LUXEL_OK);
    assert_false(lx_sink_is_direct(sink));
    assert_int_equal(lx_sink_write(sink, "......", 6), LUXEL_OK);
    assert_int_equal(lx_sink_seek(sink, 3), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "ere", 3), LUXEL_OK);
    assert_int_equal(lx_sink_seek(sink, 0), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "sph", 3), LUXEL_OK);
    assert_int_equal(lx_sink_read_back(sink, 2, found, 4), LUXEL_OK);
    assert_string_equal(found, "here");

    /* Another sink for the same file leaves this one alone, and this one it. */
    assert_int_equal(lx_sink_open(place->file, &system, NULL, &other), LUXEL_OK);
    assert_int_equal(lx_sink_write(other, "other", 5), LUXEL_OK);
    assert_int_equal(lx_sink_commit(sink), LUXEL_OK);
    assert_content(place->file, "sphere");
    assert_int_equal(lx_sink_read_back(other, 0, found, 5), LUXEL_OK);
    assert_memory_equal(found, "other", 5);
    lx_sink_abort(other);
    assert_content(place->file, "sphere");
    assert_int_equal(entries(place), 1);
}

/* Room for more than any disk has is refused at once; for a little it is had; a device is not asked. */
static void reserved(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_sink *sink;
    char byte;

    assert_int_equal(lx_sink_open(place->file, &system, diagnostics, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_reserve(sink, 4096), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "sphere", 6), LUXEL_OK);
    assert_int_equal(lx_sink_commit(sink), LUXEL_OK);
    assert_content(place->file, "sphere");

    assert_int_equal(lx_sink_open(place->file, &system, diagnostics, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_reserve(sink, UINT64_C(1) << 62), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_seek(sink, 0), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_read_back(sink, 0, &byte, 1), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_commit(sink), LUXEL_ERROR_FILE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "file-not-written");
    assert_content(place->file, "sphere");
    assert_int_equal(entries(place), 1);

    assert_int_equal(lx_sink_open("/dev/null", &system, diagnostics, &sink), LUXEL_OK);
    assert_true(lx_sink_is_direct(sink));
    assert_int_equal(lx_sink_reserve(sink, UINT64_C(1) << 62), LUXEL_OK);
    assert_int_equal(lx_sink_commit(sink), LUXEL_OK);
    luxel_diagnostics_free(diagnostics);
}

static void test_links(void **state)
{
    struct place *place = *state;
    char link[128], other[128];

    /* To a file in the same folder, by a relative link, and by a link to that link. */
    put(place->file, "old");
    snprintf(link, sizeof link, "%s/link.png", place->folder);
    snprintf(other, sizeof other, "%s/link-to-link.png", place->folder);
    assert_int_equal(symlink("picture.png", link), 0);
    assert_int_equal(symlink(link, other), 0);
    assert_int_equal(sink_text(other, NULL, "through both", NULL), LUXEL_OK);
    assert_content(place->file, "through both");
    assert_true(readlink(link, other, sizeof other) > 0);
    assert_int_equal(entries(place), 3);

    /* To nothing yet. */
    assert_int_equal(unlink(place->file), 0);
    assert_int_equal(sink_text(link, NULL, "made", NULL), LUXEL_OK);
    assert_content(place->file, "made");

    /* To itself. */
    assert_int_equal(unlink(link), 0);
    assert_int_equal(symlink("link.png", link), 0);
    assert_fails(link, NULL, "file-not-created", "symbolic links");
}

static void test_streams(void **state)
{
    struct place *place = *state;
    char found[8] = "";
    int status;

    assert_int_equal(sink_text("/dev/null", NULL, "away", NULL), LUXEL_OK);
    assert_int_equal(mkfifo(place->file, 0600), 0);
    pid_t child = fork();
    if (child == 0) {
        _exit(sink_text(place->file, NULL, "pipe", NULL) == LUXEL_OK ? 0 : 1);
    }
    FILE *file = fopen(place->file, "r");
    assert_non_null(file);
    assert_int_equal(fread(found, 1, sizeof found, file), 4);
    fclose(file);
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
    assert_string_equal(found, "pipe");

    /* A link to a device is followed, and is still a link after that. */
    assert_int_equal(unlink(place->file), 0);
    assert_int_equal(symlink("/dev/null", place->file), 0);
    assert_int_equal(sink_text(place->file, NULL, "away", NULL), LUXEL_OK);
    assert_true(readlink(place->file, found, sizeof found) > 0);
}

static void test_names(void **state)
{
    struct place *place = *state;
    char path[PATH_MAX] = "";

    /* The longest name there is, and a path without a slash. */
    int length = snprintf(path, sizeof path, "%s/", place->folder);
    memset(path + length, 'x', NAME_MAX);
    path[length + NAME_MAX] = '\0';
    assert_int_equal(sink_text(path, NULL, "long", NULL), LUXEL_OK);
    assert_int_equal(sink_text(path, NULL, "again", NULL), LUXEL_OK);
    assert_content(path, "again");
    char *here = getcwd(NULL, 0);
    assert_int_equal(chdir(place->folder), 0);
    assert_int_equal(sink_text("short.png", NULL, "short", NULL), LUXEL_OK);
    assert_content("short.png", "short");
    assert_int_equal(chdir(here), 0);
    free(here);
}

/* ---- what fails ---- */

static void failing_calls(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);

    put(place->file, "old");
    system.write = write_full_disk;
    assert_fails(place->file, &system, "file-not-written", "No space left");
    system.write = write_nothing;
    assert_fails(place->file, &system, "file-not-written", "Input/output error");
    system = make_system(unnamed);
    system.sync = sync_fails;
    assert_fails(place->file, &system, "file-not-written", "Input/output error");
    system = make_system(unnamed);
    system.rename = rename_fails;
    assert_fails(place->file, &system, "file-not-replaced", "Permission denied");
    assert_content(place->file, "old");
    assert_int_equal(entries(place), 1);
}

static void test_places(void **state)
{
    struct place *place = *state;
    char path[128];

    assert_fails("/dev/full", NULL, "file-not-written", "No space left");
    assert_fails(place->folder, NULL, "file-not-created", "Is a directory");
    assert_fails("", NULL, "file-not-created", "No such file");
    snprintf(path, sizeof path, "%s/missing/picture.png", place->folder);
    assert_fails(path, NULL, "file-not-created", "No such file");
    snprintf(path, sizeof path, "%s/missing/", place->folder);
    assert_fails(path, NULL, "file-not-created", "Is a directory");
    put(place->file, "old");
    snprintf(path, sizeof path, "%s/below", place->file);
    assert_fails(path, NULL, "file-not-created", "Not a directory");
}

/* Between opening and finishing. */
static void folder_vanishes(struct place *place, bool unnamed)
{
    struct lx_sink_system system = make_system(unnamed);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_sink *sink;
    char path[300];

    assert_int_equal(lx_sink_open(place->file, &system, diagnostics, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "new", 3), LUXEL_OK);
    DIR *folder = opendir(place->folder);
    for (const struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        snprintf(path, sizeof path, "%s/%s", place->folder, entry->d_name);
        unlink(path); /* the hidden file, if there is one */
    }
    closedir(folder);
    assert_int_equal(rmdir(place->folder), 0);
    assert_int_equal(lx_sink_commit(sink), LUXEL_ERROR_FILE);
    assert_string_equal(luxel_diagnostics_get(diagnostics, 0)->id, "file-not-replaced");
    luxel_diagnostics_free(diagnostics);
    assert_int_equal(mkdir(place->folder, 0700), 0);
}

/* A failure is told once, and a later one not again. */
static void test_one_report(void **state)
{
    struct place *place = *state;
    struct lx_sink_system system = make_system(true);
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();
    struct lx_sink *sink;

    assert_int_equal(lx_sink_open(place->file, &system, diagnostics, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_fail(sink, LX_MSG_PNG_FAILED, "a reason"), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_fail(sink, LX_MSG_PNG_FAILED, "another"), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_write(sink, "x", 1), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_status(sink), LUXEL_ERROR_FILE);
    assert_int_equal(lx_sink_commit(sink), LUXEL_ERROR_FILE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_int_equal(entries(place), 0);
    luxel_diagnostics_free(diagnostics);
}

/* As a user without root's privileges: neither a protected folder nor a protected file is written to. */
static void write_protected(const struct place *place)
{
    char inside[128];

    if (geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0)) {
        _exit(CANNOT_TRY);
    }
    snprintf(inside, sizeof inside, "%s/new.png", place->folder);
    bool refused = sink_text(place->file, NULL, "new", NULL) == LUXEL_ERROR_FILE;
    _exit(refused && (access(place->folder, W_OK) == 0 || sink_text(inside, NULL, "new", NULL) == LUXEL_ERROR_FILE)
              ? 0
              : 1);
}

static void test_protected(void **state)
{
    struct place *place = *state;

    put(place->file, "old");
    assert_int_equal(chmod(place->folder, 0555), 0);
    assert_int_equal(in_child(write_protected, place), 0);
    assert_int_equal(chmod(place->folder, 0777), 0);
    assert_int_equal(chmod(place->file, 0444), 0);
    assert_int_equal(in_child(write_protected, place), 0);
    assert_content(place->file, "old");
    assert_int_equal(entries(place), 1);
}

BOTH_WAYS(new_file)
BOTH_WAYS(replaced_file)
BOTH_WAYS(aborted)
BOTH_WAYS(pieces)
BOTH_WAYS(failing_calls)
BOTH_WAYS(out_of_order)
BOTH_WAYS(reserved)
BOTH_WAYS(folder_vanishes)

/* ---- memory ---- */

/* A file in memory holds what the file of the same writes holds: in pieces of all sizes, with places gone back to. */
static void test_memory_is_a_file(void **state)
{
    enum { LARGE = 200000 };
    static unsigned char large[LARGE], read[LARGE];
    struct place *place = *state;
    unsigned char *bytes = NULL;
    size_t length = 0;
    struct lx_sink *sinks[2];
    const struct lx_destination memory = {"name.bin", &bytes, &length};

    for (size_t i = 0; i < LARGE; i++) {
        large[i] = (unsigned char)(i * i >> 7);
    }
    assert_int_equal(lx_sink_open(place->file, NULL, NULL, &sinks[0]), LUXEL_OK);
    assert_int_equal(lx_sink_open_at(&memory, NULL, &sinks[1]), LUXEL_OK);
    assert_false(lx_sink_is_direct(sinks[1]));
    for (int i = 0; i < 2; i++) {
        assert_int_equal(lx_sink_reserve(sinks[i], LARGE), LUXEL_OK);
        assert_int_equal(lx_sink_write(sinks[i], "head", 4), LUXEL_OK);
        assert_int_equal(lx_sink_write(sinks[i], large, LARGE), LUXEL_OK);
        assert_int_equal(lx_sink_seek(sinks[i], 2), LUXEL_OK);
        assert_int_equal(lx_sink_write(sinks[i], "--", 2), LUXEL_OK);
        assert_int_equal(lx_sink_seek(sinks[i], LARGE + 1000), LUXEL_OK);
        assert_int_equal(lx_sink_write(sinks[i], large, 77), LUXEL_OK);
        assert_int_equal(lx_sink_read_back(sinks[i], 4, read, LARGE), LUXEL_OK);
        assert_memory_equal(read, large, LARGE);
        assert_null(bytes);
    }
    assert_int_equal(lx_sink_commit(sinks[0]), LUXEL_OK);
    assert_int_equal(lx_sink_commit(sinks[1]), LUXEL_OK);
    assert_int_equal(length, LARGE + 1077);
    FILE *file = fopen(place->file, "rb");
    assert_non_null(file);
    for (size_t i = 0; i < length; i++) {
        assert_int_equal(getc(file), bytes[i]);
    }
    assert_int_equal(getc(file), EOF);
    fclose(file);
    luxel_bytes_free(bytes);
}

static void test_memory_that_is_given_up(void **state)
{
    unsigned char *bytes = NULL, byte;
    size_t length = 77;
    struct lx_sink *sink;
    const struct lx_destination memory = {"name.bin", &bytes, &length};
    luxel_diagnostics *diagnostics = luxel_diagnostics_new();

    (void)state;
    assert_int_equal(lx_sink_open_at(&memory, NULL, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "head", 4), LUXEL_OK);
    lx_sink_abort(sink);
    assert_int_equal(lx_sink_open_at(&memory, diagnostics, &sink), LUXEL_OK);
    assert_int_equal(lx_sink_write(sink, "head", 4), LUXEL_OK);
    assert_int_equal(lx_sink_read_back(sink, 4, &byte, 1), LUXEL_ERROR_FILE); /* beyond what was written */
    assert_int_equal(lx_sink_commit(sink), LUXEL_ERROR_FILE);
    assert_int_equal(luxel_diagnostics_count(diagnostics), 1);
    assert_null(bytes);
    assert_int_equal(length, 77);
    luxel_diagnostics_free(diagnostics);
    /* an empty file is one, too */
    assert_int_equal(lx_sink_put(&memory, "", 0, NULL), LUXEL_OK);
    assert_non_null(bytes);
    assert_int_equal(length, 0);
    luxel_bytes_free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        CASES(new_file),
        CASES(replaced_file),
        CASES(aborted),
        CASES(pieces),
        CASE(links),
        CASE(streams),
        CASE(names),
        CASES(failing_calls),
        CASES(out_of_order),
        CASES(reserved),
        CASE(places),
        CASE(one_report),
        CASE(protected),
        CASES(folder_vanishes),
        CASE(memory_is_a_file),
        CASE(memory_that_is_given_up),
    };

    return cmocka_run_group_tests_name("sink", tests, NULL, NULL);
}
