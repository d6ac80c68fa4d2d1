/* SPDX-License-Identifier: MIT */
/*
 * The guard before the YAML parser, for hostile or damaged texts.  The parser takes control characters
 * silently, and it keeps all tokens of a list or mapping that could turn out to be a key until it ends, some
 * 300 bytes for each byte of text; so in long texts such lists may only be short.
 */
#include <string.h>

#include "../base/text.h"
#include "guard.h"

enum {
    SHORT_TEXT = 256 * 1024, /* harmless whatever it holds */
    LONGEST_KEY = 256 * 1024 /* bytes of a list or mapping that could be a key */
};

static luxel_status refuse(const struct lx_place *place, size_t start, size_t end, enum lx_message message,
                           const char *const *arguments, luxel_diagnostics *diagnostics)
{
    struct lx_place here = *place;
    here.start = start;
    here.end = end;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &here, message, arguments);
    return LUXEL_ERROR_SCENE;
}

/* Whether what is no UTF-8 is no text at all: it begins with control characters that no editor writes. */
static bool is_binary(const struct lx_place *place)
{
    enum { LOOKED_AT = 4096 };
    for (size_t i = 0; i < place->length && i < LOOKED_AT; i++)
        if ((unsigned char)place->text[i] < 0x20 && !memchr("\t\n\v\f\r\x1a\x1b", place->text[i], 7))
            return true;
    return false;
}

static luxel_status check_characters(const struct lx_place *place, luxel_diagnostics *diagnostics)
{
    const char *text = place->text;
    for (size_t i = place->start, size; i < place->length; i += size) {
        if (text[i] >= 0x20 && text[i] < 0x7F) {
            size = 1;
            continue;
        }
        uint32_t code = 0;
        size = lx_next_character(text + i, place->length - i, &code);
        if (size == 0) {
            bool binary = is_binary(place);
            luxel_status status = refuse(place, i, i + 1, binary ? LX_MSG_NOT_TEXT : LX_MSG_NOT_UTF8,
                                         LX_ARGS((char[]){text[i], 0}), diagnostics);
            lx_hint(diagnostics, binary ? LX_MSG_HINT_TEXT : LX_MSG_HINT_UTF8, NULL);
            return status;
        }
        if (code == '\t' || code == '\n' || code == '\r' || code == 0x85)
            continue;
        if (code == 0)
            return refuse(place, i, i + 1, LX_MSG_CONTROL_CHARACTER, LX_ARGS("\\x00"), diagnostics);
        if (code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0xFFFE || code == 0xFFFF) {
            char character[5] = {0};
            memcpy(character, text + i, size);
            return refuse(place, i, i + size, LX_MSG_CONTROL_CHARACTER, LX_ARGS(character), diagnostics);
        }
    }
    return LUXEL_OK;
}

static bool is_break(char c)
{
    return c == '\n' || c == '\r';
}

/* A place in a text that is read token by token, roughly as YAML does. */
struct scan {
    const struct lx_place *place;
    size_t at;
    bool begun;       /* past the first token */
    bool fresh;       /* a value may start here */
    bool after_colon; /* and then it cannot be a key */
    unsigned depth;   /* of open brackets */
    struct {
        size_t start;
        bool may_be_key;
    } open[LX_DEEPEST];
};

static size_t skip_quoted(const char *text, size_t length, size_t at)
{
    char quote = text[at++];
    while (at < length && text[at] != quote)
        at += quote == '"' && text[at] == '\\' ? 2 : 1;
    return at < length ? at + 1 : length;
}

static luxel_status scan_open(struct scan *scan, luxel_diagnostics *diagnostics)
{
    if (scan->depth == LX_DEEPEST)
        return refuse(scan->place, scan->at, scan->at + 1, LX_MSG_TOO_DEEP, LX_ARGS("32"), diagnostics);
    scan->open[scan->depth].start = scan->at++;
    scan->open[scan->depth++].may_be_key = scan->begun && !scan->after_colon;
    scan->begun = scan->fresh = true;
    scan->after_colon = false;
    return LUXEL_OK;
}

