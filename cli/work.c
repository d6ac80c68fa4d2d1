/* SPDX-License-Identifier: MIT */
/* Work that shows its progress. */
#include "work.h"

#include <stdlib.h>

#include "cli.h"
#include "message.h"
#include "outputs.h"

void work_begin(struct work *work, const struct options *options)
{
    work->settings = options->settings;
    work->settings.progress = progress_report;
    work->settings.progress_data = &work->progress;
    progress_begin(&work->progress, options->quiet);
    work->settings.within = progress_share(1);
    if (work->progress.wanted || options->keeps || work->settings.within > 0.0)
        work->settings.enough = progress_is_enough;
}

int work_end(struct work *work, luxel_status status, luxel_diagnostics *diagnostics)
{
    progress_end(&work->progress);
    if (status != LUXEL_OK)
        return message_failure(status, diagnostics);
    return message_reflected(diagnostics) ? EXIT_DONE : EXIT_TOLERANCE;
}

int work_write_files(const struct options *options, const struct loaded *loaded,
                     luxel_status (*write)(const struct loaded *loaded, const luxel_settings *settings,
                                           const void *look, const char *const *paths, size_t count, bool *written),
                     const void *look)
{
    bool *written = message_allocate(options->output_count, sizeof *written);
    struct work work;
    luxel_status status;
    int code;

    work_begin(&work, options);
    status = write(loaded, &work.settings, look, options->outputs, options->output_count, written);
    code = work_end(&work, status, loaded->diagnostics);
    luxel_diagnostics_clear(loaded->diagnostics);
    outputs_tell(options, options->outputs, written, options->output_count);
    free(written);
    return code;
}
