/* SPDX-License-Identifier: MIT */
/* Documents as text for a terminal: lines of at most 100 columns, tables in columns, formulas in Unicode. */
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "blocks.h"
#include "formula.h"

enum { COLUMNS = 100, GAP = 2 };

static void add_formula(struct lx_text *text, const char *notation)
{
    struct lx_formula *formula = lx_formula_parse(notation, NULL);
    if (formula)
        lx_formula_add_text(text, formula);
    else
        text->failed = true;
    lx_formula_free(formula);
}

void lx_pieces_add_plain(struct lx_text *text, const struct lx_pieces *pieces)
{
    for (size_t i = 0; i < pieces->count; i++) {
        const struct lx_text_piece *piece = &pieces->items[i];
        if (piece->type == LX_SPAN_FORMULA)
            add_formula(text, piece->text);
        else
            lx_text_add_escaped(text, piece->text, strlen(piece->text));
    }
}

/* Signs of East Asia and pictures take two columns. */
static bool is_wide(uint32_t code)
{
    return (code >= 0x1100 && code < 0x1160) || (code >= 0x2e80 && code < 0xa4d0) ||
           (code >= 0xac00 && code < 0xd7a4) || (code >= 0xf900 && code < 0xfb00) ||
           (code >= 0xfe30 && code < 0xfe70) || (code >= 0xff00 && code < 0xff61) ||
           (code >= 0x1f300 && code < 0x1fb00) || (code >= 0x20000 && code < 0x3fffe);
}

size_t lx_width_of(const char *text, size_t length)
{
    size_t columns = 0;
    for (size_t at = 0; at < length;) {
        uint32_t code;
        size_t bytes = lx_next_character(text + at, length - at, &code);
        bool is_mark = (code >= 0x300 && code < 0x370) || (code >= 0x20d0 && code < 0x2100);
        columns += bytes > 0 && is_mark ? 0 : bytes > 0 && is_wide(code) ? 2 : 1;
        at += bytes > 0 ? bytes : 1;
    }
    return columns;
}

/* Words between blanks, wrapped; the first line has `first` before it, the others `later`. */
static void add_wrapped(struct lx_text *text, const char *words, const char *first, const char *later)
{
    size_t column = lx_width_of(first, strlen(first));
    bool begins = true;
    lx_text_puts(text, first);
    while (*words) {
        size_t length = strcspn(words, " "), width = lx_width_of(words, length);
        if (!begins && column + 1 + width > COLUMNS) {
            lx_text_puts(text, "\n");
            lx_text_puts(text, later);
            column = lx_width_of(later, strlen(later));
            begins = true;
        }
        if (!begins) {
            lx_text_puts(text, " ");
            column++;
        }
        lx_text_add(text, words, length);
        column += width;
        begins = false;
        words += length + (words[length] == ' ');
    }
    lx_text_puts(text, "\n");
}

static void add_pieces(struct lx_text *text, const struct lx_pieces *pieces, const char *first, const char *later)
{
    struct lx_text words = {0};
    lx_pieces_add_plain(&words, pieces);
    if (*first == '[')
        lx_text_puts(&words, "]");
    add_wrapped(text, words.bytes ? words.bytes : "", first, later);
    text->failed = text->failed || words.failed;
    lx_text_clear(&words);
}

/* Lines each indented by the same. */
static void add_indented(struct lx_text *text, const char *lines)
{
    while (*lines) {
        size_t length = strcspn(lines, "\n");
        lx_text_puts(text, length > 0 ? "    " : "");
        lx_text_add_escaped(text, lines, length);
        lx_text_puts(text, "\n");
        lines += length + (lines[length] == '\n');
    }
}

/* ---- tables ---- */

/* The cells of a table as plain texts, rows x columns, with the widths of the columns. */
struct cells {
    char **texts;
    size_t *widths;
    size_t rows, columns;
};

static void clear_cells(struct cells *cells)
{
    for (size_t i = 0; cells->texts && i < cells->rows * cells->columns; i++)
        free(cells->texts[i]);
    free(cells->texts);
    free(cells->widths);
}

static bool make_cells(const struct lx_block *table, struct cells *cells)
{
    *cells = (struct cells){.rows = table->row_count, .columns = lx_block_columns(table)};
    cells->texts = lx_new_array(cells->rows * cells->columns + 1, sizeof *cells->texts);
    cells->widths = lx_new_array(cells->columns + 1, sizeof *cells->widths);
    if (!cells->texts || !cells->widths)
        return false;
    for (size_t r = 0; r < cells->rows; r++)
        for (size_t c = 0; c < cells->columns; c++) {
            struct lx_text text = {0};
            lx_text_puts(&text, c == 0 && table->rows[r].marked ? "→ " : "");
            lx_pieces_add_plain(&text, &table->rows[r].cells[c]);
            char *taken = text.bytes || text.failed ? lx_text_take(&text) : lx_copy_text("", 0);
            if (!taken)
                return false;
            size_t width = lx_width_of(taken, strlen(taken));
            cells->texts[r * cells->columns + c] = taken;
            cells->widths[c] = width > cells->widths[c] ? width : cells->widths[c];
        }
    return true;
}

/* As much of a text as fits, up to a blank; what is left stands behind *text. */
static size_t take_line(const char **text, size_t room)
{
    size_t fits = 0;
    for (size_t at = 0;; at++) {
        if ((*text)[at] != ' ' && (*text)[at])
            continue;
        if (fits > 0 && lx_width_of(*text, at) > room)
            break;
        fits = at;
        if (!(*text)[at])
            break;
    }
    const char *rest = *text + fits;
    *text = rest + (*rest == ' ');
    return fits;
}

