/* SPDX-License-Identifier: MIT */
/* A drawn file's bytes. */
#ifndef TESTS_FIGURE_TAKE_FILE_H
#define TESTS_FIGURE_TAKE_FILE_H

#include <stddef.h>

/* All of a file, of malloc(), which is removed then; NULL where that cannot be.  For any thread. */
char *take_file(const char *path, size_t *length);

#endif
