/* SPDX-License-Identifier: MIT */
/* Documents as one page of HTML 5 without outside links or scripts: formulas as MathML, pictures within. */
#include <string.h>

#include "blocks.h"
#include "formula.h"

static const char style[] =
    ":root{color-scheme:light dark;--ink:#1a1a1a;--ground:#fff;--faint:#666;--line:#d0d0d0;--wash:#f5f5f2;"
    "--mark:#fdf3d0}\n"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e6e6;--ground:#16181a;--faint:#a0a0a0;--line:#3c4044;"
    "--wash:#1f2225;--mark:#3d3516}}\n"
    "body{max-width:48rem;margin:2rem auto;padding:0 1.2rem;font:1rem/1.55 Georgia,'DejaVu Serif',serif;"
    "color:var(--ink);background:var(--ground)}\n"
    "h1{font-size:1.7rem;line-height:1.25;margin:0 0 .4rem}h2{font-size:1.3rem;margin:2.2rem 0 .6rem}"
    "h3{font-size:1.05rem;margin:1.6rem 0 .4rem}\n"
    ".byline{color:var(--faint);margin:0}\n"
    ".cover{text-align:center;margin:0 0 3rem;padding:0 0 2rem;border-bottom:1px solid var(--line)}.cover p{margin:0}"
    ".above{margin:3rem 0 .8rem}.side{text-align:right;margin:3rem 0}\n"
    "table{border-collapse:collapse;margin:1rem 0;font-size:.9rem;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.25rem .9rem .25rem 0;text-align:left;vertical-align:baseline;border-bottom:1px solid var(--line)}"
    "th{border-bottom:2px solid var(--ink);font-weight:600}.r{text-align:right}tr.marked td{background:var(--mark);"
    "font-weight:600}\n"
    ".table{overflow-x:auto}\n"
    "code,pre{font:.85em/1.45 'DejaVu Sans Mono',Consolas,monospace}code{overflow-wrap:break-word}"
    "pre{background:var(--wash);padding:.8rem 1rem;overflow-x:auto}\n"
    "math[display=block]{margin:.7rem 0;padding:.3rem 0;overflow-x:auto;overflow-y:hidden}\n"
    "figure{margin:1.5rem 0}figure img{max-width:100%;height:auto}figcaption{color:var(--faint);font-size:.9rem}\n"
    "@media print{@page{size:A4;margin:20mm}body{max-width:none;margin:0;padding:0;font-size:10.5pt}"
    ".cover{break-after:page;border:0}h2,h3{break-after:avoid}figure,tr,math[display=block]{break-inside:avoid}math["
    "display=block]{overflow:visible}pre{"
    "white-space:pre-wrap}}\n";

static void add_escaped_bytes(struct lx_text *text, const char *plain, size_t length)
{
    struct lx_text printable = {0};
    lx_text_add_escaped(&printable, plain, length);
    for (const char *at = printable.bytes ? printable.bytes : ""; *at; at++)
        switch (*at) {
        case '<': lx_text_puts(text, "&lt;"); break;
        case '>': lx_text_puts(text, "&gt;"); break;
        case '&': lx_text_puts(text, "&amp;"); break;
        case '"': lx_text_puts(text, "&quot;"); break;
        default: lx_text_add(text, at, 1); break;
        }
    text->failed = text->failed || printable.failed;
    lx_text_clear(&printable);
}

static void add_escaped(struct lx_text *text, const char *plain)
{
    add_escaped_bytes(text, plain, strlen(plain));
}

static void add_formula(struct lx_text *text, const char *notation, bool display)
{
    struct lx_formula *formula = lx_formula_parse(notation, NULL);
    lx_text_puts(text, display ? "<math display=\"block\">" : "<math>");
    if (formula)
        lx_formula_add_mathml(text, formula);
    else
        text->failed = true;
    lx_text_puts(text, "</math>");
    lx_formula_free(formula);
}

static void add_element(struct lx_text *text, const char *name, const char *content)
{
    lx_text_printf(text, "<%s>", name);
    add_escaped(text, content);
    lx_text_printf(text, "</%s>", name);
}

static void add_pieces(struct lx_text *text, const struct lx_pieces *pieces)
{
    for (size_t i = 0; i < pieces->count; i++) {
        const struct lx_text_piece *piece = &pieces->items[i];
        switch (piece->type) {
        case LX_SPAN_CODE: add_element(text, "code", piece->text); break;
        case LX_SPAN_STRONG: add_element(text, "strong", piece->text); break;
        case LX_SPAN_FORMULA: add_formula(text, piece->text, false); break;
        default: add_escaped(text, piece->text); break;
        }
    }
}

static void add_wrapped(struct lx_text *text, const char *before, const struct lx_pieces *pieces, const char *after)
{
    lx_text_puts(text, before);
    add_pieces(text, pieces);
    lx_text_puts(text, after);
}

