/* SPDX-License-Identifier: MIT */
/* Texts in random styles, for tests of what changes texts. */
#ifndef TESTS_UNIT_STYLES_H
#define TESTS_UNIT_STYLES_H

#include <stdbool.h>
#include <stdint.h>

#include "parameter/document.h"

/* A random number below `count`; the seed goes on. */
unsigned random_below(uint64_t *seed, unsigned count);

/*
 * The document as text in a style that depends on the seed; free it with free().  Its comments begin with #~N~, N
 * counting from 0; *json: it is JSON, and has none.
 */
char *random_style(const struct lx_document *document, uint64_t seed, bool *json);

#endif
