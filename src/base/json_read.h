/* SPDX-License-Identifier: MIT */
/*
 * Reads JSON (RFC 8259) into a tree of values, which points into the text; it is not deeper than a file of ours
 * needs.
 */
#ifndef LX_BASE_JSON_READ_H
#define LX_BASE_JSON_READ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum lx_json_type {
    LX_JSON_NULL,
    LX_JSON_FALSE,
    LX_JSON_TRUE,
    LX_JSON_NUMBER,
    LX_JSON_STRING,
    LX_JSON_LIST,
    LX_JSON_OBJECT
};

struct lx_json_value {
    enum lx_json_type type;
    uint32_t next, child, count; /* of a list or an object: its first value and how many; 0: none */
    const char *key;             /* of a value of an object, without quotes and as it is written */
    size_t key_length;
    const char *text; /* of a string, without quotes and as it is written */
    size_t length;
    double number;
};

/* Value 0 stands for what is not there, 1 is the whole. */
struct lx_json_tree {
    struct lx_json_value *values;
    size_t count, capacity;
    size_t line;        /* where it is no JSON */
    bool out_of_memory; /* or why it was not read */
};

/* False: it is no JSON, or memory ran out; free with lx_json_clear() in any case. */
bool lx_json_parse(const char *text, size_t length, struct lx_json_tree *tree);
void lx_json_clear(struct lx_json_tree *tree);

/* The value of a key; 0: there is none, or no object. */
uint32_t lx_json_find(const struct lx_json_tree *tree, uint32_t object, const char *key);

/* A string as UTF-8, with its escapes resolved, to be freed; NULL: it is none, or memory ran out. */
char *lx_json_string(const struct lx_json_tree *tree, uint32_t value);

#endif
