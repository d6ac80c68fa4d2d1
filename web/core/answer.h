/* SPDX-License-Identifier: MIT */
/*
 * Answers: what the core hands to the page, JSON that grows in one buffer until the next answer begins.  Numbers are
 * written so that they read back as the same float64; those that JSON has no word for become null.
 *
 * An answer that memory was short for is none: answer_text() is then NULL.
 */
#ifndef WEB_ANSWER_H
#define WEB_ANSWER_H

#include <stdbool.h>
#include <stddef.h>

void answer_begin(void);
const char *answer_text(void);

/* Brackets: '{', '}', '[', ']'.  Commas come by themselves. */
void answer_open(char bracket);
void answer_close(char bracket);

/* The name of a member, which its value must follow. */
void answer_key(const char *key);

void answer_string(const char *text); /* NULL: null */
void answer_number(double number);
void answer_bool(bool truth);
void answer_numbers(const double *numbers, size_t count); /* NULL: null */

/* A member that is a number with the bound of its error. */
void answer_amount(const char *key, double value, double error);

/* The page's translation of English words, or the words themselves; a luxel_translate. */
const char *page_translate(const char *english, void *data);

/* Marks what the page calls. */
#define PAGE_CALLS(name) __attribute__((export_name(#name)))

#endif
