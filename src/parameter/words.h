/* SPDX-License-Identifier: MIT */
/* What a table says, in words: units, ranges, types, choices, key paths.  Those with words have phrases (phrase.h). */
#ifndef LX_PARAMETER_WORDS_H
#define LX_PARAMETER_WORDS_H

#include "../base/text.h"
#include "document.h"
#include "table.h"

/* The unit's sign in UTF-8, "" for none; a phrase. */
const char *lx_unit_word(enum lx_unit unit, bool photometric);

/* Adds "> 0 mm", "0 to 90°", "any" where the range is not given, with phrases. */
void lx_add_range(struct lx_text *text, const struct lx_interval *range, const char *unit);
/* Adds the advised range, "100 to 10000 mm", or ranges: "x -10 to 10, y -10 to 10, z 0 to 10 mm"; with phrases. */
void lx_add_advised(struct lx_text *text, const struct lx_parameter *parameter, const char *unit);
/* Adds "nodes, centers". */
void lx_add_choices(struct lx_text *text, const char *const *choices);
/* Adds the names of the variants, "point, spot". */
void lx_add_variants(struct lx_text *text, const struct lx_variant *const *variants);
/* Adds the words that a rule asks for, "lambertian or cosine" where the separator is " or ". */
void lx_add_rule_choices(struct lx_text *text, const struct lx_rule *rule, const char *separator);
/* Adds "number", "3 numbers", "true or false" and the like, with phrases. */
void lx_add_type(struct lx_text *text, const struct lx_parameter *parameter);
/* Adds a value as the user wrote it, shortened and escaped: 5, "5", [...], {...}; with phrases. */
void lx_add_found(struct lx_text *text, const struct lx_document *document, lx_node_id id);

/* A way from the scene to a value: a chain of keys and list indices on the stack of who walks it. */
struct lx_step {
    const struct lx_step *up;
    const char *key; /* NULL: the index counts */
    size_t index;
};

/* Adds "lights[0].intensity". */
void lx_add_path(struct lx_text *text, const struct lx_step *step);
/* Adds only its last key and the indices behind it: "center[1]". */
void lx_add_path_end(struct lx_text *text, const struct lx_step *step);

#endif
