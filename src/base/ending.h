/* SPDX-License-Identifier: MIT */
/* What a file's name ends in, among the endings that go. */
#ifndef LX_BASE_ENDING_H
#define LX_BASE_ENDING_H

#include <luxel/diagnostics.h>

#include <stdbool.h>

/*
 * The index of the ending of a file's name, in whatever case, in a list such as ".svg", ".pdf".  Where there is none,
 * says so with the endings that are known.  LUXEL_ERROR_ARGUMENT.
 */
luxel_status lx_find_ending(const char *path, const char *const *endings, size_t count, luxel_diagnostics *diagnostics,
                            size_t *found);

/* Whether a file's name ends so, in whatever case. */
bool lx_has_ending(const char *path, const char *ending);

#endif
