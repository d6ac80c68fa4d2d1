/* SPDX-License-Identifier: MIT */
/*
 * The table of options.  getopt_long's own tables, the check that a command takes an option, and the help are
 * made from it; a new option is one row and, if it is no plain flag, one function that takes its argument.
 */
#include "options.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "argument.h"
#include "cli.h"
#include "message.h"
#include "text.h"

static const char *const quantity_words[] = {"brightness", "irradiance", NULL};
static const char *const precision_words[] = {"single", "double", NULL};

static bool take_output(struct options *options, const char *argument)
{
    options->outputs[options->output_count++] = argument;
    return true;
}

static bool take_point(struct options *options, const char *argument)
{
    struct option_place *place = &options->places[options->place_count++];

    return argument_numbers("-p", "X,Y", argument, place->numbers, 2);
}

static bool take_element(struct options *options, const char *argument)
{
    struct option_place *place = &options->places[options->place_count++];
    const double *normal = place->numbers + 3;

    place->is_element = true;
    if (!argument_numbers("--at", "X,Y,Z,NX,NY,NZ", argument, place->numbers, 6))
        return false;
    if (normal[0] != 0.0 || normal[1] != 0.0 || normal[2] != 0.0)
        return true;
    message_error(_("--at %s: the normal NX,NY,NZ must not be zero"), argument);
    return false;
}

static bool take_assignment(struct options *options, const char *argument)
{
    options->assignments[options->assignment_count++] = argument;
    return true;
}

/* Finds a word among two; reports the nearer if it is none of them. */
static bool take_word(const char *option, const char *argument, const char *const *words, size_t *found)
{
    for (*found = 0; words[*found]; ++*found)
        if (strcmp(argument, words[*found]) == 0)
            return true;
    message_error(_("%s %s: %s or %s is expected"), option, argument, words[0], words[1]);
    message_did_you_mean(luxel_nearest_word(argument, words, *found));
    return false;
}

static bool take_quantity(struct options *options, const char *argument)
{
    size_t found;

    if (!take_word("--quantity", argument, quantity_words, &found))
        return false;
    options->settings.quantity = found == 0 ? LUXEL_BRIGHTNESS : LUXEL_IRRADIANCE;
    return true;
}

static bool take_precision(struct options *options, const char *argument)
{
    size_t found;

    if (!take_word("--precision", argument, precision_words, &found))
        return false;
    options->settings.precision = found == 0 ? LUXEL_SINGLE : LUXEL_DOUBLE;
    return true;
}

static bool take_tolerance(struct options *options, const char *argument)
{
    double value;

    if (!argument_number("--tolerance", argument, &value))
        return false;
    if (value > 0.0 && value < 1.0) {
        options->settings.tolerance = value;
        return true;
    }
    message_error(_("--tolerance %s: a number above 0 and below 1 is expected"), argument);
    return false;
}

static bool take_light_error(struct options *options, const char *argument)
{
    double value;

    if (!argument_number("--light-error", argument, &value))
        return false;
    if (value >= 0.0 && value < 1.0) {
        options->settings.light_error = value;
        return true;
    }
    message_error(_("--light-error %s: a number from 0 to below 1 is expected"), argument);
    return false;
}

static bool take_threads(struct options *options, const char *argument)
{
    return argument_whole("--threads", argument, 1, 1024, &options->settings.threads);
}

#define TAKES(function) .take = (function)
#define SETS(member) .flag = offsetof(struct options, member)
#define WORDS(list) .value = VALUE_WORD, .words = (list)

