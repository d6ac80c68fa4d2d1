/* SPDX-License-Identifier: MIT */
/* Reading YAML text, and so JSON, into a document. */
#ifndef LX_SCENE_YAML_H
#define LX_SCENE_YAML_H

#include "../parameter/document.h"

/*
 * Reads the bytes of a source from `start` on as one YAML document, nested `depth` levels deep in what is there
 * already, and sets *root to its topmost node, 0 where there is nothing but space and comments (the document's
 * own root stays as it is).  LUXEL_ERROR_SCENE: malformed or beyond the limits, and reported.  LUXEL_ERROR_MEMORY.
 */
luxel_status lx_yaml_read(struct lx_document *document, size_t source, size_t start, unsigned depth,
                          luxel_diagnostics *diagnostics, lx_node_id *root);

/*
 * Reads a text as a document of its own, which starts as {0}, root included; nothing is reported.  The document is to
 * be cleared in any case.  LUXEL_ERROR_SCENE, LUXEL_ERROR_MEMORY.
 */
luxel_status lx_yaml_read_text(const char *text, size_t length, struct lx_document *document);

#endif
