/* SPDX-License-Identifier: MIT */
/* Documents as CommonMark with tables; formulas between dollars, as most readers of Markdown show them. */
#include <string.h>

#include "blocks.h"

/* Characters that mean something in Markdown, with a backslash; ends of lines as blanks. */
static void add_escaped(struct lx_text *text, const char *plain)
{
    struct lx_text printable = {0};
    lx_text_add_escaped(&printable, plain, strlen(plain));
    for (const char *at = printable.bytes ? printable.bytes : ""; *at; at++) {
        if (strchr("\\`*_{}[]<>#|$~&", *at))
            lx_text_puts(text, "\\");
        lx_text_add(text, at, 1);
    }
    text->failed = text->failed || printable.failed;
    lx_text_clear(&printable);
}

/* Code within a line: between more backquotes than it has in a row. */
static void add_code(struct lx_text *text, const char *code)
{
    size_t longest = 0;
    for (const char *at = code; (at = strchr(at, '`')) != NULL;) {
        size_t run = strspn(at, "`");
        longest = run > longest ? run : longest;
        at += run;
    }
    const char *blank = longest > 0 ? " " : "";
    lx_text_fill(text, '`', longest + 1);
    lx_text_puts(text, blank);
    lx_text_add_escaped(text, code, strlen(code));
    lx_text_puts(text, blank);
    lx_text_fill(text, '`', longest + 1);
}

/* Where pieces stand: in a table a | would part cells, and words that are strong anyway take no stars of their own. */
enum place { IN_TEXT, IN_CELL, IN_MARKED_CELL };

static void add_placed(struct lx_text *text, const struct lx_pieces *pieces, enum place place)
{
    for (size_t i = 0; i < pieces->count; i++) {
        const struct lx_text_piece *piece = &pieces->items[i];
        const char *stars = piece->type == LX_SPAN_STRONG && place != IN_MARKED_CELL ? "**" : "";
        switch (piece->type) {
        case LX_SPAN_CODE: add_code(text, piece->text); break;
        case LX_SPAN_FORMULA:
            lx_text_puts(text, "$");
            lx_add_tex_formula(text, piece->text, place != IN_TEXT);
            lx_text_puts(text, "$");
            break;
        default:
            lx_text_puts(text, stars);
            add_escaped(text, piece->text);
            lx_text_puts(text, stars);
            break;
        }
    }
}

static void add_pieces(struct lx_text *text, const struct lx_pieces *pieces)
{
    add_placed(text, pieces, IN_TEXT);
}

/* A paragraph may begin with what would make it something else: a sign of a list or a number with a point. */
static void add_paragraph(struct lx_text *text, const struct lx_pieces *pieces)
{
    struct lx_text words = {0};
    add_pieces(&words, pieces);
    const char *at = words.bytes ? words.bytes + strspn(words.bytes, " ") : "";
    size_t digits = strspn(at, "0123456789");
    if ((*at && strchr("+-=", *at)) || (digits > 0 && (at[digits] == '.' || at[digits] == ')'))) {
        lx_text_add(text, at, digits);
        lx_text_puts(text, "\\");
        at += digits;
    }
    lx_text_puts(text, at);
    lx_text_puts(text, "\n");
    text->failed = text->failed || words.failed;
    lx_text_clear(&words);
}

/* Cells are parted by |, which must not stand in code as it is; in words and formulas it does not any more. */
static void add_cell(struct lx_text *text, const struct lx_pieces *pieces, bool marked)
{
    struct lx_text cell = {0};
    if (pieces->count == 0)
        return;
    add_placed(&cell, pieces, marked ? IN_MARKED_CELL : IN_CELL);
    const char *before = "";
    lx_text_puts(text, marked ? "**" : "");
    for (const char *at = cell.bytes ? cell.bytes : ""; *at; before = at++) {
        if (*at == '|' && *before != '\\')
            lx_text_puts(text, "\\");
        lx_text_add(text, at, 1);
    }
    lx_text_puts(text, marked ? "**" : "");
    text->failed = text->failed || cell.failed;
    lx_text_clear(&cell);
}