static void add_cell(struct lx_text *text, const char *bytes, size_t length, size_t width, bool right, bool last)
{
    size_t used = lx_width_of(bytes, length), blanks = used < width ? width - used : 0;
    if (right)
        lx_text_fill(text, ' ', blanks);
    lx_text_add(text, bytes, length);
    if (!right && !last)
        lx_text_fill(text, ' ', blanks);
    if (!last)
        lx_text_fill(text, ' ', GAP);
}

static void trim_line(struct lx_text *text)
{
    while (text->length > 0 && text->bytes[text->length - 1] == ' ')
        text->bytes[--text->length] = '\0';
}

/* A row in as many lines as its cells need; takes the texts apart. */
static void add_row(struct lx_text *text, const struct lx_block *table, const struct cells *cells, size_t row,
                    const char **rests)
{
    bool more = true;
    for (size_t c = 0; c < cells->columns; c++)
        rests[c] = cells->texts[row * cells->columns + c];
    while (more) {
        more = false;
        for (size_t c = 0; c < cells->columns; c++) {
            const char *cell = rests[c];
            size_t length = take_line(&rests[c], cells->widths[c]);
            add_cell(text, cell, length, cells->widths[c], table->text[c] == 'r', c + 1 == cells->columns);
            more = more || *rests[c];
        }
        trim_line(text);
        lx_text_puts(text, "\n");
    }
}

static void add_rule(struct lx_text *text, const struct cells *cells)
{
    for (size_t c = 0; c < cells->columns; c++) {
        lx_text_fill(text, ' ', c > 0 ? GAP : 0);
        for (size_t i = 0; i < cells->widths[c]; i++)
            lx_text_puts(text, "─");
    }
    lx_text_puts(text, "\n");
}

static void add_table(struct lx_text *text, const struct lx_block *table)
{
    struct cells cells;
    const char **rests = NULL;
    if (make_cells(table, &cells) && (rests = lx_new_array(cells.columns + 1, sizeof *rests)) != NULL) {
        size_t room = lx_table_room(table->text, cells.widths, COLUMNS, GAP);
        for (size_t c = 0; c < cells.columns; c++)
            if (table->text[c] == 'l' && cells.widths[c] > room)
                cells.widths[c] = room;
        for (size_t r = 0; r < cells.rows; r++) {
            add_row(text, table, &cells, r, rests);
            if (r == 0)
                add_rule(text, &cells);
        }
    } else {
        text->failed = true;
    }
    free(rests);
    clear_cells(&cells);
}

/* ---- blocks ---- */

static void add_heading(struct lx_text *text, const struct lx_block *heading)
{
    struct lx_text words = {0};
    lx_pieces_add_plain(&words, &heading->words);
    size_t width = words.bytes ? lx_width_of(words.bytes, words.length) : 0;
    add_wrapped(text, words.bytes ? words.bytes : "", "", "");
    for (size_t i = 0; i < width && i < COLUMNS; i++)
        lx_text_puts(text, heading->level == 1 ? "═" : "─");
    lx_text_puts(text, "\n");
    text->failed = text->failed || words.failed;
    lx_text_clear(&words);
}

/* A formula's lines, each broken at blanks where it is too long. */
static void add_formula_lines(struct lx_text *text, const char *notation)
{
    struct lx_text lines = {0};
    add_formula(&lines, notation);
    for (char *at = lines.bytes; at && *at;) {
        char *end = at + strcspn(at, "\n");
        bool more = *end != '\0';
        *end = '\0';
        add_wrapped(text, at, "    ", "        ");
        at = end + more;
    }
    text->failed = text->failed || lines.failed;
    lx_text_clear(&lines);
}

static void add_block(struct lx_text *text, const struct lx_block *block)
{
    switch (block->type) {
    case LX_BLOCK_HEADING: add_heading(text, block); break;
    case LX_BLOCK_PARAGRAPH: add_pieces(text, &block->words, "", ""); break;
    case LX_BLOCK_ITEM: add_pieces(text, &block->words, "  • ", "    "); break;
    case LX_BLOCK_FORMULA: add_formula_lines(text, block->text); break;
    case LX_BLOCK_CODE: add_indented(text, block->text); break;
    case LX_BLOCK_TABLE: add_table(text, block); break;
    case LX_BLOCK_PICTURE: add_pieces(text, &block->words, "[", " "); break;
    }
}

static void add_cover_lines(struct lx_text *text, const struct luxel_document *document, enum lx_cover_place first,
                            enum lx_cover_place last)
{
    for (int place = (int)first; place <= (int)last; place++)
        for (size_t i = 0; i < document->cover_counts[place]; i++)
            add_pieces(text, &document->covers[place][i], "", "");
}

void lx_document_write_plain(const struct luxel_document *document, struct lx_text *text)
{
    const bool has_cover = lx_document_has_cover(document);
    add_cover_lines(text, document, LX_COVER_HEAD, LX_COVER_ABOVE);
    add_pieces(text, &document->title, "", "");
    add_cover_lines(text, document, LX_COVER_SIDE, LX_COVER_FOOT);
    for (size_t i = 0; i < document->byline_count && !has_cover; i++) {
        const struct lx_pieces byline = {.items = &(struct lx_text_piece){LX_SPAN_PLAIN, document->bylines[i]},
                                         .count = 1};
        add_pieces(text, &byline, "", "");
    }
    for (size_t i = 0; i < document->block_count; i++) {
        bool in_list = i > 0 && document->blocks[i].type == LX_BLOCK_ITEM && lx_block_goes_on(document, i - 1);
        lx_text_puts(text, in_list ? "" : "\n");
        add_block(text, &document->blocks[i]);
    }
}
