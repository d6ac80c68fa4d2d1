/* SPDX-License-Identifier: MIT */
/*
 * Where values stand in the text that they were read from.  The places of a document are good for underlining;
 * to change a text one must also know where the colon or dash of a value is, and where a value on several lines
 * really ends: before the comments that belong to what follows.
 */
#ifndef LX_SCENE_LAYOUT_H
#define LX_SCENE_LAYOUT_H

#include "../parameter/document.h"

/* A text and the document that was read from it, all of it. */
struct lx_layout {
    const char *text;
    size_t length;
    const struct lx_document *document;
};

/* The start and the end of the line at a byte; the end is the place of its line break. */
size_t lx_line_start(const struct lx_layout *layout, size_t at);
size_t lx_line_end(const struct lx_layout *layout, size_t at);
/* The first byte from `at` on that is no blank; or that belongs to no blank, line break or comment. */
size_t lx_skip_blanks(const struct lx_layout *layout, size_t at);
size_t lx_skip_space(const struct lx_layout *layout, size_t at);
/* Whether a byte begins a line break; whether there is one between two bytes. */
bool lx_is_break(char c);
bool lx_has_break(const struct lx_layout *layout, size_t start, size_t end);
/* The line break that the text uses. */
const char *lx_line_break(const struct lx_layout *layout);
/* The columns before a byte, a byte order mark not counted. */
size_t lx_column(const struct lx_layout *layout, size_t at);

/* What a node looks like: a key or dash with nothing behind it, a text behind | or >, [...] or {...}. */
bool lx_is_empty(const struct lx_layout *layout, lx_node_id id);
bool lx_is_block_text(const struct lx_layout *layout, lx_node_id id);
bool lx_is_flow(const struct lx_layout *layout, lx_node_id id);

/*
 * The byte behind the colon or dash of a value.  False where a key has no colon, and *at is then the end of
 * the key.
 */
bool lx_find_mark(const struct lx_layout *layout, lx_node_id parent, lx_node_id id, size_t *at);

/* The byte behind a value: behind its last character that is no comment, blank or line break. */
size_t lx_value_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id);
/* The end of the line on which a line may be added to the block that ends with this value. */
size_t lx_block_end(const struct lx_layout *layout, lx_node_id parent, lx_node_id id);

/* Whether every key of the document is in double quotes and all of it in brackets: JSON, or meant to be. */
bool lx_is_json_document(const struct lx_layout *layout);
/* Whether the bytes are exactly one JSON value. */
bool lx_is_json_value(const char *text, size_t length);

#endif
