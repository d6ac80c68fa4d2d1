/* SPDX-License-Identifier: MIT */
/*
 * Cuts lines into fields.  The separator is told by the first line: a semicolon or a tab if there is one outside
 * quotes, else a comma.  The file is held in memory, and the fields' texts are made in their places.
 */
#include "answer_fields.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../front/language.h"
#include "cli.h"
#include "message.h"
#include "text.h"

enum { LARGEST_FILE = 64 << 20 };

char *message_copy(const char *text)
{
    char *copy = message_allocate(strlen(text) + 1, 1);

    return strcpy(copy, text);
}

void *message_grow(void *list, size_t *capacity, size_t size)
{
    const size_t more = *capacity > 0 ? 2 * *capacity : 16;
    void *grown = message_allocate(more, size);

    if (*capacity > 0)
        memcpy(grown, list, *capacity * size);
    free(list);
    *capacity = more;
    return grown;
}

void fields_report_at(const char *path, unsigned line, unsigned column, const char *format, va_list arguments)
{
    char *text = NULL;

    text_print_escaped(stderr, path);
    fprintf(stderr, ":%u:%u: %s ", line, column, _("error:"));
    if (vasprintf(&text, format, arguments) >= 0)
        text_print_escaped(stderr, text);
    fputc('\n', stderr);
    free(text);
}

void fields_report(const struct fields *fields, size_t i, const char *format, ...)
{
    const struct field *field = &fields->list[i];
    va_list arguments;

    va_start(arguments, format);
    fields_report_at(fields->path, field->line, field->column, format, arguments);
    va_end(arguments);
}

static bool read_file(FILE *file, struct fields *fields)
{
    size_t capacity = 0, length = 0, got = 0;

    do {
        length += got;
        if (length > LARGEST_FILE) {
            message_error(_("%s: a table of answers may have 64 MB at most"), fields->path);
            return false;
        }
        if (length == capacity)
            fields->bytes = message_grow(fields->bytes, &capacity, 1);
        got = fread(fields->bytes + length, 1, capacity - length, file);
    } while (got > 0);
    if (ferror(file)) {
        message_error(_("%s could not be read: %s"), fields->path, language_reason(errno));
        return false;
    }
    fields->at = fields->line_begin = fields->bytes;
    fields->end = fields->bytes + length;
    return true;
}

/* What separates the fields of the first line. */
static char find_separator(const char *at, const char *end)
{
    bool quoted = false, tab = false;

    for (; at < end && (quoted || (*at != '\n' && *at != '\r')); at++) {
        quoted ^= *at == '"';
        if (!quoted && *at == ';')
            return ';';
        tab = tab || (!quoted && *at == '\t');
    }
    return tab ? '\t' : ',';
}

bool fields_open(const char *path, struct fields *fields)
{
    FILE *file = fopen(path, "rb");
    bool ok;

    *fields = (struct fields){.path = path, .line = 1};
    if (!file) {
        message_error(_("%s could not be read: %s"), path, language_reason(errno));
        return false;
    }
    ok = read_file(file, fields);
    fclose(file);
    if (ok && memchr(fields->bytes, '\0', (size_t)(fields->end - fields->at))) {
        message_error(_("%s is no text in UTF-8: there are zero bytes in it"), path);
        ok = false;
    }
    if (!ok) {
        fields_close(fields);
        return false;
    }
    if (fields->end - fields->at >= 3 && memcmp(fields->at, "\xef\xbb\xbf", 3) == 0)
        fields->at = fields->line_begin = fields->at + 3;
    fields->separator = find_separator(fields->at, fields->end);
    return true;
}

static void clear_line(struct fields *fields)
{
    for (size_t i = 0; i < fields->count; i++)
        free(fields->list[i].text);
    fields->count = 0;
}

void fields_close(struct fields *fields)
{
    clear_line(fields);
    free(fields->bytes);
    free(fields->list);
}

static bool is_blank(const struct fields *fields, char c)
{
    return (c == ' ' || c == '\t') && c != fields->separator;
}

static bool is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

/* Passes over one character, and knows the lines. */
static void advance(struct fields *fields)
{
    const bool is_end =
        *fields->at == '\n' || (*fields->at == '\r' && (fields->at + 1 == fields->end || fields->at[1] != '\n'));

    fields->at++;
    if (is_end) {
        fields->line++;
        fields->line_begin = fields->at;
    }
}

