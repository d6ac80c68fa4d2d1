/* SPDX-License-Identifier: MIT */
/*
 * Following a key path through the scene and its tables side by side: the tables say which keys there are, the
 * scene how many elements a list has and of which type each is.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "path.h"

/* What a path has led to so far. */
struct position {
    lx_node_id node; /* 0: not written */
    size_t table_count;
    const struct lx_table *tables[2];     /* inside a mapping: whose keys it has */
    const struct lx_parameter *list;      /* inside an element: the list's parameter */
    bool any_type;                        /* inside an element of unknown type: the keys of all types */
    bool is_element;                      /* inside an element of a list */
    const struct lx_parameter *parameter; /* at a value: which; NULL inside a mapping */
    unsigned depth;                       /* list brackets passed within the parameter's value */
};

static luxel_status refuse(const struct lx_path *path, size_t start, size_t end, enum lx_message message,
                           const char *const *arguments, luxel_diagnostics *diagnostics)
{
    struct lx_place place = path->place;
    place.start = start;
    place.end = end;
    lx_report(diagnostics, LUXEL_SEVERITY_ERROR, &place, message, arguments);
    return LUXEL_ERROR_PATH;
}

/* ---- reading ---- */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_key_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '-';
}

/* Reads digits that start at *at into the segment. */
static bool read_index(const char *text, size_t length, size_t *at, struct lx_segment *segment)
{
    size_t start = *at;
    segment->is_index = true;
    for (segment->index = 0; *at < length && is_digit(text[*at]); (*at)++)
        if (__builtin_mul_overflow(segment->index, 10, &segment->index) ||
            __builtin_add_overflow(segment->index, (size_t)(text[*at] - '0'), &segment->index))
            segment->index = SIZE_MAX / 10;
    return *at > start;
}

/* Reads a name up to the bracket that ends it; * stands for all elements, and is no name, nor is what begins as a
 * negative number. */
static bool read_name(const char *text, size_t length, size_t *at, struct lx_segment *segment)
{
    const size_t start = *at;
    segment->is_index = segment->is_name = true;
    while (*at < length && text[*at] != ']')
        (*at)++;
    return *at > start && text[start] != '-' && !(*at == start + 1 && text[start] == '*');
}

static bool read_key(const char *text, size_t length, size_t *at, struct lx_segment *segment)
{
    size_t start = *at;
    while (*at < length && is_key_character(text[*at]))
        (*at)++;
    size_t size = *at - start;
    if (size == 0)
        return false;
    size_t kept = size < sizeof segment->key ? size : sizeof segment->key - 1;
    memcpy(segment->key, text + start, kept);
    segment->key[kept] = 0;
    return true;
}

/* Cuts the text from `at` to `end` into segments. */
static luxel_status read_path(struct lx_path *path, size_t at, size_t end, luxel_diagnostics *diagnostics)
{
    const char *text = path->place.text;
    while (at < end || path->count == 0) {
        if (path->count == LX_MOST_SEGMENTS)
            return refuse(path, at, end, LX_MSG_PATH_TOO_LONG, NULL, diagnostics);
        struct lx_segment *segment = &path->segments[path->count];
        bool bracket = path->count > 0 && text[at] == '[';
        bool dot = path->count > 0 && text[at] == '.';
        bool good = path->count == 0 || bracket || dot;
        size_t start = at;
        at += bracket || dot;
        segment->start = at;
        if (good && bracket && at < end && !is_digit(text[at]))
            good = read_name(text, end, &at, segment);
        else if (good)
            good = bracket || (dot && at < end && is_digit(text[at])) ? read_index(text, end, &at, segment)
                                                                      : read_key(text, end, &at, segment);
        segment->end = at;
        if (good && bracket)
            good = at < end && text[at++] == ']';
        if (!good) {
            refuse(path, start, end, LX_MSG_PATH_SYNTAX, NULL, diagnostics);
            lx_hint(diagnostics, LX_MSG_HINT_PATH, NULL);
            return LUXEL_ERROR_PATH;
        }
        path->count++;
    }
    return LUXEL_OK;
}

/* ---- following ---- */

/* The path up to segment i in words. */
static char *words_up_to(const struct lx_path *path, size_t count)
{
    struct lx_text text = {0};
    for (size_t i = 0; i < count; i++) {
        const struct lx_segment *segment = &path->segments[i];
        if (segment->is_index)
            lx_text_printf(&text, "[%zu]", segment->index);
        else
            lx_text_printf(&text, "%s%s", i ? "." : "", segment->key);
    }
    return lx_text_take(&text);
}

static luxel_status refuse_segment(const struct lx_path *path, size_t i, enum lx_message message, const char *first,
                                   luxel_diagnostics *diagnostics)
{
    char *up = words_up_to(path, i);
    luxel_status status = refuse(path, path->segments[i].start, path->segments[i].end, message,
                                 LX_ARGS(up ? up : "", first), diagnostics);
    free(up);
    return status;
}

