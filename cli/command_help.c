/* SPDX-License-Identifier: MIT */
/* luxel help: the commands, and what they do with which options.  Scene keys are help_key.c's. */
#include "command_help.h"

#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "json.h"
#include "message.h"
#include "options.h"
#include "text.h"

enum { INDENT = 12 };

static void print_examples(const char *examples)
{
    fputs(_("\nExamples:\n"), stdout);
    while (*examples) {
        const size_t length = strcspn(examples, "\n");

        printf("  %.*s\n", (int)length, examples);
        examples += length + (examples[length] != '\0');
    }
}

void help_print_usage(void)
{
    fputs(_("luxel computes how light sources brighten a surface.\n"
            "\n"
            "Usage: luxel COMMAND [SCENE] [OPTION]...\n"
            "\n"),
          stdout);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        char term[TEXT_SIZE];

        text_definition(stdout, text_format(term, "  %s", commands[i]->name), INDENT, _(commands[i]->summary));
    }
    fputc('\n', stdout);
    text_definition(stdout, "", 0,
                    _("SCENE is a file, the name of a built-in scene, or - for standard input; without one it is "
                      "\"report\". luxel help COMMAND and luxel help KEY, a key of a scene, say more."));
    print_examples("luxel render -o report.png\n"
                   "luxel render my.yaml -s 'lights[0].position=[1500,800,2400]' -o sphere.png -o sphere.npy\n"
                   "luxel probe my.yaml -p 0,0 -p -150,0 --json\n"
                   "luxel scene report > my.yaml\n"
                   "luxel help shininess");
}

/* "Exit codes: 0 done, 2 wrong usage, ..." */
static void print_exit_codes(void)
{
    char *line = NULL;
    size_t size;
    FILE *text = open_memstream(&line, &size);

    if (!text)
        return;
    fputs(_("Exit codes:"), text);
    for (size_t i = 0; exit_meanings[i].meaning; i++)
        fprintf(text, "%s %d %s", i > 0 ? "," : "", exit_meanings[i].code, _(exit_meanings[i].meaning));
    fputc('.', text);
    if (fclose(text) == 0)
        text_definition(stdout, "", 0, line);
    free(line);
}

/* What a command that writes files can write. */
static void print_endings(const struct command *command)
{
    char endings[TEXT_SIZE];

    if (command->endings && !*command->endings)
        return;
    for (size_t i = 0; options_row(i); i++)
        if (options_row(i)->value == VALUE_OUTPUT && (options_row(i)->commands & command->bit)) {
            printf(_("\nExtensions of FILE: %s\n"), command_endings(command, endings, sizeof endings));
            return; /* -o comes first; other files have the words of their own options */
        }
}

void help_print_command(const struct command *command)
{
    if (command->more)
        printf(_("Usage: luxel %s %s %s%s [OPTION]...\n\n"), command->name, _(command->operand), _(command->more),
               command->most_operands > 0 ? "" : "...");
    else if (command->operand)
        printf(_("Usage: luxel %s [%s] [OPTION]...\n\n"), command->name, _(command->operand));
    else
        printf(_("Usage: luxel %s [OPTION]...\n\n"), command->name);
    text_definition(stdout, "", 0, _(command->summary));
    fputc('\n', stdout);
    text_definition(stdout, "", 0, _(command->description));
    options_print_help(stdout, command->bit);
    print_endings(command);
    print_examples(command->examples);
    fputc('\n', stdout);
    print_exit_codes();
}

/* A command, or the common options where there is none. */
static void write_json(const struct command *command)
{
    struct json json = {.stream = stdout};
    const struct option_row *row;

    json_open(&json, NULL, '{');
    if (command) {
        json_text(&json, "command", command->name);
        json_text(&json, "summary", command->summary);
        json_text(&json, "description", command->description);
    }
    json_open(&json, "options", '[');
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        const char letter[] = {row->letter, '\0'};

        if (command ? !(row->commands & command->bit) : !row->is_shared)
            continue;
        json_open(&json, NULL, '{');
        json_text(&json, "name", row->name);
        json_text(&json, "letter", row->letter ? letter : NULL);
        json_text(&json, "argument", row->argument);
        json_text(&json, "help", row->help);
        json_close(&json, '}');
    }
    json_close(&json, ']');
    json_close(&json, '}');
}

/* Whether it is a type of surface or light as well, as `room` is. */
static bool is_kind(const char *topic)
{
    luxel_parameters *keys = luxel_parameters_new();
    bool found = false;

    for (size_t i = 0; keys && i < luxel_parameters_kind_count(keys) && !found; i++)
        found = strcmp(luxel_parameters_kind(keys, i)->name, topic) == 0;
    luxel_parameters_free(keys);
    return found;
}

static int run(const struct options *options)
{
    const struct command *command = options->operand ? find_command(options->operand) : NULL;

    if (!options->operand && !options->json) {
        help_print_usage();
        return EXIT_DONE;
    }
    if (options->operand && strcmp(options->operand, "options") == 0) {
        if (options->json)
            write_json(NULL);
        else
            options_print_shared(stdout);
        return EXIT_DONE;
    }
    if (!command)
        return help_print_keys(options->operand, options->json);
    if (options->json)
        write_json(command);
    else
        help_print_command(command);
    if (options->json || !is_kind(options->operand))
        return EXIT_DONE;
    fputc('\n', stdout);
    return help_print_keys(options->operand, false);
}

const struct command command_help = {
    .name = "help",
    .bit = COMMAND_HELP,
    .operand = N_("TOPIC"),
    .operand_kind = OPERAND_TOPIC,
    .summary = N_("explain a command or a key of a scene"),
    .description = N_("TOPIC is a command, a key such as lights[].intensity or just intensity, a type of surface or "
                      "light such as spot, a word of the field such as luminance or lux, or \"options\", the common "
                      "options of the commands. With --json the answer is JSON, that of all keys without a TOPIC."),
    .examples = "luxel help render\n"
                "luxel help shininess\n"
                "luxel help 'lights[0].intensity'\n"
                "luxel help luminance\n"
                "luxel help options",
    .run = run,
};
