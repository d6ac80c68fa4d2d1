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
}

int work_end(struct work *work, luxel_status status, luxel_diagnostics *diagnostics)
{
    progress_end(&work->progress);
    return status == LUXEL_OK ? EXIT_DONE : message_failure(status, diagnostics);
}

int work_write_each(const struct options *options, const struct loaded *loaded,
                    luxel_status (*write)(const struct loaded *loaded, const luxel_settings *settings, const void *look,
                                          const char *path),
                    const void *look)
{
    bool *written = message_allocate(options->output_count, sizeof *written);
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        struct work work;
        luxel_status status;
        int one;

        work_begin(&work, options);
        status = write(loaded, &work.settings, look, options->outputs[i]);
        one = work_end(&work, status, loaded->diagnostics);
        luxel_diagnostics_clear(loaded->diagnostics);
        code = one == EXIT_DONE ? code : one;
        written[i] = status == LUXEL_OK;
        if (status == LUXEL_ERROR_ARGUMENT)
            break;
    }
    outputs_tell(options, options->outputs, written, options->output_count);
    free(written);
    return code;
}
