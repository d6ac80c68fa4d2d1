/* SPDX-License-Identifier: MIT */
/*
 * Pages are made of rows: lines of text or formula, rows of tables, pictures, each as high as it is and in its order.
 * Lengths are points.
 */
#ifndef LX_FIGURE_PAGE_ROWS_H
#define LX_FIGURE_PAGE_ROWS_H

#include "../document/blocks.h"
#include "formula_box.h"

enum lx_page_row_type { LX_ROW_LINE, LX_ROW_FORMULA, LX_ROW_CELLS, LX_ROW_PICTURE };

/* A piece of text at a place of a row: of its left edge, and its baseline below the row's top. */
struct lx_page_text {
    PangoLayoutLine *line;
    double x, y;
};

struct lx_page_row {
    enum lx_page_row_type type;
    double above;  /* space before it, but not at the top of a page */
    double height; /* of the row */
    double x, width;
    bool stays;      /* on the same page as the next one */
    bool begins;     /* a page */
    bool is_faint;   /* grey rather than black */
    bool is_code;    /* on a wash */
    bool is_marked;  /* on a wash that is to be noticed */
    bool ruled[2];   /* thick lines of a table above and below */
    bool underlined; /* the thin line below a table's heading */
    size_t heading;  /* of a row of a table: which row heads it, counted from 1; it stands on each new page */
    int level;       /* of a heading; else 0 */
    char *outline;   /* its words */
    struct lx_page_text *texts; /* of lines and cells */
    size_t text_count, text_capacity;
    struct lx_formula_line formula;
    double baseline;                  /* of a formula, below the row's top */
    const struct lx_drawing *drawing; /* of a picture */
    cairo_surface_t *image;           /* or this, if not NULL */
};

/* Everything that pages are set with, and the rows. */
struct lx_pages {
    const struct luxel_document *document;
    PangoContext *context;
    double width;          /* of the text */
    double room;           /* the height of a page's text */
    PangoLayout **layouts; /* of all texts; the lines of rows are theirs */
    size_t layout_count, layout_capacity;
    struct lx_page_row *rows;
    size_t count, capacity;
    bool failed; /* memory ran out */
};

/* How a text is set. */
struct lx_page_type {
    double size;
    double leading; /* from one line to the next, in parts of the size */
    bool bold, mono, faint;
};

extern const char lx_page_families[], lx_page_mono_families[];

/* Makes a context ready: alike on every device, and with formulas in its texts. */
void lx_page_prepare(PangoContext *context, const char *language);

/* A text of pieces, wrapped in a width (0: not), which lives as long as the pages; NULL when memory is short. */
PangoLayout *lx_page_layout(struct lx_pages *pages, const struct lx_pieces *pieces, const struct lx_page_type *type,
                            double width);
/* A plain text. */
PangoLayout *lx_page_plain_layout(struct lx_pages *pages, const char *text, const struct lx_page_type *type,
                                  double width);

/* A new row, or NULL. */
struct lx_page_row *lx_page_add_row(struct lx_pages *pages, enum lx_page_row_type type);
void lx_page_add_text(struct lx_pages *pages, struct lx_page_row *row, PangoLayoutLine *line, double x, double y);

/* The lines of a layout as rows, `above` before the first; returns how many. */
size_t lx_page_add_lines(struct lx_pages *pages, PangoLayout *layout, const struct lx_page_type *type, double x,
                         double above);

/* The title page. */
void lx_page_add_cover(struct lx_pages *pages);

void lx_page_add_table(struct lx_pages *pages, const struct lx_block *table);

/* All rows of the document. */
void lx_page_add_document(struct lx_pages *pages);

/* Draws a row with its top at y. */
void lx_page_draw_row(const struct lx_pages *pages, cairo_t *cairo, const struct lx_page_row *row, double y);

void lx_pages_clear(struct lx_pages *pages);

#endif
