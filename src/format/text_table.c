/* SPDX-License-Identifier: MIT */
/* Tables: their rows, numbers and faults. */
#include "text_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "text_table_read.h"

/* ---- faults ---- */

static void copy_words(char words[48], const char *text, size_t length)
{
    size_t size = 48, shown = length < 40 ? length : 40;
    while (shown < length && shown > 0 && (text[shown] & 0xC0) == 0x80) /* within a character of several bytes */
        shown--;
    snprintf(words, size, "%.*s%s", (int)shown, text, shown < length ? "..." : "");
}

struct lx_text_table_fault lx_text_table_fault_of(enum lx_message message, const char *const *arguments)
{
    struct lx_text_table_fault fault = {.message = message, .hint = LX_MSG_COUNT};
    for (size_t i = 0; i < 3 && arguments && arguments[i]; i++)
        copy_words(fault.words[i], arguments[i], strlen(arguments[i]));
    return fault;
}

struct lx_text_table_fault lx_text_table_fault_here(const struct lx_text_table *table, enum lx_message message,
                                                    const char *at, size_t length, const char *const *arguments)
{
    const struct lx_text_table_lines *lines = &table->lines;
    struct lx_text_table_fault fault = lx_text_table_fault_of(message, arguments);
    const char *end = lines->part + lines->length, *line = lines->start, *stop;
    fault.line = lines->line;
    for (const char *c = lines->start; c < at; c++)
        if (lx_is_line_end(*c) && !(*c == '\r' && c[1] == '\n')) {
            fault.line++;
            line = c + 1;
        }
    for (stop = at; stop < end && !lx_is_line_end(*stop);)
        stop++;
    fault.text = line;
    fault.length = (size_t)(stop - line);
    fault.start = (size_t)(at - line);
    fault.end = fault.start + length < fault.length ? fault.start + length : fault.length;
    fault.column = 1;
    for (size_t i = 0, size; i < fault.start; i += size) {
        uint32_t code;
        size = lx_next_character(line + i, fault.length - i, &code);
        size = size ? size : 1;
        fault.column++;
    }
    return fault;
}

struct lx_text_table_fault lx_text_table_fault_of_step(const struct lx_text_table *table, enum lx_text_table_step step)
{
    const struct lx_text_table_lines *lines = &table->lines;
    switch (step) {
    case LX_TABLE_LONG: {
        struct lx_text_table_fault fault = lx_text_table_fault_of(LX_MSG_TABLE_LONG, NULL);
        fault.line = lines->line;
        fault.column = 1;
        return fault;
    }
    case LX_TABLE_OPEN_QUOTE: return lx_text_table_fault_here(table, LX_MSG_TABLE_OPEN_QUOTE, lines->wrong, 1, NULL);
    case LX_TABLE_BEHIND: return lx_text_table_fault_here(table, LX_MSG_TABLE_BEHIND, lines->wrong, 1, NULL);
    case LX_TABLE_ZERO: return lx_text_table_fault_here(table, LX_MSG_TABLE_ZERO, lines->wrong, 1, NULL);
    case LX_TABLE_OUT_OF_MEMORY: return lx_text_table_fault_of(LX_MSG_OUT_OF_MEMORY, NULL);
    case LX_TABLE_LINE:
    case LX_TABLE_COMMENT:
    case LX_TABLE_END: break;
    }
    return lx_text_table_fault_of(LX_MSG_COUNT, NULL);
}

struct lx_text_table_fault lx_text_table_fault_at(const struct lx_text_table *table, size_t column,
                                                  enum lx_message message)
{
    size_t length;
    bool is_quoted;
    const char *at = lx_text_table_field(table, column, &length, &is_quoted);
    return at ? lx_text_table_fault_here(table, message, at - is_quoted, length + 2 * is_quoted, NULL)
              : lx_text_table_fault_here(table, message, table->lines.start, 0, NULL);
}

