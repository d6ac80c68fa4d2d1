/* SPDX-License-Identifier: MIT */
/* Changes of a text on their way: what splice.c and insert.c share. */
#ifndef LX_SCENE_PATCH_H
#define LX_SCENE_PATCH_H

#include "../base/text.h"
#include "../parameter/plain.h"
#include "layout.h"
#include "splice.h"

/* Bytes of the old text that give way to words. */
struct lx_text_patch {
    size_t start, end;
    size_t words, size; /* bytes of the splicer's words */
    size_t number;      /* patches of the same place follow each other as they were made */
};

struct lx_splicer {
    struct lx_layout old;               /* the text as it was, and what was read from it */
    const struct lx_document *document; /* as it is now */
    unsigned source;                    /* the text's in it */
    bool json;                          /* the text is JSON, and must stay so */
    enum lx_splice_result result;
    struct lx_text words;
    struct lx_text_patch *patches;
    size_t count, capacity;
};

/* The surroundings of a value. */
struct lx_where {
    bool flow;  /* inside brackets */
    int indent; /* the column of the block around it; -1: none */
};

/* Makes the splicer fail, unless it has failed already. */
void lx_give_up(struct lx_splicer *splicer, enum lx_splice_result result);

/* Puts two texts, one after the other, in the place of some bytes.  For one place the order of the calls counts. */
void lx_patch(struct lx_splicer *splicer, size_t start, size_t end, const char *first, const char *second);

/* Adds the text with all patches; the splicer fails where they overlap or memory runs out. */
void lx_apply_patches(struct lx_splicer *splicer, struct lx_text *text);
void lx_clear_patches(struct lx_splicer *splicer);

/* Reads a text anew. */
enum lx_splice_result lx_read_again(const char *text, size_t length, struct lx_document *document);

/* Adds the words of a new value. */
enum lx_splice_result lx_add_value(const struct lx_splicer *splicer, lx_node_id id, struct lx_where where,
                                   struct lx_text *text);

/* Adds keys to a mapping of the old text behind its last one (0: it is empty): `id` and all that follow it. */
void lx_insert(struct lx_splicer *splicer, lx_node_id mapping, lx_node_id last, lx_node_id id, struct lx_where where);

#endif
