/* SPDX-License-Identifier: MIT */
/* Cuts a table of comma-separated values, whichever way it separates and quotes, into the fields of its lines. */
#ifndef LUXEL_CLI_ANSWER_FIELDS_H
#define LUXEL_CLI_ANSWER_FIELDS_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

struct field {
    char *text; /* without quotes and blanks around it */
    unsigned line, column;
};

struct fields {
    const char *path;
    char *bytes;                       /* the whole file */
    const char *at, *end, *line_begin; /* what comes next; the end of all; where the line of `at` begins */
    unsigned line;                     /* of `at`, from 1 */
    char separator;
    struct field *list; /* those of the line last read */
    size_t count, capacity;
};

enum fields_end {
    FIELDS_LINE,  /* the next line is there; lines with nothing in them are passed over */
    FIELDS_DONE,  /* there is no other one */
    FIELDS_BROKEN /* the rest cannot be cut, which was reported */
};

/* Reads a file.  False, reported, where that fails; fields_close() is due in either case. */
bool fields_open(const char *path, struct fields *fields);
enum fields_end fields_next(struct fields *fields);
void fields_close(struct fields *fields);

/*
 * A field as a number, with half a unit of its last digit.  A decimal comma is taken as well, except that there cannot
 * be one where commas separate fields that are not quoted.
 */
bool fields_number(const struct fields *fields, size_t i, double *number, double *rounding);

/* "FILE:line:column: error: ..." at a field of the line last read. */
void fields_report(const struct fields *fields, size_t i, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The same at any place of a file. */
void fields_report_at(const char *path, unsigned line, unsigned column, const char *format, va_list arguments)
    __attribute__((format(printf, 4, 0)));

/* A copy of a text; without memory for it the tool ends, as in the next one. */
char *message_copy(const char *text);
/* Doubles an array, whose old memory is freed. */
void *message_grow(void *list, size_t *capacity, size_t size);

#endif
