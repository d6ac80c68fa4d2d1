/* SPDX-License-Identifier: MIT */
/* New keys in a mapping of the text, in the style of those that it has. */
#include <string.h>

#include "patch.h"
#include "tidy.h"

/* What the new keys copy from the last one. */
struct style {
    size_t key_start, key_end;
    char quote; /* around keys; 0: none */
    bool tight; /* {"a":1,"b":2} */
};

static struct style style_of(const struct lx_splicer *splicer, lx_node_id last)
{
    struct style style = {.quote = splicer->json ? '"' : 0};
    if (!last)
        return style;
    const struct lx_node *node = lx_document_node(splicer->old.document, last);
    const char *text = splicer->old.text;
    style.key_start = node->key_start;
    style.key_end = node->key_end;
    style.quote = text[node->key_start] == '"' || text[node->key_start] == '\'' ? text[node->key_start] : 0;
    style.tight = style.quote && text[node->key_end] == ':' && !strchr(" \t\r\n", text[node->key_end + 1]);
    return style;
}

/* Adds "key: value". */
static void add_entry(struct lx_splicer *splicer, lx_node_id id, struct lx_where where, const struct style *style,
                      struct lx_text *text)
{
    const char *key = lx_document_key(splicer->document, id);
    if (style->quote == '\'') {
        lx_text_puts(text, "'");
        lx_text_puts(text, key); /* keys that can be set are words */
        lx_text_puts(text, "'");
    } else {
        lx_write_key(text, key, style->quote == '"');
    }
    lx_text_puts(text, style->tight ? ":" : ": ");
    enum lx_splice_result result = lx_add_value(splicer, id, where, text);
    if (result != LX_SPLICED)
        lx_give_up(splicer, result);
}

/* Adds `id` and all that follow it, with `between` between them. */
static void add_entries(struct lx_splicer *splicer, lx_node_id id, struct lx_where where, const struct style *style,
                        const char *between, struct lx_text *text)
{
    for (lx_node_id first = id; id; id = lx_document_node(splicer->document, id)->next) {
        if (id != first)
            lx_text_puts(text, between);
        add_entry(splicer, id, where, style, text);
    }
}

static void insert_lines(struct lx_splicer *splicer, lx_node_id mapping, lx_node_id last, lx_node_id id,
                         struct lx_where where, struct lx_text *text)
{
    struct style style = style_of(splicer, last);
    struct lx_text between = {0};
    style.tight = false;
    lx_text_puts(&between, lx_line_break(&splicer->old));
    lx_text_fill(&between, ' ', (size_t)where.indent);
    if (between.failed) {
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
        return;
    }
    size_t at = lx_block_end(&splicer->old, mapping, last);
    add_entries(splicer, id, where, &style, between.bytes, text);
    lx_patch(splicer, at, at, between.bytes, text->failed ? "" : text->bytes);
    lx_text_clear(&between);
}

/* Into {}, { } or braces around lines and comments. */
static void insert_first(struct lx_splicer *splicer, lx_node_id mapping, lx_node_id id, struct lx_where where,
                         struct lx_text *text)
{
    const struct lx_layout *old = &splicer->old;
    const struct lx_node *node = lx_document_node(old->document, mapping);
    struct style style = style_of(splicer, 0);
    size_t start = node->start + 1, end = node->end - 1;
    bool blank = end > start && lx_skip_blanks(old, start) == end;
    add_entries(splicer, id, where, &style, ", ", text);
    if (blank)
        lx_text_puts(text, " ");
    lx_patch(splicer, start, blank ? end : start, blank ? " " : "", text->failed ? "" : text->bytes);
}

/* Behind the last key, or below it where each has a line of its own. */
static void insert_behind(struct lx_splicer *splicer, lx_node_id mapping, lx_node_id last, lx_node_id id,
                          struct lx_where where, struct lx_text *text)
{
    const struct lx_layout *old = &splicer->old;
    struct style style = style_of(splicer, last);
    size_t end = lx_value_end(old, mapping, last), line = lx_line_start(old, style.key_start);
    size_t comma = lx_skip_blanks(old, end);
    bool has_comma = comma < old->length && old->text[comma] == ',';
    size_t rest = lx_skip_blanks(old, has_comma ? comma + 1 : end);
    bool lines = lx_skip_blanks(old, line) == style.key_start && line > 0 && rest < old->length &&
                 (lx_is_break(old->text[rest]) || old->text[rest] == '#');
    struct lx_text between = {0};
    lx_text_puts(&between, style.tight && !lines ? "," : lines ? "," : ", ");
    if (lines) {
        lx_text_puts(&between, lx_line_break(old));
        lx_text_add(&between, old->text + line, style.key_start - line);
    }
    if (between.failed) {
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
        return;
    }
    add_entries(splicer, id, where, &style, between.bytes, text);
    if (lines && has_comma)
        lx_text_puts(text, ",");
    if (lines && !has_comma)
        lx_patch(splicer, end, end, ",", "");
    size_t at = lines ? lx_line_end(old, rest) : end;
    lx_patch(splicer, at, at, between.bytes + lines, text->failed ? "" : text->bytes);
    lx_text_clear(&between);
}

void lx_insert(struct lx_splicer *splicer, lx_node_id mapping, lx_node_id last, lx_node_id id, struct lx_where where)
{
    struct lx_text text = {0};
    if (lx_document_node(splicer->old.document, mapping)->kind != LX_MAPPING)
        lx_give_up(splicer, LX_NOT_SPLICED);
    else if (!where.flow)
        insert_lines(splicer, mapping, last, id, where, &text);
    else if (last)
        insert_behind(splicer, mapping, last, id, where, &text);
    else
        insert_first(splicer, mapping, id, where, &text);
    if (text.failed)
        lx_give_up(splicer, LX_SPLICE_NO_MEMORY);
    lx_text_clear(&text);
}
