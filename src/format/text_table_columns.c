/* SPDX-License-Identifier: MIT */
/*
 * The beginning of a table: which separator it has, and whether its first line names the columns.  Each separator is
 * tried in turn on the first line; the first with which this is a heading, or else a row, is that of the whole file.
 */
#include <string.h>
#include <strings.h>

#include "../base/number.h"
#include "text_table_read.h"

/* A comma comes behind those that leave it to numbers, blanks last since others stand in headings with them. */
static const char SEPARATORS[] = {';', '\t', ',', ' '};

enum { LP_FIELDS = 4 };

size_t lx_text_table_trimmed(const struct lx_text_table *table, size_t width)
{
    const struct lx_text_table_lines *lines = &table->lines;
    size_t count = lines->count;
    while (count > width && lines->fields[count - 1].length == 0 && !lines->fields[count - 1].is_quoted)
        count--;
    if (count > width)
        return count;
    for (size_t i = 0; i < count; i++)
        if (lines->fields[i].length > 0 || lines->fields[i].is_quoted)
            return count;
    return 0;
}

static bool is_word_for_number(const char *text, size_t length)
{
    text += *text == '-';
    return (length >= 3 && length <= 4) && (strncmp(text, "inf", 3) == 0 || strncmp(text, "nan", 3) == 0);
}

bool lx_text_table_is_number(const struct lx_text_table *table, const struct lx_text_table_field *field,
                             luxel_table_column_type type)
{
    double number;
    bool decimal_comma = table->lines.separator != ',' || field->is_quoted;
    return type == LUXEL_TABLE_TEXT || lx_text_table_number(field->at, field->length, decimal_comma, &number, NULL) ||
           (type == LUXEL_TABLE_VALUE && is_word_for_number(field->at, field->length));
}

/* Whether the line is a row of a table without heading. */
static bool is_row(const struct lx_text_table *table)
{
    const struct lx_text_table_form *form = table->form;
    size_t required = 0, count = lx_text_table_trimmed(table, 1);
    while (required < form->count && form->columns[required].is_required)
        required++;
    if (count != required && count != form->count)
        return false;
    for (size_t i = 0; i < count; i++)
        if (!lx_text_table_is_number(table, &table->lines.fields[i], form->columns[i].type))
            return false;
    return true;
}

/* Whether the line is one of an .lp file; one of four numbers is only where the file's name says so. */
static bool is_lamp(const struct lx_text_table *table)
{
    const struct lx_text_table_field *fields = table->lines.fields;
    const char *name = lx_source_name(table->lines.source);
    size_t length = strlen(name);
    if (table->announced == 0 || lx_text_table_trimmed(table, 1) != LP_FIELDS)
        return false;
    for (size_t i = 1; i < LP_FIELDS; i++)
        if (!lx_text_table_is_number(table, &fields[i], LUXEL_TABLE_NUMBER))
            return false;
    return !lx_text_table_is_number(table, &fields[0], LUXEL_TABLE_NUMBER) ||
           (length > 3 && strcasecmp(name + length - 3, ".lp") == 0);
}

/* Takes columns in the order in which they are wanted, from a field on. */
static void take_order(struct lx_text_table *table, size_t first, size_t count)
{
    for (size_t c = 0; c < count; c++)
        table->places[c] = first + c;
    table->width = first + count;
}

/* ---- lines before the first ---- */

/* A line "sep=;" on which the table's separator stands; `*is_one`: it is such a line. */
static struct lx_text_table_fault take_separator(struct lx_text_table *table, bool *is_one)
{
    struct lx_text_table_lines *lines = &table->lines;
    const char *at = lines->start, *stop = lines->next;
    while (stop > at && lx_is_line_end(stop[-1]))
        stop--;
    while (at < stop && (*at == '"' || *at == ' '))
        at++;
    *is_one = stop - at >= 4 && strncasecmp(at, "sep=", 4) == 0;
    if (!*is_one)
        return (struct lx_text_table_fault){.message = LX_MSG_COUNT};
    char separator = stop - at > 4 ? at[4] : '\0', shown[2] = {separator};
    size_t rest = (size_t)(stop - at) - (separator ? 5 : 4);
    bool is_known = separator && memchr(SEPARATORS, separator, sizeof SEPARATORS) && strspn(at + 5, "\"; ,\t") >= rest;
    if (!is_known)
        return lx_text_table_fault_here(table, LX_MSG_TABLE_SEPARATOR, at, (size_t)(stop - at), LX_ARGS(shown));
    lx_text_table_set_separator(lines, separator);
    return (struct lx_text_table_fault){.message = LX_MSG_COUNT};
}

