/* SPDX-License-Identifier: MIT */
/* What every file of the tool shares: its exit codes, its commands, and the words of front ends. */
#ifndef LUXEL_CLI_CLI_H
#define LUXEL_CLI_CLI_H

#include <stdbool.h>
#include <stddef.h>

#include "../front/words.h"

enum exit_code {
    EXIT_DONE = 0,
    EXIT_DIFFERENCE = 1, /* a comparison found a difference, or an answer is wrong */
    EXIT_USAGE = 2,      /* a wrong option, argument or key path */
    EXIT_SCENE = 3,      /* the scene has errors, or asks for more than memory or the precision holds */
    EXIT_FILE = 4,       /* a file, standard input or standard output could not be read or written */
    EXIT_TOLERANCE = 5,  /* an error is larger than the tolerance asked for; the values are printed */
    EXIT_INTERRUPTED = 130
};

/* One bit for each command, so that an option can say which commands take it. */
enum command_bit {
    COMMAND_RENDER = 1 << 0,
    COMMAND_PROBE = 1 << 1,
    COMMAND_CHECK = 1 << 2,
    COMMAND_SCENE = 1 << 3,
    COMMAND_HELP = 1 << 4,
    COMMAND_NONE = 1 << 5, /* `luxel --version` */
    COMMAND_SCHEMA = 1 << 6,
    COMMAND_SET = 1 << 7,
    COMMAND_GRID = 1 << 8,
    COMMAND_STATS = 1 << 9,
    COMMAND_PROFILE = 1 << 10,
    COMMAND_ISOPHOTES = 1 << 11,
    COMMAND_COMPARE = 1 << 12,
    COMMAND_FIGURE = 1 << 13,
    COMMAND_EXPLAIN = 1 << 14,
    COMMAND_REPORT = 1 << 15,
    COMMAND_ADVISE = 1 << 16,
    COMMAND_VARIANT = 1 << 17,
    COMMAND_GRADE = 1 << 18,
    COMMAND_PHOTOMETRY = 1 << 19,
    COMMAND_SWEEP = 1 << 20,
    COMMAND_GLARE = 1 << 21,
    COMMAND_DERIVE = 1 << 22,
    COMMAND_ROOM = 1 << 23,
    COMMAND_FIT = 1 << 24,
    COMMAND_EXCHANGE = 1 << 25,
    COMMAND_DAYLIGHT = 1 << 26,
    COMMAND_ARRANGE = 1 << 27,
    COMMAND_ANY = ((1 << 28) - 1) & ~COMMAND_NONE
};

/* What may stand behind a command, for those who complete it. */
enum operand_kind {
    OPERAND_SCENE, /* a file, a built-in scene, or - */
    OPERAND_NAME,  /* a built-in scene */
    OPERAND_TOPIC, /* a command, a key or a kind */
    OPERAND_FILE,  /* any file */
    OPERAND_NONE
};

struct options;

struct command {
    const char *name;
    unsigned bit;
    const char *operand; /* as the usage line shows it; NULL: it takes none */
    enum operand_kind operand_kind;
    const char *more;            /* operands behind it, as the usage line shows each; NULL: none */
    enum operand_kind more_kind; /* OPERAND_NONE: assignments KEY=VALUE, as -s takes them */
    unsigned most_operands;      /* how many in all where there are more, 0: any number */
    const char *endings; /* of the files -o writes: ".svg .pdf"; NULL: those of luxel_field_output_ending(), "": none */
    const char *default_format;                /* of -o -; NULL: --format must name one */
    const char *summary;                       /* one line */
    const char *description;                   /* a paragraph */
    const char *examples;                      /* command lines, one a line */
    int (*run)(const struct options *options); /* returns an enum exit_code */
};

extern const struct command command_render, command_probe, command_grid, command_check, command_scene, command_set,
    command_schema, command_help, command_figure, command_report, command_stats, command_profile, command_compare,
    command_isophotes, command_explain, command_advise, command_variant, command_grade, command_photometry,
    command_sweep, command_glare, command_derive, command_room, command_fit, command_exchange, command_daylight,
    command_arrange;

enum { COMMAND_COUNT = 27 };

/* All of them, in the order of the help. */
extern const struct command *const commands[COMMAND_COUNT];

/* The endings of the files that a command's -o writes, with blanks between them. */
const char *command_endings(const struct command *command, char *buffer, size_t size);

/* The command of that name, or NULL. */
const struct command *find_command(const char *name);

/* The exit codes with their meanings, in words; the last has none. */
struct exit_meaning {
    int code;
    const char *meaning;
};

extern const struct exit_meaning exit_meanings[];

/* `luxel` alone: what it is, its commands and some examples, on standard output. */
void help_print_usage(void);
/* The full help of one command. */
void help_print_command(const struct command *command);

#endif
