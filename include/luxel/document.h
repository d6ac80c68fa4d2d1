/* SPDX-License-Identifier: MIT */
/*
 * Documents: headings, paragraphs, formulas, tables and pictures that Luxel writes for people, such as the explanation
 * of a value, in several formats and languages.
 */
#ifndef LUXEL_DOCUMENT_H
#define LUXEL_DOCUMENT_H

#include <luxel/evaluator.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A document; the caller's, freed with luxel_document_free(). */
typedef struct luxel_document luxel_document;

/* The language that a document is written in; NULL stands for English wherever it is asked for. */
typedef struct luxel_language {
    luxel_translate translate; /* from English, as for messages; NULL: English */
    void *data;                /* handed to it */
    const char *code;          /* such as "ru" (BCP 47); NULL: "en" */
    void *reserved[4];         /* for later versions: NULL */
} luxel_language;

/* What a document can be written as. */
typedef enum luxel_document_format {
    LUXEL_DOCUMENT_TEXT,     /* UTF-8 for a terminal: lines of at most 100 columns, formulas in one line of Unicode */
    LUXEL_DOCUMENT_MARKDOWN, /* CommonMark with tables; formulas as $...$ and $$...$$ */
    LUXEL_DOCUMENT_LATEX,    /* a whole document for pdflatex or lualatex, UTF-8 */
    LUXEL_DOCUMENT_HTML      /* one HTML 5 page without outside links; formulas as MathML */
} luxel_document_format;

/* Frees a document; NULL is harmless. */
LUXEL_API void luxel_document_free(luxel_document *document);

/* The document as text of a format; the caller's, freed with luxel_text_free(); NULL when memory is short. */
LUXEL_API char *luxel_document_write_text(const luxel_document *document, luxel_document_format format);

/*
 * Writes the document to a file by the extension of its name: .txt, .md, .tex or .html, whole or not at all.
 * LUXEL_ERROR_ARGUMENT: another extension.  LUXEL_ERROR_FILE: it could not be written.
 */
LUXEL_API luxel_status luxel_document_write(const luxel_document *document, const char *path,
                                            luxel_diagnostics *diagnostics);

/* Whether luxel_document_write() knows the extension of this name; if not, says so in the diagnostics. */
LUXEL_API luxel_status luxel_check_document_name(const char *path, luxel_diagnostics *diagnostics);

/*
 * Explains the value at a point of the screen: every step of the calculation with its formula and the numbers put in,
 * every convention that has a say, and what each other choice of it would give (luxel_find_alternatives()).
 * The document is the caller's.  `settings` and `language` may be NULL.
 * Errors as luxel_probe_screen().
 */
LUXEL_API luxel_status luxel_explain(const luxel_scene *scene, const luxel_settings *settings, double x_mm, double y_mm,
                                     const luxel_language *language, luxel_diagnostics *diagnostics,
                                     luxel_document **document);

#ifdef __cplusplus
}
#endif
#endif
