/* SPDX-License-Identifier: MIT */
/* The command line, read through one table of options from which the help is printed too. */
#ifndef LUXEL_CLI_OPTIONS_H
#define LUXEL_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include <luxel/luxel.h>

struct command;

/* Where to probe: a screen point x, y, or a free element x, y, z and its normal. */
struct option_place {
    bool is_element;
    double numbers[6];
};

struct options {
    const struct command *command; /* NULL: none was named */
    const char *operand;           /* SCENE, NAME or TOPIC; NULL: none was given */
    const char **assignments;      /* of -s, in order */
    size_t assignment_count;
    const char **outputs; /* of -o, in order */
    size_t output_count;
    struct option_place *places; /* of -p and --at, in order */
    size_t place_count;
    luxel_settings settings; /* its tolerance is 0 unless one was asked for */
    bool strict, json, quiet, list, dry_run, help, version;
    unsigned given; /* one bit for each row of the table */
};

/* What an option's argument may be, for those who complete it. */
enum option_value {
    VALUE_FREE,      /* nothing that could be listed, or no argument */
    VALUE_WORD,      /* one of `words` */
    VALUE_OUTPUT,    /* a file with one of the endings that pictures have */
    VALUE_ASSIGNMENT /* KEY=VALUE */
};

struct option_row {
    const char *name;
    char letter;                                                 /* 0: none */
    const char *argument;                                        /* as the help shows it; NULL: a flag */
    unsigned commands;                                           /* those that take it */
    bool (*take)(struct options *options, const char *argument); /* reports what is wrong itself */
    size_t flag; /* of a flag: the offset of its bool in struct options */
    enum option_value value;
    const char *const *words; /* of VALUE_WORD, NULL-terminated */
    const char *help;
};

/* The i-th option of the table, NULL beyond the last. */
const struct option_row *options_row(size_t i);

/* Whether the option of this name was given. */
bool options_given(const struct options *options, const char *name);

/*
 * Reads the command line; the texts stay argv's.  Returns an enum exit_code: a wrong one is reported here.
 * options_clear() is due in either case.
 */
int options_read(int argc, char **argv, struct options *options);
void options_clear(struct options *options);

/* Prints the options that a command takes, one a line, with their help. */
void options_print_help(FILE *stream, unsigned command_bit);

#endif
