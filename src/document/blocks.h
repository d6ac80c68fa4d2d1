/* SPDX-License-Identifier: MIT */
/* The blocks of a document as its writers see them: texts are in the document's language, formulas in notation. */
#ifndef LX_DOCUMENT_BLOCKS_H
#define LX_DOCUMENT_BLOCKS_H

#include "document.h"

/* A piece of a text: in which the words of a sentence and what stands in for {0}, {1} ... follow each other. */
struct lx_text_piece {
    enum lx_span_type type; /* PLAIN, CODE, FORMULA or STRONG: terms have become plain */
    char *text;
};

struct lx_pieces {
    struct lx_text_piece *items;
    size_t count, capacity;
};

enum lx_block_type {
    LX_BLOCK_HEADING,
    LX_BLOCK_PARAGRAPH,
    LX_BLOCK_ITEM,
    LX_BLOCK_FORMULA,
    LX_BLOCK_CODE,
    LX_BLOCK_TABLE,
    LX_BLOCK_PICTURE
};

struct lx_row {
    struct lx_pieces *cells; /* as many as the table has columns */
    bool marked;
};

struct lx_block {
    enum lx_block_type type;
    int level;              /* of a heading: 1 or 2 */
    struct lx_pieces words; /* of heading, paragraph, item; the caption of a picture */
    char *text;             /* the notation of a formula; code; the alignment of a table, a letter a column */
    struct lx_row *rows;    /* of a table; the first is its heading */
    char name[32];          /* of a table that has one, for a file; else "" */
    size_t row_count, row_capacity;
    unsigned char *png; /* of a picture; NULL: none */
    size_t png_length;
    struct lx_drawing drawing; /* draw is NULL where there is none */
};

struct luxel_document {
    luxel_language language; /* its code is a copy */
    bool failed;             /* memory ran out */
    struct lx_pieces title;
    struct lx_pieces *covers[LX_COVER_PLACES]; /* lines of the title page */
    size_t cover_counts[LX_COVER_PLACES], cover_capacities[LX_COVER_PLACES];
    bool is_numbered;
    unsigned section, subsection, figure; /* the last numbers */
    char **bylines;
    size_t byline_count, byline_capacity;
    struct lx_block *blocks;
    size_t block_count, block_capacity;
};

/* Whether there is a title page. */
bool lx_document_has_cover(const struct luxel_document *document);

/* The columns of a table. */
size_t lx_block_columns(const struct lx_block *table);

/* Whether a block is followed by another of the same type, as items of one list are. */
bool lx_block_goes_on(const struct luxel_document *document, size_t i);

/* The text of pieces as a reader of plain text sees it: formulas in Unicode. */
void lx_pieces_add_plain(struct lx_text *text, const struct lx_pieces *pieces);

/* The columns that a text takes on a terminal; marks above letters take none. */
size_t lx_width_of(const char *text, size_t length);

/*
 * The room of each of the columns of words that must break their lines, of a table whose columns are so wide; those
 * that are no wider fit.  `line` is what there is, `gap` what stands between two columns.
 */
size_t lx_table_room(const char *alignment, const size_t *widths, size_t line, size_t gap);

/* The writers: each adds the whole document. */
void lx_document_write_plain(const struct luxel_document *document, struct lx_text *text);
void lx_document_write_markdown(const struct luxel_document *document, struct lx_text *text);
void lx_document_write_latex(const struct luxel_document *document, struct lx_text *text);
void lx_document_write_html(const struct luxel_document *document, struct lx_text *text);
/* Its tables alone. */
void lx_document_write_csv(const struct luxel_document *document, struct lx_text *text);
/* One of them: where cells of a column have bounds, "609.91 ± 0.22", these are a column of their own behind it, and a
 * cell with no more than a dash is empty. */
void lx_document_write_table(const struct lx_block *table, struct lx_text *text);

/* Adds a formula for LaTeX and its like; in a table of Markdown, | would end the cell. */
void lx_add_tex_formula(struct lx_text *text, const char *notation, bool in_cell);

/* Adds a picture as the address that holds it: data:image/png;base64,... */
void lx_add_data_address(struct lx_text *text, const unsigned char *bytes, size_t length);

#endif
