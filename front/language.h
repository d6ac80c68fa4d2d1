/* SPDX-License-Identifier: MIT */
/* The user's language: which catalogue of translations is used, and what the library is handed to use it. */
#ifndef LUXEL_FRONT_LANGUAGE_H
#define LUXEL_FRONT_LANGUAGE_H

/*
 * Takes the language of LC_ALL, LC_MESSAGES or LANG, and LANGUAGE, for messages alone: numbers keep their decimal
 * point and letters their kind in every language.  To be called once, before anything is said.
 */
void language_begin(void);

/* A luxel_translate. */
const char *language_translate(const char *english, void *data);

/* The code of the language that messages are in, such as "ru". */
const char *language_code(void);

/* The sign that parts a number from its fraction in that language, '.' or ',': for what people read alone. */
char language_decimal_mark(void);

/* Why a system call failed, in the user's language. */
const char *language_reason(int number);

#endif
