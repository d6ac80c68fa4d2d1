/* SPDX-License-Identifier: MIT */
/* Reading the command line by the table of options, and printing the help of options. */
#include "options.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli.h"
#include "message.h"
#include "standard_output.h"
#include "text.h"

enum { LONG_BASE = 256 }; /* getopt's value of a long option is LONG_BASE + row */

static size_t row_count(void)
{
    size_t count = 0;

    while (options_row(count))
        count++;
    return count;
}

static bool is_given(const struct options *options, size_t row)
{
    return (options->given[row / 64] & UINT64_C(1) << row % 64) != 0;
}

bool options_given(const struct options *options, const char *name)
{
    const struct option_row *row;

    for (size_t i = 0; (row = options_row(i)) != NULL; i++)
        if (strcmp(row->name, name) == 0)
            return is_given(options, i);
    return false;
}

/* The row that a value of getopt's stands for, or the number of rows. */
static size_t row_of_value(int value)
{
    size_t i = 0;

    if (value >= LONG_BASE)
        return (size_t)(value - LONG_BASE);
    while (options_row(i) && (options_row(i)->letter == 0 || options_row(i)->letter != value))
        i++;
    return i;
}

/* As the user typed it, which getopt tells by the value: "--output" or "-o". */
static const char *option_name(int value, char buffer[TEXT_SIZE])
{
    if (value >= LONG_BASE)
        return text_format(buffer, "--%s", options_row(row_of_value(value))->name);
    return text_format(buffer, "-%c", value);
}

static void report_unknown_long(const char *typed)
{
    const size_t length = strcspn(typed + 2, "=");
    char *name = message_allocate(length + 1, 1);
    const char *names[OPTIONS_MOST], *nearest;
    size_t beginnings = 0;

    memcpy(name, typed + 2, length);
    for (size_t i = 0; i < row_count(); i++) {
        names[i] = options_row(i)->name;
        beginnings += strncmp(names[i], name, length) == 0;
    }
    if (beginnings > 1)
        message_error(_("--%s is short for more than one option"), name);
    else
        message_error(_("unknown option --%s"), name);
    nearest = luxel_nearest_word(name, names, row_count());
    if (nearest)
        message_hint(_("did you mean --%s?"), nearest);
    free(name);
}

/* getopt_long answered '?' or ':'; `typed` is the argument that it stood at. */
static void report_bad_option(int answer, int value, const char *typed)
{
    char name[TEXT_SIZE];
    const struct option_row *row = options_row(row_of_value(value));

    if (answer == ':' && row)
        message_error(_("%s needs %s after it"), option_name(value, name), _(row->argument));
    else if (value >= LONG_BASE)
        message_error(_("%s takes no value"), option_name(value, name));
    else if (value > ' ' && value < 0x7f)
        message_error(_("unknown option -%c"), value);
    else if (value == 0 && strncmp(typed, "--", 2) == 0)
        report_unknown_long(typed);
    else
        message_error(_("unknown option %s"), typed);
}

/* The bit of the command that is meant, before options and operands are told apart: the first word that is one. */
static unsigned meant_bit(int argc, char **argv)
{
    for (int i = 1; i < argc; i++)
        if (find_command(argv[i]))
            return find_command(argv[i])->bit;
    return COMMAND_NONE;
}

/* Whether row i is the one of its name for this command; where none is, the first is. */
static bool is_meant(size_t i, unsigned bit)
{
    const struct option_row *row = options_row(i), *other;

    for (size_t k = 0; !(row->commands & bit) && (other = options_row(k)) != NULL; k++)
        if (k != i && strcmp(other->name, row->name) == 0 && (k < i || (other->commands & bit)))
            return false;
    return true;
}

/* getopt_long's tables from ours. */
static void build_tables(unsigned bit, struct option longs[OPTIONS_MOST + 1], char letters[2 * OPTIONS_MOST + 2])
{
    const struct option_row *row;
    size_t count = 0;

    *letters++ = ':'; /* tells a missing argument from an unknown option */
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        const int with = row->value == VALUE_OPTIONAL ? optional_argument : required_argument;

        if (is_meant(i, bit))
            longs[count++] = (struct option){
                .name = row->name, .has_arg = row->argument ? with : no_argument, .val = LONG_BASE + (int)i};
        if (row->letter == 0)
            continue;
        *letters++ = row->letter;
        if (row->argument)
            *letters++ = ':';
    }
    longs[count] = (struct option){0};
    *letters = '\0';
}

