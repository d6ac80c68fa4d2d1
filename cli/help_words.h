/* SPDX-License-Identifier: MIT */
/* The words of the field, and what Luxel calls them: for luxel help. */
#ifndef LUXEL_CLI_HELP_WORDS_H
#define LUXEL_CLI_HELP_WORDS_H

#include <stdbool.h>

#include "json.h"

/* Whether a word, in English or Russian, in whatever case, is one that people of the field use. */
bool help_word_is_known(const char *word);
/* Prints what it means, what Luxel calls it and where to read on; nothing of a word that is not known. */
void help_word_print(const char *word);
/* Writes the member "words" of an object: a list, which is empty where the word is not known. */
void help_word_write(struct json *json, const char *word);

#endif
