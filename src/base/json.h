/* SPDX-License-Identifier: MIT */
/*
 * Writes JSON into a growing text, indented for people: members and elements one after the other, commas and lines
 * where they belong.  A key is NULL inside an array.  Memory that ran out is the text's to tell.
 */
#ifndef LX_BASE_JSON_H
#define LX_BASE_JSON_H

#include "text.h"

struct lx_json {
    struct lx_text *text;
    unsigned depth;
    unsigned line; /* the depth from which on everything stands on one line; 0: nothing does */
    bool comma;    /* whether the next item needs one before it */
};

/* Opens an object or an array: '{' or '['. */
void lx_json_open(struct lx_json *json, const char *key, char bracket);
/* Opens one that stands on one line with all that it holds. */
void lx_json_open_line(struct lx_json *json, const char *key, char bracket);
/* Closes what was opened last and what is around it: "}]}".  The outermost ends its line. */
void lx_json_close(struct lx_json *json, const char *brackets);

/* The text must be UTF-8. */
void lx_json_text(struct lx_json *json, const char *key, const char *value);
/* The number must be finite. */
void lx_json_number(struct lx_json *json, const char *key, double value);
void lx_json_boolean(struct lx_json *json, const char *key, bool value);
/* What is JSON already. */
void lx_json_raw(struct lx_json *json, const char *key, const char *value);

#endif
