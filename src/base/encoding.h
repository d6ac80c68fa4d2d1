/* SPDX-License-Identifier: MIT */
/* Encodings of text other than UTF-8 that programs write: UTF-16, the code page 1251, ISO 8859-1. */
#ifndef LX_BASE_ENCODING_H
#define LX_BASE_ENCODING_H

#include <stdbool.h>
#include <stddef.h>

#include "text.h"

enum lx_encoding { LX_UTF8, LX_UTF16_LITTLE, LX_UTF16_BIG };

/*
 * The encoding that the first bytes tell, by a byte order mark or, of UTF-16, by the zeros in every other place of
 * Latin letters; `*mark` is the length of the mark, 0 where there is none.
 */
enum lx_encoding lx_find_encoding(const void *bytes, size_t length, size_t *mark);

/* UTF-8 takes at most so many bytes for a code unit of UTF-16. */
enum { LX_UTF16_GROWTH = 3 };

/*
 * Writes UTF-16 as UTF-8 to `text`, with room for LX_UTF16_GROWTH bytes a unit, and returns the length.  What no
 * character stands for becomes U+FFFD.  Where more units may follow (not `is_last`) the first half of a pair at the
 * end is left: `*used` is the number of units that were taken.
 */
size_t lx_decode_utf16(const unsigned char *units, size_t count, enum lx_encoding encoding, bool is_last, char *text,
                       size_t *used);

/*
 * A whole text of UTF-16 behind a mark of so many bytes as UTF-8, to be freed by the caller; its length takes the place
 * of the old one.  NULL: memory is short, and nothing has changed.
 */
char *lx_text_of_utf16(const char *text, size_t *length, size_t mark, enum lx_encoding encoding);

/* A text as UTF-8 without a mark: itself, with blanks in place of its mark, or another one as above. */
char *lx_text_of_bytes(char *text, size_t *length);

/* Adds a text as UTF-8: as it is where it is UTF-8, else read as code page 1251. */
void lx_add_decoded(struct lx_text *text, const char *bytes, size_t length);

/* Adds a text as UTF-8: as it is where it is UTF-8, else read as ISO 8859-1. */
void lx_add_latin(struct lx_text *text, const char *bytes, size_t length);

#endif
