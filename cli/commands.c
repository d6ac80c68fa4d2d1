/* SPDX-License-Identifier: MIT */
/* The table of commands and that of exit codes: what the tool, its help and its man page go by. */
#include <string.h>

#include "cli.h"

const struct command *const commands[COMMAND_COUNT] = {&command_render, &command_probe, &command_grid,   &command_check,
                                                       &command_scene,  &command_set,   &command_schema, &command_help};

const struct command *find_command(const char *name)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

const struct exit_meaning exit_meanings[] = {
    {EXIT_DONE, N_("done")},
    {EXIT_USAGE, N_("wrong usage")},
    {EXIT_SCENE, N_("a scene with errors")},
    {EXIT_FILE, N_("a file could not be read or written")},
    {EXIT_TOLERANCE, N_("a tolerance was not reached")},
    {EXIT_INTERRUPTED, N_("interrupted")},
    {0, NULL},
};
