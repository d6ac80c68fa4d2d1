/* SPDX-License-Identifier: MIT */
/*
 * Lines of tables and their fields.  A line is cut in one pass, each character looked up in the table of those at
 * which a field ends; where it is not whole in the part, more is read and the line is cut once more.
 */
#include "text_table_lines.h"

#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

enum { MARK = 4 };

bool lx_text_table_lines_begin(struct lx_text_table_lines *lines, struct lx_source *source, bool comments_anywhere)
{
    char start[MARK];
    size_t mark, length = lx_source_size(source) < MARK ? (size_t)lx_source_size(source) : MARK;
    *lines = (struct lx_text_table_lines){.source = source, .comments_anywhere = comments_anywhere};
    lines->part = lx_new_array(LX_TABLE_PART + 1, 1);
    if (!lines->part)
        return false;
    lines->start = lines->next = lines->part;
    lines->next_line = 1;
    *lines->part = '\n';
    lx_text_table_set_separator(lines, ',');
    if (lx_source_read(source, 0, start, length) != LUXEL_OK)
        return true;
    lines->encoding = lx_find_encoding(start, length, &mark);
    lines->offset = mark;
    if (lines->encoding != LX_UTF8)
        lines->raw = lx_new_array(LX_TABLE_PART, 1);
    return lines->encoding == LX_UTF8 || lines->raw;
}

void lx_text_table_lines_clear(struct lx_text_table_lines *lines)
{
    free(lines->raw);
    free(lines->part);
    free(lines->fields);
}

bool lx_is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

void lx_text_table_set_separator(struct lx_text_table_lines *lines, char separator)
{
    lines->separator = separator;
    memset(lines->stops, 0, sizeof lines->stops);
    lines->stops[(unsigned char)separator] = lines->stops['\n'] = lines->stops['\r'] = lines->stops[0] = true;
    if (separator == ' ')
        lines->stops['\t'] = lines->stops['\v'] = lines->stops['\f'] = true;
    lines->stops['#'] = lines->comments_anywhere;
}

/* ---- parts ---- */

/* Reads on behind what is kept of the part. */
static bool read_more(struct lx_text_table_lines *lines, size_t kept)
{
    uint64_t left = lx_source_size(lines->source) - lines->offset;
    size_t room = LX_TABLE_PART - kept, more = left < room ? (size_t)left : room, used;
    if (lines->encoding == LX_UTF8) {
        if (lx_source_read(lines->source, lines->offset, lines->part + kept, more) != LUXEL_OK)
            return false;
        lines->is_last = more == left;
        lines->offset += more;
        lines->length = kept + more;
        return true;
    }
    size_t units = left / 2 < room / LX_UTF16_GROWTH ? (size_t)(left / 2) : room / LX_UTF16_GROWTH;
    if (lx_source_read(lines->source, lines->offset, lines->raw, 2 * units) != LUXEL_OK)
        return false;
    lines->is_last = units == left / 2;
    lines->length =
        kept + lx_decode_utf16(lines->raw, units, lines->encoding, lines->is_last, lines->part + kept, &used);
    lines->offset += 2 * used;
    return lines->is_last || used > 0;
}

/* Moves the line to the front of the part and fills it; false where nothing more can be had. */
static bool fill(struct lx_text_table_lines *lines)
{
    size_t kept = (size_t)(lines->part + lines->length - lines->start);
    if (lines->is_last || kept == LX_TABLE_PART || lx_source_status(lines->source) != LUXEL_OK)
        return false;
    memmove(lines->part, lines->start, kept);
    lines->start = lines->next = lines->part;
    bool is_more = read_more(lines, kept);
    lines->part[lines->length] = '\n';
    return is_more;
}

/* ---- lines ---- */

static bool is_blank(const struct lx_text_table_lines *lines, char c)
{
    return c == ' ' || (c == '\t' && lines->separator != '\t') || c == '\v' || c == '\f';
}

static const char *pass_blanks(const struct lx_text_table_lines *lines, const char *at)
{
    while (is_blank(lines, *at))
        at++;
    return at;
}

static const char *find_line_end(const char *at)
{
    while (!lx_is_line_end(*at))
        at++;
    return at;
}

static bool add_field(struct lx_text_table_lines *lines, const char *at, const char *stop, bool is_quoted)
{
    if (lines->count == lines->capacity &&
        lx_reserve(&lines->fields, &lines->capacity, lines->count + 1, sizeof *lines->fields) < 0)
        return false;
    lines->fields[lines->count++] = (struct lx_text_table_field){at, (size_t)(stop - at), is_quoted};
    return true;
}

