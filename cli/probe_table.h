/* SPDX-License-Identifier: MIT */
/* Tables of probes in files: .csv, .npy, .json. */
#ifndef LUXEL_CLI_PROBE_TABLE_H
#define LUXEL_CLI_PROBE_TABLE_H

#include "result.h"

/* For outputs_check(): whether a table can be written to a file of this name. */
luxel_status probe_table_check_name(const char *path, luxel_diagnostics *diagnostics);

/* Whether some file of -o is .json. */
bool probe_table_is_json(const struct options *options);

/*
 * Writes the result to each file of -o, whole or not at all, by its ending: as .csv a line for each place, as .npy an
 * array of the values, as .json the object of --json.  Returns an enum exit_code; errors are printed here.
 */
int probe_table_write(const struct result *result);

#endif
