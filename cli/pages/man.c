/* SPDX-License-Identifier: MIT */
/* The man page luxel(1): commands, options and exit codes from their tables, and what a table cannot know. */
#include <string.h>

#include "../cli.h"
#include "../options.h"
#include "pages.h"
#include "roff.h"

/* The day of the release; it changes with the version. */
static const char page_date[] = "2026-11-21";

static void print_head(FILE *out)
{
    fprintf(out,
            ".\\\" Made by luxel-pages from the tables of the tool.\n.TH LUXEL 1 %s \"luxel %s\" \"User Commands\"\n",
            page_date, luxel_version());
    fputs(".SH NAME\nluxel \\- compute how light sources brighten a surface\n.SH SYNOPSIS\n", out);
    fputs("\\fBluxel\\fR \\fICOMMAND\\fR [\\fISCENE\\fR] [\\fIOPTION\\fR]...\n.br\n"
          "\\fBluxel help\\fR [\\fICOMMAND\\fR|\\fIKEY\\fR]\n",
          out);
    fputs(".SH DESCRIPTION\n", out);
    roff_text(
        out, _("luxel computes how light sources brighten a surface, and shows it: spheres, rectangles, disks, "
               "cylinders, rooms and meshes under ambient light, point sources and point clouds, distant sources, "
               "spotlights, planar and volume sources and luminaires, with the Lambert, Phong and Blinn-Phong models. "
               "Exact values carry a bound of their error. Every convention that two programs may differ in is a "
               "key of the scene and is printed with the result."));
    fputc('\n', out);
    roff_paragraph(out, _("SCENE is a YAML or JSON file, the name of a built-in scene, or - for standard input; where "
                          "a file has the name of a built-in scene, the file counts. Without a SCENE it is the "
                          "built-in scene \"report\". Results go to standard output, everything else to standard "
                          "error. Options may stand anywhere; -- ends them. Numbers have a decimal point in every "
                          "language."));
}

static void print_usage_line(FILE *out, const struct command *command)
{
    char line[80];

    snprintf(line, sizeof line, "luxel %s", command->name);
    roff_typed(out, line);
    if (command->more) {
        fputc(' ', out);
        roff_placeholder(out, _(command->operand));
        fputc(' ', out);
        roff_placeholder(out, _(command->more));
        fputs(command->most_operands > 0 ? "" : "...", out);
    } else if (command->operand) {
        fputs(" [", out);
        roff_placeholder(out, _(command->operand));
        fputc(']', out);
    }
    fputs(" [", out);
    roff_placeholder(out, _("OPTION"));
    fputs("]...\n", out);
}

static void print_commands(FILE *out)
{
    fputs(".SH COMMANDS\n", out);
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        char sentence[128];

        fputs(".TP\n", out);
        print_usage_line(out, commands[i]);
        snprintf(sentence, sizeof sentence, "%s.", _(commands[i]->summary));
        if (sentence[0] >= 'a' && sentence[0] <= 'z')
            sentence[0] = (char)(sentence[0] - 'a' + 'A');
        roff_text(out, sentence);
        fputc('\n', out);
        roff_text(out, _(commands[i]->description));
        fputc('\n', out);
    }
}

static void print_option(FILE *out, const struct option_row *row)
{
    char name[64];

    fputs(".TP\n", out);
    if (row->letter != 0) {
        snprintf(name, sizeof name, "-%c", row->letter);
        roff_typed(out, name);
        fputs(", ", out);
    }
    snprintf(name, sizeof name, "--%s", row->name);
    roff_typed(out, name);
    if (row->argument) {
        fputs(row->value == VALUE_OPTIONAL ? "[=" : " ", out);
        roff_placeholder(out, _(row->argument));
        fputs(row->value == VALUE_OPTIONAL ? "]" : "", out);
    }
    fputc('\n', out);
    roff_text(out, _(row->help));
    fputc('\n', out);
}

/* The commands that take an option, as the key by which options are grouped; all common ones share one. */
static unsigned group_of(const struct option_row *row)
{
    return row->commands & ~(unsigned)COMMAND_NONE;
}

static void print_options(FILE *out)
{
    const struct option_row *row;

    fputs(".SH OPTIONS\n.SS \"Common options\"\n", out);
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        char takers[TEXT_SIZE], sentence[TEXT_SIZE];

        if (!row->is_shared)
            continue;
        print_option(out, row);
        if (group_of(row) == COMMAND_ANY)
            continue;
        roff_text(out, text_format(sentence, _("Of luxel %s."), options_takers(row, takers)));
        fputc('\n', out);
    }
    for (size_t k = 0; k < COMMAND_COUNT; k++) {
        bool headed = false;

        for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
            if (row->is_shared || !(row->commands & commands[k]->bit))
                continue;
            if (!headed)
                fprintf(out, ".SS \"Of luxel %s\"\n", commands[k]->name);
            headed = true;
            print_option(out, row);
        }
    }
}

static size_t group_length(const char *path)
{
    const char *dot = strrchr(path, '.');

    return dot ? (size_t)(dot - path) : 0;
}

static bool same_group(const luxel_parameter *a, const luxel_parameter *b)
{
    const size_t length = group_length(a->path);

    return length == group_length(b->path) && strncmp(a->path, b->path, length) == 0 &&
           (a->variant == b->variant || (a->variant && b->variant && strcmp(a->variant, b->variant) == 0));
}

