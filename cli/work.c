/* SPDX-License-Identifier: MIT */
/* Work that shows its progress and can be interrupted. */
#include "work.h"

#include "cli.h"
#include "message.h"

void work_begin(struct work *work, const struct options *options)
{
    work->settings = options->settings;
    work->settings.progress = progress_report;
    work->settings.progress_data = &work->progress;
    progress_begin(&work->progress, options->quiet);
}

int work_end(struct work *work, luxel_status status, luxel_diagnostics *diagnostics)
{
    if (progress_end(&work->progress) && status == LUXEL_OK)
        status = LUXEL_CANCELLED;
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
}
