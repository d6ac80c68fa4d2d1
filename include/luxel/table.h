/* SPDX-License-Identifier: MIT */
/*
 * Tables of numbers and texts in files, as spreadsheets and programs write them, read row by row: whichever of comma,
 * semicolon, tab and blanks separates, with decimal points or commas, quotes, headings in any order and with units,
 * or none, comments, and in UTF-8, UTF-16 or the code page 1251; or arrays of numbers, as numpy.save() writes them.
 * docs/FILES.md tells all that is understood.
 */
#ifndef LUXEL_TABLE_H
#define LUXEL_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include <luxel/diagnostics.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a column holds. */
typedef enum luxel_table_column_type {
    LUXEL_TABLE_LENGTH, /* finite numbers, which become mm: the heading may give another unit of length */
    LUXEL_TABLE_NUMBER, /* finite numbers */
    LUXEL_TABLE_VALUE,  /* numbers, or the words inf, -inf and nan */
    LUXEL_TABLE_TEXT    /* anything */
} luxel_table_column_type;

/* A column that is wanted.  Without a heading columns stand in the order in which they are wanted. */
typedef struct luxel_table_column {
    luxel_table_column_type type; /* what it holds */
    bool is_required;             /* else it may be missing or empty; those that are required come first */
    const char *const *names;     /* in lower case, NULL behind the last; the first stands in messages */
    void *reserved[4];            /* for later versions: NULL */
} luxel_table_column;

/* A table that is open; made by luxel_table_open(). */
typedef struct luxel_table luxel_table;

/* A row; all of it lives until the next one is read. */
typedef struct luxel_table_row {
    const double *numbers;    /* one for each column that is wanted; NaN: none there, or a text */
    const char *const *texts; /* one for each, in UTF-8, without quotes and blanks around it; "": none there, or a
                                 number of an array */
} luxel_table_row;

/*
 * Opens a table in a file and reads up to its first row.  Of `columns`, `count` of them and 16 at most, those that are
 * required must be there; `needs_heading`: a table that does not name them is refused.  Columns of the heading that are
 * not among them, and do more than number the rows, are reported as advice.  `columns` and `diagnostics`, which takes
 * the reports of this and of all later calls, must outlive the table; it is the caller's: free it with
 * luxel_table_free().
 * LUXEL_ERROR_FILE: it cannot be read, or is no such table.  LUXEL_ERROR_ARGUMENT: NULL, or too many columns.
 * LUXEL_ERROR_MEMORY: there is not enough.
 */
LUXEL_API luxel_status luxel_table_open(const char *path, const luxel_table_column *columns, size_t count,
                                        bool needs_heading, luxel_diagnostics *diagnostics, luxel_table **table);

/* Frees a table; NULL is harmless. */
LUXEL_API void luxel_table_free(luxel_table *table);

/* Whether the table has a column, one of those that were wanted. */
LUXEL_API bool luxel_table_has(const luxel_table *table, size_t column);

/* The unit that the heading gives a column, as it stands there; "" where it gives none. */
LUXEL_API const char *luxel_table_unit(const luxel_table *table, size_t column);

/*
 * Reads the next row.  False: there is none.  `*row` NULL: something is wrong with it, which was reported with line
 * and column; the next call goes on behind it, or finds that there is no way on.
 */
LUXEL_API bool luxel_table_next(luxel_table *table, const luxel_table_row **row);

/*
 * Where a field of the row stands, for messages of the caller's: line and column from 1, the column in characters.
 * A column that the table does not have stands at the beginning of the row; in an array it is the row's number, and 1.
 */
LUXEL_API void luxel_table_place(const luxel_table *table, size_t column, unsigned *line, unsigned *place);

/*
 * The text of a field as a number, with a decimal point or comma, and half a unit of its last digit as it is written.
 * False: it is no number, or no finite one; nothing is written.
 */
LUXEL_API bool luxel_table_number(const char *text, double *number, double *rounding);

#ifdef __cplusplus
}
#endif
#endif
