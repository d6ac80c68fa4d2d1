/* SPDX-License-Identifier: MIT */
/* Writes documents as PDF into a folder, for test_documents_pdf.py; and that what cannot be written is told. */
#include <cairo.h>
#include <stdio.h>
#include <string.h>

#include "base/sink.h"
#include "documents.h"
#include "figure/pages.h"

static int write_one(const char *folder, const char *name, struct luxel_document *document)
{
    char path[4096];
    struct lx_sink *sink;
    snprintf(path, sizeof path, "%s/%s.pdf", folder, name);
    int failed = !document || lx_sink_open(path, NULL, NULL, &sink) != LUXEL_OK;
    if (!failed) {
        failed = lx_pages_write(document, sink, NULL) != LUXEL_OK;
        failed = lx_sink_commit(sink) != LUXEL_OK || failed;
    }
    luxel_document_free(document);
    return failed;
}

/* ---- a drawing, and things that are too large for a page ---- */

static void draw_frame(void *cairo, void *data)
{
    ++*(int *)data;
    cairo_rectangle(cairo, 1, 1, 898, 1998);
    cairo_stroke(cairo);
    cairo_move_to(cairo, 450, 1000);
    cairo_set_font_size(cairo, 60);
    cairo_show_text(cairo, "drawn");
}

static void release(void *data)
{
    *(int *)data += 100;
}

static struct luxel_document *make_large(int *drawn)
{
    const struct lx_drawing drawing = {900, 2000, draw_frame, release, drawn};
    struct luxel_document *document = lx_document_new(NULL);
    struct lx_text words = {0}, sum = {0}, deep = {0};
    if (!document)
        return NULL;
    for (int i = 0; i < 3000; i++)
        lx_text_puts(&words, i % 10 == 9 ? "pneumonoultramicroscopicsilicovolcanoconiosis" : "words ");
    for (int i = 0; i < 200; i++)
        lx_text_puts(&sum, i > 0 ? " + 1.2345678" : "S = 0");
    lx_text_puts(&deep, "\\sqrt{");
    lx_text_puts(&deep, sum.bytes);
    lx_text_puts(&deep, "}");
    lx_document_title(document, "{0}", LX_SPANS(LX_PLAIN("A large one")));
    lx_document_picture(document, NULL, 0, &drawing, "A drawing.", NULL);
    lx_document_formula(document, sum.bytes);
    lx_document_formula(document, deep.bytes);
    lx_document_paragraph(document, "{0} {1}", LX_SPANS(LX_MATH(sum.bytes), LX_PLAIN(words.bytes)));
    lx_document_heading(document, 1, "{0}", LX_SPANS(LX_PLAIN(words.bytes)));
    lx_document_table(document, "lllr");
    for (int i = 0; i < 3; i++)
        lx_document_row(document,
                        LX_SPANS(LX_PLAIN(words.bytes), LX_PLAIN("short"), LX_PLAIN(words.bytes), LX_PLAIN("1.5")),
                        false);
    lx_document_code(document, words.bytes);
    lx_document_table(document, "l");
    lx_document_heading(document, 2, "", NULL);
    lx_document_picture(document, "no PNG", 6, NULL, "", NULL);
    lx_text_clear(&words);
    lx_text_clear(&sum);
    lx_text_clear(&deep);
    return document;
}

static int tells_what_failed(void)
{
    struct luxel_document *document = documents_everything(NULL);
    struct lx_sink *sink;
    int failed = 1;
    if (document && lx_sink_open("/dev/full", NULL, NULL, &sink) == LUXEL_OK) {
        luxel_status written = lx_pages_write(document, sink, NULL), committed = lx_sink_commit(sink);
        failed = written != LUXEL_ERROR_FILE && committed != LUXEL_ERROR_FILE;
    }
    luxel_document_free(document);
    return failed;
}

int main(int count, char **arguments)
{
    const luxel_language russian = {.translate = documents_translate, .code = "ru"};
    int drawn = 0, failed = 0;
    if (count != 2) {
        fputs("usage: write_documents_pdf FOLDER\n", stderr);
        return 2;
    }
    failed += write_one(arguments[1], "english", documents_everything(NULL));
    failed += write_one(arguments[1], "russian", documents_everything(&russian));
    failed += write_one(arguments[1], "hostile", documents_hostile_one(documents_hostile));
    failed += write_one(arguments[1], "long", documents_long(&russian, 80));
    failed += write_one(arguments[1], "empty", lx_document_new(NULL));
    failed += write_one(arguments[1], "large", make_large(&drawn));
    failed += drawn != 101; /* drawn once, and released */
    failed += tells_what_failed();
    return failed > 0 ? 1 : 0;
}