/* The parameter with the segment's key among those that the position's mapping may have. */
static const struct lx_parameter *find_key(const struct position *position, const char *key)
{
    const struct lx_parameter *found = NULL;
    for (size_t t = 0; t < position->table_count && !found; t++)
        found = lx_find_parameter(position->tables[t], key);
    for (size_t i = 0; position->any_type && position->list->variants[i] && !found; i++)
        found = lx_find_parameter(position->list->variants[i]->table, key);
    return found;
}

static luxel_status follow_key(const struct lx_document *document, const struct lx_path *path, size_t i,
                               struct position *position, luxel_diagnostics *diagnostics)
{
    static const struct lx_parameter type = {.name = "type", .type = LX_TEXT};
    const struct lx_segment *segment = &path->segments[i];
    if (position->table_count == 0)
        return refuse_segment(path, i, lx_has_tables(position->parameter) ? LX_MSG_NEEDS_INDEX : LX_MSG_NO_KEYS,
                              segment->key, diagnostics);
    if (position->node && lx_document_node(document, position->node)->kind != LX_MAPPING &&
        !(lx_document_is_null(document, position->node) && !position->is_element))
        return refuse_segment(path, i, LX_MSG_NOT_A_MAPPING, NULL, diagnostics);
    const struct lx_parameter *found = find_key(position, segment->key);
    if (!found && position->list && strcmp(segment->key, "type") == 0)
        found = &type;
    if (!found) {
        refuse(path, segment->start, segment->end, LX_MSG_UNKNOWN_KEY, LX_ARGS("", segment->key), diagnostics);
        lx_hint_unknown_key(diagnostics, segment->key, position->tables, position->table_count, position->list);
        return LUXEL_ERROR_PATH;
    }
    lx_node_id node = position->node ? lx_document_find(document, position->node, segment->key) : 0;
    *position = (struct position){.node = node, .parameter = found};
    if (found->type == LX_GROUP) {
        position->table_count = 1;
        position->tables[0] = found->group;
    }
    return LUXEL_OK;
}

/* Enters element `node` of a list: the list or its own type decides which keys it has. */
static void enter_element(const struct lx_document *document, lx_node_id node, struct position *position)
{
    const struct lx_parameter *list = position->parameter;
    if (list->type == LX_GROUPS) {
        *position = (struct position){.node = node, .is_element = true, .table_count = 1, .tables = {list->group}};
        return;
    }
    lx_node_id type = lx_document_find(document, node, "type");
    const struct lx_variant *variant = NULL;
    if (type && lx_document_node(document, type)->kind == LX_SCALAR)
        variant = lx_find_variant(list, lx_document_text(document, type));
    *position = (struct position){.node = node, .list = list, .any_type = !variant, .is_element = true};
    position->tables[position->table_count++] = list->group;
    if (variant)
        position->tables[position->table_count++] = variant->table;
}

/* How many list brackets a value of this parameter may have. */
static unsigned list_depth(const struct lx_parameter *parameter)
{
    switch (parameter->type) {
    case LX_REALS:
    case LX_WHOLES:
    case LX_CHOICE_OR_PAIR:
    case LX_GROUPS:
    case LX_VARIANTS: return 1;
    case LX_POINTS:
    case LX_VECTORS: return 2;
    default: return 0;
    }
}

/* Reports that the list of so many elements, to which the first `count` segments lead, has no such element. */
static luxel_status refuse_element(const struct lx_path *path, size_t count, size_t start, size_t end, size_t size,
                                   luxel_diagnostics *diagnostics)
{
    char last[24], number[24];
    char *up = words_up_to(path, count);
    snprintf(number, sizeof number, "%zu", size);
    snprintf(last, sizeof last, "%zu", size - 1);
    luxel_status status = refuse(path, start, end,
                                 size == 0   ? LX_MSG_NO_ELEMENTS
                                 : size == 1 ? LX_MSG_ONE_ELEMENT
                                             : LX_MSG_NO_SUCH_ELEMENT,
                                 LX_ARGS(up ? up : "", number, last), diagnostics);
    free(up);
    return status;
}

