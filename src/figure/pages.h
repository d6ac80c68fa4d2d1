/* SPDX-License-Identifier: MIT */
/* Documents as pages: A4 in PDF, with typeset formulas, tables and the pictures' drawings. */
#ifndef LX_FIGURE_PAGES_H
#define LX_FIGURE_PAGES_H

#include "../base/sink.h"
#include "../document/blocks.h"

/*
 * Writes the pages; the same document gives the same bytes.  LUXEL_ERROR_MEMORY, or what the sink fails with.
 */
luxel_status lx_pages_write(const struct luxel_document *document, struct lx_sink *sink,
                            luxel_diagnostics *diagnostics);

#endif
