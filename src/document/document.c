/* SPDX-License-Identifier: MIT */
/* Building documents: blocks are appended, their sentences translated and filled as they come. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/phrase.h"
#include "blocks.h"
#include "formula.h"

static const char *translated(const struct luxel_document *document, const char *english)
{
    if (!*english || !document->language.translate)
        return english; /* gettext("") is the catalogue's header */
    return document->language.translate(english, document->language.data);
}

const char *lx_document_word(const struct luxel_document *document, const char *english)
{
    return translated(document, english);
}

char *lx_document_rendered(const struct luxel_document *document, struct lx_text *text)
{
    if (!text->bytes && !text->failed)
        return lx_copy_text("", 0);
    return lx_text_render(text, document->language.translate, document->language.data);
}

struct luxel_document *lx_document_new(const luxel_language *language)
{
    struct luxel_document *document = lx_new_array(1, sizeof *document);
    const char *code = language && language->code ? language->code : "en";
    if (!document)
        return NULL;
    if (language)
        document->language = *language;
    document->language.code = lx_copy_text(code, strlen(code));
    if (!document->language.code) {
        free(document);
        return NULL;
    }
    return document;
}

static void clear_pieces(struct lx_pieces *pieces)
{
    for (size_t i = 0; i < pieces->count; i++)
        free(pieces->items[i].text);
    free(pieces->items);
    *pieces = (struct lx_pieces){0};
}

size_t lx_block_columns(const struct lx_block *table)
{
    return strlen(table->text);
}

static void clear_block(struct lx_block *block)
{
    for (size_t r = 0; r < block->row_count; r++) {
        for (size_t c = 0; c < lx_block_columns(block); c++)
            clear_pieces(&block->rows[r].cells[c]);
        free(block->rows[r].cells);
    }
    free(block->rows);
    clear_pieces(&block->words);
    free(block->text);
    free(block->png);
    if (block->drawing.release)
        block->drawing.release(block->drawing.data);
}

void luxel_document_free(luxel_document *document)
{
    if (!document)
        return;
    for (size_t i = 0; i < document->block_count; i++)
        clear_block(&document->blocks[i]);
    for (size_t i = 0; i < document->byline_count; i++)
        free(document->bylines[i]);
    for (size_t place = 0; place < LX_COVER_PLACES; place++) {
        for (size_t i = 0; i < document->cover_counts[place]; i++)
            clear_pieces(&document->covers[place][i]);
        free(document->covers[place]);
    }
    free(document->bylines);
    free(document->blocks);
    clear_pieces(&document->title);
    free((char *)document->language.code);
    free(document);
}

bool lx_document_failed(const struct luxel_document *document)
{
    return document->failed;
}

bool lx_block_goes_on(const struct luxel_document *document, size_t i)
{
    return i + 1 < document->block_count && document->blocks[i + 1].type == document->blocks[i].type;
}

/* Whether the notation of a formula can be read; LaTeX and Markdown would hand on whatever it is. */
static bool is_formula(struct luxel_document *document, const char *notation)
{
    size_t at = 0;
    struct lx_formula *formula = lx_formula_parse(notation, &at);
    bool read = formula != NULL;
    document->failed = document->failed || (!read && at == SIZE_MAX);
    lx_formula_free(formula);
    return read;
}

/* ---- pieces ---- */

static void add_piece(struct luxel_document *document, struct lx_pieces *pieces, enum lx_span_type type,
                      const char *bytes, size_t length)
{
    struct lx_text_piece *last = pieces->count > 0 ? &pieces->items[pieces->count - 1] : NULL;
    struct lx_text text = {0};
    if (length == 0 || document->failed)
        return;
    bool joins = last && last->type == LX_SPAN_PLAIN && type == LX_SPAN_PLAIN;
    if (joins)
        lx_text_puts(&text, last->text);
    lx_text_add(&text, bytes, length);
    char *taken = lx_text_take(&text);
    if (!taken || (!joins && lx_reserve((void **)&pieces->items, &pieces->capacity, pieces->count + 1,
                                        sizeof *pieces->items) < 0)) {
        free(taken);
        document->failed = true;
    } else if (joins) {
        free(last->text);
        last->text = taken;
    } else {
        pieces->items[pieces->count++] = (struct lx_text_piece){type, taken};
    }
}

