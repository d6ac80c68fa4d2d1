/* SPDX-License-Identifier: MIT */
/*
 * luxel-pages: writes what is installed beside the tool from the tool's own tables: the man page, the completions of
 * the shells, and the reference of scene keys.  It runs when the project is built and is not installed itself.
 */
#ifndef LUXEL_CLI_PAGES_PAGES_H
#define LUXEL_CLI_PAGES_PAGES_H

#include <stdbool.h>
#include <stdio.h>

#include <luxel/luxel.h>

#include "../options.h"

void pages_man(FILE *out, const luxel_parameters *parameters);
void pages_scene(FILE *out, const luxel_parameters *parameters);

/* The tables that the script of a shell needs, in its language. */
void pages_bash(FILE *out, const luxel_parameters *parameters);
void pages_zsh(FILE *out, const luxel_parameters *parameters);
void pages_fish(FILE *out, const luxel_parameters *parameters);

/* ---- shared by them ---- */

enum { PAGES_WORDS = 1024 /* room for the choices of a key */ };

/* Whether a parameter is the first of its path (several kinds may have it) and holds a value rather than other keys. */
bool pages_is_key(const luxel_parameters *parameters, size_t i);
/* The words that such a key may have with blanks between them, "" where it has none. */
const char *pages_key_words(const luxel_parameter *parameter, char buffer[PAGES_WORDS]);
/* Prints the keys with their words in single quotes, each between two texts. */
void pages_print_keys(FILE *out, const luxel_parameters *parameters, const char *before, const char *after);
/* The last name of a path: "intensity" of "lights[].intensity". */
const char *pages_last_name(const char *path);
/* Whether no parameter before the i-th has the same last name. */
bool pages_is_first_name(const luxel_parameters *parameters, size_t i);

/* The words that an option may have, with blanks between them; NULL where they are not a few. */
const char *pages_option_words(const struct option_row *row, char buffer[512]);

/* Prints each command that writes files with their endings, in single quotes, between two texts. */
void pages_print_endings(FILE *out, const char *before, const char *after);

/* Prints a text in single quotes as bash and zsh read it. */
void pages_quote(FILE *out, const char *text);

#endif
