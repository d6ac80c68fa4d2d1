/* SPDX-License-Identifier: MIT */
/*
 * The arrays and links behind the document tree.  Nothing is ever freed one by one: a change leaves the old
 * nodes behind, and copying takes along only what the root still reaches.
 */
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/number.h"
#include "document.h"
#include "plain.h"

/* A source text, shared by the copies of a document, which may live in different threads. */
struct lx_source_text {
    atomic_size_t users;
    char *name, *text;
    size_t length;
};

static void source_release(struct lx_source_text *source)
{
    if (atomic_fetch_sub(&source->users, 1) > 1)
        return;
    free(source->name);
    free(source->text);
    free(source);
}

void lx_document_clear(struct lx_document *document)
{
    for (size_t i = 0; i < document->source_count; i++)
        source_release(document->sources[i]);
    free(document->sources);
    free(document->nodes);
    free(document->texts);
    *document = (struct lx_document){0};
}

size_t lx_document_bytes(const struct lx_document *document)
{
    size_t bytes = document->node_count * sizeof *document->nodes + document->text_length;
    for (size_t i = 0; i < document->source_count; i++)
        bytes += sizeof(struct lx_source_text) + document->sources[i]->length;
    return bytes;
}

struct lx_document_mark lx_document_mark(const struct lx_document *document)
{
    return (struct lx_document_mark){document->node_count, document->text_length, document->source_count};
}

void lx_document_rewind(struct lx_document *document, struct lx_document_mark mark)
{
    document->node_count = mark.nodes;
    document->text_length = mark.text;
    while (document->source_count > mark.sources)
        source_release(document->sources[--document->source_count]);
}

static int hold_source(struct lx_document *document, struct lx_source_text *source)
{
    if (document->source_count >= LX_MOST_SOURCES ||
        lx_reserve(&document->sources, &document->source_capacity, document->source_count + 1,
                   sizeof(struct lx_source_text *)) < 0)
        return -1;
    document->sources[document->source_count++] = source;
    return 0;
}

int lx_document_add_source(struct lx_document *document, const char *name, char *text, size_t length)
{
    struct lx_source_text *source = lx_new_array(1, sizeof *source);
    if (!source) {
        free(text);
        return -1;
    }
    atomic_init(&source->users, 1);
    source->text = text;
    source->length = length;
    source->name = lx_copy_text(name, strlen(name));
    if (!source->name || hold_source(document, source) < 0) {
        source_release(source);
        return -1;
    }
    return 0;
}

int lx_document_add_node(struct lx_document *document, struct lx_node node, lx_node_id *id)
{
    size_t first = document->node_count ? document->node_count : 1;
    if (first > UINT32_MAX / 2 || lx_reserve(&document->nodes, &document->node_capacity, first + 1, sizeof node) < 0)
        return -1;
    if (first == 1)
        memset(document->nodes, 0, sizeof node);
    document->nodes[first] = node;
    document->node_count = first + 1;
    *id = (lx_node_id)first;
    return 0;
}

int lx_document_add_text(struct lx_document *document, const char *bytes, size_t length, uint32_t *offset)
{
    if (length >= UINT32_MAX - document->text_length ||
        lx_reserve(&document->texts, &document->text_capacity, document->text_length + length + 1, 1) < 0)
        return -1;
    *offset = (uint32_t)document->text_length;
    if (length)
        memcpy(document->texts + document->text_length, bytes, length);
    document->text_length += length;
    document->texts[document->text_length++] = 0;
    return 0;
}

void lx_document_append(struct lx_document *document, lx_node_id parent, lx_node_id child)
{
    lx_node_id *link = &document->nodes[parent].first;
    while (*link)
        link = &document->nodes[*link].next;
    *link = child;
}

void lx_document_replace(struct lx_document *document, lx_node_id parent, lx_node_id old, lx_node_id child)
{
    lx_node_id *link = &document->nodes[parent].first;
    while (*link && *link != old)
        link = &document->nodes[*link].next;
    document->nodes[child].next = document->nodes[old].next;
    *link = child;
}

lx_node_id lx_document_find(const struct lx_document *document, lx_node_id mapping, const char *key)
{
    if (document->nodes[mapping].kind != LX_MAPPING)
        return 0;
    lx_node_id id = document->nodes[mapping].first;
    while (id && strcmp(lx_document_key(document, id), key) != 0)
        id = document->nodes[id].next;
    return id;
}

lx_node_id lx_document_element(const struct lx_document *document, lx_node_id sequence, size_t i)
{
    lx_node_id id = document->nodes[sequence].first;
    while (id && i-- > 0)
        id = document->nodes[id].next;
    return id;
}

size_t lx_document_size(const struct lx_document *document, lx_node_id id)
{
    size_t size = 0;
    for (id = document->nodes[id].first; id; id = document->nodes[id].next)
        size++;
    return size;
}

bool lx_document_is_null(const struct lx_document *document, lx_node_id id)
{
    static const char *const words[] = {"", "~", "null", "Null", "NULL"};
    const struct lx_node *node = lx_document_node(document, id);
    if (node->kind != LX_SCALAR || !node->plain)
        return false;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcmp(lx_document_text(document, id), words[i]) == 0)
            return true;
    return false;
}

/* ---- comparing ---- */

