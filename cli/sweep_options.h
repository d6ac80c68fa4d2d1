/* SPDX-License-Identifier: MIT */
/* The options of luxel sweep, as the table of options takes them. */
#ifndef LUXEL_CLI_SWEEP_OPTIONS_H
#define LUXEL_CLI_SWEEP_OPTIONS_H

#include "options.h"

bool sweep_take_workers(struct options *options, const char *argument);
bool sweep_take_show(struct options *options, const char *argument);
bool sweep_take_shard(struct options *options, const char *argument);

#endif
