/* SPDX-License-Identifier: MIT */
/*
 * Texts for people: what every front end needs to answer an argument that it does not understand in the same
 * way as the library answers a wrong scene.
 */
#ifndef LUXEL_TEXT_H
#define LUXEL_TEXT_H

#include <stddef.h>

#include <luxel/diagnostics.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The word that was probably meant by what was typed: one of `count` words, of which some may be NULL, or NULL
 * where none is near enough.
 */
LUXEL_API const char *luxel_nearest_word(const char *typed, const char *const *words, size_t count);

/*
 * A copy that may be shown on a terminal: control characters and bytes that are no UTF-8 as \xNN, invisible
 * characters as \uNNNN.  The caller's: free it with luxel_text_free().  NULL when memory is short.
 */
LUXEL_API char *luxel_escaped_text(const char *text);

/*
 * Writes a text to a file, which appears whole or not at all; one that was there stays until the new one is complete.
 * LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_text_write(const char *path, const char *text, size_t length,
                                        luxel_diagnostics *diagnostics);

/* Whether a file's name ends in one of `count` extensions such as ".csv", in whatever case.  LUXEL_ERROR_ARGUMENT. */
LUXEL_API luxel_status luxel_check_ending(const char *path, const char *const *endings, size_t count,
                                          luxel_diagnostics *diagnostics);

#ifdef __cplusplus
}
#endif
#endif
