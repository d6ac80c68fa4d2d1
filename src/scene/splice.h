/* SPDX-License-Identifier: MIT */
/* A changed document as the text that it came from, in which only what was changed is written anew. */
#ifndef LX_SCENE_SPLICE_H
#define LX_SCENE_SPLICE_H

#include "../base/text.h"
#include "../parameter/document.h"

enum lx_splice_result {
    LX_SPLICED,
    LX_NOT_SPLICED, /* there is something in the text that it does not know how to change */
    LX_SPLICE_NO_MEMORY
};

/* Whether everything below a node was read from the same source as the node. */
bool lx_is_as_read(const struct lx_document *document, lx_node_id id);

/*
 * Adds the text of a node that was read from `text`, with what was changed below it since.  *json says whether
 * the text is JSON, or meant to be.
 */
enum lx_splice_result lx_splice(const struct lx_document *document, lx_node_id id, const char *text, size_t length,
                                struct lx_text *result, bool *json);

#endif
