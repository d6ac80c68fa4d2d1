/* SPDX-License-Identifier: MIT */
/* What the tests of file formats share: a folder for each case, and a file in it that is made of bytes. */
#ifndef TEST_FILES_H
#define TEST_FILES_H

/* cmocka.h asks for the next four. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "format/format.h"

struct files {
    char folder[64];
    char path[96]; /* of the file that was made last */
};

/* Set-up and tear-down of a case; the folder's files are removed. */
int make_files(void **state);
int remove_files(void **state);

/* Makes the file `name` of these bytes, and files->path its path. */
void make_file(struct files *files, const char *name, const void *bytes, size_t length);

/* The bytes of a file, of malloc(). */
unsigned char *file_bytes(const char *path, size_t *length);

/* Writes an image to the file `name` and reads it back. */
void write_and_read(struct files *files, const char *name, const struct lx_image *image, struct lx_loaded *loaded);

/* Reads the file that was made last, which must fail with this status and exactly one message, of this id. */
void assert_refused(const struct files *files, luxel_status status, const char *id);

#define FILES_CASE(name) cmocka_unit_test_setup_teardown(test_##name, make_files, remove_files)

#endif
