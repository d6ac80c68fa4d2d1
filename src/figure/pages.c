/* SPDX-License-Identifier: MIT */
/* Documents as PDF: rows go to pages, and pages to the sink, with an outline, page numbers and what the file says. */
#include "pages.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cairo-pdf.h>
#include <luxel/version.h>

#include "../base/diagnostics.h"
#include "../base/memory.h"
#include "page_rows.h"
#include "pdf_language.h"

/* A4 and its margins. */
static const double WIDTH = 210 * 72 / 25.4, HEIGHT = 297 * 72 / 25.4;
static const double SIDE = 25 * 72 / 25.4, TOP = 24 * 72 / 25.4, BOTTOM = 26 * 72 / 25.4;

static const double INK[] = {0.08, 0.08, 0.08}, FAINT[] = {0.4, 0.4, 0.4}, WASH[] = {0.955, 0.955, 0.945},
                    MARK[] = {0.99, 0.95, 0.82};

static const struct lx_page_type footer = {.size = 8, .leading = 1.3, .faint = true};

static void set_color(cairo_t *cairo, const double color[3])
{
    cairo_set_source_rgb(cairo, color[0], color[1], color[2]);
}

static void fill(cairo_t *cairo, const double color[3], double x, double y, double width, double height)
{
    set_color(cairo, color);
    cairo_rectangle(cairo, x, y, width, height);
    cairo_fill(cairo);
}

/* ---- rows ---- */

static void draw_picture(cairo_t *cairo, const struct lx_page_row *row, double y)
{
    const struct lx_drawing *drawing = row->drawing;
    cairo_save(cairo);
    cairo_translate(cairo, row->x, y);
    if (drawing) {
        cairo_scale(cairo, row->width / drawing->width_pt, row->height / drawing->height_pt);
        drawing->draw(cairo, drawing->data);
    } else {
        cairo_scale(cairo, row->width / cairo_image_surface_get_width(row->image),
                    row->height / cairo_image_surface_get_height(row->image));
        cairo_set_source_surface(cairo, row->image, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
        cairo_paint(cairo);
    }
    cairo_restore(cairo);
}

static void draw_formula(cairo_t *cairo, const struct lx_page_row *row, double y)
{
    cairo_save(cairo);
    cairo_translate(cairo, row->formula.x, y + row->baseline);
    cairo_scale(cairo, row->formula.scale, row->formula.scale);
    lx_formula_box_draw(cairo, &row->formula.box, 0, 0);
    cairo_restore(cairo);
}

void lx_page_draw_row(const struct lx_pages *pages, cairo_t *cairo, const struct lx_page_row *row, double y)
{
    const double thick = 0.9, thin = 0.5;
    if (row->is_code)
        fill(cairo, WASH, 0, y - 0.05, pages->width, row->height + 0.1);
    if (row->is_marked)
        fill(cairo, MARK, -3, y, row->width + 6, row->height);
    if (row->ruled[0])
        fill(cairo, INK, 0, y - thick, row->width, thick);
    if (row->underlined)
        fill(cairo, INK, 0, y + row->height - thin, row->width, thin);
    if (row->ruled[1])
        fill(cairo, INK, 0, y + row->height, row->width, thick);
    set_color(cairo, row->is_faint ? FAINT : INK);
    for (size_t i = 0; i < row->text_count; i++) {
        cairo_move_to(cairo, row->texts[i].x, y + row->texts[i].y);
        pango_cairo_show_layout_line(cairo, row->texts[i].line);
        cairo_new_path(cairo);
    }
    if (row->type == LX_ROW_FORMULA)
        draw_formula(cairo, row, y);
    if (row->type == LX_ROW_PICTURE)
        draw_picture(cairo, row, y);
}

void lx_pages_clear(struct lx_pages *pages)
{
    for (size_t i = 0; i < pages->count; i++) {
        free(pages->rows[i].texts);
        free(pages->rows[i].outline);
        lx_formula_box_clear(&pages->rows[i].formula.box);
        cairo_surface_destroy(pages->rows[i].image);
    }
    for (size_t i = 0; i < pages->layout_count; i++)
        g_object_unref(pages->layouts[i]);
    free(pages->rows);
    free(pages->layouts);
    if (pages->context)
        g_object_unref(pages->context);
    *pages = (struct lx_pages){0};
}

/* ---- which rows go to which page ---- */

/* The height of the rows that stay together from the i-th on. */
static double height_together(const struct lx_pages *pages, size_t i)
{
    double height = pages->rows[i].height;
    for (; i + 1 < pages->count && pages->rows[i].stays; i++)
        height += pages->rows[i + 1].above + pages->rows[i + 1].height;
    return height;
}

/* Places the rows from `first` on in a page; returns the first that does not fit.  `tops` takes where they stand. */
static size_t fill_page(const struct lx_pages *pages, size_t first, double *tops, double *heading_top)
{
    const struct lx_page_row *begin = &pages->rows[first];
    double y = 0;
    size_t i = first;
    *heading_top = -1;
    if (begin->heading > 0) { /* a table goes on */
        const struct lx_page_row *heading = &pages->rows[begin->heading - 1];
        if (heading->height + begin->height < pages->room) {
            *heading_top = 0;
            y = heading->height;
        }
    }
    for (; i < pages->count; i++) {
        const struct lx_page_row *row = &pages->rows[i];
        double above = i > first ? row->above : 0;
        bool begins_group = i == first || !pages->rows[i - 1].stays;
        double group = begins_group ? height_together(pages, i) : row->height;
        bool fits = y + above + row->height <= pages->room;
        bool group_fits = y + above + group <= pages->room || group > pages->room;
        if (i > first && (!fits || !group_fits || row->begins))
            break;
        tops[i] = y + above;
        y += above + row->height;
    }
    return i;
}

/* ---- pages ---- */

/* The text remembers where memory ran out; cairo 1.16 crashes where a stream of a PDF says so in the middle of it. */
static cairo_status_t collect(void *text, const unsigned char *bytes, unsigned count)
{
    lx_text_add(text, (const char *)bytes, count);
    return CAIRO_STATUS_SUCCESS;
}

static void draw_footer(struct lx_pages *pages, cairo_t *cairo, size_t page, size_t count)
{
    char number[64];
    snprintf(number, sizeof number, "%zu / %zu", page, count);
    if (page == 1 && lx_document_has_cover(pages->document))
        return;
    PangoLayout *right = lx_page_plain_layout(pages, number, &footer, pages->width);
    PangoLayout *left = lx_page_layout(pages, &pages->document->title, &footer, pages->width * 0.8);
    if (!left || !right)
        return;
    pango_layout_set_alignment(right, PANGO_ALIGN_RIGHT);
    pango_layout_set_height(left, -1);
    pango_layout_set_ellipsize(left, PANGO_ELLIPSIZE_END);
    set_color(cairo, FAINT);
    cairo_move_to(cairo, 0, HEIGHT - TOP - BOTTOM + 24);
    pango_cairo_show_layout(cairo, right);
    if (page > 1) { /* the first one has the title itself */
        cairo_move_to(cairo, 0, HEIGHT - TOP - BOTTOM + 24);
        pango_cairo_show_layout(cairo, left);
    }
    cairo_new_path(cairo);
}

/* Headings in the outline, those of the second level below those of the first. */
static void add_outline(cairo_surface_t *surface, const struct lx_page_row *row, size_t page, double y, int *parent)
{
    char place[96];
    snprintf(place, sizeof place, "page=%zu pos=[%d %d]", page, (int)SIDE, (int)fmax(0, TOP + y - 8));
    int made = cairo_pdf_surface_add_outline(surface, row->level == 1 ? CAIRO_PDF_OUTLINE_ROOT : *parent, row->outline,
                                             place, row->level == 1 ? CAIRO_PDF_OUTLINE_FLAG_OPEN : 0);
    if (row->level == 1)
        *parent = made;
}

static bool set_metadata(cairo_surface_t *surface, const struct luxel_document *document)
{
    struct lx_text title = {0}, authors = {0};
    lx_pieces_add_plain(&title, &document->title);
    for (size_t i = 0; i < document->byline_count; i++) {
        lx_text_puts(&authors, i > 0 ? ", " : "");
        lx_text_add_escaped(&authors, document->bylines[i], strlen(document->bylines[i]));
    }
    if (title.bytes)
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, title.bytes);
    if (authors.bytes)
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_AUTHOR, authors.bytes);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "Luxel");
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    bool done = !title.failed && !authors.failed;
    lx_text_clear(&title);
    lx_text_clear(&authors);
    return done;
}

