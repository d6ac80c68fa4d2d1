/* SPDX-License-Identifier: MIT */
/* The blocks of a document as rows of pages. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "page_rows.h"

static const struct lx_page_type title = {.size = 19, .leading = 1.25, .bold = true};
static const struct lx_page_type byline = {.size = 9.6, .leading = 1.45, .faint = true};
static const struct lx_page_type section = {.size = 13.4, .leading = 1.3, .bold = true};
static const struct lx_page_type subsection = {.size = 10.8, .leading = 1.3, .bold = true};
static const struct lx_page_type body = {.size = 9.6, .leading = 1.45};
static const struct lx_page_type code = {.size = 8, .leading = 1.35, .mono = true};
static const struct lx_page_type caption = {.size = 8.6, .leading = 1.36, .faint = true};

static const double INDENT = 13; /* of the words of an item */
static const double INSET = 7;   /* of code in its wash */

static void keep_last(struct lx_pages *pages)
{
    if (pages->count > 0)
        pages->rows[pages->count - 1].stays = true;
}

static void add_words(struct lx_pages *pages, const struct lx_pieces *words, const struct lx_page_type *type, double x,
                      double above)
{
    lx_page_add_lines(pages, lx_page_layout(pages, words, type, pages->width - x), type, x, above);
}

static void add_heading(struct lx_pages *pages, const struct lx_block *heading)
{
    const struct lx_page_type *type = heading->level == 1 ? &section : &subsection;
    size_t first = pages->count;
    struct lx_text words = {0};
    add_words(pages, &heading->words, type, 0, heading->level == 1 ? 20 : 13);
    lx_pieces_add_plain(&words, &heading->words);
    if (!words.bytes && !words.failed)
        return;
    char *outline = lx_text_take(&words);
    pages->failed = pages->failed || !outline;
    if (first == pages->count) {
        free(outline);
        return;
    }
    pages->rows[first].level = heading->level;
    pages->rows[first].outline = outline;
    for (size_t i = first; i < pages->count; i++)
        pages->rows[i].stays = true; /* with what it heads */
}

static void add_item(struct lx_pages *pages, const struct lx_block *item, bool begins)
{
    size_t first = pages->count;
    add_words(pages, &item->words, &body, INDENT, begins ? 6 : 3);
    PangoLayout *bullet = lx_page_plain_layout(pages, "•", &body, 0);
    if (!bullet || first == pages->count || pages->failed)
        return;
    struct lx_page_row *row = &pages->rows[first];
    lx_page_add_text(pages, row, pango_layout_get_line_readonly(bullet, 0), 2, row->texts[0].y);
}

static void add_formula(struct lx_pages *pages, const char *notation)
{
    const struct lx_formula_font type = {pages->context, lx_page_families, body.size * 1.04};
    struct lx_formula *formula = lx_formula_parse(notation, NULL);
    size_t count = 0, taken = 0;
    struct lx_formula_line *lines = formula ? lx_formula_set_lines(&type, formula, pages->width, &count) : NULL;
    pages->failed = pages->failed || !lines;
    lx_formula_free(formula);
    for (; lines && taken < count; taken++) {
        struct lx_page_row *row = lx_page_add_row(pages, LX_ROW_FORMULA);
        if (!row)
            break;
        const struct lx_formula_box *box = &lines[taken].box;
        double scale = lines[taken].scale, strut = 0.8 * body.size;
        double height = fmax(box->height * scale, strut), depth = fmax(box->depth * scale, 0.25 * body.size);
        row->above = taken == 0 ? 8 : 4;
        row->baseline = height;
        row->height = height + depth;
        row->formula = lines[taken];
        row->stays = taken + 1 < count && (taken == 0 || taken + 2 == count);
    }
    for (size_t i = taken; lines && i < count; i++)
        lx_formula_box_clear(&lines[i].box);
    free(lines);
}

/* Keeps rows up to the last on one page if they fit one; what introduces them stays with them if it does so, too. */
static void keep_together(struct lx_pages *pages, size_t first)
{
    double height = 0, introduction = 0;
    for (size_t i = first; i < pages->count; i++)
        height += pages->rows[i].height + (i > first ? pages->rows[i].above : 0);
    for (size_t i = first; i > 0 && pages->rows[i - 1].stays; i--)
        introduction += pages->rows[i - 1].height + pages->rows[i].above;
    if (height > pages->room)
        return;
    for (size_t i = first; i + 1 < pages->count; i++)
        pages->rows[i].stays = true;
    if (first > 0 && introduction + height > pages->room)
        pages->rows[first - 1].stays = false;
}

static void add_code(struct lx_pages *pages, const char *text)
{
    PangoLayout *layout = lx_page_plain_layout(pages, text, &code, pages->width - 2 * INSET);
    if (!layout)
        return;
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    pango_layout_set_indent(layout, (int)(-2.4 * code.size * PANGO_SCALE)); /* what goes on stands further in */
    size_t first = pages->count;
    lx_page_add_lines(pages, layout, &code, INSET, 10);
    for (size_t i = first; i < pages->count && !pages->failed; i++) {
        struct lx_page_row *row = &pages->rows[i];
        row->is_code = true;
        if (i == first)
            row->texts[0].y += INSET / 2;
        row->height += (i == first ? INSET / 2 : 0) + (i + 1 == pages->count ? INSET / 2 : 0);
    }
    keep_together(pages, first);
}

