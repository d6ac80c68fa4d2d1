/* SPDX-License-Identifier: MIT */
/* Documents out: the choice of a writer by format or by the ending of a file, and what several writers add alike. */
#include <string.h>

#include "../base/diagnostics.h"
#include "../base/ending.h"
#include "../base/sink.h"
#include "blocks.h"

enum { LEAST = 12 }; /* columns of a terminal that a column of words is given even where there is none left */

static const char *const endings[] = {".txt", ".md", ".tex", ".html"};

static void (*const writers[])(const struct luxel_document *, struct lx_text *) = {
    [LUXEL_DOCUMENT_TEXT] = lx_document_write_plain,
    [LUXEL_DOCUMENT_MARKDOWN] = lx_document_write_markdown,
    [LUXEL_DOCUMENT_LATEX] = lx_document_write_latex,
    [LUXEL_DOCUMENT_HTML] = lx_document_write_html,
};

char *luxel_document_write_text(const luxel_document *document, luxel_document_format format)
{
    struct lx_text text = {0};
    if (!document || document->failed || (size_t)format >= sizeof writers / sizeof writers[0])
        return NULL;
    writers[format](document, &text);
    return lx_text_take(&text);
}

luxel_status luxel_check_document_name(const char *path, luxel_diagnostics *diagnostics)
{
    size_t found;
    return lx_find_ending(path, endings, sizeof endings / sizeof endings[0], diagnostics, &found);
}

luxel_status lx_document_put(const struct luxel_document *document, const struct lx_destination *destination,
                             luxel_diagnostics *diagnostics)
{
    size_t format;
    luxel_status status =
        lx_find_ending(destination->path, endings, sizeof endings / sizeof endings[0], diagnostics, &format);
    if (status != LUXEL_OK)
        return status;
    char *text = luxel_document_write_text(document, (luxel_document_format)format);
    if (!text)
        return lx_out_of_memory(diagnostics);
    status = lx_sink_put(destination, text, strlen(text), diagnostics);
    luxel_text_free(text);
    return status;
}

luxel_status luxel_document_write(const luxel_document *document, const char *path, luxel_diagnostics *diagnostics)
{
    return lx_document_put(document, &(struct lx_destination){.path = path}, diagnostics);
}

size_t lx_table_room(const char *alignment, const size_t *widths, size_t line, size_t gap)
{
    size_t columns = strlen(alignment), total = 0, room = line, wide = 0, before;
    for (size_t c = 0; c < columns; c++)
        total += widths[c] + (c > 0 ? gap : 0);
    if (total <= line)
        return line;
    room = 0;
    do { /* those that fit leave room to the others */
        size_t taken = 0;
        before = wide;
        wide = 0;
        for (size_t c = 0; c < columns; c++) {
            bool breaks = alignment[c] == 'l' && (room == 0 || widths[c] > room);
            wide += breaks;
            taken += (breaks ? 0 : widths[c]) + (c > 0 ? gap : 0);
        }
        room = wide > 0 && taken < line ? (line - taken) / wide : 0;
        room = room > LEAST ? room : LEAST;
    } while (wide != before && wide > 0);
    return room;
}

void lx_add_tex_formula(struct lx_text *text, const char *notation, bool in_cell)
{
    static const char *const signs[][2] = {{"⊥", "\\perp "}, {"°", "^\\circ "}, {"\\degree", "^\\circ "}};
    enum { COUNT = sizeof signs / sizeof signs[0] };
    while (*notation) {
        size_t i = 0;
        while (i < COUNT && strncmp(notation, signs[i][0], strlen(signs[i][0])) != 0)
            i++;
        if (i < COUNT) {
            lx_text_puts(text, signs[i][1]);
            notation += strlen(signs[i][0]);
            continue;
        }
        if (*notation == '|' && in_cell)
            lx_text_puts(text, "\\vert ");
        else
            lx_text_add(text, notation, 1);
        notation++;
    }
}

void lx_add_data_address(struct lx_text *text, const unsigned char *bytes, size_t length)
{
    static const char signs[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    lx_text_puts(text, "data:image/png;base64,");
    for (size_t i = 0; i < length; i += 3) {
        size_t left = length - i;
        unsigned three =
            (unsigned)bytes[i] << 16 | (left > 1 ? (unsigned)bytes[i + 1] << 8 : 0) | (left > 2 ? bytes[i + 2] : 0);
        char four[4];
        for (int k = 0; k < 4; k++)
            four[k] = (size_t)k <= left ? signs[three >> (18 - 6 * k) & 63] : '=';
        lx_text_add(text, four, sizeof four);
    }
}