/* Draws all pages, or only counts them (cairo NULL). */
static size_t draw_pages(struct lx_pages *pages, cairo_t *cairo, size_t count, double *tops)
{
    size_t page = 0;
    int parent = CAIRO_PDF_OUTLINE_ROOT;
    for (size_t first = 0, next; first < pages->count; first = next) {
        double heading_top;
        next = fill_page(pages, first, tops, &heading_top);
        page++;
        if (!cairo)
            continue;
        cairo_save(cairo);
        cairo_translate(cairo, SIDE, TOP);
        if (heading_top >= 0)
            lx_page_draw_row(pages, cairo, &pages->rows[pages->rows[first].heading - 1], heading_top);
        for (size_t i = first; i < next; i++) {
            lx_page_draw_row(pages, cairo, &pages->rows[i], tops[i]);
            if (pages->rows[i].outline)
                add_outline(cairo_get_target(cairo), &pages->rows[i], page, tops[i], &parent);
        }
        draw_footer(pages, cairo, page, count);
        cairo_restore(cairo);
        cairo_show_page(cairo);
    }
    return page;
}

luxel_status lx_pages_write(const struct luxel_document *document, struct lx_sink *sink, luxel_diagnostics *diagnostics)
{
    struct lx_pages pages = {
        .document = document, .width = WIDTH - 2 * SIDE, .room = HEIGHT - TOP - BOTTOM, .failed = document->failed};
    struct lx_text pdf = {0};
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(collect, &pdf, WIDTH, HEIGHT);
    cairo_t *cairo = cairo_create(surface);
    double *tops = NULL;
    pages.context = pango_cairo_create_context(cairo);
    lx_page_prepare(pages.context, document->language.code);
    if (!pages.failed)
        lx_page_add_document(&pages);
    if (!pages.failed)
        tops = lx_new_array(pages.count + 1, sizeof *tops);
    if (tops && set_metadata(surface, document))
        draw_pages(&pages, cairo, draw_pages(&pages, NULL, 0, tops), tops);
    else
        pages.failed = true;
    bool failed = pages.failed || cairo_status(cairo) != CAIRO_STATUS_SUCCESS;
    free(tops);
    lx_pages_clear(&pages);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    failed = failed || cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS;
    cairo_surface_destroy(surface);
    lx_pdf_add_language(&pdf, document->language.code ? document->language.code : "en");
    failed = failed || pdf.failed;
    if (!failed)
        lx_sink_write(sink, pdf.bytes, pdf.length);
    lx_text_clear(&pdf);
    return failed ? lx_out_of_memory(diagnostics) : lx_sink_status(sink);
}
