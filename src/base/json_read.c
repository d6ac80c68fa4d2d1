/* SPDX-License-Identifier: MIT */
/* Reading JSON, value by value; what is open is a chain of parents, so that nothing recurs. */
#include "json_read.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "text.h"

enum { DEEPEST = 64 };

struct reader {
    struct lx_json_tree *tree;
    const char *at, *end;
    uint32_t open[DEEPEST], last[DEEPEST]; /* lists and objects that are open, and the value before in each */
    unsigned depth;
};

static void skip_blanks(struct reader *reader)
{
    while (reader->at < reader->end && strchr(" \t\r\n", *reader->at) && *reader->at)
        reader->at++;
}

static bool take(struct reader *reader, char wanted)
{
    skip_blanks(reader);
    if (reader->at == reader->end || *reader->at != wanted)
        return false;
    reader->at++;
    return true;
}

/* A string behind its first quote. */
static bool take_string(struct reader *reader, const char **text, size_t *length)
{
    *text = reader->at;
    while (reader->at < reader->end && *reader->at != '"') {
        if ((unsigned char)*reader->at < ' ')
            return false;
        reader->at += *reader->at == '\\' && reader->at + 1 < reader->end ? 2 : 1;
    }
    if (reader->at >= reader->end)
        return false;
    *length = (size_t)(reader->at++ - *text);
    return true;
}

static bool take_word(struct reader *reader, const char *word, enum lx_json_type type, struct lx_json_value *value)
{
    const size_t length = strlen(word);
    if ((size_t)(reader->end - reader->at) < length || memcmp(reader->at, word, length) != 0)
        return false;
    reader->at += length;
    value->type = type;
    return true;
}

static bool take_number(struct reader *reader, struct lx_json_value *value)
{
    const char *start = reader->at;
    while (reader->at < reader->end && *reader->at && strchr("+-.eE0123456789", *reader->at))
        reader->at++;
    value->type = LX_JSON_NUMBER;
    return *start != '+' && *start != '.' && lx_read_number(start, (size_t)(reader->at - start), &value->number);
}

/* What stands for a value: all of it, or the beginning of a list or an object. */
static bool take_value(struct reader *reader, struct lx_json_value *value)
{
    skip_blanks(reader);
    if (reader->at == reader->end)
        return false;
    switch (*reader->at) {
    case '{':
    case '[': value->type = *reader->at++ == '{' ? LX_JSON_OBJECT : LX_JSON_LIST; return reader->depth < DEEPEST;
    case '"':
        reader->at++;
        value->type = LX_JSON_STRING;
        return take_string(reader, &value->text, &value->length);
    case 't': return take_word(reader, "true", LX_JSON_TRUE, value);
    case 'f': return take_word(reader, "false", LX_JSON_FALSE, value);
    case 'n': return take_word(reader, "null", LX_JSON_NULL, value);
    default: return take_number(reader, value);
    }
}

/* Adds a value behind the last one of what is open. */
static bool add(struct reader *reader, const struct lx_json_value *value)
{
    struct lx_json_tree *tree = reader->tree;
    if (tree->count > UINT32_MAX / 2 ||
        lx_reserve(&tree->values, &tree->capacity, tree->count + 1, sizeof *tree->values)) {
        tree->out_of_memory = true;
        return false;
    }
    const uint32_t number = (uint32_t)tree->count++;
    tree->values[number] = *value;
    if (reader->depth > 0) {
        const unsigned top = reader->depth - 1;
        if (reader->last[top])
            tree->values[reader->last[top]].next = number;
        else
            tree->values[reader->open[top]].child = number;
        reader->last[top] = number;
        tree->values[reader->open[top]].count++;
    }
    if (value->type >= LX_JSON_LIST) {
        reader->open[reader->depth] = number;
        reader->last[reader->depth++] = 0;
    }
    return true;
}

/* Closes what ends here, and takes the comma before a further value; *is_done: nothing is open any more. */
static bool close_some(struct reader *reader, bool *is_done)
{
    for (*is_done = false; reader->depth > 0; reader->depth--) {
        const unsigned top = reader->depth - 1;
        const bool is_object = reader->tree->values[reader->open[top]].type == LX_JSON_OBJECT;
        if (!take(reader, is_object ? '}' : ']'))
            return reader->last[top] == 0 || take(reader, ',');
    }
    *is_done = true;
    return true;
}

