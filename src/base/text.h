/* SPDX-License-Identifier: MIT */
/* Text: a growing buffer, characters of UTF-8, escaping of what must not reach a terminal, and likeness of words. */
#ifndef LX_BASE_TEXT_H
#define LX_BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A growing text; start with {0}.  Once memory ran out, `failed` stays set and additions do nothing. */
struct lx_text {
    char *bytes; /* ends with a 0 byte once anything was added */
    size_t length, capacity;
    bool failed;
};

void lx_text_add(struct lx_text *text, const char *bytes, size_t length);
void lx_text_puts(struct lx_text *text, const char *string);
/* Adds so many of one character. */
void lx_text_fill(struct lx_text *text, char character, size_t count);
/* Adds like printf; no floating point (use number.h), so that no locale matters. */
void lx_text_printf(struct lx_text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
/*
 * Adds with control characters (C0, DEL, C1, bytes that are no UTF-8) as \xNN and characters that are
 * invisible or turn the direction of writing as \uNNNN.  Returns how many columns were added.
 */
size_t lx_text_add_escaped(struct lx_text *text, const char *bytes, size_t length);
/* The text as the caller's, to be freed with free(); NULL where memory ran out.  Leaves the buffer empty. */
char *lx_text_take(struct lx_text *text);
void lx_text_clear(struct lx_text *text);

/* How many columns lx_text_add_escaped() adds for the character at the start of the bytes. */
size_t lx_escaped_width(const char *bytes, size_t length);

/* Whether no character of it would be escaped. */
bool lx_is_printable(const char *bytes, size_t length);

/*
 * The character at the start of the bytes: returns how many bytes it takes and sets *code, or returns 0
 * where they are no UTF-8 (overlong forms and surrogates are none).
 */
size_t lx_next_character(const char *bytes, size_t length, uint32_t *code);

/* The number of changed, missing, added or swapped letters between two words, upper and lower case alike. */
unsigned lx_word_distance(const char *a, size_t a_length, const char *b);

/* Keeps the nearest of the words offered; start with {.word = ..., .length = ...}. */
struct lx_nearest {
    const char *word;
    size_t length;
    const char *best; /* NULL: none is near enough to be meant */
    unsigned distance;
};

void lx_nearest_offer(struct lx_nearest *nearest, const char *candidate);

#endif
