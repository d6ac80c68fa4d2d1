/* SPDX-License-Identifier: MIT */
/*
 * The diagnostics object, public functions included: a list of entries, each a message with arguments and a
 * place, of which the line, column and excerpt are worked out when it is reported, since the text may be gone
 * when it is read.
 */
#include <stdlib.h>
#include <string.h>

#include "diagnostics.h"
#include "memory.h"
#include "number.h"
#include "text.h"

enum { SEVERITIES = 2, EXCERPT_COLUMNS = 110, EXCERPT_BEFORE = 60, NO_HINT = -1 };

struct words {
    int message;
    char **arguments; /* NULL-terminated texts with phrases */
};

struct entry {
    luxel_diagnostic shown;
    struct words message, hint;
    char *source, *key, *excerpt;
};

struct luxel_diagnostics {
    struct entry *entries;
    size_t count, capacity;
    size_t total[SEVERITIES], kept[SEVERITIES];
    bool last_kept;
};

static const struct {
    const char *id, *english;
} messages[LX_MSG_COUNT] = {
#define LX_MESSAGE(name, id, english) {id, english},
#include "messages.def"
#undef LX_MESSAGE
};

/* ---- making and freeing ---- */

luxel_diagnostics *luxel_diagnostics_new(void)
{
    return lx_new_array(1, sizeof(luxel_diagnostics));
}

static void words_clear(struct words *words)
{
    for (size_t i = 0; words->arguments && words->arguments[i]; i++)
        free(words->arguments[i]);
    free(words->arguments);
    words->arguments = NULL;
}

static void entry_clear(struct entry *entry)
{
    words_clear(&entry->message);
    words_clear(&entry->hint);
    free(entry->source);
    free(entry->key);
    free(entry->excerpt);
}

void luxel_diagnostics_clear(luxel_diagnostics *diagnostics)
{
    if (!diagnostics)
        return;
    for (size_t i = 0; i < diagnostics->count; i++)
        entry_clear(&diagnostics->entries[i]);
    free(diagnostics->entries);
    *diagnostics = (luxel_diagnostics){0};
}

void luxel_diagnostics_free(luxel_diagnostics *diagnostics)
{
    luxel_diagnostics_clear(diagnostics);
    free(diagnostics);
}

/* ---- reporting ---- */

static bool words_set(struct words *words, enum lx_message message, const char *const *arguments)
{
    size_t count = 0;
    while (arguments && arguments[count])
        count++;
    words->message = (int)message;
    words->arguments = lx_new_array(count + 1, sizeof *words->arguments);
    for (size_t i = 0; words->arguments && count && *arguments; i++) {
        struct lx_text text = {0};
        arguments = lx_add_argument(&text, arguments);
        words->arguments[i] = lx_text_take(&text);
        if (!words->arguments[i])
            return false;
    }
    return words->arguments != NULL;
}

static bool is_break(char c)
{
    return c == '\n' || c == '\r';
}

static size_t character_size(const char *text, size_t length)
{
    uint32_t code;
    size_t size = lx_next_character(text, length, &code);
    return size ? size : 1;
}

/* Sets line and column, both from 1, and returns where the line starts. */
static size_t locate(const char *text, size_t length, size_t at, luxel_diagnostic *shown)
{
    size_t start = length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    unsigned line = 1, column = 1;
    for (size_t i = start; i < at; i++) {
        if (!is_break(text[i]) || (text[i] == '\r' && i + 1 < length && text[i + 1] == '\n'))
            continue;
        line++;
        start = i + 1;
    }
    for (size_t i = start; i < at; i += character_size(text + i, length - i))
        column++;
    shown->line = line;
    shown->column = column;
    return start;
}

/* Cuts the line around the mark to what fits a terminal, with an ellipsis where something is left out. */
static bool take_excerpt(const struct lx_place *place, size_t line, size_t start, size_t end, struct entry *entry)
{
    const char *text = place->text;
    size_t from = start, to, columns = 0;
    while (from > line && columns < EXCERPT_BEFORE) {
        from--;
        if (((unsigned char)text[from] & 0xC0) != 0x80)
            columns += lx_escaped_width(text + from, start - from);
    }
    for (to = from, columns = 0; to < place->length && !is_break(text[to]) && columns < EXCERPT_COLUMNS;) {
        columns += lx_escaped_width(text + to, place->length - to);
        to += character_size(text + to, place->length - to);
    }

    struct lx_text excerpt = {0};
    size_t offset = 0, width = 0;
    if (from > line) {
        lx_text_puts(&excerpt, "…");
        offset = 1;
    }
    size_t mark = start < to ? start : to, mark_end = end < to ? end : to;
    offset += lx_text_add_escaped(&excerpt, text + from, mark - from);
    if (mark_end > mark)
        width = lx_text_add_escaped(&excerpt, text + mark, mark_end - mark);
    else
        mark_end = mark;
    lx_text_add_escaped(&excerpt, text + mark_end, to - mark_end);
    if (to < place->length && !is_break(text[to]))
        lx_text_puts(&excerpt, "…");
    entry->excerpt = lx_text_take(&excerpt);
    entry->shown.mark_offset = (unsigned)offset;
    entry->shown.mark_length = width ? (unsigned)width : 1;
    return entry->excerpt != NULL;
}

