/* SPDX-License-Identifier: MIT */
/*
 * Putting elements in, taking them out and moving them, as patches of the text.  Slots (slot.h) say what belongs to
 * an element; all between the slots stays where it is.  As in splice.c nothing has to be right for every text: the
 * caller reads the result and compares.
 */
#include "rearrange.h"

#include <stdlib.h>

#include "../base/memory.h"
#include "slot.h"

enum { INDENT = 2 };

/* Puts bytes of the text in the place of others. */
static void patch_bytes(struct lx_splicer *splicer, size_t start, size_t end, size_t from, size_t to)
{
    struct lx_text bytes = {0};
    lx_text_add(&bytes, splicer->old.text + from, to - from);
    if (bytes.failed)
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
    else
        lx_patch(splicer, start, end, to > from ? bytes.bytes : "", "");
    lx_text_clear(&bytes);
}

/* Puts made words in the place of bytes, and frees them. */
static void patch_text(struct lx_splicer *splicer, size_t start, size_t end, struct lx_text *words)
{
    if (words->failed)
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
    else
        lx_patch(splicer, start, end, words->bytes, "");
    lx_text_clear(words);
}

/* The child with this number and the one before it; 0 where there is none. */
static lx_node_id find_child(const struct lx_layout *old, lx_node_id parent, size_t index, lx_node_id *before)
{
    *before = index ? lx_document_element(old->document, parent, index - 1) : 0;
    return lx_document_element(old->document, parent, index);
}

/* ---- in ---- */

/* As lines of a block list: before the comments of the next element, or below the last one. */
static void put_line(struct lx_splicer *splicer, lx_node_id list, size_t index, const char *words)
{
    const struct lx_layout *old = &splicer->old;
    lx_node_id before, at = find_child(old, list, index, &before), further = 0;
    struct lx_text text = {0};
    if (!at && index > 1)
        find_child(old, list, index - 1, &further);
    struct lx_slot slot = at ? lx_find_slot(old, list, before, at) : lx_find_slot(old, list, further, before);
    size_t column = lx_column(old, slot.start);
    if (at) {
        lx_text_printf(&text, "- %s%s", words, lx_line_break(old));
        lx_text_fill(&text, ' ', column);
        patch_text(splicer, slot.head, slot.head, &text);
        return;
    }
    lx_text_puts(&text, lx_line_break(old));
    lx_text_fill(&text, ' ', column);
    lx_text_printf(&text, "- %s", words);
    patch_text(splicer, slot.end, slot.end, &text);
}

/* The column of the dashes of the first list in block style among the children of a mapping, or of one to come. */
static size_t dash_column(const struct lx_layout *old, lx_node_id mapping)
{
    const struct lx_node *node = lx_document_node(old->document, mapping);
    for (lx_node_id id = node->first; id; id = lx_document_node(old->document, id)->next)
        if (lx_document_node(old->document, id)->kind == LX_SEQUENCE && !lx_is_flow(old, id))
            return lx_column(old, lx_document_node(old->document, id)->start);
    return lx_column(old, lx_document_node(old->document, node->first)->key_start) + INDENT;
}

/* Into [ ]; or, where `block` and nothing but a comment follows on the line, in its place as a line of its own. */
static void put_first(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, const char *words, bool block)
{
    const struct lx_layout *old = &splicer->old;
    const struct lx_node *node = lx_document_node(old->document, list);
    size_t mark, line_end = lx_line_end(old, node->start), rest = lx_skip_blanks(old, node->end);
    struct lx_text text = {0};
    if (block && !splicer->json && !lx_is_flow(old, parent) && lx_find_mark(old, parent, list, &mark) &&
        !lx_has_break(old, mark, node->end) && (rest == line_end || old->text[rest] == '#')) {
        lx_patch(splicer, mark, node->end, "", "");
        lx_text_puts(&text, lx_line_break(old));
        lx_text_fill(&text, ' ', dash_column(old, parent));
        lx_text_printf(&text, "- %s", words);
        patch_text(splicer, line_end, line_end, &text);
        return;
    }
    lx_text_puts(&text, words);
    if (lx_skip_blanks(old, node->start + 1) == node->end - 1)
        patch_text(splicer, node->start + 1, node->end - 1, &text);
    else
        patch_text(splicer, node->start + 1, node->start + 1, &text);
}

