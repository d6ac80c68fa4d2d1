/* SPDX-License-Identifier: MIT */
/* luxel check: is the scene valid, and what would an experienced user look at again? */
#include <luxel/luxel.h>

#include "advice.h"
#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"

static void print_text(const struct loaded *loaded, bool quiet)
{
    if (!quiet) {
        text_print_escaped(stdout, loaded->name);
        fputs(_(": valid\n"), stdout);
    }
    message_diagnostics(stdout, loaded->diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
}

/* A scene that could not be read at all has no result. */
static int report(const struct options *options, const struct loaded *loaded, int code)
{
    if (code == EXIT_DONE) {
        const int gathered = advice_gather(options, loaded);

        if (gathered != EXIT_DONE)
            return gathered;
    }
    if (options->json && code != EXIT_FILE)
        advice_print_json(loaded, code == EXIT_DONE, options->strict);
    else if (code == EXIT_DONE)
        print_text(loaded, options->quiet);
    return code;
}

static int run(const struct options *options)
{
    struct loaded loaded;
    int code = load_scene(options, false, &loaded);

    code = report(options, &loaded, code);
    load_clear(&loaded);
    return code;
}

const struct command command_check = {
    .name = "check",
    .bit = COMMAND_CHECK,
    .operand = N_("SCENE"),
    .summary = N_("validate a scene and list advice about it"),
    .description = N_("Reports every error with its place. For a valid scene it lists what lies outside the advised "
                      "ranges, has no effect or is out of view, with what would mend it; with --strict that makes the "
                      "scene fail. Advice about the peak and the picture, as luxel advise gives it, never does."),
    .examples = "luxel check my.yaml\n"
                "luxel check my.yaml --strict --json",
    .run = run,
};