/* Cuts a field in quotes; `*at` goes behind it and the blanks there. */
static enum lx_text_table_step cut_quoted(struct lx_text_table_lines *lines, const char **at)
{
    const char *open = *at + 1, *end = lines->part + lines->length, *close = open;
    while (close < end && (*close != '"' || (close + 1 < end && close[1] == '"')))
        close += *close == '"' ? 2 : 1;
    lines->wrong = *at;
    if (close >= end || (close + 1 == end && !lines->is_last)) {
        *at = end; /* it may be closed in the next part */
        return LX_TABLE_OPEN_QUOTE;
    }
    for (const char *inside = open; inside < close; inside++) {
        lines->inside += lx_is_line_end(*inside) && !(*inside == '\r' && inside[1] == '\n');
        if (*inside == 0) {
            lines->wrong = inside;
            return LX_TABLE_ZERO;
        }
    }
    if (!add_field(lines, open, close, true))
        return LX_TABLE_OUT_OF_MEMORY;
    *at = pass_blanks(lines, close + 1);
    lines->wrong = *at;
    bool is_done = lines->stops[(unsigned char)**at] || (lines->separator == ' ' && *at > close + 1);
    return is_done ? LX_TABLE_LINE : LX_TABLE_BEHIND;
}

static enum lx_text_table_step cut_plain(struct lx_text_table_lines *lines, const char **at)
{
    const char *start = *at, *stop = start;
    while (!lines->stops[(unsigned char)*stop])
        stop++;
    *at = stop;
    while (stop > start && is_blank(lines, stop[-1]))
        stop--;
    return add_field(lines, start, stop, false) ? LX_TABLE_LINE : LX_TABLE_OUT_OF_MEMORY;
}

/* Cuts all fields of the line at `*at`, which goes to where it ends: at a line end, a comment, or a fault. */
static enum lx_text_table_step cut_fields(struct lx_text_table_lines *lines, const char **at)
{
    for (;;) {
        *at = pass_blanks(lines, *at);
        bool is_over = lx_is_line_end(**at) || (**at == '#' && lines->stops['#']);
        if (is_over && lines->separator == ' ')
            return LX_TABLE_LINE;
        enum lx_text_table_step step = **at == '"' ? cut_quoted(lines, at) : cut_plain(lines, at);
        if (step != LX_TABLE_LINE)
            return step;
        if (**at == 0) {
            lines->wrong = *at;
            return LX_TABLE_ZERO;
        }
        if (**at == '#' || lx_is_line_end(**at))
            return LX_TABLE_LINE;
        *at += lines->separator != ' ';
    }
}

/* Cuts the line that starts in the part; false where more must be read first. */
static bool cut_line(struct lx_text_table_lines *lines, enum lx_text_table_step *step)
{
    const char *end = lines->part + lines->length, *at = pass_blanks(lines, lines->start);
    lines->count = lines->inside = 0;
    if (*at == '#') {
        const char *stop = find_line_end(at);
        *step = add_field(lines, at + 1, stop, false) ? LX_TABLE_COMMENT : LX_TABLE_OUT_OF_MEMORY;
        at = stop;
    } else {
        *step = cut_fields(lines, &at);
        if (*step == LX_TABLE_LINE)
            at = find_line_end(at);
    }
    bool is_whole = at < end && !(*at == '\r' && at + 1 == end);
    if (!is_whole && !lines->is_last)
        return false;
    lines->next = at < end ? at + 1 + (*at == '\r' && at + 1 < end && at[1] == '\n') : end;
    lines->next_line += 1 + lines->inside;
    return true;
}

enum lx_text_table_step lx_text_table_cut(struct lx_text_table_lines *lines)
{
    enum lx_text_table_step step = LX_TABLE_END;
    lines->start = lines->next;
    lines->line = lines->next_line;
    for (;;) {
        bool is_there = lines->start < lines->part + lines->length;
        if (is_there && (cut_line(lines, &step) || step == LX_TABLE_OUT_OF_MEMORY))
            return step;
        if (fill(lines))
            continue;
        if (!is_there || lx_source_status(lines->source) != LUXEL_OK)
            return LX_TABLE_END;
        return step == LX_TABLE_OPEN_QUOTE ? step : LX_TABLE_LONG;
    }
}

void lx_text_table_again(struct lx_text_table_lines *lines)
{
    lines->next = lines->start;
    lines->next_line = lines->line;
}

void lx_text_table_add(struct lx_text *text, const struct lx_text_table_field *field)
{
    const char *at = field->at, *end = at + field->length, *quote;
    while (field->is_quoted && (quote = memchr(at, '"', (size_t)(end - at))) && quote + 1 < end) {
        lx_add_decoded(text, at, (size_t)(quote + 1 - at));
        at = quote + 2;
    }
    lx_add_decoded(text, at, (size_t)(end - at));
}