static void add_table(struct lx_text *text, const struct lx_block *table)
{
    size_t columns = lx_block_columns(table);
    for (size_t r = 0; r < table->row_count; r++) {
        lx_text_puts(text, "|");
        for (size_t c = 0; c < columns; c++) {
            lx_text_puts(text, " ");
            add_cell(text, &table->rows[r].cells[c], table->rows[r].marked);
            lx_text_puts(text, " |");
        }
        lx_text_puts(text, r == 0 ? "\n|" : "\n");
        for (size_t c = 0; r == 0 && c < columns; c++)
            lx_text_puts(text, table->text[c] == 'r' ? " ---: |" : " --- |");
        lx_text_puts(text, r == 0 ? "\n" : "");
    }
}

/* A fence longer than any row of backquotes in it. */
static void add_block_of_code(struct lx_text *text, const char *code)
{
    size_t fence = 3;
    for (const char *at = code; (at = strchr(at, '`')) != NULL;) {
        size_t run = strspn(at, "`");
        fence = run >= fence ? run + 1 : fence;
        at += run;
    }
    lx_text_fill(text, '`', fence);
    lx_text_puts(text, "yaml\n");
    while (*code) {
        size_t length = strcspn(code, "\n");
        lx_text_add_escaped(text, code, length);
        lx_text_puts(text, "\n");
        code += length + (code[length] == '\n');
    }
    lx_text_fill(text, '`', fence);
    lx_text_puts(text, "\n");
}

static void add_picture(struct lx_text *text, const struct lx_block *picture)
{
    lx_text_puts(text, picture->png_length > 0 ? "![" : "*");
    add_pieces(text, &picture->words);
    if (picture->png_length > 0) {
        lx_text_puts(text, "](");
        lx_add_data_address(text, picture->png, picture->png_length);
        lx_text_puts(text, ")\n\n*");
        add_pieces(text, &picture->words);
    }
    lx_text_puts(text, "*\n");
}

static void add_block(struct lx_text *text, const struct lx_block *block)
{
    switch (block->type) {
    case LX_BLOCK_HEADING:
        lx_text_puts(text, block->level == 1 ? "## " : "### ");
        add_pieces(text, &block->words);
        lx_text_puts(text, "\n");
        break;
    case LX_BLOCK_PARAGRAPH: add_paragraph(text, &block->words); break;
    case LX_BLOCK_ITEM:
        lx_text_puts(text, "- ");
        add_paragraph(text, &block->words);
        break;
    case LX_BLOCK_FORMULA: {
        bool lines = strstr(block->text, "\\\\") || strchr(block->text, '&');
        lx_text_puts(text, lines ? "$$\n\\begin{aligned}\n" : "$$\n");
        lx_add_tex_formula(text, block->text, false);
        lx_text_puts(text, lines ? "\n\\end{aligned}\n$$\n" : "\n$$\n");
        break;
    }
    case LX_BLOCK_CODE: add_block_of_code(text, block->text); break;
    case LX_BLOCK_TABLE: add_table(text, block); break;
    case LX_BLOCK_PICTURE: add_picture(text, block); break;
    }
}

/* Lines of a title page, each a paragraph. */
static void add_cover_lines(struct lx_text *text, const struct luxel_document *document, enum lx_cover_place place,
                            const char *before, const char *after)
{
    for (size_t i = 0; i < document->cover_counts[place]; i++) {
        lx_text_puts(text, before);
        add_paragraph(text, &document->covers[place][i]);
        lx_text_puts(text, after);
    }
}

void lx_document_write_markdown(const struct luxel_document *document, struct lx_text *text)
{
    const bool has_cover = lx_document_has_cover(document);
    add_cover_lines(text, document, LX_COVER_HEAD, "", "\n");
    add_cover_lines(text, document, LX_COVER_ABOVE, "", "\n");
    lx_text_puts(text, "# ");
    add_pieces(text, &document->title);
    lx_text_puts(text, "\n");
    add_cover_lines(text, document, LX_COVER_SIDE, "\n", "");
    add_cover_lines(text, document, LX_COVER_FOOT, "\n", "");
    for (size_t i = 0; i < document->byline_count && !has_cover; i++) {
        lx_text_puts(text, i == 0 ? "\n" : "");
        add_escaped(text, document->bylines[i]);
        lx_text_puts(text, i + 1 < document->byline_count ? "\\\n" : "\n");
    }
    for (size_t i = 0; i < document->block_count; i++) {
        bool in_list = i > 0 && document->blocks[i].type == LX_BLOCK_ITEM && lx_block_goes_on(document, i - 1);
        lx_text_puts(text, in_list ? "" : "\n");
        add_block(text, &document->blocks[i]);
    }
}
