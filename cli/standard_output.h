/* SPDX-License-Identifier: MIT */
/* What `-o -` means: a file that goes to standard output, in the format that --format names. */
#ifndef LUXEL_CLI_STANDARD_OUTPUT_H
#define LUXEL_CLI_STANDARD_OUTPUT_H

#include "options.h"

/*
 * Gives outputs that are standard output a name whose extension says the format, and takes --format of luxel explain.
 * false: what was asked for does not go together, and is reported.
 */
bool standard_output_resolve(struct options *options);

/* Whether the results are to be printed as a table, too. */
bool standard_output_is_free(const struct options *options);

/* Whether a text, such as a message, is about standard output as the file of `-o -`. */
bool standard_output_is_named(const char *text);

/* Whether nobody reads standard output any more. */
bool standard_output_reader_left(void);

#endif