static void add_table(struct lx_text *text, const struct lx_block *table)
{
    lx_text_puts(text, "<div class=\"table\"><table>\n");
    for (size_t r = 0; r < table->row_count; r++) {
        const char *cell = r == 0 ? "th" : "td";
        lx_text_puts(text, r == 0 ? "<thead>" : r == 1 ? "<tbody>\n" : "");
        lx_text_puts(text, table->rows[r].marked ? "<tr class=\"marked\">" : "<tr>");
        for (size_t c = 0; c < lx_block_columns(table); c++) {
            lx_text_printf(text, "<%s%s%s>", cell, r == 0 ? " scope=\"col\"" : "",
                           table->text[c] == 'r' ? " class=\"r\"" : "");
            add_pieces(text, &table->rows[r].cells[c]);
            lx_text_printf(text, "</%s>", cell);
        }
        lx_text_puts(text, r == 0 ? "</tr></thead>\n" : "</tr>\n");
    }
    lx_text_puts(text, table->row_count > 1 ? "</tbody></table></div>\n" : "</table></div>\n");
}

static void add_picture(struct lx_text *text, const struct lx_block *picture)
{
    lx_text_puts(text, "<figure>");
    if (picture->png_length > 0) {
        struct lx_text words = {0};
        lx_text_puts(text, "<img src=\"");
        lx_add_data_address(text, picture->png, picture->png_length);
        lx_text_puts(text, "\" alt=\"");
        lx_pieces_add_plain(&words, &picture->words);
        add_escaped(text, words.bytes ? words.bytes : "");
        text->failed = text->failed || words.failed;
        lx_text_clear(&words);
        lx_text_puts(text, "\" />");
    }
    add_wrapped(text, "<figcaption>", &picture->words, "</figcaption></figure>\n");
}

static void add_block(struct lx_text *text, const struct lx_block *block, size_t number, bool begins, bool ends)
{
    switch (block->type) {
    case LX_BLOCK_HEADING:
        lx_text_printf(text, "<h%d id=\"s%zu\">", block->level + 1, number);
        add_pieces(text, &block->words);
        lx_text_printf(text, "</h%d>\n", block->level + 1);
        break;
    case LX_BLOCK_PARAGRAPH: add_wrapped(text, "<p>", &block->words, "</p>\n"); break;
    case LX_BLOCK_ITEM:
        add_wrapped(text, begins ? "<ul>\n<li>" : "<li>", &block->words, ends ? "</li>\n</ul>\n" : "</li>\n");
        break;
    case LX_BLOCK_FORMULA:
        add_formula(text, block->text, true);
        lx_text_puts(text, "\n");
        break;
    case LX_BLOCK_CODE:
        lx_text_puts(text, "<pre><code>");
        for (const char *at = block->text; *at;) {
            size_t length = strcspn(at, "\n");
            add_escaped_bytes(text, at, length);
            lx_text_puts(text, "\n");
            at += length + (at[length] == '\n');
        }
        lx_text_puts(text, "</code></pre>\n");
        break;
    case LX_BLOCK_TABLE: add_table(text, block); break;
    case LX_BLOCK_PICTURE: add_picture(text, block); break;
    }
}

static void add_cover_lines(struct lx_text *text, const struct luxel_document *document, enum lx_cover_place place)
{
    static const char *const classes[LX_COVER_PLACES] = {"head", "above", "side", "foot"};
    if (document->cover_counts[place] == 0)
        return;
    lx_text_printf(text, "<div class=\"%s\">\n", classes[place]);
    for (size_t i = 0; i < document->cover_counts[place]; i++)
        add_wrapped(text, "<p>", &document->covers[place][i], "</p>\n");
    lx_text_puts(text, "</div>\n");
}

/* The title with the lines below it, or the title page. */
static void add_beginning(struct lx_text *text, const struct luxel_document *document)
{
    const bool has_cover = lx_document_has_cover(document);
    lx_text_puts(text, has_cover ? "<header class=\"cover\">\n" : "");
    add_cover_lines(text, document, LX_COVER_HEAD);
    add_cover_lines(text, document, LX_COVER_ABOVE);
    add_wrapped(text, "<h1>", &document->title, "</h1>\n");
    add_cover_lines(text, document, LX_COVER_SIDE);
    add_cover_lines(text, document, LX_COVER_FOOT);
    lx_text_puts(text, has_cover ? "</header>\n" : "");
    for (size_t i = 0; i < document->byline_count && !has_cover; i++) {
        lx_text_puts(text, "<p class=\"byline\">");
        add_escaped(text, document->bylines[i]);
        lx_text_puts(text, "</p>\n");
    }
}

void lx_document_write_html(const struct luxel_document *document, struct lx_text *text)
{
    struct lx_text title = {0};
    lx_pieces_add_plain(&title, &document->title);
    lx_text_puts(text, "<!DOCTYPE html>\n<html lang=\"");
    add_escaped(text, document->language.code);
    lx_text_puts(text, "\">\n<head>\n<meta charset=\"utf-8\" />\n"
                       "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\" />\n<title>");
    add_escaped(text, title.bytes ? title.bytes : "");
    lx_text_puts(text, "</title>\n<style>\n");
    lx_text_puts(text, style);
    lx_text_puts(text, "</style>\n</head>\n<body>\n");
    add_beginning(text, document);
    for (size_t i = 0; i < document->block_count; i++)
        add_block(text, &document->blocks[i], i, i == 0 || !lx_block_goes_on(document, i - 1),
                  !lx_block_goes_on(document, i));
    lx_text_puts(text, "</body>\n</html>\n");
    text->failed = text->failed || title.failed;
    lx_text_clear(&title);
}
