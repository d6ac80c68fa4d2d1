/* SPDX-License-Identifier: MIT */
/*
 * Tables of numbers in text, as people and programs write them: the one reader of clouds, fields, answers and points.
 * It goes through the file part by part, so that of millions of rows only one is in memory.
 *
 * Separators   commas, semicolons, tabs or blanks, the same throughout: those with which the first line names the
 *              columns or is a row, or those of a line `sep=;` before it.
 * Numbers      with a decimal point or, unless commas separate, a decimal comma; in quotes either.
 * Heading      names of the columns in any order and case, with units: x_mm, x (mm), x [m], "x, cm".  Columns that are
 *              not wanted are passed over.  Without a heading the columns stand in the order in which they are wanted.
 *              A heading may stand in a comment, as numpy.savetxt() writes it, and may lack the name of the rows' first
 *              column, as that of R.
 * Lines        end in LF, CR LF or CR; lines of nothing but separators count for nothing, nor do separators behind the
 *              last field.  # begins a comment, in tables with texts only at the beginning of a line.
 * Encoding     UTF-8 with or without a byte order mark, UTF-16, and the code page 1251 in texts and headings.
 * .lp          the number of lamps, then on each line the name of a picture and x, y, z.
 */
#ifndef LX_FORMAT_TEXT_TABLE_H
#define LX_FORMAT_TEXT_TABLE_H

#include <luxel/table.h>

#include "../base/diagnostics.h"
#include "../base/source.h"

enum { LX_MOST_COLUMNS = 16 };

/* What is to be read. */
struct lx_text_table_form {
    const luxel_table_column *columns;
    size_t count;       /* LX_MOST_COLUMNS at most */
    bool needs_heading; /* a table without one is refused */
    bool takes_lp;      /* an .lp file is taken, whose numbers are the first three columns */
};

/* The names of the columns in a row, as far as there is room: "x, y, z". */
void lx_text_table_list_columns(const struct lx_text_table_form *form, char *list, size_t size);

/* What is wrong with a table, and where; the message is LX_MSG_COUNT where nothing is. */
struct lx_text_table_fault {
    enum lx_message message, hint; /* the hint LX_MSG_COUNT: none */
    size_t line;                   /* from 1; 0: no line of its own */
    unsigned column;               /* from 1, in characters */
    char words[3][48];             /* the arguments of either */
    const char *text;              /* the line, until the next one is read */
    size_t length, start, end;     /* of the text, and of what is wrong in it */
};

struct lx_text_table;

/* Opens a table and reads up to its first row; NULL: memory ran out.  The form and the source must outlive it. */
struct lx_text_table *lx_text_table_new(struct lx_source *source, const struct lx_text_table_form *form,
                                        struct lx_text_table_fault *fault);
void lx_text_table_free(struct lx_text_table *table);

/*
 * Goes to the next row and writes its numbers, one for each column that is wanted: in mm for lengths, NaN where the
 * table has none or for texts.  False at the end, after a failure of the source, which keeps it, and where something
 * is wrong; then the next call goes on behind it unless `is_broken` was set.
 */
bool lx_text_table_next(struct lx_text_table *table, double *numbers, struct lx_text_table_fault *fault);
bool lx_text_table_is_broken(const struct lx_text_table *table);

/* Whether the table has a column that was wanted. */
bool lx_text_table_has(const struct lx_text_table *table, size_t column);
bool lx_text_table_has_heading(const struct lx_text_table *table);
bool lx_text_table_is_lp(const struct lx_text_table *table);

/* The unit that the heading gives a column, "" where it gives none. */
const char *lx_text_table_unit(const struct lx_text_table *table, size_t column);

/*
 * The columns of the heading that are passed over, but for names of rows and the like: reported as advice, at the place
 * of the first of them in the file of this name, before the first row is read; or listed in quotes, as many as there is
 * room for, "" where there is none.
 */
enum { LX_UNUSED_SIZE = 256 };
void lx_text_table_report_unused(const struct lx_text_table *table, const char *name, luxel_diagnostics *diagnostics);
void lx_text_table_list_unused(const struct lx_text_table *table, char *list, size_t size);

/* The line of the row, and the bytes of a field of it until the next one is read (NULL: it has none). */
size_t lx_text_table_line(const struct lx_text_table *table);
const char *lx_text_table_field(const struct lx_text_table *table, size_t column, size_t *length, bool *is_quoted);

/* Points to a field of the row from a fault that others report. */
struct lx_text_table_fault lx_text_table_fault_at(const struct lx_text_table *table, size_t column,
                                                  enum lx_message message);

/*
 * A number as tables have it.  `decimal_comma`: whether a comma may stand for the point.  `*rounding`, unless NULL,
 * becomes half a unit of its last digit.
 */
bool lx_text_table_number(const char *text, size_t length, bool decimal_comma, double *number, double *rounding);

/* Adds a fault as words, its place aside, to a text with phrases (phrase.h). */
void lx_add_fault(struct lx_text *text, const struct lx_text_table_fault *fault);

/* The place of a fault in the file of this name. */
struct lx_place lx_text_table_place_of(const struct lx_text_table_fault *fault, const char *name);

/* Reports a fault at its place in the file of this name. */
void lx_report_fault(luxel_diagnostics *diagnostics, const char *name, const struct lx_text_table_fault *fault);

#endif