/* "lights[], type spot: position, intensity, ...": the keys of a group, where the i-th is its first. */
static void print_group(FILE *out, const luxel_parameters *parameters, size_t i)
{
    const luxel_parameter *first = luxel_parameters_get(parameters, i);
    char name[64], keys[512] = "";
    size_t used = 0;

    for (size_t k = 0; k < i; k++)
        if (same_group(luxel_parameters_get(parameters, k), first))
            return;
    fputs(".TP\n", out);
    snprintf(name, sizeof name, "%.*s", (int)group_length(first->path), first->path);
    roff_typed(out, *name ? name : _("top level"));
    if (first->variant) {
        fputs(_(" of type "), out);
        roff_typed(out, first->variant);
    }
    fputc('\n', out);
    for (size_t k = i; k < luxel_parameters_count(parameters); k++) {
        const luxel_parameter *parameter = luxel_parameters_get(parameters, k);

        if (!same_group(parameter, first))
            continue;
        used += (size_t)snprintf(keys + used, sizeof keys - used, "%s%s%s", used > 0 ? ", " : "",
                                 pages_last_name(parameter->path), parameter->required ? "*" : "");
        if (used >= sizeof keys)
            used = sizeof keys - 1;
    }
    roff_text(out, keys);
    fputc('\n', out);
}

static void print_keys(FILE *out, const luxel_parameters *parameters)
{
    fputs(".SH \"SCENE KEYS\"\n", out);
    roff_text(out,
              _("A scene is one YAML 1.2 document. Lengths are millimetres; the screen lies in z = 0, y points up, "
                "the observer looks along -z, unless it has a position and a target. This is the scene \"report\":"));
    fputc('\n', out);
    for (size_t i = 0; luxel_builtin_scene_name(i); i++)
        if (strcmp(luxel_builtin_scene_name(i), "report") == 0)
            roff_example(out, luxel_builtin_scene_text(i));
    roff_paragraph(out, _("These are all keys, in their groups; those with a * are required. luxel help KEY tells the "
                          "type, unit, default, legal and advised range and the meaning of each."));
    for (size_t i = 0; i < luxel_parameters_count(parameters); i++)
        print_group(out, parameters, i);
}

static void print_exit_codes(FILE *out)
{
    fputs(".SH \"EXIT STATUS\"\n", out);
    for (size_t i = 0; exit_meanings[i].meaning; i++) {
        fprintf(out, ".TP\n.B %d\n", exit_meanings[i].code);
        roff_text(out, _(exit_meanings[i].meaning));
        fputc('\n', out);
    }
}

static void print_variables(FILE *out)
{
    static const struct {
        const char *name, *meaning;
    } variables[] = {
        {"LUXEL_ISA", N_("forces an instruction set: generic, x86-64, x86-64-v3 or x86-64-v4. One that this machine "
                         "lacks is an error. All keep the same bounds of error.")},
        {"NO_COLOR", N_("if set and not empty, messages are not coloured; without it they are on a terminal.")},
        {"TERM", N_("on a terminal of type \"dumb\" neither colour nor progress is shown.")},
        {"LC_ALL, LC_MESSAGES, LANG, LANGUAGE", N_("choose the language of texts. They change no number and no JSON.")},
    };

    fputs(".SH ENVIRONMENT\n", out);
    for (size_t i = 0; i < COUNT_OF(variables); i++) {
        fputs(".TP\n", out);
        roff_typed(out, variables[i].name);
        fputc('\n', out);
        roff_text(out, _(variables[i].meaning));
        fputc('\n', out);
    }
}

static void print_files(FILE *out)
{
    fputs(".SH FILES\n.TP\n", out);
    roff_placeholder(out, "*.yaml, *.json");
    fputc('\n', out);
    roff_text(out, _("scenes, of up to 64 MB. Any name will do."));
    fputs("\n.TP\n", out);
    for (size_t i = 0; luxel_field_output_ending(i); i++) {
        char name[16];

        snprintf(name, sizeof name, "%s*%s", i > 0 ? ", " : "", luxel_field_output_ending(i));
        roff_placeholder(out, name);
    }
    fputc('\n', out);
    roff_text(out, _("pictures that luxel render writes, and as .csv the grids that luxel grid measures. Each appears "
                     "whole or not at all: one that was there stays until the new one is complete."));
    fputs("\n", out);
}

static void print_examples(FILE *out)
{
    fputs(".SH EXAMPLES\n", out);
    roff_text(out, _("The picture and the numbers of the built-in scene, and the same with another lamp:"));
    fputc('\n', out);
    roff_example(out, "luxel render -o report.png\n"
                      "luxel render -s 'lights[0].position=[1500,800,2400]' -o sphere.png -o sphere.npy");
    roff_paragraph(out, _("A scene of your own, begun with a built-in one, and its check:"));
    roff_example(out, "luxel scene report > my.yaml\nluxel check my.yaml");
    roff_paragraph(out, _("Exact values at two points of the screen, light by light, as JSON:"));
    roff_example(out, "luxel probe my.yaml -p 0,0 -p -150,0 --json");
    roff_paragraph(out, _("What a key means:"));
    roff_example(out, "luxel help shininess\nluxel help 'lights[].falloff'");
    roff_paragraph(out, _("Completion and errors in an editor that uses yaml-language-server; the second line goes "
                          "into the scene:"));
    roff_example(out, "luxel schema > luxel.schema.json\n# yaml-language-server: $schema=luxel.schema.json");
}

void pages_man(FILE *out, const luxel_parameters *parameters)
{
    print_head(out);
    print_commands(out);
    print_options(out);
    print_keys(out, parameters);
    print_exit_codes(out);
    print_variables(out);
    print_files(out);
    print_examples(out);
    fputs(".SH \"SEE ALSO\"\n", out);
    roff_text(out, _("In the documentation folder: SCENE.md describes every key of a scene, MATHS.md every formula and "
                     "its source. Programs use the same numbers through the library libluxel and its header "
                     "luxel/luxel.h."));
    fputc('\n', out);
}
