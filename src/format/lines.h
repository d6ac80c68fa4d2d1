/* SPDX-License-Identifier: MIT */
/* For the readers of texts in which # begins a comment: their lines and words. */
#ifndef LX_FORMAT_LINES_H
#define LX_FORMAT_LINES_H

#include <stdbool.h>
#include <stddef.h>

enum { LX_JOINED_LINES = '\v' /* stands where a line goes on on the next one */ };

/* The lines of a text without comments and those that are blank; next and end are set at first. */
struct lx_lines {
    const char *next, *end; /* what follows the line */
    const char *at, *stop;  /* what is left of it */
    size_t line, joined;    /* its number, from 1 on, and how many it goes on on */
};

bool lx_is_blank(char c);
bool lx_next_line(struct lx_lines *lines);
/* The next word of the line; false where there is none. */
bool lx_next_word(struct lx_lines *lines, const char **word, size_t *length);
bool lx_word_is(const char *word, size_t length, const char *wanted);
bool lx_is_word(const char *word, size_t length, const char *wanted); /* in whatever case */

#endif
