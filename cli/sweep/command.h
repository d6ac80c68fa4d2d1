/* SPDX-License-Identifier: MIT */
/* The run of luxel sweep, which a system may lack. */
#ifndef LUXEL_CLI_SWEEP_COMMAND_H
#define LUXEL_CLI_SWEEP_COMMAND_H

#include "../options.h"

int sweep_command_run(const struct options *options);

#endif
