/* SPDX-License-Identifier: MIT */
/* Texts of pages: paragraphs by pango, with formulas among their words as shapes about which lines are broken. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "page_rows.h"

/* As in canvas.c, without blanks. */
const char lx_page_families[] = "Noto Serif,DejaVu Serif,Liberation Serif,Cambria,serif";
const char lx_page_mono_families[] = "DejaVu Sans Mono,Noto Sans Mono,Liberation Mono,Consolas,monospace";

#define OBJECT "\xef\xbf\xbc" /* stands for a formula; lines may be broken at both of its sides */
#define JOINER "\xe2\x81\xa0" /* but not where this stands */

/* What a text becomes while its pieces are added. */
struct words {
    struct lx_pages *pages;
    const struct lx_page_type *type;
    struct lx_text text;
    PangoAttrList *attributes;
    double ascent, descent; /* of the font */
};

static void add_attribute(struct words *words, PangoAttribute *attribute, size_t from)
{
    attribute->start_index = (guint)from;
    attribute->end_index = (guint)words->text.length;
    pango_attr_list_insert(words->attributes, attribute);
}

/* Pango copies attributes as it likes; all of them mean the same box. */
struct shared_box {
    struct lx_formula_box box;
    unsigned owners;
};

static void release_box(gpointer data)
{
    struct shared_box *shared = data;
    if (--shared->owners > 0)
        return;
    lx_formula_box_clear(&shared->box);
    free(shared);
}

static gpointer share_box(gconstpointer data)
{
    struct shared_box *shared = (struct shared_box *)data;
    shared->owners++;
    return shared;
}

/* Called by pango where the shape of a formula stands. */
static void draw_box(cairo_t *cairo, PangoAttrShape *attribute, gboolean as_path, gpointer data)
{
    double x, y;
    (void)data;
    if (as_path)
        return;
    cairo_get_current_point(cairo, &x, &y);
    lx_formula_box_draw(cairo, &((const struct shared_box *)attribute->data)->box, x, y);
}

void lx_page_prepare(PangoContext *context, const char *language)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    pango_cairo_context_set_font_options(context, options);
    cairo_font_options_destroy(options);
    pango_cairo_context_set_resolution(context, 72);
    pango_context_set_round_glyph_positions(context, FALSE);
    pango_context_set_language(context, pango_language_from_string(language));
    pango_cairo_context_set_shape_renderer(context, draw_box, NULL, NULL);
}

static void add_box(struct words *words, const struct lx_formula_box *box)
{
    size_t from = words->text.length;
    struct shared_box *kept = lx_new_array(1, sizeof *kept);
    lx_text_puts(&words->text, OBJECT);
    if (!kept || words->text.failed) {
        words->pages->failed = true;
        free(kept);
        return;
    }
    *kept = (struct shared_box){*box, 1};
    /* what is hardly higher than letters does not push lines apart */
    double slack = 0.22 * words->type->size;
    double height = box->height < words->ascent + slack ? words->ascent : box->height;
    double depth = box->depth < words->descent + slack ? words->descent : box->depth;
    PangoRectangle shape = {0, -(int)lround(height * PANGO_SCALE), (int)lround(box->width * PANGO_SCALE),
                            (int)lround((height + depth) * PANGO_SCALE)};
    add_attribute(words, pango_attr_shape_new_with_data(&shape, &shape, kept, share_box, release_box), from);
}

static void add_formula(struct words *words, const char *notation)
{
    const struct lx_formula_font type = {words->pages->context, lx_page_families, words->type->size};
    struct lx_formula *formula = lx_formula_parse(notation, NULL);
    size_t count = 0, added = 0;
    struct lx_formula_box *parts = formula ? lx_formula_set_parts(&type, formula, &count) : NULL;
    words->pages->failed = words->pages->failed || !parts;
    bool joins = words->text.length > 0 && words->text.bytes[words->text.length - 1] != ' ';
    lx_text_puts(&words->text, joins ? JOINER : "");
    for (; parts && added < count && !words->pages->failed; added++) {
        add_box(words, &parts[added]);
        parts[added] = words->pages->failed ? parts[added] : (struct lx_formula_box){0};
    }
    for (size_t i = 0; parts && i < count; i++)
        lx_formula_box_clear(&parts[i]);
    free(parts);
    lx_formula_free(formula);
}

static void add_piece(struct words *words, const struct lx_text_piece *piece, bool after_formula)
{
    size_t from = words->text.length;
    if (piece->type == LX_SPAN_FORMULA) {
        add_formula(words, piece->text);
        return;
    }
    if (after_formula && *piece->text != ' ')
        lx_text_puts(&words->text, JOINER);
    lx_text_add_escaped(&words->text, piece->text, strlen(piece->text));
    if (piece->type == LX_SPAN_STRONG)
        add_attribute(words, pango_attr_weight_new(PANGO_WEIGHT_BOLD), from);
    if (piece->type == LX_SPAN_CODE) {
        add_attribute(words, pango_attr_family_new(lx_page_mono_families), from);
        add_attribute(words, pango_attr_scale_new(0.88), from);
    }
}