static const struct option_row rows[] = {
    {"output", 'o', N_("FILE"), COMMAND_RENDER | COMMAND_GRID | COMMAND_SET, TAKES(take_output), .value = VALUE_OUTPUT,
     .help = N_("write the scene (luxel set; - is standard output), the measuring grids (luxel grid, as .csv) or the "
                "picture, in the format that the ending of the name says; may be repeated")},
    {"dry-run", 'n', NULL, COMMAND_SET, SETS(dry_run), .help = N_("print the changed scene and write no file")},
    {"point", 'p', N_("X,Y"), COMMAND_PROBE, TAKES(take_point),
     .help = N_("probe this point of the screen, in mm, instead of the scene's own points; may be repeated")},
    {"at", 0, N_("X,Y,Z,NX,NY,NZ"), COMMAND_PROBE, TAKES(take_element),
     .help = N_("probe a free surface element: its position in mm and its normal; may be repeated")},
    {"list", 0, NULL, COMMAND_SCENE, SETS(list), .help = N_("list the built-in scenes")},
    {"set", 's', N_("KEY=VALUE"), COMMAND_ANY, TAKES(take_assignment), .value = VALUE_ASSIGNMENT,
     .help = N_("change one value of the scene, such as lights[0].intensity=20; the value is YAML; may be repeated")},
    {"quantity", 0, N_("NAME"), COMMAND_ANY, TAKES(take_quantity), WORDS(quantity_words),
     .help = N_("what to compute: brightness (default) or irradiance, which luxel grid always measures")},
    {"tolerance", 0, N_("T"), COMMAND_ANY, TAKES(take_tolerance),
     .help =
         N_("relative error that the value of a probe or of a grid's cell may have, above 0 and below 1; exit code 5 "
            "where it is not reached")},
    {"precision", 0, N_("NAME"), COMMAND_ANY, TAKES(take_precision), WORDS(precision_words),
     .help = N_("numbers of the picture: single (default) or double")},
    {"threads", 0, N_("N"), COMMAND_ANY, TAKES(take_threads),
     .help = N_("threads to compute with, 1 to 1024; the default is one per processor; results do not depend on it")},
    {"light-error", 0, N_("E"), COMMAND_ANY, TAKES(take_light_error),
     .help = N_("error allowed for leaving far sources out, from 0 (the default: every source counts) to below 1")},
    {"strict", 0, NULL, COMMAND_ANY, SETS(strict), .help = N_("treat advice about the scene as an error")},
    {"json", 0, NULL, COMMAND_ANY, SETS(json), .help = N_("print the results as one JSON object")},
    {"quiet", 'q', NULL, COMMAND_ANY, SETS(quiet), .help = N_("print no progress, notes and confirmations")},
    {"help", 'h', NULL, COMMAND_ANY | COMMAND_NONE, SETS(help), .help = N_("print this help and do nothing else")},
    {"version", 'V', NULL, COMMAND_ANY | COMMAND_NONE, SETS(version),
     .help = N_("print the version and the instruction set that would be used")},
};

enum { ROW_COUNT = COUNT_OF(rows), LONG_BASE = 256 }; /* getopt's value of a long option is LONG_BASE + row */

const struct option_row *options_row(size_t i)
{
    return i < ROW_COUNT ? &rows[i] : NULL;
}

bool options_given(const struct options *options, const char *name)
{
    for (size_t i = 0; i < ROW_COUNT; i++)
        if (strcmp(rows[i].name, name) == 0)
            return (options->given & 1U << i) != 0;
    return false;
}

static const struct option_row *row_of_value(int value)
{
    if (value >= LONG_BASE)
        return &rows[value - LONG_BASE];
    for (size_t i = 0; i < ROW_COUNT; i++)
        if (rows[i].letter != 0 && rows[i].letter == value)
            return &rows[i];
    return NULL;
}

/* As the user typed it, which getopt tells by the value: "--output" or "-o". */
static const char *option_name(int value, char buffer[TEXT_SIZE])
{
    if (value >= LONG_BASE)
        return text_format(buffer, "--%s", rows[value - LONG_BASE].name);
    return text_format(buffer, "-%c", value);
}

static void report_unknown_long(const char *typed)
{
    const size_t length = strcspn(typed + 2, "=");
    char *name = message_allocate(length + 1, 1);
    const char *names[ROW_COUNT], *nearest;
    size_t beginnings = 0;

    memcpy(name, typed + 2, length);
    for (size_t i = 0; i < ROW_COUNT; i++) {
        names[i] = rows[i].name;
        beginnings += strncmp(rows[i].name, name, length) == 0;
    }
    if (beginnings > 1)
        message_error(_("--%s is short for more than one option"), name);
    else
        message_error(_("unknown option --%s"), name);
    nearest = luxel_nearest_word(name, names, ROW_COUNT);
    if (nearest)
        message_hint(_("did you mean --%s?"), nearest);
    free(name);
}

