/* SPDX-License-Identifier: MIT */
/* The tables of a document as one CSV file (RFC 4180): each below a line with its heading, an empty line behind it. */
#include <string.h>

#include "blocks.h"

static void add_field(struct lx_text *text, const struct lx_pieces *pieces)
{
    struct lx_text field = {0};
    lx_pieces_add_plain(&field, pieces);
    const char *words = field.bytes ? field.bytes : "";
    const bool is_quoted = strpbrk(words, ",\"\r\n") != NULL;
    lx_text_puts(text, is_quoted ? "\"" : "");
    for (; *words; words++) {
        if (*words == '"')
            lx_text_puts(text, "\"");
        lx_text_add(text, words, 1);
    }
    lx_text_puts(text, is_quoted ? "\"" : "");
    text->failed = text->failed || field.failed;
    lx_text_clear(&field);
}

static void add_row(struct lx_text *text, const struct lx_pieces *cells, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        lx_text_puts(text, i > 0 ? "," : "");
        add_field(text, &cells[i]);
    }
    lx_text_puts(text, "\r\n");
}

void lx_document_write_csv(const struct luxel_document *document, struct lx_text *text)
{
    const struct lx_block *heading = NULL;
    for (size_t i = 0; i < document->block_count; i++) {
        const struct lx_block *block = &document->blocks[i];
        heading = block->type == LX_BLOCK_HEADING ? block : heading;
        if (block->type != LX_BLOCK_TABLE)
            continue;
        if (heading)
            add_row(text, &heading->words, 1);
        for (size_t r = 0; r < block->row_count; r++)
            add_row(text, block->rows[r].cells, lx_block_columns(block));
        lx_text_puts(text, "\r\n");
    }
}
