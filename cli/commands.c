/* SPDX-License-Identifier: MIT */
/* The table of commands and that of exit codes: what the tool, its help and its man page go by. */
#include <stdio.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"

const struct command *const commands[COMMAND_COUNT] = {
    &command_render,  &command_probe,    &command_derive,  &command_fit,   &command_explain, &command_grid,
    &command_glare,   &command_daylight, &command_arrange, &command_stats, &command_profile, &command_isophotes,
    &command_compare, &command_figure,   &command_report,  &command_check, &command_advise,  &command_photometry,
    &command_room,    &command_exchange, &command_variant, &command_grade, &command_sweep,   &command_scene,
    &command_set,     &command_schema,   &command_help};

const struct command *find_command(const char *name)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

const char *command_endings(const struct command *command, char *buffer, size_t size)
{
    size_t used = 0;

    if (command->endings)
        return command->endings;
    for (size_t i = 0; luxel_field_output_ending(i) && used < size; i++)
        used += (size_t)snprintf(buffer + used, size - used, "%s%s", i > 0 ? " " : "", luxel_field_output_ending(i));
    return buffer;
}

const struct exit_meaning exit_meanings[] = {
    {EXIT_DONE, N_("done")},
    {EXIT_DIFFERENCE, N_("a comparison found a difference, or an answer is wrong")},
    {EXIT_USAGE, N_("wrong usage")},
    {EXIT_SCENE, N_("a scene with errors")},
    {EXIT_FILE, N_("a file could not be read or written")},
    {EXIT_TOLERANCE, N_("a tolerance was not reached")},
    {EXIT_INTERRUPTED, N_("interrupted")},
    {0, NULL},
};
