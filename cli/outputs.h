/* SPDX-License-Identifier: MIT */
/* The files of -o, looked at before anything is computed. */
#ifndef LUXEL_CLI_OUTPUTS_H
#define LUXEL_CLI_OUTPUTS_H

#include <luxel/luxel.h>

#include "options.h"

/*
 * Refuses what can be known to fail: names that `check` does not take, and two that are the same file.  Returns an enum
 * exit_code; errors are printed here.
 */
int outputs_check(const struct options *options, luxel_status (*check)(const char *, luxel_diagnostics *));

/* The part of it that fails where no file can be made, which should not cost a computation: EXIT_DONE or EXIT_FILE. */
int outputs_check_places(const struct options *options);

/*
 * Tells which of the files were written, for commands that print nothing else: as a JSON object where that is asked
 * for, else as notes to a user at a terminal.
 */
void outputs_tell(const struct options *options, const char *const *files, const bool *written, size_t count);

/* For outputs_check(): the name of a table, which is written as .csv. */
luxel_status outputs_check_csv(const char *path, luxel_diagnostics *diagnostics);

#endif
