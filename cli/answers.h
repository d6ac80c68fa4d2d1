/* SPDX-License-Identifier: MIT */
/*
 * Reads tables of answers to the exercise, in every way of writing tables that the library reads (<luxel/table.h>).
 *
 * The columns are told by their names, in any order: variant, value, and either x and y in mm or the number of the
 * point (3 or P3), and where it is given student (or name).  Others are left alone.
 */
#ifndef LUXEL_CLI_ANSWERS_H
#define LUXEL_CLI_ANSWERS_H

#include <stdbool.h>
#include <stddef.h>

struct answer {
    size_t file;   /* index of its table */
    unsigned line; /* from 1 */
    char *student; /* NULL: not given */
    unsigned variant;
    unsigned point; /* from 1; 0: it has x and y instead */
    double x_mm, y_mm;
    bool is_blank;   /* its cell says that there is no answer: the point is missing */
    double value;    /* NaN: "off the surface" */
    double rounding; /* half a unit of the value's last digit */
};

/* All answers of all tables, in their order. */
struct answers {
    struct answer *list;
    size_t count, capacity;
    char **files; /* the tables' names */
    size_t file_count, file_capacity;
    bool is_quiet;   /* columns and files that are passed over are not told */
    size_t mistakes; /* lines, or whole tables, that could not be understood; each was reported */
};

/*
 * Appends the answers of a table, or of every .csv and .tsv file of a folder, in the order of their names; other files
 * of a folder are told as skipped.  What is wrong is reported with its place, and the rest is read all the same.
 */
void answers_read(const char *path, struct answers *answers);
/* Reports a mistake in an answer, at the line where it stands. */
void answers_report(struct answers *answers, const struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* Frees what they hold; `answers` itself is the caller's. */
void answers_clear(struct answers *answers);

#endif
