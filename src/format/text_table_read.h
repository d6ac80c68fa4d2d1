/* SPDX-License-Identifier: MIT */
/* What the parts of the reader of tables share: its state, and what finds the separator and the columns. */
#ifndef LX_FORMAT_TEXT_TABLE_READ_H
#define LX_FORMAT_TEXT_TABLE_READ_H

#include "text_table.h"
#include "text_table_lines.h"

#define LX_NO_FIELD SIZE_MAX

struct lx_text_table {
    const struct lx_text_table_form *form;
    struct lx_text_table_lines lines;
    bool has_heading, is_lp, is_broken;
    size_t width;                   /* fields of a row */
    size_t shift;                   /* 1: in front of them stands one that the heading does not name */
    bool knows_shift;               /* a row was there */
    size_t places[LX_MOST_COLUMNS]; /* the field of each column, or LX_NO_FIELD */
    double factors[LX_MOST_COLUMNS];
    char *units[LX_MOST_COLUMNS];
    struct lx_text_table_fault *unused; /* columns that are passed over: the first word is what they are called */
    size_t unused_count, unused_capacity;
    size_t announced, rows; /* of an .lp file; and how many there were */
    bool has_point, has_group;
};

/* A fault without a place of its own, with up to three arguments. */
struct lx_text_table_fault lx_text_table_fault_of(enum lx_message message, const char *const *arguments);

/* A fault at a stretch of the line. */
struct lx_text_table_fault lx_text_table_fault_here(const struct lx_text_table *table, enum lx_message message,
                                                    const char *at, size_t length, const char *const *arguments);

/* The fault of a step that is none of line, comment and end. */
struct lx_text_table_fault lx_text_table_fault_of_step(const struct lx_text_table *table, enum lx_text_table_step step);

/* Reads up to the first row and finds separator, heading and columns. */
struct lx_text_table_fault lx_text_table_find_columns(struct lx_text_table *table);

/* Whether a field is a number, or what may stand for one in a column of this type. */
bool lx_text_table_is_number(const struct lx_text_table *table, const struct lx_text_table_field *field,
                             luxel_table_column_type type);

/* Fields of the line without empty ones at its end that no column needs; 0: all are empty. */
size_t lx_text_table_trimmed(const struct lx_text_table *table, size_t width);

/*
 * Whether the fields of the line name all columns that must be there; then their places and units are set.
 * `fault`: they do, but not so that it could be read.
 */
bool lx_text_table_take_heading(struct lx_text_table *table, struct lx_text_table_fault *fault);

#endif