void lx_add_fault(struct lx_text *text, const struct lx_text_table_fault *fault)
{
    struct lx_text words[3] = {{0}, {0}, {0}};
    for (int i = 0; i < 3; i++) {
        lx_text_add_escaped(&words[i], fault->words[i], strlen(fault->words[i]));
        text->failed = text->failed || words[i].failed;
    }
    if (!text->failed)
        lx_add_phrase(text, lx_message_words(fault->message),
                      LX_ARGS(words[0].bytes ? words[0].bytes : "", words[1].bytes ? words[1].bytes : "",
                              words[2].bytes ? words[2].bytes : ""));
    for (int i = 0; i < 3; i++)
        lx_text_clear(&words[i]);
}

struct lx_place lx_text_table_place_of(const struct lx_text_table_fault *fault, const char *name)
{
    return (struct lx_place){
        .source = name,
        .text = fault->text,
        .length = fault->length,
        .lines_before = fault->line ? fault->line - 1 : 0,
        .line = fault->line,
        .start = fault->start,
        .end = fault->end,
    };
}

void lx_report_fault(luxel_diagnostics *diagnostics, const char *name, const struct lx_text_table_fault *fault)
{
    const struct lx_place place = lx_text_table_place_of(fault, name);
    if (fault->message == LX_MSG_OUT_OF_MEMORY) {
        lx_out_of_memory(diagnostics);
        return;
    }
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, fault->message,
              LX_ARGS(fault->words[0], fault->words[1], fault->words[2]));
    if (fault->hint != LX_MSG_COUNT)
        lx_hint(diagnostics, fault->hint, LX_ARGS(fault->words[0], fault->words[1], fault->words[2]));
}

/* ---- numbers ---- */

/* Half a unit of the last digit of what is a number. */
static double rounding_of(const char *text, size_t length)
{
    const char *exponent = memchr(text, 'e', length), *end = text + length;
    exponent = exponent ? exponent : memchr(text, 'E', length);
    const char *stop = exponent ? exponent : end, *point = memchr(text, '.', (size_t)(stop - text));
    double power = exponent ? strtod(exponent + 1, NULL) : 0;
    power -= point ? fmin((double)(stop - point - 1), 1000) : 0;
    return 0.5 * pow(10, power);
}

bool lx_text_table_number(const char *text, size_t length, bool decimal_comma, double *number, double *rounding)
{
    enum { LONGEST = 1100 };
    char copy[LONGEST];
    const char *comma = decimal_comma ? memchr(text, ',', length) : NULL;
    if (!comma && !rounding)
        return lx_read_number(text, length, number);
    if (length == 0 || length >= LONGEST || (comma && comma + 1 == text + length))
        return false;
    memcpy(copy, text, length);
    copy[length] = '\0';
    if (comma)
        copy[comma - text] = '.';
    if (!lx_read_number(copy, length, number))
        return false;
    if (rounding)
        *rounding = rounding_of(copy, length);
    return true;
}

/* Whether a comma may group digits as well as begin a fraction: 1,234. */
static bool may_be_group(const char *text, size_t length)
{
    const char *comma = memchr(text, ',', length);
    text += *text == '-' || *text == '+';
    size_t whole = (size_t)(comma - text), digits = strspn(comma + 1, "0123456789");
    return whole >= 1 && whole <= 3 && *text != '0' && strspn(text, "0123456789") == whole && digits == 3 &&
           text + whole + 1 + digits <= text + length;
}

/* Whether the file has decimal points and a comma that may be one or not; then the number has two meanings. */
static bool is_ambiguous(struct lx_text_table *table, const struct lx_text_table_field *field)
{
    const char *comma = memchr(field->at, ',', field->length);
    if (comma)
        table->has_group = table->has_group || may_be_group(field->at, field->length);
    else
        table->has_point = table->has_point || memchr(field->at, '.', field->length);
    return table->has_point && table->has_group;
}

static bool begins_with(const char *text, size_t length, const char *letters)
{
    size_t count = strlen(letters);
    for (size_t i = 0; i < count; i++)
        if (i == length || (text[i] | 0x20) != letters[i])
            return false;
    return true;
}

