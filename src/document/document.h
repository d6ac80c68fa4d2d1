/* SPDX-License-Identifier: MIT */
/*
 * The document that explanations and reports are built as: a list of blocks, which writers turn into text, Markdown,
 * LaTeX and HTML (write_*.c) and the figure room into pages.
 *
 * Texts are English constants, marked with LX_N(), that the document puts into its language as they are added.  What
 * changes in a sentence stands in it as {0}, {1} ... and is given as spans.  Additions to a document whose memory ran
 * out do nothing; lx_document_failed() tells.
 */
#ifndef LX_DOCUMENT_DOCUMENT_H
#define LX_DOCUMENT_DOCUMENT_H

#include <luxel/document.h>

#include "../base/sink.h"
#include "../base/text.h"

/* What stands in for {0}, {1} ... in a sentence, or fills the cell of a table. */
enum lx_span_type {
    LX_SPAN_END,     /* ends an array of spans */
    LX_SPAN_PLAIN,   /* a text as it is: a number, a name of the user */
    LX_SPAN_TERM,    /* an English constant, translated */
    LX_SPAN_CODE,    /* a key, a command, a file: as typed */
    LX_SPAN_FORMULA, /* see formula.h; shown as code if it is not in that notation */
    LX_SPAN_STRONG   /* a translated term that is to be noticed */
};

struct lx_span {
    enum lx_span_type type;
    const char *text;
};

#define LX_PLAIN(text)                                                                                                 \
    {                                                                                                                  \
        LX_SPAN_PLAIN, (text)                                                                                          \
    }
#define LX_TERM_SPAN(english)                                                                                          \
    {                                                                                                                  \
        LX_SPAN_TERM, (english)                                                                                        \
    }
#define LX_CODE(text)                                                                                                  \
    {                                                                                                                  \
        LX_SPAN_CODE, (text)                                                                                           \
    }
#define LX_MATH(formula)                                                                                               \
    {                                                                                                                  \
        LX_SPAN_FORMULA, (formula)                                                                                     \
    }
#define LX_STRONG(english)                                                                                             \
    {                                                                                                                  \
        LX_SPAN_STRONG, (english)                                                                                      \
    }
#define LX_SPANS(...) ((const struct lx_span[]){__VA_ARGS__, {LX_SPAN_END, NULL}})

/* How a picture in a document is drawn: to a cairo context of the given width in points; see figure/. */
struct lx_drawing {
    double width_pt, height_pt;
    void (*draw)(void *cairo, void *data);
    void (*release)(void *data); /* frees data; NULL: nothing to free */
    void *data;
};

/* A document in a language (NULL: English), which is copied.  NULL when memory is short. */
struct luxel_document *lx_document_new(const luxel_language *language);
bool lx_document_failed(const struct luxel_document *document);

/* The translation of an English constant into the document's language. */
const char *lx_document_word(const struct luxel_document *document, const char *english);

/* A text with phrases (base/phrase.h) in the document's language, the caller's; NULL where memory ran out. */
char *lx_document_rendered(const struct luxel_document *document, struct lx_text *text);

/* The document's title; one line each of which may stand below it (author, group, date): plain texts. */
void lx_document_title(struct luxel_document *document, const char *english, const struct lx_span *spans);
void lx_document_byline(struct luxel_document *document, const char *plain);

/* Where a line stands on a title page: above all, above the title, on the right below it, at the foot. */
enum lx_cover_place { LX_COVER_HEAD, LX_COVER_ABOVE, LX_COVER_SIDE, LX_COVER_FOOT, LX_COVER_PLACES };

/* A line of the title page, which takes the place of the lines below the title where there is one. */
void lx_document_cover(struct luxel_document *document, enum lx_cover_place place, const char *english,
                       const struct lx_span *spans);

/* From now on headings are numbered (1, 1.1), and captions of pictures begin with "Fig. 1." */
void lx_document_number(struct luxel_document *document);
/* A heading of level 1 (a section) or 2. */
void lx_document_heading(struct luxel_document *document, int level, const char *english, const struct lx_span *spans);
void lx_document_paragraph(struct luxel_document *document, const char *english, const struct lx_span *spans);
/* An item of a list; items that follow each other are one list. */
void lx_document_item(struct luxel_document *document, const char *english, const struct lx_span *spans);
/* A formula on a line of its own, in the notation of formula.h. */
void lx_document_formula(struct luxel_document *document, const char *formula);
/* Text as typed, line by line, such as a scene; pages do not tear it where it fits one. */
void lx_document_code(struct luxel_document *document, const char *text);

/*
 * A table: `alignment` has a letter, l or r, for each column; the first row is the heading.  Begin, add rows of as many
 * spans, end.  A row that is marked is one to be noticed.
 */
void lx_document_table(struct luxel_document *document, const char *alignment);
/* Names the table that was begun last, for a file of its own; `number` 0: it is the only one of this name. */
void lx_document_name_table(struct luxel_document *document, const char *name, size_t number);
void lx_document_row(struct luxel_document *document, const struct lx_span *cells, bool marked);

/*
 * A picture with a caption, both as a PNG file's bytes (copied) and as a drawing (taken over, released with the
 * document), of which each writer takes what it can show; text and LaTeX name the caption only.
 */
void lx_document_picture(struct luxel_document *document, const void *png, size_t length,
                         const struct lx_drawing *drawing, const char *english, const struct lx_span *spans);

/* Writes a document as luxel_document_write() does, wherever it goes. */
luxel_status lx_document_put(const struct luxel_document *document, const struct lx_destination *destination,
                             luxel_diagnostics *diagnostics);

#endif
