/* SPDX-License-Identifier: MIT */
/* Finding lines, marks and ends in a scene's text, around the places that the document knows. */
#include <string.h>

#include "../base/text.h"
#include "guard.h"
#include "layout.h"

/* ---- lines ---- */

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

bool lx_is_break(char c)
{
    return c == '\n' || c == '\r';
}

size_t lx_line_start(const struct lx_layout *layout, size_t at)
{
    while (at > 0 && !lx_is_break(layout->text[at - 1]))
        at--;
    return at;
}

size_t lx_line_end(const struct lx_layout *layout, size_t at)
{
    while (at < layout->length && !lx_is_break(layout->text[at]))
        at++;
    return at;
}

size_t lx_skip_blanks(const struct lx_layout *layout, size_t at)
{
    while (at < layout->length && is_blank(layout->text[at]))
        at++;
    return at;
}

size_t lx_skip_space(const struct lx_layout *layout, size_t at)
{
    const char *text = layout->text;
    while (at < layout->length) {
        if (text[at] == '#' && (at == 0 || is_blank(text[at - 1]) || lx_is_break(text[at - 1])))
            at = lx_line_end(layout, at);
        else if (is_blank(text[at]) || lx_is_break(text[at]))
            at++;
        else
            break;
    }
    return at;
}

bool lx_has_break(const struct lx_layout *layout, size_t start, size_t end)
{
    return lx_line_end(layout, start) < end;
}

const char *lx_line_break(const struct lx_layout *layout)
{
    size_t at = lx_line_end(layout, 0);
    if (at == layout->length || layout->text[at] == '\n')
        return "\n";
    return at + 1 < layout->length && layout->text[at + 1] == '\n' ? "\r\n" : "\r";
}

size_t lx_column(const struct lx_layout *layout, size_t at)
{
    size_t start = lx_line_start(layout, at), columns = 0, size;
    if (start == 0 && at >= 3 && memcmp(layout->text, "\xEF\xBB\xBF", 3) == 0)
        start = 3;
    for (; start < at; start += size, columns++) {
        uint32_t code;
        size = lx_next_character(layout->text + start, at - start, &code);
        size = size ? size : 1;
    }
    return columns;
}

/* ---- nodes ---- */

static const struct lx_node *node_of(const struct lx_layout *layout, lx_node_id id)
{
    return lx_document_node(layout->document, id);
}

bool lx_is_empty(const struct lx_layout *layout, lx_node_id id)
{
    const struct lx_node *node = node_of(layout, id);
    return node->kind == LX_SCALAR && node->plain && !lx_document_text(layout->document, id)[0];
}

bool lx_is_block_text(const struct lx_layout *layout, lx_node_id id)
{
    const struct lx_node *node = node_of(layout, id);
    if (node->kind != LX_SCALAR || node->plain)
        return false;
    return node->start == node->end || (layout->text[node->start] != '"' && layout->text[node->start] != '\'');
}

bool lx_is_flow(const struct lx_layout *layout, lx_node_id id)
{
    const struct lx_node *node = node_of(layout, id);
    return node->kind != LX_SCALAR && node->start < layout->length &&
           (layout->text[node->start] == '[' || layout->text[node->start] == '{');
}

/* The dash of an element: the first one behind the element before it that has a value. */
static size_t find_dash(const struct lx_layout *layout, lx_node_id sequence, lx_node_id id)
{
    lx_node_id full = 0;
    size_t empty = 0;
    for (lx_node_id child = node_of(layout, sequence)->first; child != id; child = node_of(layout, child)->next) {
        bool is_empty = lx_is_empty(layout, child);
        full = is_empty ? full : child;
        empty = is_empty ? empty + 1 : 0;
    }
    size_t at = full ? lx_skip_space(layout, lx_value_end(layout, sequence, full)) : node_of(layout, sequence)->start;
    while (empty-- > 0 && at < layout->length)
        at = lx_skip_space(layout, at + 1);
    return at;
}

bool lx_find_mark(const struct lx_layout *layout, lx_node_id parent, lx_node_id id, size_t *at)
{
    bool mapping = node_of(layout, parent)->kind == LX_MAPPING;
    size_t end = node_of(layout, id)->key_end;
    size_t mark = mapping ? lx_skip_space(layout, end) : find_dash(layout, parent, id);
    bool found = mark < layout->length && layout->text[mark] == (mapping ? ':' : '-');
    *at = found || !mapping ? mark + 1 : end;
    return found;
}