/* What a plain scalar that is no text means: the words of a truth value in one case, others as they are. */
static const char *one_case(const char *text)
{
    if (strcmp(text, "True") == 0 || strcmp(text, "TRUE") == 0)
        return "true";
    return strcmp(text, "False") == 0 || strcmp(text, "FALSE") == 0 ? "false" : text;
}

static bool same_scalar(const struct lx_document *one, lx_node_id id, const struct lx_document *other,
                        lx_node_id other_id, bool exact)
{
    const char *text = lx_document_text(one, id), *other_text = lx_document_text(other, other_id);
    bool plain = lx_document_node(one, id)->plain, other_plain = lx_document_node(other, other_id)->plain;
    bool is_null = lx_document_is_null(one, id);
    if (is_null || lx_document_is_null(other, other_id))
        return is_null && lx_document_is_null(other, other_id);
    if (plain == other_plain || lx_plain_is_text(plain ? text : other_text))
        if (strcmp(text, other_text) == 0)
            return true;
    double number, other_number;
    if (exact || !plain || !other_plain)
        return false;
    if (lx_read_number(text, strlen(text), &number) && lx_read_number(other_text, strlen(other_text), &other_number))
        return number >= other_number && number <= other_number;
    return strcmp(one_case(text), one_case(other_text)) == 0;
}

bool lx_document_same(const struct lx_document *one, lx_node_id id, const struct lx_document *other,
                      lx_node_id other_id, bool exact)
{
    const struct lx_node *node = lx_document_node(one, id), *other_node = lx_document_node(other, other_id);
    if (node->kind != other_node->kind)
        return false;
    if (node->kind == LX_SCALAR)
        return same_scalar(one, id, other, other_id, exact);
    bool mapping = node->kind == LX_MAPPING;
    id = node->first;
    other_id = other_node->first;
    while (id && other_id) {
        if (mapping && strcmp(lx_document_key(one, id), lx_document_key(other, other_id)) != 0)
            return false;
        if (!lx_document_same(one, id, other, other_id, exact))
            return false;
        id = lx_document_node(one, id)->next;
        other_id = lx_document_node(other, other_id)->next;
    }
    return !id && !other_id;
}

struct lx_place lx_document_stretch(const struct lx_document *document, size_t source, size_t start, size_t end)
{
    const struct lx_source_text *from = document->sources[source];
    return (struct lx_place){
        .source = from->name, .text = from->text, .length = from->length, .start = start, .end = end};
}

struct lx_place lx_document_place(const struct lx_document *document, lx_node_id id)
{
    const struct lx_node *node = lx_document_node(document, id);
    return lx_document_stretch(document, node->source, node->start, node->end);
}

struct lx_place lx_document_key_place(const struct lx_document *document, lx_node_id id)
{
    const struct lx_node *node = lx_document_node(document, id);
    return lx_document_stretch(document, node->source, node->key_start, node->key_end);
}

/* ---- copying ---- */

struct copying {
    const struct lx_document *from;
    struct lx_document *to;
    uint32_t *sources; /* new index of each source plus 1, 0: not taken along yet */
};

static int copy_source(struct copying *copying, uint32_t index, uint32_t *copied)
{
    if (!copying->sources[index]) {
        struct lx_source_text *source = copying->from->sources[index];
        if (hold_source(copying->to, source) < 0)
            return -1;
        atomic_fetch_add(&source->users, 1);
        copying->sources[index] = (uint32_t)copying->to->source_count;
    }
    *copied = copying->sources[index] - 1;
    return 0;
}

/* Copies a node and all below it; the depth is bounded by that of the documents. */
static int copy_tree(struct copying *copying, lx_node_id id, bool in_mapping, lx_node_id *copied)
{
    const struct lx_document *from = copying->from;
    struct lx_node node = *lx_document_node(from, id);
    uint32_t source = 0;
    const char *key = lx_document_key(from, id), *text = lx_document_text(from, id);
    if (copy_source(copying, node.source, &source) < 0 ||
        (in_mapping && lx_document_add_text(copying->to, key, strlen(key), &node.key) < 0) ||
        (node.kind == LX_SCALAR && lx_document_add_text(copying->to, text, strlen(text), &node.text) < 0))
        return -1;
    node.source = source & (LX_MOST_SOURCES - 1);
    lx_node_id child = node.first;
    node.first = node.next = 0;
    if (lx_document_add_node(copying->to, node, copied) < 0)
        return -1;
    lx_node_id last = 0;
    for (; child; child = lx_document_node(from, child)->next) {
        lx_node_id next;
        if (copy_tree(copying, child, node.kind == LX_MAPPING, &next) < 0)
            return -1;
        if (last)
            copying->to->nodes[last].next = next;
        else
            copying->to->nodes[*copied].first = next;
        last = next;
    }
    return 0;
}

int lx_document_copy(const struct lx_document *document, struct lx_document *copy)
{
    struct copying copying = {document, copy, lx_new_array(document->source_count, sizeof(uint32_t))};
    *copy = (struct lx_document){0};
    /* offset 0 stands for the empty text wherever a node has none */
    uint32_t offset;
    if (!copying.sources || lx_document_add_text(copy, "", 0, &offset) < 0 ||
        (document->root && copy_tree(&copying, document->root, false, &copy->root) < 0)) {
        free(copying.sources);
        lx_document_clear(copy);
        return -1;
    }
    free(copying.sources);
    return 0;
}
