/* SPDX-License-Identifier: MIT */
/* The command line, read through one table of options from which the help is printed too. */
#ifndef LUXEL_CLI_OPTIONS_H
#define LUXEL_CLI_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <luxel/luxel.h>

#include "text.h"

struct command;

/* Where to probe: a screen point x, y, a free element x, y, z and its normal, or all places of a file. */
struct option_place {
    bool is_element;
    double numbers[6];
    const char *file; /* NULL: none */
};

/* How --csv writes numbers and fields. */
enum option_csv {
    CSV_NONE,
    CSV_RFC4180, /* commas between fields, points in numbers */
    CSV_EXCEL_RU /* semicolons, decimal commas and a byte order mark, as spreadsheets in Russia read them */
};

enum {
    OPTION_LEVELS = 64, /* that may be listed */
    OPTIONS_MOST = 128  /* rows that the table may have */
};

/* What stats, profile, isophotes and compare look at; numbers are NaN and counts 0 where none were given. */
struct option_analysis {
    luxel_region region; /* the whole where none was given */
    bool histogram, logarithmic, from_picture, exact, arc;
    unsigned bins, samples;
    double scale[2]; /* low, high */
    double from_mm[2], to_mm[2], through_mm[2];
    double angle_deg;
    unsigned wanted_levels;       /* about so many round ones */
    double levels[OPTION_LEVELS]; /* or just these */
    size_t level_count;
    size_t view; /* of a picture in colour, a luxel_color_view */
};

/* What figures and reports look like; texts are NULL where none were given. */
struct option_drawing {
    const char *palette, *label, *title, *author, *group, *date, *section, *grid;
    const char *institution, *faculty, *course, *teacher, *place, *aim, *tables;
    bool palettes, contours, bands, lines, plain, no_extrema, no_points, stacked, dark, daylight;
    double width_mm, dots_per_inch; /* 0: the default */
    unsigned digits;                /* of the values of a report; 0: the default */
    size_t purpose;                 /* of luxel report, a luxel_report_purpose */
    size_t diagram;                 /* of luxel photometry, a luxel_diagram */
    double spacing;                 /* of the luminaires of its UGR table; 0: the default */
    size_t room;                    /* of that table, to be rated with reflected light; 0: none, else 1 more */
};

/* Options of luxel fit; texts are NULL and numbers 0 where none were given. */
struct option_fit {
    const char *picture, *values, *residual;
    double noise, relative_noise, saturated;
    luxel_loss loss;
    bool is_relative;
};

/* Options of luxel daylight about the sun. */
struct option_sun {
    const char *day; /* NULL: no hours are asked for */
    bool patches, has_location;
    double location[2], least_altitude_deg;
};

/* Options of luxel arrange. */
struct option_arrange {
    const char **goals; /* in order */
    size_t goal_count;
    bool dims;
    unsigned most; /* 0 where none was given */
};

/* Options of luxel sweep. */
struct option_sweep {
    uint64_t show;
    unsigned part, parts, workers; /* parts is 1 and workers 0 where none were given */
    const char *merge;
};

struct options {
    const struct command *command; /* NULL: none was named */
    char *const *arguments;        /* the whole command line, argv */
    const char *operand;           /* SCENE, NAME or TOPIC; NULL: none was given */
    const char **operands;         /* all of them, of commands that take several; the first is `operand` */
    size_t operand_count;
    const char **assignments; /* of -s, in order */
    size_t assignment_count;
    const char **free_keys; /* of --free, in order */
    size_t free_key_count;
    const char **outputs; /* of -o, in order */
    size_t output_count;
    struct option_place *places; /* of -p, --at and --points, in order */
    size_t place_count;
    double view[3];          /* of free elements; 0 where none was given */
    double up[3];            /* of observers; 0 where none was given */
    luxel_room room;         /* of luxel room; its defaults */
    double outdoor;          /* lx under the open sky; 0 where none was given */
    unsigned material;       /* the surface whose material they have that lie on none; 0 where none was given */
    luxel_settings settings; /* its tolerance is 0 unless one was asked for */
    const char *lights;      /* of --lights, names and numbers; NULL: it was not given */
    bool strict, json, quiet, list, dry_run, help, version;
    bool judges; /* luxel grid --limits */
    bool keeps;  /* Ctrl-C leaves what is known of reflected light */
    struct option_analysis analysis;
    struct option_drawing drawing;
    struct option_sweep sweep;
    struct option_fit fit;
    enum option_csv csv;
    bool accepts_pixel, by_student;    /* of luxel grade */
    size_t format;                     /* index in option_formats */
    const char *format_word;           /* of --format; NULL: it was not given */
    size_t names;                      /* luxel check --names: 0 those of grids, 1 those of lights */
    bool prints_document;              /* luxel explain: whether the explanation goes to standard output */
    char standard_output[32];          /* the name of -o -, which says its format; "": there is none */
    unsigned bits;                     /* of a .png's grey levels; 0: none were given */
    uint64_t given[OPTIONS_MOST / 64]; /* one bit for each row of the table */
    struct option_arrange arrange;
    struct option_sun sun;
};

/* What an option's argument may be, for those who complete it. */
enum option_value {
    VALUE_FREE,       /* nothing that could be listed, or no argument */
    VALUE_WORD,       /* one of `words` */
    VALUE_OUTPUT,     /* a file with one of the endings that pictures have */
    VALUE_FILE,       /* a file to read */
    VALUE_ASSIGNMENT, /* KEY=VALUE */
    VALUE_PALETTE,    /* a name of luxel_palette_name() */
    VALUE_ROOM,       /* a room of the UGR table */
    VALUE_GRIDS,      /* the name of a measuring grid of the scene */
    VALUE_LIGHTS,     /* names of its lights, with commas between them */
    VALUE_OPTIONAL    /* one of `words`, or no argument at all */
};

struct option_row {
    const char *name;
    char letter;                                                 /* 0: none */
    const char *argument;                                        /* as the help shows it; NULL: a flag */
    unsigned commands;                                           /* those that take it */
    bool (*take)(struct options *options, const char *argument); /* reports what is wrong itself */
    size_t member; /* without `take`: where in struct options the bool of a flag, or the text of an argument, is */
    enum option_value value;
    const char *const *words; /* of VALUE_WORD, NULL-terminated */
    bool is_shared;           /* by many commands, whose help therefore only names it */
    const char *help;
};

/* Takes the word of --format as one of option_formats; reports another. */
bool options_take_document_format(struct options *options);

/* What JSON and files call a quantity, whatever the units: "brightness" or "irradiance". */
const char *options_quantity_name(luxel_quantity quantity);

/* The words of --format, in the order of luxel_document_format. */
extern const char *const option_formats[];

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

/* Prints the options that a command takes: its own, one a line, with their help, and the names of the shared ones. */
void options_print_help(FILE *stream, unsigned command_bit);

/* Prints the shared options with their help, and which commands take them. */
void options_print_shared(FILE *stream);

/* "--output, --bits": the options that a command takes, its own or the shared ones. */
const char *options_list(unsigned command_bit, bool is_shared, char list[TEXT_SIZE]);

/* "render, probe": the commands that take an option. */
const char *options_takers(const struct option_row *row, char list[TEXT_SIZE]);

#endif
