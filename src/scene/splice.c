/* SPDX-License-Identifier: MIT */
/*
 * Splicing.  The text is read once more, and the tree that comes out is walked side by side with the changed one.
 * Where a node of the changed tree comes from another source (an assignment), a patch puts that one's words in the
 * place of the old value, or adds a line or a comma for a key that was not there.  The patches of insert.c and
 * these are collected in the order of the walk and then applied.  Nothing here has to be right for every text that
 * YAML allows: the caller reads the result and compares.
 */
#include <stdlib.h>
#include <string.h>

#include "patch.h"
#include "splice.h"
#include "tidy.h"
#include "yaml.h"

/* ---- where a node comes from ---- */

bool lx_is_as_read(const struct lx_document *document, lx_node_id id)
{
    unsigned source = lx_document_node(document, id)->source;
    for (id = lx_document_node(document, id)->first; id; id = lx_document_node(document, id)->next)
        if (lx_document_node(document, id)->source != source || !lx_is_as_read(document, id))
            return false;
    return true;
}

/* The value that an assignment's node was read from: what follows the '='. */
static struct lx_place value_words(const struct lx_document *document, lx_node_id id)
{
    struct lx_place place = lx_document_place(document, id);
    const char *equals = place.text ? memchr(place.text, '=', place.length) : NULL;
    size_t start = equals ? (size_t)(equals - place.text) + 1 : 0;
    return (struct lx_place){.text = place.text + start, .length = place.length - start, .start = start};
}

/* A group that was made on the way to the key of an assignment stands on that key. */
static bool is_made(const struct lx_document *document, lx_node_id id)
{
    return lx_document_node(document, id)->start < value_words(document, id).start;
}

/* ---- the words of a value ---- */

/* Adds words of several lines with every line but the first moved in, so that they stay below their block. */
static void add_lines(struct lx_text *text, const struct lx_layout *words, size_t start, size_t end, int indent,
                      const char *line_break)
{
    bool outside = false; /* a line begins in the first column, which is outside any block */
    for (size_t at = lx_line_end(words, start); at < end; at = lx_line_end(words, at + 1))
        outside |= at + 1 < end && !strchr(" \t\r\n", words->text[at + 1]);
    size_t shift = indent < 0 ? 0 : (size_t)indent + (outside ? 2 : 0);
    for (size_t at = start; at < end;) {
        size_t line_end = lx_line_end(words, at);
        line_end = line_end < end ? line_end : end;
        if (at > start && line_end > at)
            lx_text_fill(text, ' ', shift);
        lx_text_add(text, words->text + at, line_end - at);
        if (line_end < end)
            lx_text_puts(text, line_break);
        at = line_end + 1;
        if (at < end && words->text[line_end] == '\r' && words->text[at] == '\n')
            at++;
    }
}

/* Whether a value may be written as the user typed it. */
static bool fits_as_typed(const struct lx_splicer *splicer, const struct lx_layout *words, struct lx_where where)
{
    const struct lx_node *root = lx_document_node(words->document, words->document->root);
    if (splicer->json)
        return lx_is_json_value(words->text + root->start, root->end - root->start);
    if (root->kind != LX_SCALAR)
        return lx_is_flow(words, words->document->root);
    if (lx_is_block_text(words, words->document->root) || lx_has_break(words, root->start, root->end))
        return false;
    const char *text = lx_document_text(words->document, words->document->root);
    return !root->plain || !where.flow || lx_plain_is_writable(text);
}

/* Reads what the user typed, with later changes below it spliced in, and adds it in a form that fits. */
static enum lx_splice_result add_typed(const struct lx_splicer *splicer, lx_node_id id, struct lx_where where,
                                       struct lx_text *text)
{
    struct lx_text typed = {0};
    struct lx_document document = {0};
    struct lx_place value = value_words(splicer->document, id);
    enum lx_splice_result result = LX_SPLICED;
    bool json;
    if (lx_is_as_read(splicer->document, id))
        lx_text_add(&typed, value.text, value.length);
    else
        result = lx_splice(splicer->document, id, value.text, value.length, &typed, &json);
    if (typed.failed)
        result = LX_SPLICE_NO_MEMORY;
    if (result == LX_SPLICED)
        result = lx_read_again(typed.bytes, typed.length, &document);
    if (result == LX_SPLICED) {
        struct lx_layout words = {typed.bytes, typed.length, &document};
        const struct lx_node *root = lx_document_node(&document, document.root);
        if (fits_as_typed(splicer, &words, where))
            add_lines(text, &words, root->start, root->end, where.indent, lx_line_break(&splicer->old));
        else
            lx_write_flow(text, &document, document.root, splicer->json);
    }
    lx_document_clear(&document);
    lx_text_clear(&typed);
    return result;
}

enum lx_splice_result lx_add_value(const struct lx_splicer *splicer, lx_node_id id, struct lx_where where,
                                   struct lx_text *text)
{
    const struct lx_document *document = splicer->document;
    if (lx_document_node(document, id)->source == splicer->source) {
        lx_write_flow(text, document, id, splicer->json);
        return LX_SPLICED;
    }
    if (!is_made(document, id))
        return add_typed(splicer, id, where, text);
    enum lx_splice_result result = LX_SPLICED;
    lx_text_puts(text, "{");
    where.flow = true;
    for (lx_node_id child = lx_document_node(document, id)->first; child && result == LX_SPLICED;
         child = lx_document_node(document, child)->next) {
        if (child != lx_document_node(document, id)->first)
            lx_text_puts(text, ", ");
        lx_write_key(text, lx_document_key(document, child), splicer->json);
        lx_text_puts(text, ": ");
        result = lx_add_value(splicer, child, where, text);
    }
    lx_text_puts(text, "}");
    return result;
}