static luxel_status scan_close(struct scan *scan, luxel_diagnostics *diagnostics)
{
    scan->at++;
    scan->depth--;
    scan->fresh = false;
    size_t start = scan->open[scan->depth].start;
    if (scan->open[scan->depth].may_be_key && scan->at - start > LONGEST_KEY)
        return refuse(scan->place, start, start + 1, LX_MSG_LONG_LIST, LX_ARGS(LX_TERM(LX_N("256 kB"))), diagnostics);
    return LUXEL_OK;
}

/* Whether the character that is looked at is the last of a word. */
static bool ends_word(const struct scan *scan)
{
    return scan->at + 1 == scan->place->length || strchr(" \t\n\r", scan->place->text[scan->at + 1]);
}

/* One character that is not part of a quoted text or comment. */
static luxel_status scan_character(struct scan *scan, luxel_diagnostics *diagnostics)
{
    const char *text = scan->place->text;
    char c = text[scan->at];
    if ((c == '[' || c == '{') && (scan->depth || scan->fresh))
        return scan_open(scan, diagnostics);
    if ((c == ']' || c == '}') && scan->depth)
        return scan_close(scan, diagnostics);
    if ((c == '&' || c == '*' || c == '!') && scan->fresh)
        return refuse(scan->place, scan->at, scan->at + 1, LX_MSG_NO_ANCHORS, NULL, diagnostics);
    if (is_break(c)) {
        scan->fresh = true;
        scan->after_colon = scan->depth && scan->after_colon;
    } else if (c == ':' && (scan->depth || ends_word(scan))) {
        scan->fresh = scan->after_colon = true;
    } else if (c == ',' && scan->depth) {
        scan->fresh = true;
        scan->after_colon = false;
    } else if (c != ' ' && c != '\t' && !((c == '-' || c == '?') && scan->fresh && ends_word(scan))) {
        scan->fresh = false;
        scan->begun = true;
    }
    scan->at++;
    return LUXEL_OK;
}

/* Refuses what would make the parser look ahead without end. */
static luxel_status check_look_ahead(const struct lx_place *place, luxel_diagnostics *diagnostics)
{
    struct scan scan = {.place = place, .at = place->start, .fresh = true};
    luxel_status status = LUXEL_OK;
    while (status == LUXEL_OK && scan.at < place->length) {
        char c = place->text[scan.at];
        if (c == '#' && (scan.at == place->start || strchr(" \t\n\r", place->text[scan.at - 1]))) {
            while (scan.at < place->length && !is_break(place->text[scan.at]))
                scan.at++;
        } else if ((c == '"' || c == '\'') && scan.fresh) {
            scan.at = skip_quoted(place->text, place->length, scan.at);
            scan.fresh = false;
            scan.begun = true;
        } else {
            status = scan_character(&scan, diagnostics);
        }
    }
    for (unsigned i = 0; status == LUXEL_OK && i < scan.depth; i++)
        if (scan.open[i].may_be_key)
            status = refuse(place, scan.open[i].start, scan.open[i].start + 1, LX_MSG_NOT_CLOSED, NULL, diagnostics);
    return status;
}

/* Directives: only %YAML means anything, and a text of nothing else would fill the parser's lists. */
static luxel_status check_directives(const struct lx_place *place, luxel_diagnostics *diagnostics)
{
    const char *text = place->text;
    for (size_t i = place->start; i < place->length;) {
        size_t start = i;
        while (i < place->length && !is_break(text[i]))
            i++;
        if (text[start] == '%' && (i - start < 7 || memcmp(text + start, "%YAML 1", 7) != 0))
            return refuse(place, start, i, LX_MSG_NO_DIRECTIVES, NULL, diagnostics);
        if (text[start] != '%' && text[start] != '#' && i > start)
            break;
        while (i < place->length && is_break(text[i]))
            i++;
    }
    return LUXEL_OK;
}

luxel_status lx_guard_text(const struct lx_place *place, luxel_diagnostics *diagnostics)
{
    luxel_status status = check_characters(place, diagnostics);
    if (status == LUXEL_OK)
        status = check_directives(place, diagnostics);
    if (status == LUXEL_OK && place->length - place->start > SHORT_TEXT)
        status = check_look_ahead(place, diagnostics);
    return status;
}