static void add_span(struct luxel_document *document, struct lx_pieces *pieces, const struct lx_span *span)
{
    bool is_term = span->type == LX_SPAN_TERM || span->type == LX_SPAN_STRONG;
    enum lx_span_type type = span->type == LX_SPAN_TERM ? LX_SPAN_PLAIN : span->type;
    if (!span->text) {
        document->failed = true; /* what could not be made for want of memory */
        return;
    }
    const char *text = is_term ? translated(document, span->text) : span->text;
    if (type == LX_SPAN_FORMULA && !is_formula(document, text))
        type = LX_SPAN_CODE;
    add_piece(document, pieces, type, text, strlen(text));
}

/* A sentence of the document's language with its spans in their places. */
static void add_sentence(struct luxel_document *document, struct lx_pieces *pieces, const char *english,
                         const struct lx_span *spans)
{
    const char *at = translated(document, english);
    size_t count = 0;
    while (spans && spans[count].type != LX_SPAN_END)
        count++;
    while (*at) {
        size_t plain = strcspn(at, "{");
        add_piece(document, pieces, LX_SPAN_PLAIN, at, plain);
        at += plain;
        if (!*at)
            return;
        bool is_place = at[1] >= '0' && at[1] <= '9' && at[2] == '}' && (size_t)(at[1] - '0') < count;
        if (is_place)
            add_span(document, pieces, &spans[at[1] - '0']);
        else
            add_piece(document, pieces, LX_SPAN_PLAIN, at, 1);
        at += is_place ? 3 : 1;
    }
}

/* ---- blocks ---- */

static struct lx_block *add_block(struct luxel_document *document, enum lx_block_type type)
{
    if (!document->failed && lx_reserve((void **)&document->blocks, &document->block_capacity,
                                        document->block_count + 1, sizeof *document->blocks) < 0)
        document->failed = true;
    if (document->failed)
        return NULL;
    struct lx_block *block = &document->blocks[document->block_count++];
    *block = (struct lx_block){.type = type};
    return block;
}

static void add_words(struct luxel_document *document, enum lx_block_type type, int level, const char *english,
                      const struct lx_span *spans)
{
    struct lx_block *block = add_block(document, type);
    if (!block)
        return;
    block->level = level;
    add_sentence(document, &block->words, english, spans);
}

static void add_text(struct luxel_document *document, enum lx_block_type type, const char *text)
{
    struct lx_block *block = add_block(document, type);
    if (!block)
        return;
    block->text = lx_copy_text(text, strlen(text));
    if (block->text)
        return;
    document->failed = true;
    document->block_count--;
}

void lx_document_title(struct luxel_document *document, const char *english, const struct lx_span *spans)
{
    clear_pieces(&document->title);
    add_sentence(document, &document->title, english, spans);
}

void lx_document_byline(struct luxel_document *document, const char *plain)
{
    char *copy = lx_copy_text(plain, strlen(plain));
    if (copy && lx_reserve((void **)&document->bylines, &document->byline_capacity, document->byline_count + 1,
                           sizeof *document->bylines) == 0) {
        document->bylines[document->byline_count++] = copy;
        return;
    }
    free(copy);
    document->failed = true;
}

void lx_document_cover(struct luxel_document *document, enum lx_cover_place place, const char *english,
                       const struct lx_span *spans)
{
    struct lx_pieces **lines = &document->covers[place];
    size_t *count = &document->cover_counts[place];
    if (document->failed ||
        lx_reserve((void **)lines, &document->cover_capacities[place], *count + 1, sizeof **lines) < 0) {
        document->failed = true;
        return;
    }
    (*lines)[*count] = (struct lx_pieces){0};
    add_sentence(document, &(*lines)[(*count)++], english, spans);
}

