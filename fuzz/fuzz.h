/* SPDX-License-Identifier: MIT */
/*
 * Fuzz targets: programs that do with any bytes what a user would do with a file, and stop where something is wrong
 * that no sanitizer sees.  With clang's libFuzzer they look for such bytes; with replay.c they go through those that
 * were found before, as a plain test.
 */
#ifndef LUXEL_FUZZ_FUZZ_H
#define LUXEL_FUZZ_FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <luxel/luxel.h>

/* The target of a program; 0. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Stops the program where what must hold does not. */
void fuzz_must(bool holds, const char *what);

/*
 * A file of these bytes that is nowhere but in memory, and a symbolic link to it whose name has an ending, such as
 * ".off"; to be closed by fuzz_close().
 */
struct fuzz_file {
    int descriptor;
    char path[64]; /* of the link */
};
struct fuzz_file fuzz_open(const void *data, size_t size, const char *ending);
void fuzz_close(struct fuzz_file *file);

/* What a user may do with a scene that was read: commit, look, compute, probe, write.  Takes it over. */
void fuzz_use_scene(luxel_scene *scene);

/* Tries a scene that names a file of these bytes: `scene` is its text, with one %s for the file's name. */
void fuzz_use_file(const char *scene, const void *data, size_t size, const char *ending);

/* What the command says on standard error from fuzz_listen() to fuzz_heard(). */
struct fuzz_words {
    FILE *before;
    char *text;
    size_t length;
};
void fuzz_listen(struct fuzz_words *words);
/* How many lines were said, which must be whole and without characters that steer a terminal. */
size_t fuzz_heard(struct fuzz_words *words);

/* Diagnostics in words, all of them, which must be there. */
void fuzz_read_messages(const luxel_diagnostics *diagnostics);

#endif