/* inf, -inf and nan. */
static bool read_word(const char *text, size_t length, double *number)
{
    bool is_negative = length > 0 && *text == '-';
    text += is_negative;
    length -= is_negative;
    if (length != 3 || !(begins_with(text, 3, "inf") || begins_with(text, 3, "nan")))
        return false;
    *number = (*text | 0x20) == 'n' ? (double)NAN : is_negative ? -HUGE_VAL : HUGE_VAL;
    return true;
}

/* Why a field is no number that may stand in its column. */
static struct lx_text_table_fault judge_field(const struct lx_text_table *table, size_t column, size_t place)
{
    const struct lx_text_table_field *field = &table->lines.fields[place];
    const char *name = table->form->columns[column].names[0];
    struct lx_text text = {0};
    lx_add_decoded(&text, field->at, field->length);
    const char *shown = text.bytes ? text.bytes : "", *word = shown + (*shown == '-' || *shown == '+');
    size_t length = strlen(word);
    bool is_large = begins_with(word, length, "nan") || begins_with(word, length, "inf") ||
                    lx_looks_like_number(shown, strlen(shown));
    enum lx_message message = *shown == '\0' ? LX_MSG_TABLE_MISSING
                              : is_large     ? LX_MSG_TABLE_NOT_FINITE
                                             : LX_MSG_TABLE_NUMBER;
    struct lx_text_table_fault fault = lx_text_table_fault_here(
        table, message, field->at - field->is_quoted, field->length + 2 * field->is_quoted, LX_ARGS(shown, name));
    if (message == LX_MSG_TABLE_NUMBER && lx_looks_like_number(shown, strspn(shown, "0123456789+-.eE")))
        fault.hint = LX_MSG_HINT_TABLE_NUMBERS;
    lx_text_clear(&text);
    return fault;
}

/* ---- rows ---- */

static struct lx_text_table_fault count_fault(const struct lx_text_table *table, size_t count)
{
    const struct lx_text_table_lines *lines = &table->lines;
    char found[LX_NUMBER_SIZE], expected[LX_NUMBER_SIZE];
    lx_write_number((double)count, found);
    lx_write_number((double)(table->width + table->shift), expected);
    struct lx_text_table_fault fault =
        lx_text_table_fault_here(table, table->has_heading ? LX_MSG_TABLE_FIELDS : LX_MSG_TABLE_NUMBERS, lines->start,
                                 0, LX_ARGS(found, expected));
    if (lines->separator == ',' && count > table->width)
        fault.hint = LX_MSG_HINT_TABLE_COMMAS;
    return fault;
}

/* Whether the rows begin with a field that the heading does not name, as those of R do. */
static void find_shift(struct lx_text_table *table)
{
    const struct lx_text_table_lines *lines = &table->lines;
    bool is_set_off = lines->separator == ' ' || lines->separator == '\t' || lines->fields[0].is_quoted;
    table->knows_shift = true;
    table->shift = table->has_heading && is_set_off && lx_text_table_trimmed(table, table->width) == table->width + 1;
}

static struct lx_text_table_fault read_row(struct lx_text_table *table, double *numbers)
{
    static const struct lx_text_table_fault good = {.message = LX_MSG_COUNT, .hint = LX_MSG_COUNT};
    const struct lx_text_table_form *form = table->form;
    const struct lx_text_table_lines *lines = &table->lines;
    if (!table->knows_shift)
        find_shift(table);
    size_t count = lines->count;
    if (count != table->width + table->shift) {
        count = lx_text_table_trimmed(table, table->width + table->shift);
        if (count != table->width + table->shift)
            return count_fault(table, count);
    }
    for (size_t c = 0; c < form->count; c++) {
        size_t place = table->places[c];
        numbers[c] = (double)NAN;
        if (place == LX_NO_FIELD || form->columns[c].type == LUXEL_TABLE_TEXT)
            continue;
        place += table->shift;
        const struct lx_text_table_field *field = &lines->fields[place];
        bool decimal_comma = lines->separator != ',' || field->is_quoted;
        if (field->length == 0 && !form->columns[c].is_required)
            continue;
        if (!lx_text_table_number(field->at, field->length, decimal_comma, &numbers[c], NULL) &&
            !(form->columns[c].type == LUXEL_TABLE_VALUE && read_word(field->at, field->length, &numbers[c])))
            return judge_field(table, c, place);
        if (decimal_comma && is_ambiguous(table, field))
            return lx_text_table_fault_at(table, c, LX_MSG_TABLE_TWO_MEANINGS);
        numbers[c] *= table->factors[c];
    }
    return good;
}

