/* SPDX-License-Identifier: MIT */
/* What the tests of documents share: documents with everything that one may hold. */
#ifndef TEST_DOCUMENTS_H
#define TEST_DOCUMENTS_H

#include "document/document.h"

/* A picture of 4 x 4 pixels. */
extern const unsigned char documents_png[];
extern const size_t documents_png_length;

/* Words of a user that mean something in some format or other. */
extern const char documents_hostile[];

/* A language of a few words, as of documents_everything(). */
const char *documents_translate(const char *english, void *data);

/* Formulas of every kind, NULL at the end. */
extern const char *const documents_formulas[];

/* A document with a block of every type; NULL when memory is short. */
struct luxel_document *documents_everything(const luxel_language *language);

/* A document with these words of a user in every place that takes words. */
struct luxel_document *documents_hostile_one(const char *words);

/* So long that it takes pages: paragraphs, a table of `rows` rows, long formulas, code. */
struct luxel_document *documents_long(const luxel_language *language, size_t rows);

#endif
