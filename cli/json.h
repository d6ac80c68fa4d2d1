/* SPDX-License-Identifier: MIT */
/*
 * Writes JSON to a stream: members and elements one after the other, commas where they belong.  A key is NULL
 * inside an array.  Numbers have 17 significant digits, so that they read back as the same double.
 */
#ifndef LUXEL_CLI_JSON_H
#define LUXEL_CLI_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct json {
    FILE *stream;
    unsigned depth;
    bool comma; /* whether the next item needs one before it */
};

void json_open(struct json *json, const char *key, char bracket); /* '{' or '[' */
void json_close(struct json *json, char bracket);                 /* '}' or ']'; the outermost ends the line */

void json_null(struct json *json, const char *key);
void json_bool(struct json *json, const char *key, bool value);
void json_whole(struct json *json, const char *key, size_t value);
/* null unless the value is finite */
void json_number(struct json *json, const char *key, double value);
/* null where there is no value */
void json_number_if(struct json *json, const char *key, bool exists, double value);
/* null for NULL; the text must be UTF-8 */
void json_text(struct json *json, const char *key, const char *value);
void json_numbers(struct json *json, const char *key, const double *values, size_t count);
void json_wholes(struct json *json, const char *key, const unsigned *values, size_t count);

#endif