static bool read_all(struct reader *reader)
{
    for (bool is_done = false; !is_done;) {
        struct lx_json_value value = {.type = LX_JSON_NULL};
        const bool has_key =
            reader->depth > 0 && reader->tree->values[reader->open[reader->depth - 1]].type == LX_JSON_OBJECT;
        if (has_key && !(take(reader, '"') && take_string(reader, &value.key, &value.key_length) && take(reader, ':')))
            return false;
        if (!take_value(reader, &value) || !add(reader, &value) || !close_some(reader, &is_done))
            return false;
    }
    skip_blanks(reader);
    return reader->at == reader->end;
}

bool lx_json_parse(const char *text, size_t length, struct lx_json_tree *tree)
{
    struct reader reader = {.tree = tree, .at = text, .end = text + length};
    *tree = (struct lx_json_tree){.line = 1};
    while (reader.end > reader.at && reader.end[-1] == 0) /* what GLB files are filled up with, at most */
        reader.end--;
    const bool is_read = add(&reader, &(struct lx_json_value){.type = LX_JSON_NULL}) && read_all(&reader);
    for (const char *at = text; !is_read && at < reader.at; at++)
        tree->line += *at == '\n';
    return is_read;
}

void lx_json_clear(struct lx_json_tree *tree)
{
    free(tree->values);
    *tree = (struct lx_json_tree){0};
}

uint32_t lx_json_find(const struct lx_json_tree *tree, uint32_t object, const char *key)
{
    const size_t length = strlen(key);
    if (tree->values[object].type != LX_JSON_OBJECT)
        return 0;
    for (uint32_t i = tree->values[object].child; i; i = tree->values[i].next)
        if (tree->values[i].key_length == length && memcmp(tree->values[i].key, key, length) == 0)
            return i;
    return 0;
}

/* The four digits of an escape; what they are not is U+FFFD. */
static uint32_t escaped_code(const char *at, const char *end)
{
    uint32_t code = 0;
    for (int i = 0; i < 4; i++) {
        static const char digits[] = "0123456789abcdef";
        const char *digit = at + i < end && at[i] ? strchr(digits, at[i] | 0x20) : NULL;
        if (!digit || !*digit)
            return 0xFFFD;
        code = code * 16 + (uint32_t)(digit - digits);
    }
    return code >= 0xD800 && code < 0xE000 ? 0xFFFD : code;
}

static void add_code(struct lx_text *text, uint32_t code)
{
    char bytes[3];
    if (code < 0x80) {
        bytes[0] = (char)code;
        lx_text_add(text, bytes, 1);
    } else if (code < 0x800) {
        bytes[0] = (char)(0xC0 | code >> 6), bytes[1] = (char)(0x80 | (code & 0x3F));
        lx_text_add(text, bytes, 2);
    } else {
        bytes[0] = (char)(0xE0 | code >> 12), bytes[1] = (char)(0x80 | (code >> 6 & 0x3F));
        bytes[2] = (char)(0x80 | (code & 0x3F));
        lx_text_add(text, bytes, 3);
    }
}

char *lx_json_string(const struct lx_json_tree *tree, uint32_t value)
{
    const struct lx_json_value *string = &tree->values[value];
    struct lx_text text = {0};
    if (string->type != LX_JSON_STRING)
        return NULL;
    const char *end = string->text + string->length;
    lx_text_puts(&text, "");
    for (const char *at = string->text; at < end; at++) {
        static const char letters[] = "bfnrt", meant[] = "\b\f\n\r\t";
        const char *plain = memchr(at, '\\', (size_t)(end - at));
        if (!plain)
            plain = end;
        lx_text_add(&text, at, (size_t)(plain - at));
        at = plain;
        if (at + 1 >= end)
            break;
        const char *letter = strchr(letters, *++at);
        if (*at == 'u') {
            add_code(&text, escaped_code(at + 1, end));
            at += end - at > 4 ? 4 : end - at - 1;
        } else {
            lx_text_add(&text, letter && *letter ? &meant[letter - letters] : at, 1);
        }
    }
    return lx_text_take(&text);
}