/* The end of the text behind | or >; its last line break belongs to it where the indicator says "keep". */
static size_t block_text_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id, bool kept)
{
    const struct lx_node *node = node_of(layout, id);
    size_t header, end = node->end;
    lx_find_mark(layout, parent, id, &header);
    header = lx_skip_space(layout, header);
    size_t header_end = header;
    bool keep = false;
    for (; header_end < layout->length && strchr("|>+-123456789", layout->text[header_end]); header_end++)
        keep |= layout->text[header_end] == '+';
    if (kept && keep && end > node->start && lx_is_break(layout->text[end - 1])) {
        end -= end - node->start > 1 && layout->text[end - 1] == '\n' && layout->text[end - 2] == '\r' ? 2 : 1;
        return end;
    }
    while (end > node->start && (is_blank(layout->text[end - 1]) || lx_is_break(layout->text[end - 1])))
        end--;
    return end > node->start ? end : header_end;
}

static lx_node_id last_child(const struct lx_layout *layout, lx_node_id id)
{
    lx_node_id child = node_of(layout, id)->first;
    while (child && node_of(layout, child)->next)
        child = node_of(layout, child)->next;
    return child;
}

static size_t find_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id, bool kept)
{
    lx_node_id last;
    while (!lx_is_flow(layout, id) && (last = last_child(layout, id))) {
        parent = id;
        id = last;
    }
    size_t at = node_of(layout, id)->end;
    if (lx_is_block_text(layout, id))
        return block_text_end(layout, parent, id, kept);
    if (lx_is_empty(layout, id))
        lx_find_mark(layout, parent, id, &at);
    return at;
}

size_t lx_value_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id)
{
    return find_end(layout, parent, id, false);
}

size_t lx_block_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id)
{
    return lx_line_end(layout, find_end(layout, parent, id, true));
}

/* ---- JSON ---- */

static bool has_json_keys(const struct lx_layout *layout, lx_node_id id)
{
    const struct lx_node *node = node_of(layout, id);
    for (lx_node_id child = node->first; child; child = node_of(layout, child)->next)
        if ((node->kind == LX_MAPPING && layout->text[node_of(layout, child)->key_start] != '"') ||
            !has_json_keys(layout, child))
            return false;
    return true;
}

bool lx_is_json_document(const struct lx_layout *layout)
{
    return lx_is_flow(layout, layout->document->root) && has_json_keys(layout, layout->document->root);
}

/* A JSON text that is being read; once it is none, `at` is beyond its end. */
struct json {
    const char *text;
    size_t length, at;
};

static bool take(struct json *json, char c)
{
    while (json->at < json->length && strchr(" \t\r\n", json->text[json->at]))
        json->at++;
    bool found = json->at < json->length && json->text[json->at] == c;
    json->at += found;
    return found;
}

static size_t take_digits(struct json *json)
{
    size_t start = json->at;
    while (json->at < json->length && json->text[json->at] >= '0' && json->text[json->at] <= '9')
        json->at++;
    return json->at - start;
}

static bool take_any(struct json *json, const char *characters)
{
    bool found = json->at < json->length && strchr(characters, json->text[json->at]);
    json->at += found;
    return found;
}

static bool json_string(struct json *json)
{
    if (!take(json, '"'))
        return false;
    while (json->at < json->length && (unsigned char)json->text[json->at] >= 0x20) {
        char c = json->text[json->at++];
        if (c == '"')
            return true;
        if (c != '\\')
            continue;
        size_t digits = json->at < json->length && json->text[json->at] == 'u' ? 4 : 0;
        if (!take_any(json, "\"\\/bfnrtu"))
            return false;
        while (digits-- > 0)
            if (!take_any(json, "0123456789abcdefABCDEF"))
                return false;
    }
    return false;
}

static bool json_word(struct json *json)
{
    static const char *const words[] = {"true", "false", "null"};
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        size_t size = strlen(words[i]);
        if (json->length - json->at >= size && memcmp(json->text + json->at, words[i], size) == 0) {
            json->at += size;
            return true;
        }
    }
    take_any(json, "-");
    size_t start = json->at, digits = take_digits(json);
    if (digits == 0 || (digits > 1 && json->text[start] == '0'))
        return false;
    if (take_any(json, ".") && take_digits(json) == 0)
        return false;
    if (!take_any(json, "eE"))
        return true;
    take_any(json, "+-");
    return take_digits(json) > 0;
}

static bool json_value(struct json *json, unsigned depth)
{
    bool mapping = take(json, '{');
    if (!mapping && !take(json, '['))
        return json->at < json->length && (json->text[json->at] == '"' ? json_string(json) : json_word(json));
    char close = mapping ? '}' : ']';
    if (depth == LX_DEEPEST)
        return false;
    if (take(json, close))
        return true;
    do {
        if (mapping && !(json_string(json) && take(json, ':')))
            return false;
        if (!json_value(json, depth + 1))
            return false;
    } while (take(json, ','));
    return take(json, close);
}

bool lx_is_json_value(const char *text, size_t length)
{
    struct json json = {.text = text, .length = length};
    return json_value(&json, 0) && json.at == length;
}
