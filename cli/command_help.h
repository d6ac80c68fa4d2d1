/* SPDX-License-Identifier: MIT */
/* The help of scene keys, from the library's parameter table. */
#ifndef LUXEL_CLI_COMMAND_HELP_H
#define LUXEL_CLI_COMMAND_HELP_H

#include <stdbool.h>

/*
 * Explains the keys that a topic names (NULL: all of them), as text or as JSON.  Returns an enum exit_code: an
 * unknown topic is reported here.
 */
int help_print_keys(const char *topic, bool as_json);

#endif
