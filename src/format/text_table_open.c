/* SPDX-License-Identifier: MIT */
/* The public functions for tables: a table or an array with its source, its texts and the reports. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "array_table.h"
#include "text_table.h"
#include "text_table_lines.h"

/* No more of a pipe is taken into memory. */
enum { MOST_OF_A_PIPE = 1 << 30 };

struct luxel_table {
    luxel_diagnostics *diagnostics;
    struct lx_source *source;
    struct lx_text_table_form form;
    struct lx_text_table *table;
    struct lx_array_table *array; /* instead, of a file that holds one */
    double numbers[LX_MOST_COLUMNS];
    const char *texts[LX_MOST_COLUMNS];
    struct lx_text held[LX_MOST_COLUMNS]; /* what they point to */
    luxel_table_row row;
    bool has_failed; /* the source, which was told */
};

static luxel_status open_table(luxel_table *made, const char *path)
{
    struct lx_text_table_fault fault;
    luxel_status status = lx_source_open(path, MOST_OF_A_PIPE, made->diagnostics, &made->source);
    if (status != LUXEL_OK)
        return status;
    if (lx_is_array(made->source))
        return lx_array_table_new(made->source, &made->form, &made->array);
    made->table = lx_text_table_new(made->source, &made->form, &fault);
    if (!made->table)
        return lx_out_of_memory(made->diagnostics);
    if (lx_source_status(made->source) != LUXEL_OK)
        return lx_source_status(made->source);
    if (fault.message == LX_MSG_COUNT) {
        lx_text_table_report_unused(made->table, path, made->diagnostics);
        return LUXEL_OK;
    }
    lx_report_fault(made->diagnostics, path, &fault);
    return fault.message == LX_MSG_OUT_OF_MEMORY ? LUXEL_ERROR_MEMORY : LUXEL_ERROR_FILE;
}

luxel_status luxel_table_open(const char *path, const luxel_table_column *columns, size_t count, bool needs_heading,
                              luxel_diagnostics *diagnostics, luxel_table **table)
{
    const char *missing = !path ? "path" : !columns || count == 0 || count > LX_MOST_COLUMNS ? "columns" : "table";
    if (!path || !columns || count == 0 || count > LX_MOST_COLUMNS || !table)
        return lx_refuse(diagnostics, LX_MSG_MISSING_ARGUMENT, LX_ARGS(missing));
    for (size_t c = 0; c < count; c++)
        if (LX_CHECK_RESERVE(&columns[c], diagnostics) != LUXEL_OK)
            return LUXEL_ERROR_ARGUMENT;
    *table = NULL;
    luxel_table *made = lx_new_array(1, sizeof *made);
    if (!made)
        return lx_out_of_memory(diagnostics);
    made->diagnostics = diagnostics;
    made->form = (struct lx_text_table_form){.columns = columns, .count = count, .needs_heading = needs_heading};
    luxel_status status = open_table(made, path);
    if (status == LUXEL_OK)
        *table = made;
    else
        luxel_table_free(made);
    return status;
}

void luxel_table_free(luxel_table *table)
{
    if (!table)
        return;
    lx_text_table_free(table->table);
    lx_array_table_free(table->array);
    lx_source_close(table->source);
    for (size_t c = 0; c < LX_MOST_COLUMNS; c++)
        lx_text_clear(&table->held[c]);
    free(table);
}

bool luxel_table_has(const luxel_table *table, size_t column)
{
    if (!table)
        return false;
    return table->array ? lx_array_table_has(table->array, column) : lx_text_table_has(table->table, column);
}

const char *luxel_table_unit(const luxel_table *table, size_t column)
{
    return table && !table->array ? lx_text_table_unit(table->table, column) : "";
}

/* The text of a field; false where out of memory. */
static bool take_text(luxel_table *table, size_t column)
{
    struct lx_text *held = &table->held[column];
    struct lx_text_table_field field = {0};
    char number[LX_NUMBER_SIZE];
    held->length = 0;
    lx_text_puts(held, "");
    if (!table->array)
        field.at = lx_text_table_field(table->table, column, &field.length, &field.is_quoted);
    if (field.at)
        lx_text_table_add(held, &field);
    else if (table->array && table->form.columns[column].type == LUXEL_TABLE_TEXT && luxel_table_has(table, column))
        lx_text_puts(held, lx_write_number(table->numbers[column], number));
    table->texts[column] = held->bytes;
    return !held->failed;
}

/* Reads the numbers of the next row; `*is_good` false: of none, which is reported.  False: there is no way on. */
static bool next_of_text(luxel_table *table, bool *is_good)
{
    struct lx_text_table_fault fault;
    *is_good = lx_text_table_next(table->table, table->numbers, &fault);
    if (*is_good)
        return true;
    bool is_over = fault.message == LX_MSG_COUNT, has_failed = lx_source_status(table->source) != LUXEL_OK;
    if (!is_over)
        lx_report_fault(table->diagnostics, lx_source_name(table->source), &fault);
    bool is_new = !is_over || (has_failed && !table->has_failed); /* the source has reported that it did */
    table->has_failed = has_failed;
    return is_new;
}

static bool next_of_array(luxel_table *table, bool *is_good)
{
    const struct lx_place place = {.source = lx_source_name(table->source)};
    char number[LX_NUMBER_SIZE];
    if (!lx_array_table_next(table->array, table->numbers, is_good))
        return false;
    lx_write_number((double)lx_array_table_row(table->array), number);
    if (!*is_good)
        lx_report(table->diagnostics, LUXEL_SEVERITY_ERROR, &place, LX_MSG_TABLE_ROW, LX_ARGS(number));
    return true;
}

bool luxel_table_next(luxel_table *table, const luxel_table_row **row)
{
    bool is_good;
    *row = NULL;
    if (!table || !(table->array ? next_of_array(table, &is_good) : next_of_text(table, &is_good)))
        return false;
    if (!is_good)
        return true;
    for (size_t c = 0; c < table->form.count; c++)
        if (!take_text(table, c)) {
            lx_out_of_memory(table->diagnostics);
            return true;
        }
    table->row = (luxel_table_row){.numbers = table->numbers, .texts = table->texts};
    *row = &table->row;
    return true;
}

void luxel_table_place(const luxel_table *table, size_t column, unsigned *line, unsigned *place)
{
    if (table->array) {
        *line = (unsigned)lx_array_table_row(table->array);
        *place = 1;
        return;
    }
    struct lx_text_table_fault at = lx_text_table_fault_at(table->table, column, LX_MSG_COUNT);
    *line = (unsigned)at.line;
    *place = at.column;
}

bool luxel_table_number(const char *text, double *number, double *rounding)
{
    double found, half;
    if (!text || !lx_text_table_number(text, strlen(text), true, &found, &half))
        return false;
    *number = found;
    *rounding = half;
    return true;
}