static bool place_set(struct entry *entry, const struct lx_place *place)
{
    if (place->source && !(entry->source = lx_copy_text(place->source, strlen(place->source))))
        return false;
    if (place->key && !(entry->key = lx_copy_text(place->key, strlen(place->key))))
        return false;
    if (!place->text) {
        entry->shown.line = (unsigned)place->line;
        return true;
    }
    size_t start = place->start < place->length ? place->start : place->length;
    size_t end = place->end < place->length ? place->end : place->length;
    size_t line = locate(place->text, place->length, start, &entry->shown);
    entry->shown.line += (unsigned)place->lines_before;
    return take_excerpt(place, line, start > line ? start : line, end, entry);
}

bool lx_keeps(const luxel_diagnostics *diagnostics, luxel_severity severity)
{
    return diagnostics && diagnostics->kept[severity] < LUXEL_DIAGNOSTICS_KEPT;
}

void lx_report(luxel_diagnostics *diagnostics, luxel_severity severity, const struct lx_place *place,
               enum lx_message message, const char *const *arguments)
{
    if (!diagnostics)
        return;
    diagnostics->total[severity]++;
    diagnostics->last_kept = false;
    if (!lx_keeps(diagnostics, severity) || lx_reserve(&diagnostics->entries, &diagnostics->capacity,
                                                       diagnostics->count + 1, sizeof *diagnostics->entries) < 0)
        return;
    struct entry entry = {.shown = {.severity = severity, .id = messages[message].id}, .hint = {NO_HINT, NULL}};
    if (!words_set(&entry.message, message, arguments) || (place && !place_set(&entry, place))) {
        entry_clear(&entry);
        return;
    }
    entry.shown.source = entry.source;
    entry.shown.key = entry.key;
    entry.shown.excerpt = entry.excerpt;
    diagnostics->entries[diagnostics->count++] = entry;
    diagnostics->kept[severity]++;
    diagnostics->last_kept = true;
}

/* Gives an entry another place; false, and the entry is as it was, where memory ran out. */
static bool move_entry(struct entry *entry, const struct lx_place *place)
{
    struct entry moved = {.shown = {.severity = entry->shown.severity, .id = entry->shown.id}};
    if (!place_set(&moved, place)) {
        entry_clear(&moved);
        return false;
    }
    free(entry->source);
    free(entry->key);
    free(entry->excerpt);
    moved.message = entry->message;
    moved.hint = entry->hint;
    moved.shown.source = moved.source;
    moved.shown.key = moved.key;
    moved.shown.excerpt = moved.excerpt;
    *entry = moved;
    return true;
}

void lx_hand_over(luxel_diagnostics *to, luxel_diagnostics *from, const char *source, const struct lx_place *place)
{
    for (size_t i = 0; from && i < from->count; i++) {
        struct entry *entry = &from->entries[i];
        const luxel_severity severity = entry->shown.severity;
        const bool is_kept =
            lx_keeps(to, severity) && lx_reserve(&to->entries, &to->capacity, to->count + 1, sizeof *to->entries) == 0;
        if (!is_kept) {
            entry_clear(entry);
            continue;
        }
        if (!entry->source || (source && strcmp(entry->source, source) == 0))
            move_entry(entry, place);
        to->entries[to->count++] = *entry;
        to->kept[severity]++;
        to->last_kept = true;
    }
    if (!from)
        return;
    for (size_t s = 0; to && s < SEVERITIES; s++)
        to->total[s] += from->total[s];
    free(from->entries);
    *from = (luxel_diagnostics){0};
}

const char *lx_message_words(enum lx_message message)
{
    return messages[message].english;
}

void lx_hint(luxel_diagnostics *diagnostics, enum lx_message message, const char *const *arguments)
{
    if (!diagnostics || !diagnostics->last_kept)
        return;
    struct words *hint = &diagnostics->entries[diagnostics->count - 1].hint;
    words_clear(hint);
    if (!words_set(hint, message, arguments)) {
        words_clear(hint);
        hint->message = NO_HINT;
    }
}

