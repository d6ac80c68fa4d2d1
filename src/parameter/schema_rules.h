/* SPDX-License-Identifier: MIT */
/* The part of a schema that says what must hold between keys. */
#ifndef LX_PARAMETER_SCHEMA_RULES_H
#define LX_PARAMETER_SCHEMA_RULES_H

#include "../base/json.h"
#include "table.h"

/* Adds the rules of an object's tables as its member allOf, if there are any. */
void lx_add_rules(struct lx_json *json, const struct lx_table *const *tables, size_t count);

/* Adds to a description what rules say about a key that the schema itself cannot enforce, or not in full. */
void lx_describe_rules(struct lx_text *text, const struct lx_table *table, const char *key);

/* Adds as allOf that the second number of an array is greater than the first, at a choice of steps between them. */
void lx_add_rising_pair(struct lx_json *json);

#endif
