/* SPDX-License-Identifier: MIT */
/* Names of files that are to be written: whether they can be, and whether two of them are one file. */
#include "outputs.h"

#include <libgen.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "message.h"

/* The full path of an output that may not exist yet, to tell whether two outputs are one; NULL if unknown. */
static char *full_path(const char *path)
{
    char *folder_copy, *name_copy, *folder, *joined = NULL;
    char *existing = realpath(path, NULL);

    if (existing)
        return existing;
    folder_copy = strdup(path);
    name_copy = strdup(path);
    folder = folder_copy ? realpath(dirname(folder_copy), NULL) : NULL;
    if (folder && name_copy && asprintf(&joined, "%s/%s", folder, basename(name_copy)) < 0)
        joined = NULL;
    free(folder);
    free(folder_copy);
    free(name_copy);
    return joined;
}

static bool same_target(const char *a, const char *b)
{
    char *full_a = full_path(a), *full_b = full_path(b);
    const bool same = strcmp(a, b) == 0 || (full_a && full_b && strcmp(full_a, full_b) == 0);

    free(full_a);
    free(full_b);
    return same;
}

int outputs_check(const struct options *options, luxel_status (*check)(const char *, luxel_diagnostics *))
{
    luxel_diagnostics *diagnostics = message_new_diagnostics();
    int code = EXIT_DONE;

    for (size_t i = 0; i < options->output_count; i++) {
        const luxel_status status = check(options->outputs[i], diagnostics);

        if (status != LUXEL_OK)
            code = message_failure(status, diagnostics);
        luxel_diagnostics_clear(diagnostics);
        for (size_t k = 0; k < i; k++)
            if (same_target(options->outputs[i], options->outputs[k])) {
                message_error(_("-o %s and -o %s are the same file"), options->outputs[k], options->outputs[i]);
                code = EXIT_USAGE;
            }
    }
    luxel_diagnostics_free(diagnostics);
    return code;
}

luxel_status outputs_check_csv(const char *path, luxel_diagnostics *diagnostics)
{
    static const char *const endings[] = {".csv"};

    return luxel_check_ending(path, endings, COUNT_OF(endings), diagnostics);
}
