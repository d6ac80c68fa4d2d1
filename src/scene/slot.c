/* SPDX-License-Identifier: MIT */
/* Finding the slots of elements and keys. */
#include "slot.h"

size_t lx_line_below(const struct lx_layout *layout, size_t at)
{
    at = lx_line_end(layout, at);
    if (at + 1 < layout->length && layout->text[at] == '\r' && layout->text[at + 1] == '\n')
        at++;
    return at < layout->length ? at + 1 : at;
}

bool lx_is_separator(const struct lx_layout *layout, size_t start, size_t end)
{
    unsigned commas = 0;
    for (; start < end; start++) {
        char c = layout->text[start];
        if (c == ',')
            commas++;
        else if (c != ' ' && c != '\t' && !lx_is_break(c))
            return false;
    }
    return commas == 1;
}

static bool starts_line(const struct lx_layout *layout, size_t at)
{
    return lx_skip_blanks(layout, lx_line_start(layout, at)) == at;
}

/* Where the comments right above begin, of something that starts its line; they must not begin before `lowest`. */
static size_t head_of(const struct lx_layout *layout, size_t at, size_t lowest)
{
    size_t line = lx_line_start(layout, at), indent = at - line;
    while (line > lowest) {
        size_t above = line - 1;
        if (above > 0 && layout->text[above] == '\n' && layout->text[above - 1] == '\r')
            above--;
        line = lx_line_start(layout, above);
        size_t comment = lx_skip_blanks(layout, line);
        if (line < lowest || comment - line != indent || layout->text[comment] != '#')
            break;
        at = comment;
    }
    return at;
}

/* Where a child begins; a mapping without braces in brackets, [a: 1], begins at its key. */
static size_t child_start(const struct lx_layout *layout, lx_node_id parent, lx_node_id id)
{
    const struct lx_node *node = lx_document_node(layout->document, id);
    if (lx_document_node(layout->document, parent)->kind == LX_MAPPING)
        return node->key_start;
    if (!lx_is_flow(layout, parent)) {
        size_t mark;
        lx_find_mark(layout, parent, id, &mark);
        return mark - 1;
    }
    bool is_pair = node->kind == LX_MAPPING && !lx_is_flow(layout, id) && node->first;
    return is_pair ? lx_document_node(layout->document, node->first)->key_start : node->start;
}

/* What follows a child in brackets: its comma, and a comment behind both.  Whether nothing else is on the line. */
static bool find_tail(const struct lx_layout *layout, struct lx_slot *slot)
{
    slot->comma = lx_skip_space(layout, slot->end);
    slot->has_comma = slot->comma < layout->length && layout->text[slot->comma] == ',';
    bool near = slot->has_comma && !lx_has_break(layout, slot->end, slot->comma);
    slot->tail = slot->tail_end = near ? slot->comma + 1 : slot->end;
    if (slot->has_comma && !near)
        return false;
    size_t rest = lx_skip_blanks(layout, slot->tail);
    if (rest < layout->length && layout->text[rest] == '#' && rest > slot->tail)
        slot->tail_end = lx_line_end(layout, rest);
    return slot->tail_end > slot->tail || rest == layout->length || lx_is_break(layout->text[rest]);
}

struct lx_slot lx_find_slot(const struct lx_layout *layout, lx_node_id parent, lx_node_id before, lx_node_id id)
{
    struct lx_slot slot = {.start = child_start(layout, parent, id)};
    size_t lowest = lx_document_node(layout->document, parent)->start;
    slot.alone = starts_line(layout, slot.start);
    if (lx_is_flow(layout, parent)) {
        slot.end = lx_value_end(layout, parent, id);
        slot.alone = find_tail(layout, &slot) && slot.alone;
    } else {
        slot.end = slot.tail = slot.tail_end = lx_block_end(layout, parent, id);
        /* what stands above the topmost key is about the whole; a block has its start where its first child has */
        if (!before)
            lowest = parent == layout->document->root ? slot.start : 0;
    }
    if (before)
        lowest = lx_value_end(layout, parent, before);
    slot.head = slot.alone ? head_of(layout, slot.start, lowest) : slot.start;
    return slot;
}
