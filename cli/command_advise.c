/* SPDX-License-Identifier: MIT */
/* luxel advise: what an experienced user would change in a valid scene, and how. */
#include <luxel/luxel.h>

#include "advice.h"
#include "cli.h"
#include "load.h"
#include "message.h"
#include "options.h"
#include "text.h"

static int advise(const struct options *options, const struct loaded *loaded)
{
    int code = advice_check_view(loaded);

    if (code == EXIT_DONE)
        code = advice_gather(options, loaded);

    if (code != EXIT_DONE)
        return code;
    if (options->json) {
        advice_print_json(loaded, true, options->strict, NULL);
    } else if (luxel_diagnostics_total(loaded->diagnostics, LUXEL_SEVERITY_ADVICE) > 0) {
        message_diagnostics(stdout, loaded->diagnostics, LUXEL_SEVERITY_ADVICE, LUXEL_SEVERITY_ADVICE);
    } else if (!options->quiet) {
        text_print_escaped(stdout, loaded->name);
        fputs(_(": nothing to advise\n"), stdout);
    }
    return EXIT_DONE;
}

static int run(const struct options *options)
{
    return load_and(options, advise);
}

const struct command command_advise = {
    .name = "advise",
    .bit = COMMAND_ADVISE,
    .operand = N_("SCENE"),
    .summary = N_("suggest improvements to a scene, and the changes that make them"),
    .description = N_("Looks whether the peak stands out and lies in view, whether lights stand behind the surfaces or "
                      "so near or far that their attenuation spoils the picture, whether the picture is dark or "
                      "clipped by its range, and whether all lies in the advised ranges. Each hint is a change that "
                      "mends it, to be given with -s. With --json the object is that of luxel check."),
    .examples = "luxel advise my.yaml\n"
                "luxel advise my.yaml -s 'lights[0].position=[2000,0,2000]'",
    .run = run,
};
