/* SPDX-License-Identifier: MIT */
/* The tables of the zsh completion: words with descriptions, and the specifications that _arguments reads. */
#include <stdlib.h>
#include <string.h>

#include "../cli.h"
#include "../options.h"
#include "pages.h"

/* A word with its description for _describe: in quotes, colons in the word escaped. */
static void print_described(FILE *out, const char *word, const char *description)
{
    char line[512];

    snprintf(line, sizeof line, "%s:%s", word, description);
    fputs("    ", out);
    pages_quote(out, line);
    fputc('\n', out);
}

static void print_words(FILE *out, const luxel_parameters *parameters)
{
    const luxel_parameter_kind *kind;

    fputs("typeset -ga _luxel_commands=(\n", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        print_described(out, commands[i]->name, _(commands[i]->summary));
    fputs(")\ntypeset -ga _luxel_scenes=(\n", out);
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++)
        print_described(out, luxel_builtin_scene_name(i), luxel_builtin_scene_title(i));
    fputs(")\n# A command that writes files, and what their names end in.\ntypeset -ga _luxel_endings=(\n", out);
    pages_print_endings(out, "    ", "\n");
    fputs(")\ntypeset -ga _luxel_topics=(\n", out);
    for (size_t i = 0; (kind = luxel_parameters_kind(parameters, i)) != NULL; i++)
        print_described(out, kind->name, _(kind->meaning));
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        if (pages_is_first_name(parameters, i))
            print_described(out, pages_last_name(luxel_parameters_get(parameters, i)->path),
                            _(luxel_parameters_get(parameters, i)->meaning));
    fputs(")\n", out);
}

static void print_keys(FILE *out, const luxel_parameters *parameters)
{
    fputs("# A key of a scene, and the words that it may have.\ntypeset -ga _luxel_keys=(\n", out);
    pages_print_keys(out, parameters, "    ", "\n");
    fputs(")\n", out);
}

/* A description in square brackets, what is special there escaped. */
static void add_description(FILE *out, const char *text)
{
    fputc('[', out);
    for (; *text; text++) {
        if (strchr("[]:\\", *text))
            fputc('\\', out);
        fputc(*text, out);
    }
    fputc(']', out);
}

/* One of an option's names as a specification: '*-o+[what it does]:FILE:_luxel_output'; with a ! it is not offered. */
static void print_option(FILE *out, const struct option_row *row, bool is_long, bool is_offered)
{
    static const char *const actions[] = {[VALUE_FREE] = " ",
                                          [VALUE_OUTPUT] = "_luxel_output",
                                          [VALUE_FILE] = "_files",
                                          [VALUE_ASSIGNMENT] = "_luxel_assignment",
                                          [VALUE_PALETTE] = " ",
                                          [VALUE_GRIDS] = "_luxel_grids",
                                          [VALUE_LIGHTS] = "_luxel_lights"};
    char buffer[512];
    const char *words = pages_option_words(row, buffer);
    char *line = NULL;
    size_t size;
    FILE *text = open_memstream(&line, &size);

    if (!text)
        return;
    if (!is_offered)
        fputc('!', text);
    if (is_long)
        fprintf(text, "*--%s%s", row->name, row->value == VALUE_OPTIONAL ? "=-" : row->argument ? "=" : "");
    else
        fprintf(text, "*-%c%s", row->letter, row->argument ? "+" : "");
    add_description(text, _(row->help));
    if (words) {
        fprintf(text, "%s%s:(%s)", row->value == VALUE_OPTIONAL ? "::" : ":", row->argument, words);
    } else if (row->argument) {
        fprintf(text, ":%s:%s", row->argument, actions[row->value]);
    }
    fclose(text);
    fputs("        ", out);
    pages_quote(out, line);
    fputc('\n', out);
    free(line);
}

/* Before the command every option may stand, but only those that need none are offered. */
static void print_options_of(FILE *out, const char *name, unsigned bit)
{
    const struct option_row *row;

    fprintf(out, "    %s) specifications=(\n", name);
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        const bool is_offered = (row->commands & bit) != 0;

        if (!is_offered && bit != COMMAND_NONE)
            continue;
        if (row->letter != 0)
            print_option(out, row, false, is_offered);
        print_option(out, row, true, is_offered);
    }
}

void pages_zsh(FILE *out, const luxel_parameters *parameters)
{
    static const char *const operands[] = {[OPERAND_SCENE] = "_luxel_scene",
                                           [OPERAND_NAME] = "_luxel_name",
                                           [OPERAND_TOPIC] = "_luxel_topic",
                                           [OPERAND_FILE] = "_files"};

    print_words(out, parameters);
    print_keys(out, parameters);
    fputs("\n# The options of a command and what it works on; of none, the options that stand alone.\n"
          "_luxel_specify() {\n    case $1 in\n",
          out);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        print_options_of(out, commands[i]->name, commands[i]->bit);
        if (commands[i]->operand_kind != OPERAND_NONE)
            fprintf(out, "        '1:%s:%s'\n", commands[i]->operand, operands[commands[i]->operand_kind]);
        if (commands[i]->more)
            fprintf(out, "        '*:%s:%s'\n", commands[i]->more,
                    commands[i]->more_kind == OPERAND_NONE ? "_luxel_assignment" : operands[commands[i]->more_kind]);
        fputs("    ) ;;\n", out);
    }
    print_options_of(out, "*", COMMAND_NONE);
    fputs("    ) ;;\n    esac\n}\n", out);
}
