/* SPDX-License-Identifier: MIT */
/*
 * The document: a tree of mappings, sequences and scalars as the user wrote it, each with its place in one of
 * several source texts (a file, and every later assignment).  Nodes lie in one array and are linked by index,
 * so that a million of them stay small and are copied at once.
 */
#ifndef LX_PARAMETER_DOCUMENT_H
#define LX_PARAMETER_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../base/diagnostics.h"

enum lx_node_kind { LX_SCALAR, LX_SEQUENCE, LX_MAPPING };

typedef uint32_t lx_node_id; /* 0: no node */

struct lx_node {
    lx_node_id next, first;      /* the following sibling; the first child */
    uint32_t key;                /* in a mapping: offset of the key's text */
    uint32_t key_start, key_end; /* its place in the source */
    uint32_t text;               /* of a scalar: offset of its text, quotes and escapes undone */
    uint32_t start, end;         /* place in the source; start == end: nothing was written there */
    uint32_t source : 29;
    uint32_t kind : 2;  /* enum lx_node_kind */
    uint32_t plain : 1; /* a scalar without quotes */
};

struct lx_source_text;

struct lx_document {
    struct lx_node *nodes; /* [0] is no node */
    size_t node_count, node_capacity;
    char *texts; /* of keys and scalars, each ended by a 0 byte */
    size_t text_length, text_capacity;
    struct lx_source_text **sources;
    size_t source_count, source_capacity;
    lx_node_id root;
};

/* Limits: of what the links can reach, and of what a machine should be asked to hold. */
enum { LX_MOST_OF_DOCUMENT = 1 << 24, LX_MOST_SOURCES = 1 << 28 };

/* A document starts as {0}. */
void lx_document_clear(struct lx_document *document);

/* An independent copy of what the root still reaches; 0, or -1 when memory ran out. */
int lx_document_copy(const struct lx_document *document, struct lx_document *copy);

/* The bytes it holds, garbage and sources included. */
size_t lx_document_bytes(const struct lx_document *document);

/* The state of the arrays, to take back what was added since. */
struct lx_document_mark {
    size_t nodes, text, sources;
};
struct lx_document_mark lx_document_mark(const struct lx_document *document);
void lx_document_rewind(struct lx_document *document, struct lx_document_mark mark);

/*
 * Adds a source text; the bytes, which malloc() gave, become the document's, also on failure.  0, or -1 when
 * memory ran out.  Its index is source_count - 1.
 */
int lx_document_add_source(struct lx_document *document, const char *name, char *text, size_t length);

/* Adds a node or a text (without 0 bytes) and sets *id or *offset; 0, or -1 when memory ran out. */
int lx_document_add_node(struct lx_document *document, struct lx_node node, lx_node_id *id);
int lx_document_add_text(struct lx_document *document, const char *bytes, size_t length, uint32_t *offset);

/* Makes a node the last child of a parent, or puts it in the place of one of its children. */
void lx_document_append(struct lx_document *document, lx_node_id parent, lx_node_id child);
void lx_document_replace(struct lx_document *document, lx_node_id parent, lx_node_id old, lx_node_id child);

static inline const struct lx_node *lx_document_node(const struct lx_document *document, lx_node_id id)
{
    return &document->nodes[id];
}

/* The key of a node in a mapping, the text of a scalar. */
static inline const char *lx_document_key(const struct lx_document *document, lx_node_id id)
{
    return document->texts + document->nodes[id].key;
}

static inline const char *lx_document_text(const struct lx_document *document, lx_node_id id)
{
    return document->texts + document->nodes[id].text;
}

/* The first child of a mapping with this key, the i-th child of a sequence, the number of children. */
lx_node_id lx_document_find(const struct lx_document *document, lx_node_id mapping, const char *key);
lx_node_id lx_document_element(const struct lx_document *document, lx_node_id sequence, size_t i);
size_t lx_document_size(const struct lx_document *document, lx_node_id id);

/* A plain scalar that YAML reads as null: empty, ~ or null. */
bool lx_document_is_null(const struct lx_document *document, lx_node_id id);

/*
 * Whether two nodes, of the same or of two documents, hold the same values under the same keys in the same order.
 * `exact`: numbers and truth values must be written alike, too; quotes never matter where they change nothing.
 */
bool lx_document_same(const struct lx_document *one, lx_node_id id, const struct lx_document *other,
                      lx_node_id other_id, bool exact);

/* The place of a node, and of its key. */
struct lx_place lx_document_place(const struct lx_document *document, lx_node_id id);
struct lx_place lx_document_key_place(const struct lx_document *document, lx_node_id id);
/* A stretch of a source. */
struct lx_place lx_document_stretch(const struct lx_document *document, size_t source, size_t start, size_t end);

#endif