/* Adds what stands between two neighbours, if it is nothing but space and a comma. */
static void add_separator(struct lx_text *text, const struct lx_layout *old, lx_node_id list, lx_node_id one,
                          lx_node_id other)
{
    if (one && other) {
        size_t start = lx_find_slot(old, list, 0, one).end, end = lx_find_slot(old, list, one, other).start;
        if (lx_is_separator(old, start, end)) {
            lx_text_add(text, old->text + start, end - start);
            return;
        }
    }
    lx_text_puts(text, ", ");
}

/* Adds a line break and the indentation of a slot that starts its line. */
static void add_new_line(struct lx_text *text, const struct lx_layout *old, const struct lx_slot *slot)
{
    size_t line = lx_line_start(old, slot->start);
    lx_text_puts(text, lx_line_break(old));
    lx_text_add(text, old->text + line, slot->start - line);
}

/* Before the element `at`, which follows `before`. */
static void put_before(struct lx_splicer *splicer, lx_node_id list, lx_node_id before, lx_node_id at, const char *words)
{
    const struct lx_layout *old = &splicer->old;
    struct lx_slot slot = lx_find_slot(old, list, before, at);
    struct lx_text text = {0};
    lx_text_puts(&text, words);
    if (slot.alone) {
        lx_text_puts(&text, ",");
        add_new_line(&text, old, &slot);
    } else if (before) {
        add_separator(&text, old, list, before, at);
    } else {
        add_separator(&text, old, list, at, lx_document_node(old->document, at)->next);
    }
    patch_text(splicer, slot.head, slot.head, &text);
}

/* Behind the last element, which follows `before`. */
static void put_behind(struct lx_splicer *splicer, lx_node_id list, lx_node_id before, lx_node_id last,
                       const char *words)
{
    const struct lx_layout *old = &splicer->old;
    struct lx_slot slot = lx_find_slot(old, list, before, last);
    struct lx_text text = {0};
    if (slot.alone) {
        if (!slot.has_comma)
            lx_patch(splicer, slot.end, slot.end, ",", "");
        add_new_line(&text, old, &slot);
        lx_text_puts(&text, words);
        if (slot.has_comma)
            lx_text_puts(&text, ",");
    } else {
        add_separator(&text, old, list, before, last);
        lx_text_puts(&text, words);
    }
    size_t at = slot.alone ? slot.tail_end : slot.end;
    patch_text(splicer, at, at, &text);
}

void lx_put_in(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, size_t index, const char *words,
               bool block)
{
    const struct lx_layout *old = &splicer->old;
    lx_node_id before, further, at = find_child(old, list, index, &before);
    if (!before && !at) {
        put_first(splicer, parent, list, words, block);
    } else if (!lx_is_flow(old, list)) {
        put_line(splicer, list, index, words);
    } else if (at) {
        put_before(splicer, list, before, at, words);
    } else {
        find_child(old, list, index - 1, &further);
        put_behind(splicer, list, further, before, words);
    }
}

/* ---- out ---- */

static void cut_lines(struct lx_splicer *splicer, const struct lx_slot *slot)
{
    const struct lx_layout *old = &splicer->old;
    lx_patch(splicer, lx_line_start(old, slot->head), lx_line_below(old, slot->tail_end), "", "");
}

