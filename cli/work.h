/* SPDX-License-Identifier: MIT */
/* Long work of the library, with progress on a terminal. */
#ifndef LUXEL_CLI_WORK_H
#define LUXEL_CLI_WORK_H

#include <luxel/luxel.h>

#include "load.h"
#include "options.h"
#include "progress.h"

struct work {
    luxel_settings settings; /* those of the options, which report to `progress` */
    struct progress progress;
};

/* The settings to hand to the library; `work` must stay where it is until work_end(). */
void work_begin(struct work *work, const struct options *options);

/* Ends what ended with `status`.  Returns an enum exit_code; what went wrong is reported here. */
int work_end(struct work *work, luxel_status status, luxel_diagnostics *diagnostics);

/* Writes the files of -o, of which `written` tells those that are there.  Returns an enum exit_code. */
int work_write_files(const struct options *options, const struct loaded *loaded,
                     luxel_status (*write)(const struct loaded *loaded, const luxel_settings *settings,
                                           const void *look, const char *const *paths, size_t count, bool *written),
                     const void *look);

#endif
