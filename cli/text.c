/* SPDX-License-Identifier: MIT */
/*
 * Numbers and tables as text.  The tool never sets a numeric locale, so printf writes a decimal point
 * whatever the user's language is.
 */
#include "text.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <luxel/luxel.h>

#include "cli.h"
#include "message.h"

struct row {
    char *line; /* a line of its own, or NULL: the cells */
    char *cells[TEXT_COLUMNS];
};

struct text_table {
    const char *alignment;
    size_t columns, count, capacity;
    struct row *rows;
};

const char *text_format(char buffer[TEXT_SIZE], const char *format, ...)
{
    va_list arguments;
    int length;

    va_start(arguments, format);
    length = vsnprintf(buffer, TEXT_SIZE, format, arguments);
    va_end(arguments);
    if (length >= TEXT_SIZE) {
        /* Cut before the character that may have lost its end. */
        length = TEXT_SIZE - 1;
        while (length > 0 && ((unsigned char)buffer[length - 1] & 0xc0) == 0x80)
            length--;
        buffer[length > 0 ? length - 1 : 0] = '\0';
    }
    return buffer;
}

const char *text_length(double value_mm, char buffer[TEXT_SIZE])
{
    const double size = fabs(value_mm);
    size_t length;

    if (size != 0.0 && (size < 1e-3 || size >= 1e9)) {
        snprintf(buffer, TEXT_SIZE, "%.6g", value_mm);
        return buffer;
    }
    /* Adding 0 turns -0 into 0. */
    length = (size_t)snprintf(buffer, TEXT_SIZE, "%.4f", value_mm + 0.0);
    while (buffer[length - 1] == '0' && buffer[length - 2] != '.')
        buffer[--length] = '\0';
    return buffer;
}

const char *text_lengths(const double *values_mm, size_t count, char buffer[TEXT_SIZE])
{
    char number[TEXT_SIZE];
    size_t used = 0;

    for (size_t i = 0; i < count; i++)
        used += (size_t)snprintf(buffer + used, TEXT_SIZE - used, "%s%s", i == 0 ? "(" : ", ",
                                 text_length(values_mm[i], number));
    snprintf(buffer + used, TEXT_SIZE - used, ")");
    return buffer;
}

static unsigned wanted_digits;

void text_set_digits(unsigned digits)
{
    wanted_digits = digits;
}

const char *text_value(char buffer[TEXT_SIZE], unsigned usual, double value)
{
    return text_format(buffer, "%.*g", (int)(wanted_digits > 0 ? wanted_digits : usual), value);
}

const char *text_bounded(char buffer[TEXT_SIZE], unsigned usual, double value, double error)
{
    int digits = (int)usual;

    if (wanted_digits > 0 || !(error > 0.0) || !isfinite(error) || !isfinite(value))
        return text_value(buffer, usual, value);
    if (value != 0.0) /* those down to the second one of the error */
        digits = (int)floor(log10(fabs(value))) - (int)floor(log10(error)) + 2;
    if (digits < 1)
        return text_format(buffer, "0");
    return text_format(buffer, "%.*g", digits < (int)usual ? digits : (int)usual, value);
}

const char *text_bound(char buffer[TEXT_SIZE], unsigned usual, double value, double error)
{
    if (isfinite(value) && isfinite(error))
        error += fabs(strtod(text_bounded(buffer, usual, value, error), NULL) - value);
    return text_error(error, buffer);
}

const char *text_value_bound(char buffer[TEXT_SIZE], unsigned usual, double value, double error)
{
    char bounded[TEXT_SIZE], bound[TEXT_SIZE];

    text_bounded(bounded, usual, value, error);
    text_bound(bound, usual, value, error);
    return strcmp(bound, "0") == 0 ? text_format(buffer, "%s", bounded)
                                   : text_format(buffer, "%s ± %s", bounded, bound);
}

const char *text_unit(const char *unit)
{
    return strcmp(unit, "relative") == 0 ? _("relative units") : _(unit);
}

const char *text_error(double error, char buffer[TEXT_SIZE])
{
    return text_format(buffer, error > 0.0 ? "%.1e" : "%.0f", luxel_round_bound(error, 2));
}