/* The index of the first element of a list that has the name in the segment; reports where there is none. */
static luxel_status find_named(const struct lx_document *document, struct lx_path *path, size_t i, lx_node_id list,
                               luxel_diagnostics *diagnostics)
{
    struct lx_segment *segment = &path->segments[i];
    const char *wanted = path->place.text + segment->start;
    const size_t length = segment->end - segment->start;
    struct lx_text known = {0}, own = {0};
    size_t index = 0;
    for (lx_node_id at = lx_document_node(document, list)->first; at; at = lx_document_node(document, at)->next) {
        const bool has_keys = lx_document_node(document, at)->kind == LX_MAPPING;
        const lx_node_id name = has_keys ? lx_document_find(document, at, "name") : 0;
        if (name && lx_document_node(document, name)->kind == LX_SCALAR) {
            const char *text = lx_document_text(document, name);
            if (strlen(text) == length && memcmp(text, wanted, length) == 0) {
                lx_text_clear(&known);
                segment->index = index;
                return LUXEL_OK;
            }
            lx_text_puts(&known, known.length > 0 ? ", " : "");
            lx_text_puts(&known, text);
        }
        index++;
    }
    if (known.length == 0)
        return refuse_element(path, i, segment->start, segment->end, index, diagnostics);
    char *up = words_up_to(path, i);
    lx_text_puts(&own, up ? up : "");
    lx_text_puts(&own, "[…]");
    free(up);
    char *name = lx_copy_text(wanted, length);
    const luxel_status status =
        refuse(path, segment->start, segment->end, LX_MSG_WRONG_CHOICE,
               LX_ARGS(own.bytes ? own.bytes : "", known.bytes ? known.bytes : "", name ? name : ""), diagnostics);
    free(name);
    lx_text_clear(&own);
    lx_text_clear(&known);
    return status;
}

luxel_status lx_refuse_index(const struct lx_path *path, size_t size, luxel_diagnostics *diagnostics)
{
    return refuse_element(path, path->count, 0, path->place.length, size, diagnostics);
}

static luxel_status follow_index(const struct lx_document *document, struct lx_path *path, size_t i,
                                 struct position *position, luxel_diagnostics *diagnostics)
{
    if (position->table_count || position->depth >= list_depth(position->parameter))
        return refuse_segment(path, i, LX_MSG_NOT_A_LIST, NULL, diagnostics);
    if (!position->node)
        return refuse_segment(path, i, LX_MSG_LIST_NOT_WRITTEN, NULL, diagnostics);
    if (lx_document_node(document, position->node)->kind != LX_SEQUENCE)
        return refuse_segment(path, i, LX_MSG_NO_LIST_HERE, NULL, diagnostics);
    if (path->segments[i].is_name) {
        const luxel_status status = find_named(document, path, i, position->node, diagnostics);
        if (status != LUXEL_OK)
            return status;
    }
    lx_node_id node = lx_document_element(document, position->node, path->segments[i].index);
    if (!node)
        return refuse_element(path, i, path->segments[i].start, path->segments[i].end,
                              lx_document_size(document, position->node), diagnostics);
    if (lx_has_tables(position->parameter)) {
        enter_element(document, node, position);
    } else {
        position->node = node;
        position->depth++;
    }
    return LUXEL_OK;
}

luxel_status lx_follow_path(const luxel_scene *scene, const struct lx_place *place, size_t length,
                            luxel_diagnostics *diagnostics, struct lx_path *path)
{
    memset(path, 0, sizeof *path);
    path->place = *place;
    size_t start = 0;
    while (start < length && place->text[start] == ' ')
        start++;
    while (length > start && place->text[length - 1] == ' ')
        length--;
    luxel_status status = read_path(path, start, length, diagnostics);
    struct position position = {.node = scene->document.root, .table_count = 1, .tables = {&lx_scene_table}};
    path->nodes[0] = position.node;
    for (size_t i = 0; status == LUXEL_OK && i < path->count; i++) {
        if (path->segments[i].is_index)
            status = follow_index(&scene->document, path, i, &position, diagnostics);
        else
            status = follow_key(&scene->document, path, i, &position, diagnostics);
        path->nodes[i + 1] = position.node;
    }
    path->parameter = position.parameter;
    path->depth = position.depth;
    return status;
}

luxel_status lx_follow_list(const luxel_scene *scene, const struct lx_place *place, luxel_diagnostics *diagnostics,
                            struct lx_path *path, size_t *size)
{
    const struct lx_document *document = &scene->document;
    luxel_status status = lx_follow_path(scene, place, place->length, diagnostics, path);
    if (status != LUXEL_OK)
        return status;
    lx_node_id list = path->nodes[path->count];
    bool no_list = !path->parameter || path->depth >= list_depth(path->parameter);
    if (no_list ||
        (list && lx_document_node(document, list)->kind != LX_SEQUENCE && !lx_document_is_null(document, list))) {
        char *up = words_up_to(path, path->count);
        status = refuse(path, 0, place->length, no_list ? LX_MSG_NOT_A_LIST : LX_MSG_NO_LIST_HERE,
                        LX_ARGS(up ? up : ""), diagnostics);
        free(up);
        return status;
    }
    *size = list ? lx_document_size(document, list) : 0;
    return LUXEL_OK;
}

char *lx_text_of_element(const char *text, const char *all, size_t i)
{
    struct lx_text made = {0};
    lx_text_printf(&made, "%.*s[%zu]%s", (int)(all - text), text, i, all + strlen("[*]"));
    return lx_text_take(&made);
}