/* The last one of a block gives way to empty brackets behind the colon or dash of the block. */
static void take_only(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, const struct lx_slot *slot)
{
    const struct lx_layout *old = &splicer->old;
    bool mapping = lx_document_node(old->document, list)->kind == LX_MAPPING;
    size_t mark;
    if (!parent || lx_is_flow(old, list) || !slot->alone || !lx_find_mark(old, parent, list, &mark) ||
        !lx_has_break(old, mark, slot->head)) {
        lx_give_up(splicer, LX_NOT_SPLICED);
        return;
    }
    lx_patch(splicer, mark, mark, mapping ? " {}" : " []", "");
    cut_lines(splicer, slot);
}

/* Out of brackets, where others stand on the same lines. */
static void take_from_line(struct lx_splicer *splicer, const struct lx_slot *before, const struct lx_slot *slot,
                           const struct lx_slot *next)
{
    const struct lx_layout *old = &splicer->old;
    if (next && lx_is_separator(old, slot->end, next->start)) {
        lx_patch(splicer, slot->start, next->start, "", "");
    } else if (!next && lx_is_separator(old, before->end, slot->start)) {
        lx_patch(splicer, before->end, slot->end, "", "");
    } else {
        size_t comma = slot->has_comma ? slot->comma : before->comma;
        lx_patch(splicer, slot->start, slot->end, "", "");
        lx_patch(splicer, comma, comma + 1, "", "");
    }
}

void lx_take_out(struct lx_splicer *splicer, lx_node_id parent, lx_node_id list, lx_node_id id)
{
    const struct lx_layout *old = &splicer->old;
    lx_node_id before = 0, further = 0, next = lx_document_node(old->document, id)->next;
    for (lx_node_id child = lx_document_node(old->document, list)->first; child != id;
         child = lx_document_node(old->document, child)->next) {
        further = before;
        before = child;
    }
    struct lx_slot slot = lx_find_slot(old, list, before, id), before_it = {0}, behind = {0};
    if (before)
        before_it = lx_find_slot(old, list, further, before);
    if (next)
        behind = lx_find_slot(old, list, id, next);
    if (!before && !next) {
        take_only(splicer, parent, list, &slot);
    } else if (slot.alone) {
        cut_lines(splicer, &slot);
        if (lx_is_flow(old, list) && !next && !slot.has_comma)
            lx_patch(splicer, before_it.comma, before_it.comma + 1, "", "");
    } else if (lx_is_flow(old, list)) {
        take_from_line(splicer, &before_it, &slot, next ? &behind : NULL);
    } else if (next && !before) { /* the first one stands on the line of the dash around it */
        lx_patch(splicer, slot.start, behind.head, "", "");
    } else {
        lx_give_up(splicer, LX_NOT_SPLICED);
    }
}

/* ---- elsewhere ---- */

/* Lets slot `to` hold what slot `from` does: with `whole` with its comments. */
static void fill_slot(struct lx_splicer *splicer, const struct lx_slot *to, const struct lx_slot *from, bool whole)
{
    patch_bytes(splicer, whole ? to->head : to->start, to->end, whole ? from->head : from->start, from->end);
    if (whole)
        patch_bytes(splicer, to->tail, to->tail_end, from->tail, from->tail_end);
}

void lx_move_to(struct lx_splicer *splicer, lx_node_id list, size_t from, size_t to)
{
    const struct lx_layout *old = &splicer->old;
    size_t low = from < to ? from : to, count = (from < to ? to : from) - low + 1;
    struct lx_slot *slots = lx_new_array(count, sizeof *slots);
    if (!slots) {
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
        return;
    }
    lx_node_id before, id = find_child(old, list, low, &before);
    bool whole = true;
    for (size_t i = 0; i < count; i++, before = id, id = lx_document_node(old->document, id)->next) {
        slots[i] = lx_find_slot(old, list, before, id);
        whole = whole && (slots[i].alone || !lx_is_flow(old, list));
    }
    for (size_t i = 0; i < count; i++) {
        size_t source = from < to ? (i + 1) % count : (i + count - 1) % count;
        fill_slot(splicer, &slots[i], &slots[source], whole);
    }
    free(slots);
}