/* Reads what begins with a dash; getopt moves the operands behind it. */
static bool read_dashed(int argc, char **argv, struct options *options)
{
    struct option longs[OPTIONS_MOST + 1];
    char letters[2 * OPTIONS_MOST + 2];
    int value;

    build_tables(meant_bit(argc, argv), longs, letters);
    opterr = 0;
    while ((value = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
        const struct option_row *row;

        if (value == '?' || value == ':') {
            report_bad_option(value, optopt, argv[optind - 1]);
            return false;
        }
        row = options_row(row_of_value(value));
        options->given[row_of_value(value) / 64] |= UINT64_C(1) << row_of_value(value) % 64;
        if (row->take && !row->take(options, optarg))
            return false;
        if (!row->take && row->argument)
            *(const char **)((char *)options + row->member) = optarg;
        else if (!row->take)
            *(bool *)((char *)options + row->member) = true;
    }
    return true;
}

static bool report_unknown_command(const char *typed)
{
    const char *names[COMMAND_COUNT], *nearest;

    for (size_t i = 0; i < COMMAND_COUNT; i++)
        names[i] = commands[i]->name;
    nearest = luxel_nearest_word(typed, names, COMMAND_COUNT);
    message_error(_("unknown command \"%s\""), typed);
    if (access(typed, F_OK) == 0)
        message_hint(_("to compute the picture of a scene: luxel render %s"), typed);
    else if (nearest)
        message_did_you_mean(nearest);
    else
        message_hint(_("luxel help lists the commands"));
    return false;
}

/* Operands behind the first one: assignments or more of its kind, where the command takes them. */
static bool read_more_operands(int count, char **operands, struct options *options)
{
    const struct command *command = options->command;
    const unsigned most = command->more ? command->most_operands : 1;

    if (most > 0 && (unsigned)count >= most) {
        if (most > 1)
            message_error(_("luxel %s takes %u arguments: \"%s\" is one too many"), command->name, most,
                          operands[most - 1]);
        else
            message_error(_("luxel %s takes one %s at most: \"%s\" is one too many"), command->name,
                          _(command->operand), operands[0]);
        return false;
    }
    for (int i = 0; i < count; i++)
        if (command->more_kind == OPERAND_NONE)
            options->assignments[options->assignment_count++] = operands[i];
        else
            options->operands[options->operand_count++] = operands[i];
    return true;
}

/* COMMAND [SCENE], and for some KEY=VALUE... */
static bool read_operands(int count, char **operands, struct options *options)
{
    if (count == 0)
        return true;
    if (strcmp(operands[0], "version") == 0 && count == 1) { /* as other tools have it */
        options->version = true;
        return true;
    }
    options->command = find_command(operands[0]);
    if (!options->command)
        return report_unknown_command(operands[0]);
    if (count > 1)
        options->operands[options->operand_count++] = options->operand = operands[1];
    if (count <= (options->command->operand ? 2 : 1))
        return true;
    if (!options->command->operand) {
        message_error(_("luxel %s takes no argument: \"%s\" is one too many"), options->command->name, operands[1]);
        return false;
    }
    return read_more_operands(count - 2, operands + 2, options);
}

/* "--output, --bits, -s": as a hint. */
static void print_taken(const struct command *command)
{
    char own[TEXT_SIZE], shared[TEXT_SIZE];

    options_list(command->bit, false, own);
    options_list(command->bit, true, shared);
    message_hint(_("luxel %s takes %s%s%s"), command->name, own, *own ? ", " : "", shared);
}

/* Every option that was given must be one that the command takes. */
static bool check_commands(const struct options *options)
{
    const unsigned bit = options->command ? options->command->bit : COMMAND_NONE;

    const struct option_row *row;

    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        if (!is_given(options, i) || (row->commands & bit) || (options->version && strcmp(row->name, "json") == 0))
            continue;
        if (options->command)
            message_error(_("luxel %s takes no --%s"), options->command->name, row->name);
        else
            message_error(_("--%s needs a command before it"), row->name);
        if (!options->command && row->is_shared)
            return false;
        if (!row->is_shared)
            for (size_t k = 0; k < COMMAND_COUNT; k++)
                if (row->commands & commands[k]->bit)
                    message_hint(_("luxel %s takes it"), commands[k]->name);
        if (options->command)
            print_taken(options->command);
        return false;
    }
    return true;
}