/* ---- values in the place of others ---- */

/* [a: 1] is a list of a mapping without braces: its marks begin at the colon. */
static bool is_pair(const struct lx_splicer *splicer, lx_node_id old, struct lx_where where)
{
    return where.flow && lx_document_node(splicer->old.document, old)->kind == LX_MAPPING &&
           !lx_is_flow(&splicer->old, old);
}

/*
 * A list or mapping on lines of its own gives way to a value that stands behind the colon or dash.  Comments between
 * the two and behind the last line stay.
 */
static void replace_lines(struct lx_splicer *splicer, size_t mark, size_t start, size_t end, const char *words)
{
    const struct lx_layout *old = &splicer->old;
    lx_patch(splicer, mark, mark, " ", words);
    size_t rest = lx_skip_blanks(old, end);
    if (rest < old->length && !lx_is_break(old->text[rest])) {
        lx_patch(splicer, start, rest, "", "");
        return;
    }
    start = lx_line_start(old, start);
    if (start > mark) {
        start--;
        start -= start > mark && old->text[start] == '\n' && old->text[start - 1] == '\r';
    }
    lx_patch(splicer, start, rest, "", "");
}

static void replace_with(struct lx_splicer *splicer, lx_node_id parent, lx_node_id id, struct lx_where where,
                         const char *words)
{
    const struct lx_layout *old = &splicer->old;
    const struct lx_node *node = lx_document_node(old->document, id);
    size_t start = node->start, end = lx_value_end(old, parent, id), mark;
    bool marked = lx_find_mark(old, parent, id, &mark);
    bool block = !where.flow && node->kind != LX_SCALAR && !lx_is_flow(old, id);
    if (lx_is_empty(old, id)) {
        if (!marked && !where.flow)
            lx_give_up(splicer, LX_NOT_SPLICED);
        lx_patch(splicer, mark, mark, marked ? " " : ": ", words);
    } else if (block && lx_has_break(old, mark, start)) {
        replace_lines(splicer, mark, start, end, words);
    } else {
        if (is_pair(splicer, id, where))
            start = lx_document_node(old->document, node->first)->key_start;
        else if (lx_is_block_text(old, id))
            start = lx_skip_space(old, mark);
        /* {"a":1} is fine in JSON; {a:1} would be a key "a:1" */
        bool tight = marked && mark == start && old->text[mark - 1] == ':' && old->text[node->key_start] != '"';
        lx_patch(splicer, start, end, tight ? " " : "", words);
    }
}

static void replace(struct lx_splicer *splicer, lx_node_id parent, lx_node_id old, lx_node_id id, struct lx_where where)
{
    struct lx_text words = {0};
    enum lx_splice_result result = lx_add_value(splicer, id, where, &words);
    if (result != LX_SPLICED || words.failed)
        lx_give_up(splicer, words.failed ? LX_SPLICE_NO_MEMORY : result);
    else
        replace_with(splicer, parent, old, where, words.bytes);
    lx_text_clear(&words);
}

/* ---- the walk ---- */

/* Finds what differs between a node and what it was when it was read. */
static void walk(struct lx_splicer *splicer, lx_node_id old, lx_node_id id, struct lx_where where)
{
    const struct lx_document *before = splicer->old.document, *now = splicer->document;
    if (lx_document_node(before, old)->kind != lx_document_node(now, id)->kind)
        lx_give_up(splicer, LX_NOT_SPLICED);
    if (lx_document_node(now, id)->kind == LX_SCALAR || splicer->result != LX_SPLICED)
        return;
    if (lx_is_flow(&splicer->old, old))
        where.flow = true;
    else if (!where.flow)
        where.indent = (int)lx_column(&splicer->old, lx_document_node(before, old)->start);
    lx_node_id was = lx_document_node(before, old)->first, child = lx_document_node(now, id)->first, last = 0;
    for (; was && child; last = was, was = lx_document_node(before, was)->next) {
        bool is_new = lx_document_node(now, child)->source != splicer->source;
        if (is_new && !lx_document_same(before, was, now, child, true))
            replace(splicer, old, was, child, where);
        else if (!is_new && is_pair(splicer, was, where) && lx_document_size(now, child) > 1)
            replace(splicer, old, was, child, where);
        else if (!is_new)
            walk(splicer, was, child, where);
        child = lx_document_node(now, child)->next;
    }
    if (was)
        lx_give_up(splicer, LX_NOT_SPLICED);
    if (child)
        lx_insert(splicer, old, last, child, where);
}

enum lx_splice_result lx_read_again(const char *text, size_t length, struct lx_document *document)
{
    switch (lx_yaml_read_text(text, length, document)) {
    case LUXEL_OK: return document->root ? LX_SPLICED : LX_NOT_SPLICED;
    case LUXEL_ERROR_MEMORY: return LX_SPLICE_NO_MEMORY;
    default: return LX_NOT_SPLICED;
    }
}

enum lx_splice_result lx_splice(const struct lx_document *document, lx_node_id id, const char *text, size_t length,
                                struct lx_text *result, bool *json)
{
    struct lx_document before = {0};
    struct lx_splicer splicer = {.document = document, .source = lx_document_node(document, id)->source};
    splicer.old = (struct lx_layout){text, length, &before};
    splicer.result = lx_read_again(text, length, &before);
    if (splicer.result == LX_SPLICED) {
        *json = splicer.json = lx_is_json_document(&splicer.old);
        walk(&splicer, before.root, id, (struct lx_where){.indent = -1});
    }
    if (splicer.result == LX_SPLICED)
        lx_apply_patches(&splicer, result);
    lx_clear_patches(&splicer);
    lx_document_clear(&before);
    return splicer.result;
}
