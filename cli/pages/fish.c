/* SPDX-License-Identifier: MIT */
/* The tables of the fish completion: one `complete` for each command, option and operand. */
#include <string.h>

#include "../cli.h"
#include "../options.h"
#include "pages.h"

/* fish reads \' and \\ inside single quotes. */
static void quote(FILE *out, const char *text)
{
    fputc('\'', out);
    for (; *text; text++) {
        if (*text == '\'' || *text == '\\')
            fputc('\\', out);
        fputc(*text, out);
    }
    fputc('\'', out);
}

static void print_words(FILE *out, const luxel_parameters *parameters)
{
    fputs("# A command that writes files, and what their names end in.\nset -g __luxel_endings", out);
    pages_print_endings(out, " \\\n    ", "");
    fputs("\n# A key of a scene, and the words that it may have.\nset -g __luxel_keys", out);
    pages_print_keys(out, parameters, " \\\n    ", "");
    fputs("\n\nfunction __luxel_with_argument\n    string join \\n --", out);
    for (size_t i = 0; options_row(i); i++) {
        if (!options_row(i)->argument || options_row(i)->value == VALUE_OPTIONAL)
            continue;
        if (options_row(i)->letter != 0)
            fprintf(out, " -%c", options_row(i)->letter);
        fprintf(out, " --%s", options_row(i)->name);
    }
    fputs("\nend\n\n", out);
}

/* "__luxel_in render probe": one of the commands of an option was typed. */
static void print_condition(FILE *out, unsigned bits)
{
    fputs("complete -c luxel -n '", out);
    if (bits & COMMAND_NONE) {
        fputs("true'", out);
        return;
    }
    fputs("__luxel_in", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (bits & commands[i]->bit)
            fprintf(out, " %s", commands[i]->name);
    fputc('\'', out);
}

static void print_option(FILE *out, const struct option_row *row)
{
    char buffer[512];
    const char *words = pages_option_words(row, buffer);

    print_condition(out, row->commands);
    if (row->letter != 0)
        fprintf(out, " -s %c", row->letter);
    fprintf(out, " -l %s", row->name);
    if (words) {
        fprintf(out, "%s -a '%s'", row->value == VALUE_OPTIONAL ? "" : " -x", words);
    } else if (row->value == VALUE_OUTPUT) {
        fputs(" -r -F -a '(__luxel_outputs)'", out);
    } else if (row->value == VALUE_FILE) {
        fputs(" -r -F", out);
    } else if (row->value == VALUE_ASSIGNMENT) {
        fputs(" -x -a '(__luxel_assignments)'", out);
    } else if (row->value == VALUE_GRIDS) {
        fputs(" -x -a '(__luxel_names grids)'", out);
    } else if (row->value == VALUE_LIGHTS) {
        fputs(" -x -a '(__luxel_lights)'", out);
    } else if (row->argument) {
        fputs(" -x", out);
    }
    fputs(" -d ", out);
    quote(out, _(row->help));
    fputc('\n', out);
}

/* The built-in scenes behind the commands that take them, with or without files. */
static void print_scenes(FILE *out)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        const enum operand_kind kind = commands[i]->operand_kind;

        if (kind != OPERAND_SCENE && kind != OPERAND_NAME)
            continue;
        for (size_t k = 0; k < luxel_builtin_scene_count(); k++) {
            fprintf(out, "complete -c luxel -n '__luxel_wants_operand %s' -a %s -d ", commands[i]->name,
                    luxel_builtin_scene_name(k));
            quote(out, luxel_builtin_scene_title(k));
            fputc('\n', out);
        }
        if (kind == OPERAND_SCENE)
            fprintf(out, "complete -c luxel -n '__luxel_wants_operand %s' -a '(__luxel_scene_files)'\n",
                    commands[i]->name);
    }
}

static void print_topic(FILE *out, const char *topic, const char *meaning)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        if (commands[i]->operand_kind != OPERAND_TOPIC)
            continue;
        fprintf(out, "complete -c luxel -n '__luxel_wants_operand %s' -a %s -d ", commands[i]->name, topic);
        quote(out, meaning);
        fputc('\n', out);
    }
}

void pages_fish(FILE *out, const luxel_parameters *parameters)
{
    const struct option_row *row;
    const luxel_parameter_kind *kind;

    print_words(out, parameters);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        fprintf(out, "complete -c luxel -n __luxel_wants_command -a %s -d ", commands[i]->name);
        quote(out, _(commands[i]->summary));
        fputc('\n', out);
    }
    for (size_t i = 0; (row = options_row(i)) != NULL; i++)
        print_option(out, row);
    print_scenes(out);
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (commands[i]->more)
            fprintf(out, "complete -c luxel -n '__luxel_wants_more %s' %s\n", commands[i]->name,
                    commands[i]->more_kind == OPERAND_NONE ? "-x -a '(__luxel_assignments)'" : "-F");
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        print_topic(out, commands[i]->name, _(commands[i]->summary));
    for (size_t i = 0; (kind = luxel_parameters_kind(parameters, i)) != NULL; i++)
        print_topic(out, kind->name, _(kind->meaning));
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        if (pages_is_first_name(parameters, i))
            print_topic(out, pages_last_name(luxel_parameters_get(parameters, i)->path),
                        _(luxel_parameters_get(parameters, i)->meaning));
}