luxel_status lx_refuse(luxel_diagnostics *diagnostics, enum lx_message message, const char *const *arguments)
{
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, message, arguments);
    return LUXEL_ERROR_ARGUMENT;
}

luxel_status lx_out_of_memory(luxel_diagnostics *diagnostics)
{
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_OUT_OF_MEMORY, NULL);
    return LUXEL_ERROR_MEMORY;
}

/* ---- reading ---- */

size_t luxel_diagnostics_total(const luxel_diagnostics *diagnostics, luxel_severity severity)
{
    return diagnostics && (unsigned)severity < SEVERITIES ? diagnostics->total[severity] : 0;
}

size_t luxel_diagnostics_count(const luxel_diagnostics *diagnostics)
{
    return diagnostics ? diagnostics->count : 0;
}

const luxel_diagnostic *luxel_diagnostics_get(const luxel_diagnostics *diagnostics, size_t i)
{
    return i < luxel_diagnostics_count(diagnostics) ? &diagnostics->entries[i].shown : NULL;
}

static char *in_words(const struct words *words, luxel_translate translate, void *data)
{
    struct lx_text text = {0};
    if (words->message != NO_HINT)
        lx_add_rendered(&text, messages[words->message].english, (const char *const *)words->arguments, translate,
                        data);
    return lx_text_take(&text);
}

char *luxel_diagnostics_message(const luxel_diagnostics *diagnostics, size_t i, luxel_translate translate, void *data)
{
    return i < luxel_diagnostics_count(diagnostics) ? in_words(&diagnostics->entries[i].message, translate, data)
                                                    : NULL;
}

/* The one assignment that a hint has to try, -s 'KEY=VALUE', with the length of its key; NULL: it has none, or more. */
static const char *assignment_of(const struct words *hint, size_t *key_length)
{
    static const char option[] = "-s '";
    const char *text = hint->message == LX_MSG_HINT_TRY && hint->arguments ? hint->arguments[0] : NULL;
    if (!text || strncmp(text, option, sizeof option - 1) != 0 || strstr(text + 1, option))
        return NULL;
    text += sizeof option - 1;
    *key_length = strcspn(text, "=");
    return text;
}

/* Whether a key is another one or a part of it. */
static bool is_within(const char *key, size_t length, const char *whole, size_t whole_length)
{
    return length >= whole_length && strncmp(key, whole, whole_length) == 0 &&
           (length == whole_length || key[whole_length] == '[' || key[whole_length] == '.');
}

void lx_settle_hints(luxel_diagnostics *diagnostics)
{
    for (size_t i = 0; diagnostics && i < diagnostics->count; i++)
        for (size_t k = diagnostics->count - 1; k > i; k--) {
            struct words *hint = &diagnostics->entries[i].hint, settled = {NO_HINT, NULL};
            const struct words *last = &diagnostics->entries[k].hint;
            size_t length, last_length;
            const char *key = assignment_of(hint, &length), *last_key = assignment_of(last, &last_length);
            if (!key || !last_key || !is_within(key, length, last_key, last_length))
                continue;
            if (words_set(&settled, (enum lx_message)last->message, (const char *const *)last->arguments)) {
                words_clear(hint);
                *hint = settled;
            } else {
                words_clear(&settled);
            }
            break;
        }
}

char *luxel_diagnostics_hint(const luxel_diagnostics *diagnostics, size_t i, luxel_translate translate, void *data)
{
    return i < luxel_diagnostics_count(diagnostics) ? in_words(&diagnostics->entries[i].hint, translate, data) : NULL;
}

void luxel_text_free(char *text)
{
    free(text);
}

void luxel_bytes_free(unsigned char *bytes)
{
    free(bytes);
}

luxel_status lx_setting_out_of_range(luxel_diagnostics *diagnostics, const char *setting, double value,
                                     const char *range)
{
    char number[LX_NUMBER_SIZE];
    return lx_refuse(diagnostics, LX_MSG_SETTING_OUT_OF_RANGE,
                     LX_ARGS(setting, lx_write_number(value, number), LX_TERM(range)));
}

luxel_status lx_check_reserve(void *const *reserved, size_t count, luxel_diagnostics *diagnostics)
{
    while (count > 0 && !reserved[count - 1])
        count--;
    if (count == 0)
        return LUXEL_OK;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, NULL, LX_MSG_RESERVED_NOT_NULL, NULL);
    lx_hint(diagnostics, LX_MSG_HINT_INITIALIZE, NULL);
    return LUXEL_ERROR_ARGUMENT;
}
