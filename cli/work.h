/* SPDX-License-Identifier: MIT */
/* Long work of the library: with progress on a terminal, and cancelled by Ctrl-C. */
#ifndef LUXEL_CLI_WORK_H
#define LUXEL_CLI_WORK_H

#include <luxel/luxel.h>

#include "options.h"
#include "progress.h"

struct work {
    luxel_settings settings; /* those of the options, which report to `progress` */
    struct progress progress;
};

/* The settings to hand to the library; `work` must stay where it is until work_end(). */
void work_begin(struct work *work, const struct options *options);

/*
 * Ends what ended with `status`: LUXEL_CANCELLED if the user has interrupted in the meantime.  Returns an enum
 * exit_code; what went wrong is reported here.
 */
int work_end(struct work *work, luxel_status status, luxel_diagnostics *diagnostics);

#endif