/* The number of lamps is the announced one. */
static bool check_number_of_lamps(struct lx_text_table *table, struct lx_text_table_fault *fault)
{
    char found[LX_NUMBER_SIZE], expected[LX_NUMBER_SIZE];
    if (table->announced == 0 || table->announced == table->rows || lx_source_status(table->lines.source) != LUXEL_OK)
        return true;
    *fault = lx_text_table_fault_of(LX_MSG_TABLE_LAMPS, LX_ARGS(lx_write_number((double)table->rows, found),
                                                                lx_write_number((double)table->announced, expected)));
    return false;
}

bool lx_text_table_next(struct lx_text_table *table, double *numbers, struct lx_text_table_fault *fault)
{
    fault->message = LX_MSG_COUNT;
    while (!table->is_broken) {
        enum lx_text_table_step step = lx_text_table_cut(&table->lines);
        if (step == LX_TABLE_COMMENT)
            continue;
        if (step == LX_TABLE_END) {
            check_number_of_lamps(table, fault);
            table->is_broken = true;
            return false;
        }
        if (step != LX_TABLE_LINE) {
            table->is_broken = true;
            *fault = lx_text_table_fault_of_step(table, step);
            return false;
        }
        bool is_plain = table->lines.count == table->width && table->lines.fields[0].length > 0;
        if (!is_plain && lx_text_table_trimmed(table, 0) == 0)
            continue;
        table->rows++;
        *fault = read_row(table, numbers);
        return fault->message == LX_MSG_COUNT;
    }
    return false;
}

/* ---- opening, and what is asked for ---- */

struct lx_text_table *lx_text_table_new(struct lx_source *source, const struct lx_text_table_form *form,
                                        struct lx_text_table_fault *fault)
{
    struct lx_text_table *table = lx_new_array(1, sizeof *table);
    bool has_texts = false;
    for (size_t c = 0; c < form->count; c++)
        has_texts = has_texts || form->columns[c].type == LUXEL_TABLE_TEXT;
    if (!table)
        return NULL;
    table->form = form;
    if (!lx_text_table_lines_begin(&table->lines, source, !has_texts)) {
        lx_text_table_free(table);
        return NULL;
    }
    *fault = lx_text_table_find_columns(table);
    table->is_broken = fault->message != LX_MSG_COUNT;
    return table;
}

void lx_text_table_free(struct lx_text_table *table)
{
    if (!table)
        return;
    for (size_t c = 0; c < LX_MOST_COLUMNS; c++)
        free(table->units[c]);
    free(table->unused);
    lx_text_table_lines_clear(&table->lines);
    free(table);
}

bool lx_text_table_is_broken(const struct lx_text_table *table)
{
    return table->is_broken;
}

bool lx_text_table_has(const struct lx_text_table *table, size_t column)
{
    return column < table->form->count && table->places[column] != LX_NO_FIELD;
}

bool lx_text_table_has_heading(const struct lx_text_table *table)
{
    return table->has_heading;
}

bool lx_text_table_is_lp(const struct lx_text_table *table)
{
    return table->is_lp;
}

const char *lx_text_table_unit(const struct lx_text_table *table, size_t column)
{
    return column < LX_MOST_COLUMNS && table->units[column] ? table->units[column] : "";
}

size_t lx_text_table_line(const struct lx_text_table *table)
{
    return table->lines.line;
}

const char *lx_text_table_field(const struct lx_text_table *table, size_t column, size_t *length, bool *is_quoted)
{
    const struct lx_text_table_lines *lines = &table->lines;
    size_t place = lx_text_table_has(table, column) ? table->places[column] + table->shift : LX_NO_FIELD;
    *length = place < lines->count ? lines->fields[place].length : 0;
    *is_quoted = place < lines->count && lines->fields[place].is_quoted;
    return place < lines->count ? lines->fields[place].at : NULL;
}
