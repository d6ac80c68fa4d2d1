/* SPDX-License-Identifier: MIT */
/* luxel schema: the keys of a scene as a JSON Schema, for editors. */
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "message.h"
#include "options.h"

static int run(const struct options *options)
{
    const bool of_study = options->operand && strcmp(options->operand, "study") == 0;
    luxel_status status;
    char *schema;

    if (options->operand && !of_study && strcmp(options->operand, "scene") != 0) {
        message_error(_("luxel schema %s: there is one of scene and one of study"), options->operand);
        return EXIT_USAGE;
    }
    status = of_study ? luxel_study_schema(&schema) : luxel_scene_schema(&schema);
    if (status != LUXEL_OK)
        return message_failure(status, NULL);
    fputs(schema, stdout);
    luxel_text_free(schema);
    return EXIT_DONE;
}

const struct command command_schema = {
    .name = "schema",
    .bit = COMMAND_SCHEMA,
    .operand = N_("study"),
    .operand_kind = OPERAND_NONE,
    .summary = N_("print the JSON Schema of scenes or studies, for editors"),
    .description = N_("An editor that knows the schema completes keys, shows their meaning and marks errors while "
                      "you type. Editors that use yaml-language-server find it by a comment in the scene: # "
                      "yaml-language-server: $schema=luxel.schema.json. Only luxel check finds what no schema can "
                      "express, such as pixels that are not square."),
    .examples = "luxel schema > luxel.schema.json\n"
                "luxel schema study > study.schema.json",
    .run = run,
};
