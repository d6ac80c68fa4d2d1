/* SPDX-License-Identifier: MIT */
/* The tables of a document as one CSV file (RFC 4180): each below a line with its heading, an empty line behind it; and
 * one of them as a file for programs. */
#include <stdlib.h>
#include <string.h>

#include "blocks.h"

static void add_words(struct lx_text *text, const char *words)
{
    const bool is_quoted = strpbrk(words, ",\"\r\n") != NULL;
    lx_text_puts(text, is_quoted ? "\"" : "");
    for (; *words; words++) {
        if (*words == '"')
            lx_text_puts(text, "\"");
        lx_text_add(text, words, 1);
    }
    lx_text_puts(text, is_quoted ? "\"" : "");
}

/* The words of a cell, to be freed; NULL: memory ran out, as the text knows. */
static char *words_of(struct lx_text *text, const struct lx_pieces *pieces)
{
    struct lx_text field = {0};
    lx_text_puts(&field, "");
    lx_pieces_add_plain(&field, pieces);
    char *words = lx_text_take(&field);
    text->failed = text->failed || !words;
    return words;
}

static void add_field(struct lx_text *text, const struct lx_pieces *pieces)
{
    char *words = words_of(text, pieces);
    add_words(text, words ? words : "");
    free(words);
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

/* ---- one table ---- */

static const char BOUND[] = " ± ";

/* Whether some cell of a column has a bound. */
static bool has_bounds(const struct lx_block *table, size_t column, struct lx_text *text)
{
    bool found = false;
    for (size_t r = 1; r < table->row_count && !found; r++) {
        char *words = words_of(text, &table->rows[r].cells[column]);
        found = words && strstr(words, BOUND);
        free(words);
    }
    return found;
}

/* A cell without its bound, and where the column has some that behind it; of the heading the sign. */
static void add_cell(struct lx_text *text, const struct lx_pieces *pieces, bool is_heading, bool is_bounded)
{
    char *words = words_of(text, pieces), *bound = words && !is_heading ? strstr(words, BOUND) : NULL;
    if (bound)
        *bound = 0;
    add_words(text, words && strcmp(words, "–") != 0 ? words : "");
    if (is_bounded)
        lx_text_puts(text, ",");
    if (is_bounded && is_heading && words) {
        struct lx_text heading = {0};
        lx_text_puts(&heading, words);
        lx_text_puts(&heading, *words ? " ±" : "±");
        add_words(text, heading.bytes ? heading.bytes : "");
        text->failed = text->failed || heading.failed;
        lx_text_clear(&heading);
    } else if (bound) {
        add_words(text, bound + strlen(BOUND));
    }
    free(words);
}

void lx_document_write_table(const struct lx_block *table, struct lx_text *text)
{
    const size_t columns = lx_block_columns(table);
    for (size_t r = 0; r < table->row_count; r++) {
        for (size_t c = 0; c < columns; c++) {
            lx_text_puts(text, c > 0 ? "," : "");
            add_cell(text, &table->rows[r].cells[c], r == 0, has_bounds(table, c, text));
        }
        lx_text_puts(text, "\r\n");
    }
}