struct reader {
    const unsigned char *bytes;
    size_t left;
};

static cairo_status_t read_bytes(void *data, unsigned char *bytes, unsigned count)
{
    struct reader *reader = data;
    if (count > reader->left)
        return CAIRO_STATUS_READ_ERROR;
    memcpy(bytes, reader->bytes, count);
    reader->bytes += count;
    reader->left -= count;
    return CAIRO_STATUS_SUCCESS;
}

/* A picture of which there are only pixels; NULL where they cannot be read. */
static cairo_surface_t *read_image(const struct lx_block *picture)
{
    struct reader reader = {picture->png, picture->png_length};
    cairo_surface_t *image = cairo_image_surface_create_from_png_stream(read_bytes, &reader);
    if (cairo_surface_status(image) == CAIRO_STATUS_SUCCESS)
        return image;
    cairo_surface_destroy(image);
    return NULL;
}

/* The picture as it is drawn if it can be, else its pixels; both no wider than the text and no higher than a page. */
static void add_drawing(struct lx_pages *pages, const struct lx_block *picture)
{
    const double tallest = 560, pixel = 0.75; /* with its caption on one page; of 96 on an inch */
    const struct lx_drawing *drawing = picture->drawing.draw ? &picture->drawing : NULL;
    cairo_surface_t *image = !drawing && picture->png_length > 0 ? read_image(picture) : NULL;
    double width = drawing ? drawing->width_pt : image ? pixel * cairo_image_surface_get_width(image) : 0;
    double height = drawing ? drawing->height_pt : image ? pixel * cairo_image_surface_get_height(image) : 0;
    struct lx_page_row *row = width > 0 && height > 0 ? lx_page_add_row(pages, LX_ROW_PICTURE) : NULL;
    if (!row) {
        cairo_surface_destroy(image);
        return;
    }
    double scale = fmin(1, fmin(pages->width / width, tallest / height));
    row->drawing = drawing;
    row->image = image;
    row->width = width * scale;
    row->height = height * scale;
    row->above = 12;
    row->stays = true;
}

static void add_picture(struct lx_pages *pages, const struct lx_block *picture)
{
    add_drawing(pages, picture);
    size_t first = pages->count;
    add_words(pages, &picture->words, &caption, 0, 6);
    for (size_t i = first; i + 1 < pages->count; i++)
        pages->rows[i].stays = true;
}

static void add_block(struct lx_pages *pages, const struct lx_block *block, bool begins)
{
    switch (block->type) {
    case LX_BLOCK_HEADING: add_heading(pages, block); break;
    case LX_BLOCK_PARAGRAPH: add_words(pages, &block->words, &body, 0, 6); break;
    case LX_BLOCK_ITEM: add_item(pages, block, begins); break;
    case LX_BLOCK_FORMULA: add_formula(pages, block->text); break;
    case LX_BLOCK_CODE: add_code(pages, block->text); break;
    case LX_BLOCK_TABLE: lx_page_add_table(pages, block); break;
    case LX_BLOCK_PICTURE: add_picture(pages, block); break;
    }
}

/* What stands between two blocks belongs to the first of them here. */
static void add_space(struct lx_pages *pages, size_t first, double space)
{
    if (first < pages->count)
        pages->rows[first].above = fmax(pages->rows[first].above, space);
}

static void add_bylines(struct lx_pages *pages)
{
    const struct luxel_document *document = pages->document;
    for (size_t i = 0; i < document->byline_count && !pages->failed; i++)
        lx_page_add_lines(pages, lx_page_plain_layout(pages, document->bylines[i], &byline, pages->width), &byline, 0,
                          i == 0 ? 5 : 0);
}

void lx_page_add_document(struct lx_pages *pages)
{
    const struct luxel_document *document = pages->document;
    const bool has_cover = lx_document_has_cover(document);
    size_t cover = 0;
    if (has_cover) {
        lx_page_add_cover(pages);
        cover = pages->count;
    } else {
        add_words(pages, &document->title, &title, 0, 0);
        add_bylines(pages);
    }
    for (size_t i = 0; i < document->block_count && !pages->failed; i++) {
        const struct lx_block *block = &document->blocks[i];
        size_t first = pages->count;
        bool introduces = i > 0 && document->blocks[i - 1].type == LX_BLOCK_PARAGRAPH &&
                          (block->type == LX_BLOCK_FORMULA || block->type == LX_BLOCK_TABLE ||
                           block->type == LX_BLOCK_CODE || block->type == LX_BLOCK_ITEM);
        if (introduces)
            keep_last(pages);
        add_block(pages, block, i == 0 || !lx_block_goes_on(document, i - 1));
        if (i == 0)
            add_space(pages, first, 16);
        else if (block->type == LX_BLOCK_PARAGRAPH && document->blocks[i - 1].type != LX_BLOCK_HEADING)
            add_space(pages, first, document->blocks[i - 1].type == LX_BLOCK_PARAGRAPH ? 6 : 10);
    }
    if (has_cover && cover < pages->count)
        pages->rows[cover].begins = true;
}
