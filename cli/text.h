/* SPDX-License-Identifier: MIT */
/* Texts on standard output: numbers, places and tables with aligned columns. */
#ifndef LUXEL_CLI_TEXT_H
#define LUXEL_CLI_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { TEXT_SIZE = 400 }; /* room for any cell built here */

/* A length in millimetres with one to four decimals: 0.0, -150.0, 177.5766. */
const char *text_length(double value_mm, char buffer[TEXT_SIZE]);
/* "(0.0, 150.0)": `count` lengths, at most three. */
const char *text_lengths(const double *values_mm, size_t count, char buffer[TEXT_SIZE]);
/* The digits that --digits asks for; 0, as at the start: each place has its own. */
void text_set_digits(unsigned digits);
/* A value of a result, in the usual digits of the place or those that are asked for. */
const char *text_value(char buffer[TEXT_SIZE], unsigned usual, double value);
/* A value with a bound of its error: in no more digits than that leaves, two of its own, or those asked for. */
const char *text_bounded(char buffer[TEXT_SIZE], unsigned usual, double value, double error);
/* The bound of a value's error as text_error() prints it, of the value as text_bounded() prints it, which rounds it. */
const char *text_bound(char buffer[TEXT_SIZE], unsigned usual, double value, double error);
/* "2.7275907 ± 1.4e-08": a value with its bound; one that is known exactly, such as the 0 of an unlit place, alone. */
const char *text_value_bound(char buffer[TEXT_SIZE], unsigned usual, double value, double error);
/* A unit behind a number, translated. */
const char *text_unit(const char *unit);
/* A bound of an error, with two digits, rounded up. */
const char *text_error(double error, char buffer[TEXT_SIZE]);
/* printf into a cell. */
const char *text_format(char buffer[TEXT_SIZE], const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Prints a text that is not ours with its control characters escaped. */
void text_print_escaped(FILE *stream, const char *text);

/*
 * Prints a term and beside it, from column `indent` on, its text, wrapped before column 80.  A term that is
 * too long has a line of its own; "" gives a plain indented paragraph.
 */
void text_definition(FILE *stream, const char *term, int indent, const char *text);

enum { TEXT_COLUMNS = 24 };

/* A table: rows of cells, printed with columns as wide as their widest cell. */
struct text_table;

/* `alignment` has one letter for each column: l or r. */
struct text_table *text_table_new(const char *alignment);
/* Adds a row of as many texts as the table has columns; they are copied. */
void text_table_row(struct text_table *table, const char *const *cells);
/* Adds a line that takes no part in the columns. */
void text_table_line(struct text_table *table, const char *line);
/* Prints the table, each line indented, and frees it. */
void text_table_print(struct text_table *table, FILE *stream, int indent);

#define TEXT_CELLS(...) ((const char *const[]){__VA_ARGS__})

#endif
