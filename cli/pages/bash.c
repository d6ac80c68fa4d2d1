/* SPDX-License-Identifier: MIT */
/* The tables of the bash completion: plain words in variables, and what follows an option or a command. */
#include <string.h>

#include "../cli.h"
#include "../options.h"
#include "pages.h"

static void print_commands(FILE *out)
{
    fputs("_luxel_commands='", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "%s%s", i > 0 ? " " : "", commands[i]->name);
    fputs("'\n_luxel_scenes='", out);
    for (size_t i = 0; i < luxel_builtin_scene_count(); i++)
        fprintf(out, "%s%s", i > 0 ? " " : "", luxel_builtin_scene_name(i));
    fputs("'\n# A command that writes files, and what their names end in.\n_luxel_endings=(\n", out);
    pages_print_endings(out, "    ", "\n");
    fputs(")\n", out);
}

static void print_topics(FILE *out, const luxel_parameters *parameters)
{
    const luxel_parameter_kind *kind;

    fputs("_luxel_topics='", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "%s ", commands[i]->name);
    for (size_t i = 0; (kind = luxel_parameters_kind(parameters, i)) != NULL; i++)
        fprintf(out, "%s ", kind->name);
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        if (pages_is_first_name(parameters, i))
            fprintf(out, "%s%s", i > 0 ? " " : "", pages_last_name(luxel_parameters_get(parameters, i)->path));
    fputs("'\n", out);
}

static void print_keys(FILE *out, const luxel_parameters *parameters)
{
    fputs("# A key of a scene, and the words that it may have.\n_luxel_keys=(\n", out);
    pages_print_keys(out, parameters, "    ", "\n");
    fputs(")\n", out);
}

static void print_options_of(FILE *out, unsigned bit)
{
    const struct option_row *row;
    const char *separator = "";

    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        if (!(row->commands & bit))
            continue;
        fputs(separator, out);
        if (row->letter != 0)
            fprintf(out, "-%c ", row->letter);
        fprintf(out, "--%s", row->name);
        separator = " ";
    }
}

static void print_options(FILE *out)
{
    fputs("\n# The options of a command; of none, those that stand alone.\n_luxel_options() {\n    case $1 in\n", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        fprintf(out, "    %s) echo '", commands[i]->name);
        print_options_of(out, commands[i]->bit);
        fputs("' ;;\n", out);
    }
    fputs("    *) echo '", out);
    print_options_of(out, COMMAND_NONE);
    fputs("' ;;\n    esac\n}\n", out);
}

/* Those that want an argument, or those that may have one behind a = sign. */
static void print_values(FILE *out, bool optional)
{
    static const char *const kinds[] = {[VALUE_FREE] = "free",
                                        [VALUE_OUTPUT] = "output",
                                        [VALUE_FILE] = "file",
                                        [VALUE_ASSIGNMENT] = "assignment",
                                        [VALUE_PALETTE] = "free",
                                        [VALUE_GRIDS] = "grids",
                                        [VALUE_LIGHTS] = "lights"};
    const struct option_row *row;
    char buffer[512];
    const char *words;

    fputs(optional ? "\n# What an option may have behind a = sign.\n_luxel_optional() {\n    case $1 in\n"
                   : "\n# What an option takes: a kind, or the words themselves; nothing for a flag.\n"
                     "_luxel_value() {\n    case $1 in\n",
          out);
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        if (!row->argument || (row->value == VALUE_OPTIONAL) != optional)
            continue;
        if (row->letter != 0)
            fprintf(out, "    -%c | --%s) echo '", row->letter, row->name);
        else
            fprintf(out, "    --%s) echo '", row->name);
        words = pages_option_words(row, buffer);
        fprintf(out, "%s' ;;\n", words ? words : kinds[row->value]);
    }
    fputs("    esac\n}\n", out);
}

static void print_operands(FILE *out)
{
    static const char *const kinds[] = {[OPERAND_SCENE] = "scene",
                                        [OPERAND_NAME] = "name",
                                        [OPERAND_TOPIC] = "topic",
                                        [OPERAND_FILE] = "file",
                                        [OPERAND_NONE] = "free"};

    fputs("\n# What may stand behind a command.\n_luxel_operand() {\n    case $1 in\n", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(out, "    %s) echo %s ;;\n", commands[i]->name, kinds[commands[i]->operand_kind]);
    fputs("    esac\n}\n", out);
    fputs("\n# What may stand behind that.\n_luxel_more() {\n    case $1 in\n", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (commands[i]->more)
            fprintf(out, "    %s) echo %s ;;\n", commands[i]->name,
                    commands[i]->more_kind == OPERAND_NONE ? "assignment" : kinds[commands[i]->more_kind]);
    fputs("    *) echo free ;;\n    esac\n}\n", out);
}

void pages_bash(FILE *out, const luxel_parameters *parameters)
{
    print_commands(out);
    print_topics(out, parameters);
    print_keys(out, parameters);
    print_options(out);
    print_values(out, false);
    print_values(out, true);
    print_operands(out);
}
