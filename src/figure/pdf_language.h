/* SPDX-License-Identifier: MIT */
/* The language of a PDF file, by which screen readers choose their voice. */
#ifndef LX_FIGURE_PDF_LANGUAGE_H
#define LX_FIGURE_PDF_LANGUAGE_H

#include "../base/text.h"

/* Says in a file of cairo that its text is in a language ("ru"); what cairo wrote in another way stays as it is. */
void lx_pdf_add_language(struct lx_text *pdf, const char *code);

#endif
