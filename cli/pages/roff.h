/* SPDX-License-Identifier: MIT */
/* Text in the language of man pages, whatever characters it has. */
#ifndef LUXEL_CLI_PAGES_ROFF_H
#define LUXEL_CLI_PAGES_ROFF_H

#include <stddef.h>
#include <stdio.h>

/* Prints a text as running text: every character stands for itself, a hyphen may end a line. */
void roff_text(FILE *out, const char *text);
/* A text in bold, as it is typed: hyphens are minus signs. */
void roff_typed(FILE *out, const char *text);
/* A text in italics: a placeholder. */
void roff_placeholder(FILE *out, const char *text);
/* A paragraph of running text. */
void roff_paragraph(FILE *out, const char *text);
/* Lines as they are, indented, such as commands. */
void roff_example(FILE *out, const char *lines);

#endif
