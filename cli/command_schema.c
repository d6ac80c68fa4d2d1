/* SPDX-License-Identifier: MIT */
/* luxel schema: the keys of a scene as a JSON Schema, for editors. */
#include <luxel/luxel.h>

#include "cli.h"
#include "message.h"
#include "options.h"

static int run(const struct options *options)
{
    char *schema;
    const luxel_status status = luxel_scene_schema(&schema);

    (void)options;
    if (status != LUXEL_OK)
        return message_failure(status, NULL);
    fputs(schema, stdout);
    luxel_text_free(schema);
    return EXIT_DONE;
}

const struct command command_schema = {
    .name = "schema",
    .bit = COMMAND_SCHEMA,
    .operand_kind = OPERAND_NONE,
    .summary = N_("print the JSON Schema of scenes, for editors"),
    .description = N_("An editor that knows the schema completes keys, shows their meaning and marks errors while "
                      "you type. Editors that use yaml-language-server find it by a comment in the scene: # "
                      "yaml-language-server: $schema=luxel.schema.json. Only luxel check finds what no schema can "
                      "express, such as pixels that are not square."),
    .examples = "luxel schema > luxel.schema.json",
    .run = run,
};