/* The number of lamps on the first line of an .lp file. */
static bool take_number_of_lamps(struct lx_text_table *table)
{
    const struct lx_text_table_field *field = table->lines.fields;
    double number;
    if (!table->form->takes_lp || lx_text_table_trimmed(table, 1) != 1 || memchr(field->at, '.', field->length) ||
        !lx_read_number(field->at, field->length, &number) || !(number >= 1 && number <= 1e9))
        return false;
    table->announced = (size_t)number;
    return true;
}

/* A heading in a comment, if it names the columns with any of the separators. */
static struct lx_text_table_fault take_comment(struct lx_text_table *table)
{
    struct lx_text_table_lines *lines = &table->lines, inside = {0};
    struct lx_text_table_fault fault = {.message = LX_MSG_COUNT};
    const struct lx_text_table_lines whole = *lines;
    const struct lx_text_table_field comment = lines->fields[0];
    struct lx_source *source = NULL;
    if (table->has_heading)
        return fault;
    if (lx_source_of_bytes("", comment.at, comment.length, NULL, &source) != LUXEL_OK ||
        !lx_text_table_lines_begin(&inside, source, true)) {
        fault = lx_text_table_fault_of(LX_MSG_OUT_OF_MEMORY, NULL);
    } else {
        for (size_t i = 0; i < sizeof SEPARATORS && !table->has_heading; i++) {
            lx_text_table_set_separator(&inside, SEPARATORS[i]);
            enum lx_text_table_step step = lx_text_table_cut(&inside);
            table->lines = inside;
            if (step == LX_TABLE_LINE)
                lx_text_table_take_heading(table, &fault);
            inside = table->lines;
            lx_text_table_again(&inside);
        }
    }
    table->lines = whole;
    lx_text_table_lines_clear(&inside);
    lx_source_close(source);
    fault.line = fault.line ? lines->line : 0;
    fault.text = NULL;
    for (size_t i = 0; i < table->unused_count; i++) { /* they lie in a text that is gone */
        table->unused[i].line = lines->line;
        table->unused[i].text = NULL;
    }
    return fault;
}

/* ---- the first line ---- */

/* Tries one separator on the first line; `*is_found`: it is the one. */
static struct lx_text_table_fault try_separator(struct lx_text_table *table, char separator, bool rows_only,
                                                bool *is_found)
{
    struct lx_text_table_lines *lines = &table->lines;
    struct lx_text_table_fault fault = {.message = LX_MSG_COUNT};
    lx_text_table_again(lines);
    lx_text_table_set_separator(lines, separator);
    *is_found = false;
    if (lx_text_table_cut(lines) != LX_TABLE_LINE)
        return fault;
    if (!rows_only) {
        *is_found = lx_text_table_take_heading(table, &fault);
        return fault;
    }
    if (table->has_heading) {
        size_t count = lx_text_table_trimmed(table, table->width);
        *is_found = count >= table->width && count <= table->width + 1 && table->width > 1;
    } else if (table->form->takes_lp && is_lamp(table)) {
        *is_found = table->is_lp = true;
        take_order(table, 1, LP_FIELDS - 1);
    } else if (!table->form->needs_heading && is_row(table)) {
        *is_found = true;
        take_order(table, 0, lx_text_table_trimmed(table, 1));
    }
    if (*is_found)
        lx_text_table_again(lines);
    return fault;
}