int options_read(int argc, char **argv, struct options *options)
{
    const size_t room = (size_t)argc;
    const double none = (double)NAN;

    *options = (struct options){
        .assignments = message_allocate(room, sizeof *options->assignments),
        .free_keys = message_allocate(room, sizeof *options->free_keys),
        .arrange.goals = message_allocate(room, sizeof *options->arrange.goals),
        .outputs = message_allocate(room, sizeof *options->outputs),
        .places = message_allocate(room, sizeof *options->places),
        .operands = message_allocate(room, sizeof *options->operands),
        .arguments = argv,
        .sweep = {.parts = 1},
        .analysis = {.scale = {none, none},
                     .from_mm = {none, none},
                     .to_mm = {none, none},
                     .through_mm = {none, none},
                     .angle_deg = none},
    };
    luxel_settings_init(&options->settings);
    luxel_room_init(&options->room);
    if (!read_dashed(argc, argv, options) || !read_operands(argc - optind, argv + optind, options) ||
        !check_commands(options) || !standard_output_resolve(options))
        return EXIT_USAGE;
    return EXIT_DONE;
}

void options_clear(struct options *options)
{
    free(options->assignments);
    free(options->free_keys);
    free(options->arrange.goals);
    free(options->outputs);
    free(options->places);
    free(options->operands);
}

const char *options_list(unsigned command_bit, bool is_shared, char list[TEXT_SIZE])
{
    const struct option_row *row;
    size_t used = 0;

    list[0] = '\0';
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        char letter[TEXT_SIZE] = "";

        if (!(row->commands & command_bit) || row->is_shared != is_shared || used >= TEXT_SIZE)
            continue;
        if (row->letter != 0)
            text_format(letter, "-%c, ", row->letter);
        used += (size_t)snprintf(list + used, TEXT_SIZE - used, "%s%s--%s", used > 0 ? ", " : "", letter, row->name);
    }
    return list;
}

const char *options_takers(const struct option_row *row, char list[TEXT_SIZE])
{
    size_t used = 0;

    list[0] = '\0';
    for (size_t k = 0; k < COMMAND_COUNT; k++)
        if ((row->commands & commands[k]->bit) && used < TEXT_SIZE)
            used += (size_t)snprintf(list + used, TEXT_SIZE - used, "%s%s", used > 0 ? ", " : "", commands[k]->name);
    return list;
}

enum { HELP_INDENT = 24 };

static void print_row(FILE *stream, const struct option_row *row, const char *help)
{
    char left[TEXT_SIZE], letter[TEXT_SIZE];

    text_format(letter, "-%c,", row->letter);
    text_format(left, row->value == VALUE_OPTIONAL ? "  %3s --%s[=%s]" : "  %3s --%s %s",
                row->letter != 0 ? letter : "", row->name, row->argument ? _(row->argument) : "");
    text_definition(stream, left, HELP_INDENT, help);
}

void options_print_help(FILE *stream, unsigned command_bit)
{
    const struct option_row *row;
    char list[TEXT_SIZE];

    if (*options_list(command_bit, false, list))
        fputs(_("\nOptions:\n"), stream);
    for (size_t i = 0; (row = options_row(i)) != NULL; i++)
        if ((row->commands & command_bit) && !row->is_shared)
            print_row(stream, row, _(row->help));
    fputs(_("\nCommon options, explained by luxel help options:\n"), stream);
    text_definition(stream, "", 2, options_list(command_bit, true, list));
}

void options_print_shared(FILE *stream)
{
    const struct option_row *row;

    fputs(_("Common options:\n"), stream);
    for (size_t i = 0; (row = options_row(i)) != NULL; i++) {
        char takers[TEXT_SIZE];

        if (!row->is_shared)
            continue;
        print_row(stream, row, _(row->help));
        if ((row->commands & COMMAND_ANY) == COMMAND_ANY)
            continue;
        text_definition(stream, "", HELP_INDENT,
                        text_format((char[TEXT_SIZE]){0}, _("of luxel %s"), options_takers(row, takers)));
    }
}