/* getopt_long answered '?' or ':'; `typed` is the argument that it stood at. */
static void report_bad_option(int answer, int value, const char *typed)
{
    char name[TEXT_SIZE];
    const struct option_row *row = row_of_value(value);

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

/* getopt_long's tables from ours. */
static void build_tables(struct option longs[ROW_COUNT + 1], char letters[2 * ROW_COUNT + 2])
{
    *letters++ = ':'; /* tells a missing argument from an unknown option */
    for (int i = 0; i < ROW_COUNT; i++) {
        const int has_argument = rows[i].argument ? required_argument : no_argument;

        longs[i] = (struct option){.name = rows[i].name, .has_arg = has_argument, .val = LONG_BASE + i};
        if (rows[i].letter == 0)
            continue;
        *letters++ = rows[i].letter;
        if (rows[i].argument)
            *letters++ = ':';
    }
    longs[ROW_COUNT] = (struct option){0};
    *letters = '\0';
}

/* Reads what begins with a dash; getopt moves the operands behind it. */
static bool read_dashed(int argc, char **argv, struct options *options)
{
    struct option longs[ROW_COUNT + 1];
    char letters[2 * ROW_COUNT + 2];
    int value;

    build_tables(longs, letters);
    opterr = 0;
    while ((value = getopt_long(argc, argv, letters, longs, NULL)) != -1) {
        const struct option_row *row;

        if (value == '?' || value == ':') {
            report_bad_option(value, optopt, argv[optind - 1]);
            return false;
        }
        row = row_of_value(value);
        options->given |= 1U << (row - rows);
        if (!row->take)
            *(bool *)((char *)options + row->flag) = true;
        else if (!row->take(options, optarg))
            return false;
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

/* Operands behind the first one: assignments, where the command takes them. */
static bool read_more_operands(int count, char **operands, struct options *options)
{
    if (options->command->assignments) {
        for (int i = 0; i < count; i++)
            take_assignment(options, operands[i]);
        return true;
    }
    message_error(_("luxel %s takes one %s at most: \"%s\" is one too many"), options->command->name,
                  _(options->command->operand), operands[0]);
    return false;
}

/* COMMAND [SCENE], and for some KEY=VALUE... */
static bool read_operands(int count, char **operands, struct options *options)
{
    if (count == 0)
        return true;
    options->command = find_command(operands[0]);
    if (!options->command)
        return report_unknown_command(operands[0]);
    if (count > 1)
        options->operand = operands[1];
    if (count <= (options->command->operand ? 2 : 1))
        return true;
    if (!options->command->operand) {
        message_error(_("luxel %s takes no argument: \"%s\" is one too many"), options->command->name, operands[1]);
        return false;
    }
    return read_more_operands(count - 2, operands + 2, options);
}

/* Every option that was given must be one that the command takes. */
static bool check_commands(const struct options *options)
{
    const unsigned bit = options->command ? options->command->bit : COMMAND_NONE;

    for (size_t i = 0; i < ROW_COUNT; i++) {
        if (!(options->given & 1U << i) || (rows[i].commands & bit))
            continue;
        if (options->command)
            message_error(_("luxel %s takes no --%s"), options->command->name, rows[i].name);
        else
            message_error(_("--%s needs a command before it"), rows[i].name);
        for (size_t k = 0; k < COMMAND_COUNT; k++)
            if ((rows[i].commands & commands[k]->bit) && (rows[i].commands & COMMAND_ANY) != COMMAND_ANY)
                message_hint(_("luxel %s takes it"), commands[k]->name);
        return false;
    }
    return true;
}

int options_read(int argc, char **argv, struct options *options)
{
    const size_t room = (size_t)argc;

    *options = (struct options){
        .assignments = message_allocate(room, sizeof *options->assignments),
        .outputs = message_allocate(room, sizeof *options->outputs),
        .places = message_allocate(room, sizeof *options->places),
    };
    luxel_settings_init(&options->settings);
    if (!read_dashed(argc, argv, options) || !read_operands(argc - optind, argv + optind, options) ||
        !check_commands(options))
        return EXIT_USAGE;
    return EXIT_DONE;
}

void options_clear(struct options *options)
{
    free(options->assignments);
    free(options->outputs);
    free(options->places);
}

/* The help of an option; that of an output with the endings that there are. */
static const char *help_of(const struct option_row *row, char buffer[2 * TEXT_SIZE])
{
    const char *help = _(row->help);
    size_t used = strlen(help);

    if (row->value != VALUE_OUTPUT)
        return help;
    snprintf(buffer, 2 * TEXT_SIZE, "%s", help);
    for (size_t i = 0; luxel_output_ending(i) && used < 2 * TEXT_SIZE; i++)
        used +=
            (size_t)snprintf(buffer + used, 2 * TEXT_SIZE - used, "%s%s", i > 0 ? ", " : ": ", luxel_output_ending(i));
    return buffer;
}

void options_print_help(FILE *stream, unsigned command_bit)
{
    enum { INDENT = 24 };

    for (size_t i = 0; i < ROW_COUNT; i++) {
        char left[TEXT_SIZE], letter[TEXT_SIZE], help[2 * TEXT_SIZE];

        if (!(rows[i].commands & command_bit))
            continue;
        text_format(letter, "-%c,", rows[i].letter);
        text_format(left, "  %3s --%s%s%s", rows[i].letter != 0 ? letter : "", rows[i].name,
                    rows[i].argument ? " " : "", rows[i].argument ? _(rows[i].argument) : "");
        text_definition(stream, left, INDENT, help_of(&rows[i], help));
    }
}
