/* SPDX-License-Identifier: MIT */
/* Documents as text of our own making: a whole scene tidily, or one value on a line, as YAML or as JSON. */
#ifndef LX_SCENE_TIDY_H
#define LX_SCENE_TIDY_H

#include "../base/text.h"
#include "../parameter/document.h"

/* Adds the document as lines of YAML: what is large in block style, the rest on one line each. */
void lx_write_tidy(struct lx_text *text, const struct lx_document *document);

/* Adds the document so, or with `json` as JSON on one line. */
void lx_write_whole(struct lx_text *text, const struct lx_document *document, bool json);

/* Adds a node and all below it on one line, in flow style; with `json` as JSON, as far as JSON has words for it. */
void lx_write_flow(struct lx_text *text, const struct lx_document *document, lx_node_id id, bool json);

/* Adds a key without its colon, in the quotes that it needs; with `json` always in double quotes. */
void lx_write_key(struct lx_text *text, const char *key, bool json);

#endif