static PangoFontDescription *font_of(const struct lx_page_type *type)
{
    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family_static(font, type->mono ? lx_page_mono_families : lx_page_families);
    pango_font_description_set_absolute_size(font, type->size * PANGO_SCALE);
    pango_font_description_set_weight(font, type->bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
    return font;
}

static PangoLayout *finish(struct words *words, double width)
{
    PangoLayout *layout = pango_layout_new(words->pages->context);
    PangoFontDescription *font = font_of(words->type);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    pango_layout_set_text(layout, words->text.bytes ? words->text.bytes : "", (int)words->text.length);
    pango_attr_list_insert(words->attributes, pango_attr_insert_hyphens_new(FALSE)); /* codes would be misread */
    pango_layout_set_attributes(layout, words->attributes);
    if (width > 0) {
        pango_layout_set_width(layout, (int)(width * PANGO_SCALE));
        pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    }
    words->pages->failed = words->pages->failed || words->text.failed;
    lx_text_clear(&words->text);
    pango_attr_list_unref(words->attributes);
    struct lx_pages *pages = words->pages;
    if (lx_reserve(&pages->layouts, &pages->layout_capacity, pages->layout_count + 1, sizeof *pages->layouts) < 0) {
        pages->failed = true;
        g_object_unref(layout);
        return NULL;
    }
    pages->layouts[pages->layout_count++] = layout;
    return layout;
}

static void measure_font(struct words *words)
{
    PangoFontDescription *font = font_of(words->type);
    PangoFontMetrics *metrics = pango_context_get_metrics(words->pages->context, font, NULL);
    words->ascent = (double)pango_font_metrics_get_ascent(metrics) / PANGO_SCALE;
    words->descent = (double)pango_font_metrics_get_descent(metrics) / PANGO_SCALE;
    pango_font_metrics_unref(metrics);
    pango_font_description_free(font);
}

PangoLayout *lx_page_layout(struct lx_pages *pages, const struct lx_pieces *pieces, const struct lx_page_type *type,
                            double width)
{
    struct words words = {.pages = pages, .type = type, .attributes = pango_attr_list_new()};
    measure_font(&words);
    for (size_t i = 0; i < pieces->count; i++)
        add_piece(&words, &pieces->items[i], i > 0 && pieces->items[i - 1].type == LX_SPAN_FORMULA);
    return finish(&words, width);
}

PangoLayout *lx_page_plain_layout(struct lx_pages *pages, const char *text, const struct lx_page_type *type,
                                  double width)
{
    struct words words = {.pages = pages, .type = type, .attributes = pango_attr_list_new()};
    for (bool more = *text; more;) { /* line by line, the ends of which are not to be escaped */
        size_t length = strcspn(text, "\n");
        lx_text_add_escaped(&words.text, text, length);
        text += length + (text[length] == '\n');
        more = *text;
        lx_text_puts(&words.text, more ? "\n" : "");
    }
    return finish(&words, width);
}

/* ---- rows ---- */

struct lx_page_row *lx_page_add_row(struct lx_pages *pages, enum lx_page_row_type type)
{
    if (lx_reserve(&pages->rows, &pages->capacity, pages->count + 1, sizeof *pages->rows) < 0) {
        pages->failed = true;
        return NULL;
    }
    struct lx_page_row *row = &pages->rows[pages->count++];
    *row = (struct lx_page_row){.type = type, .width = pages->width};
    return row;
}

void lx_page_add_text(struct lx_pages *pages, struct lx_page_row *row, PangoLayoutLine *line, double x, double y)
{
    if (lx_reserve(&row->texts, &row->text_capacity, row->text_count + 1, sizeof *row->texts) < 0)
        pages->failed = true;
    else
        row->texts[row->text_count++] = (struct lx_page_text){line, x, y};
}

size_t lx_page_add_lines(struct lx_pages *pages, PangoLayout *layout, const struct lx_page_type *type, double x,
                         double above)
{
    size_t first = pages->count;
    if (!layout)
        return 0;
    PangoLayoutIter *iterator = pango_layout_get_iter(layout);
    do {
        PangoRectangle logical;
        struct lx_page_row *row = lx_page_add_row(pages, LX_ROW_LINE);
        if (!row)
            break;
        pango_layout_iter_get_line_extents(iterator, NULL, &logical);
        double baseline = (double)(pango_layout_iter_get_baseline(iterator) - logical.y) / PANGO_SCALE;
        double height = (double)logical.height / PANGO_SCALE, wanted = type->leading * type->size;
        double lead = height < wanted ? wanted - height : 0.1 * type->size;
        row->above = pages->count - 1 == first ? above : 0;
        row->height = height + lead;
        row->is_faint = type->faint;
        lx_page_add_text(pages, row, pango_layout_iter_get_line_readonly(iterator), x + (double)logical.x / PANGO_SCALE,
                         baseline + lead / 2);
    } while (pango_layout_iter_next_line(iterator));
    pango_layout_iter_free(iterator);
    size_t count = pages->count - first;
    for (size_t i = 0; i + 1 < count; i++) /* no line of a paragraph stands alone on a page */
        pages->rows[first + i].stays = i == 0 || i + 2 == count;
    return count;
}