/* What is wrong with a first line that is neither heading nor row. */
static struct lx_text_table_fault judge_line(struct lx_text_table *table, char given)
{
    struct lx_text_table_lines *lines = &table->lines;
    size_t length = (size_t)(lines->next - lines->start), numbers = 0;
    char list[48], separator = ' ';
    for (size_t i = sizeof SEPARATORS; i-- > 0;)
        if (memchr(lines->start, SEPARATORS[i], length) && (SEPARATORS[i] != ',' || separator == ' '))
            separator = SEPARATORS[i];
    lx_text_table_again(lines);
    lx_text_table_set_separator(lines, given ? given : separator);
    enum lx_text_table_step step = lx_text_table_cut(lines);
    if (step != LX_TABLE_LINE)
        return lx_text_table_fault_of_step(table, step);
    for (size_t i = 0; i < lines->count; i++)
        numbers += lines->fields[i].length > 0 && lx_text_table_is_number(table, &lines->fields[i], LUXEL_TABLE_VALUE);
    lx_text_table_list_columns(table->form, list, sizeof list);
    if (table->announced > 0 && !table->has_heading)
        return lx_text_table_fault_here(table, LX_MSG_TABLE_LAMP, lines->start, 0, NULL);
    if (numbers == 0 || table->form->needs_heading) {
        struct lx_text_table_fault fault =
            lx_text_table_fault_here(table, LX_MSG_TABLE_HEADING, lines->start, 0, LX_ARGS(list));
        fault.hint = LX_MSG_HINT_TABLE_HEADING;
        return fault;
    }
    lx_text_table_again(lines);
    take_order(table, 0, table->form->count); /* the row's own faults are told when it is read */
    return (struct lx_text_table_fault){.message = LX_MSG_COUNT};
}

static struct lx_text_table_fault find_separator(struct lx_text_table *table, char given)
{
    bool is_found;
    for (int rows_only = table->has_heading; rows_only < 2; rows_only++)
        for (size_t i = 0; i < sizeof SEPARATORS; i++) {
            /* blanks take tabs, too, and rows of numbers may have both */
            bool is_blank = rows_only && !table->has_heading && !given && SEPARATORS[i] == '\t';
            if ((given && SEPARATORS[i] != given) || (is_blank && table->lines.comments_anywhere))
                continue;
            struct lx_text_table_fault fault = try_separator(table, SEPARATORS[i], rows_only, &is_found);
            if (is_found)
                return fault;
        }
    if (table->has_heading) { /* one in a comment, whose columns the rows lack or exceed */
        lx_text_table_again(&table->lines);
        return (struct lx_text_table_fault){.message = LX_MSG_COUNT};
    }
    return judge_line(table, given);
}

struct lx_text_table_fault lx_text_table_find_columns(struct lx_text_table *table)
{
    struct lx_text_table_fault fault = {.message = LX_MSG_COUNT};
    struct lx_text_table_lines *lines = &table->lines;
    char given = '\0';
    for (size_t c = 0; c < LX_MOST_COLUMNS; c++) {
        table->places[c] = LX_NO_FIELD;
        table->factors[c] = 1;
    }
    for (bool is_first = true;; is_first = false) {
        lx_text_table_set_separator(lines, given ? given : ',');
        enum lx_text_table_step step = lx_text_table_cut(lines);
        bool is_separator = false;
        if (step == LX_TABLE_END)
            return fault;
        if (is_first && (step == LX_TABLE_LINE || step == LX_TABLE_BEHIND)) {
            fault = take_separator(table, &is_separator);
            given = is_separator ? lines->separator : '\0';
        }
        if (fault.message == LX_MSG_COUNT && step == LX_TABLE_COMMENT)
            fault = take_comment(table);
        if (fault.message != LX_MSG_COUNT)
            return fault;
        if (is_separator || step == LX_TABLE_COMMENT || (step == LX_TABLE_LINE && lx_text_table_trimmed(table, 0) == 0))
            continue;
        if (step == LX_TABLE_LONG || step == LX_TABLE_ZERO || step == LX_TABLE_OUT_OF_MEMORY)
            return lx_text_table_fault_of_step(table, step);
        if (step != LX_TABLE_LINE || table->announced > 0 || table->has_heading || !take_number_of_lamps(table))
            return find_separator(table, given);
    }
}