/* In characters, from 1. */
static unsigned column_now(const struct fields *fields)
{
    unsigned column = 1;

    for (const char *at = fields->line_begin; at < fields->at; at++)
        column += ((unsigned char)*at & 0xc0) != 0x80;
    return column;
}

/* From behind the quote on; false: it is never closed. */
static bool cut_quoted(struct fields *fields, struct field *field)
{
    const char *close = fields->at;
    size_t length = 0;

    while (close < fields->end && (*close != '"' || (close + 1 < fields->end && close[1] == '"')))
        close += *close == '"' ? 2 : 1;
    field->text = message_allocate((size_t)(close - fields->at) + 1, 1);
    if (close == fields->end)
        return false;
    while (fields->at < close) {
        field->text[length++] = *fields->at;
        if (*fields->at == '"')
            advance(fields);
        advance(fields);
    }
    advance(fields);
    return true;
}

static void cut_plain(struct fields *fields, struct field *field)
{
    const char *begin = fields->at, *last;

    while (fields->at < fields->end && *fields->at != fields->separator && !is_line_end(*fields->at))
        fields->at++;
    for (last = fields->at; last > begin && is_blank(fields, last[-1]);)
        last--;
    field->text = message_allocate((size_t)(last - begin) + 1, 1);
    memcpy(field->text, begin, (size_t)(last - begin));
}

static void skip_blanks(struct fields *fields)
{
    while (fields->at < fields->end && is_blank(fields, *fields->at))
        fields->at++;
}

/* One field with the blanks around it; false, reported, where it is quoted wrongly. */
static bool cut_field(struct fields *fields)
{
    struct field *field;
    bool is_closed = true;

    if (fields->count == fields->capacity)
        fields->list = message_grow(fields->list, &fields->capacity, sizeof *fields->list);
    field = &fields->list[fields->count++];
    skip_blanks(fields);
    *field = (struct field){.line = fields->line, .column = column_now(fields)};
    if (fields->at < fields->end && *fields->at == '"') {
        fields->at++;
        is_closed = cut_quoted(fields, field);
        skip_blanks(fields);
    } else {
        cut_plain(fields, field);
    }
    if (is_closed && (fields->at == fields->end || *fields->at == fields->separator || is_line_end(*fields->at)))
        return true;
    fields_report(fields, fields->count - 1,
                  is_closed ? _("behind a quoted field the next one must begin") : _("a quote is not closed"));
    return false;
}

static bool is_empty_line(const struct fields *fields)
{
    for (size_t i = 0; i < fields->count; i++)
        if (fields->list[i].text[0] != '\0')
            return false;
    return true;
}

enum fields_end fields_next(struct fields *fields)
{
    do {
        clear_line(fields);
        if (fields->at == fields->end)
            return FIELDS_DONE;
        for (;;) {
            if (!cut_field(fields))
                return FIELDS_BROKEN;
            if (fields->at == fields->end || *fields->at != fields->separator)
                break;
            fields->at++;
        }
        while (fields->at < fields->end && is_line_end(*fields->at))
            advance(fields); /* empty lines as well */
    } while (is_empty_line(fields));
    return FIELDS_LINE;
}

/* The length of the number that text starts with, and the power of ten of its last digit. */
static size_t number_length(const char *text, int *last_digit)
{
    const char *at = text + (*text == '+' || *text == '-');
    const size_t whole = strspn(at, "0123456789");
    size_t fraction = 0;
    long exponent = 0;

    at += whole;
    if (*at == '.' || *at == ',') {
        fraction = strspn(at + 1, "0123456789");
        at += 1 + fraction;
    }
    if (whole + fraction == 0)
        return 0;
    if (*at == 'e' || *at == 'E') {
        const size_t sign = at[1] == '+' || at[1] == '-', digits = strspn(at + 1 + sign, "0123456789");

        if (digits == 0 || digits > 4)
            return 0;
        exponent = strtol(at + 1, NULL, 10);
        at += 1 + sign + digits;
    }
    *last_digit = (int)exponent - (int)(fraction < 1000 ? fraction : 1000);
    return (size_t)(at - text);
}

bool fields_number(const struct fields *fields, size_t i, double *number, double *rounding)
{
    const char *text = fields->list[i].text;
    int last_digit = 0;
    char *copy, *comma;

    if (*text == '\0' || number_length(text, &last_digit) != strlen(text))
        return false;
    copy = message_copy(text);
    comma = strchr(copy, ',');
    if (comma)
        *comma = '.';
    *number = strtod(copy, NULL);
    free(copy);
    *rounding = 0.5 * pow(10, last_digit);
    return isfinite(*number);
}