void text_print_escaped(FILE *stream, const char *text)
{
    char *escaped = luxel_escaped_text(text);

    if (escaped)
        fputs(escaped, stream);
    luxel_text_free(escaped);
}

/* Columns that a UTF-8 text takes: one for each character, which holds for every text of this tool. */
static size_t text_width(const char *text)
{
    size_t width = 0;

    for (; *text; text++)
        width += ((unsigned char)*text & 0xc0) != 0x80;
    return width;
}

static void print_blanks(FILE *stream, size_t count)
{
    fprintf(stream, "%*s", (int)count, "");
}

void text_definition(FILE *stream, const char *term, int indent, const char *text)
{
    enum { WIDTH = 80 };
    const size_t start = (size_t)indent;
    size_t column = text_width(term);

    fputs(term, stream);
    if (column > 0 && column + 1 > start) {
        fputc('\n', stream);
        column = 0;
    }
    print_blanks(stream, start - column);
    column = start;
    while (*text) {
        const size_t length = strcspn(text, " ");
        char word[256];
        size_t width;

        snprintf(word, sizeof word, "%.*s", (int)length, text);
        width = text_width(word);
        if (column > start && column + 1 + width > WIDTH) {
            fputc('\n', stream);
            print_blanks(stream, start);
            column = start;
        } else if (column > start) {
            fputc(' ', stream);
            column++;
        }
        fputs(word, stream);
        column += width;
        text += length + (text[length] == ' ');
    }
    fputc('\n', stream);
}

static char *copy(const char *text)
{
    const size_t size = strlen(text) + 1;

    return memcpy(message_allocate(size, 1), text, size);
}

struct text_table *text_table_new(const char *alignment)
{
    struct text_table *table = message_allocate(1, sizeof *table);

    table->alignment = alignment;
    table->columns = strlen(alignment);
    return table;
}

static struct row *add_row(struct text_table *table)
{
    if (table->count == table->capacity) {
        const size_t capacity = table->capacity > 0 ? 2 * table->capacity : 16;
        struct row *rows = message_allocate(capacity, sizeof *rows);

        if (table->count > 0)
            memcpy(rows, table->rows, table->count * sizeof *rows);
        free(table->rows);
        table->rows = rows;
        table->capacity = capacity;
    }
    return &table->rows[table->count++];
}

void text_table_row(struct text_table *table, const char *const *cells)
{
    struct row *row = add_row(table);

    for (size_t i = 0; i < table->columns; i++)
        row->cells[i] = copy(cells[i]);
}

void text_table_line(struct text_table *table, const char *line)
{
    add_row(table)->line = copy(line);
}

static void print_row(const struct text_table *table, const struct row *row, const size_t *widths, FILE *stream)
{
    size_t columns = table->columns;

    while (columns > 0 && row->cells[columns - 1][0] == '\0')
        columns--;
    for (size_t i = 0; i < columns; i++) {
        const size_t padding = widths[i] - text_width(row->cells[i]);

        if (i > 0)
            fputs("  ", stream);
        if (table->alignment[i] == 'r')
            print_blanks(stream, padding);
        fputs(row->cells[i], stream);
        if (table->alignment[i] == 'l' && i + 1 < columns)
            print_blanks(stream, padding);
    }
}

void text_table_print(struct text_table *table, FILE *stream, int indent)
{
    size_t widths[TEXT_COLUMNS] = {0};

    for (size_t r = 0; r < table->count; r++)
        for (size_t i = 0; i < table->columns && !table->rows[r].line; i++) {
            const size_t width = text_width(table->rows[r].cells[i]);

            if (width > widths[i])
                widths[i] = width;
        }
    for (size_t r = 0; r < table->count; r++) {
        struct row *row = &table->rows[r];

        print_blanks(stream, (size_t)indent);
        if (row->line)
            fputs(row->line, stream);
        else
            print_row(table, row, widths, stream);
        fputc('\n', stream);
        free(row->line);
        for (size_t i = 0; i < table->columns; i++)
            free(row->cells[i]);
    }
    free(table->rows);
    free(table);
}