bool lx_document_has_cover(const struct luxel_document *document)
{
    size_t lines = 0;
    for (size_t place = 0; place < LX_COVER_PLACES; place++)
        lines += document->cover_counts[place];
    return lines > 0;
}

void lx_document_number(struct luxel_document *document)
{
    document->is_numbered = true;
}

/* The number of a heading, before its words. */
static void add_number(struct luxel_document *document, struct lx_pieces *words, int level)
{
    char number[32];
    if (!document->is_numbered)
        return;
    if (level == 1) {
        document->subsection = 0;
        snprintf(number, sizeof number, "%u ", ++document->section);
    } else {
        snprintf(number, sizeof number, "%u.%u ", document->section, ++document->subsection);
    }
    add_piece(document, words, LX_SPAN_PLAIN, number, strlen(number));
}

void lx_document_heading(struct luxel_document *document, int level, const char *english, const struct lx_span *spans)
{
    struct lx_block *block = add_block(document, LX_BLOCK_HEADING);
    if (!block)
        return;
    block->level = level;
    add_number(document, &block->words, level);
    add_sentence(document, &block->words, english, spans);
}

void lx_document_paragraph(struct luxel_document *document, const char *english, const struct lx_span *spans)
{
    add_words(document, LX_BLOCK_PARAGRAPH, 0, english, spans);
}

void lx_document_item(struct luxel_document *document, const char *english, const struct lx_span *spans)
{
    add_words(document, LX_BLOCK_ITEM, 0, english, spans);
}

void lx_document_formula(struct luxel_document *document, const char *formula)
{
    add_text(document, is_formula(document, formula) ? LX_BLOCK_FORMULA : LX_BLOCK_CODE, formula);
}

void lx_document_code(struct luxel_document *document, const char *text)
{
    add_text(document, LX_BLOCK_CODE, text);
}

void lx_document_table(struct luxel_document *document, const char *alignment)
{
    add_text(document, LX_BLOCK_TABLE, alignment);
}

void lx_document_name_table(struct luxel_document *document, const char *name, size_t number)
{
    if (document->failed)
        return;
    struct lx_block *table = &document->blocks[document->block_count - 1];
    snprintf(table->name, sizeof table->name, number > 0 ? "%s-%zu" : "%s", name, number);
}

void lx_document_row(struct luxel_document *document, const struct lx_span *cells, bool marked)
{
    if (document->failed || document->block_count == 0)
        return;
    struct lx_block *table = &document->blocks[document->block_count - 1];
    size_t columns = lx_block_columns(table);
    struct lx_pieces *made = lx_new_array(columns, sizeof *made);
    if (!made ||
        lx_reserve((void **)&table->rows, &table->row_capacity, table->row_count + 1, sizeof *table->rows) < 0) {
        free(made);
        document->failed = true;
        return;
    }
    table->rows[table->row_count++] = (struct lx_row){made, marked};
    for (size_t i = 0; i < columns && cells[i].type != LX_SPAN_END; i++)
        add_span(document, &made[i], &cells[i]);
}

void lx_document_picture(struct luxel_document *document, const void *png, size_t length,
                         const struct lx_drawing *drawing, const char *english, const struct lx_span *spans)
{
    struct lx_block *block = add_block(document, LX_BLOCK_PICTURE);
    if (!block) {
        if (drawing && drawing->release)
            drawing->release(drawing->data);
        return;
    }
    if (drawing)
        block->drawing = *drawing;
    if (length > 0) {
        block->png = lx_new_array(length, 1);
        block->png_length = block->png ? length : 0;
        document->failed = document->failed || !block->png;
        if (block->png)
            memcpy(block->png, png, length);
    }
    if (document->is_numbered) {
        char number[16];
        snprintf(number, sizeof number, "%u", ++document->figure);
        add_sentence(document, &block->words, LX_N("Fig. {0}. "), LX_SPANS(LX_PLAIN(number)));
    }
    add_sentence(document, &block->words, english, spans);
}
