/* SPDX-License-Identifier: MIT */
/* What every file of the front ends shares: the marks for texts that people read. */
#ifndef LUXEL_FRONT_WORDS_H
#define LUXEL_FRONT_WORDS_H

#include <libintl.h>

/*
 * Every text for people goes through one of these: _() where it is printed, N_() where a constant table holds
 * it and the printing place calls _() later, ngettext() where a number decides its form.  They are the names that
 * gettext's tools look for.  JSON is never translated.
 */
#define _(text) gettext(text)
#define N_(text) text

#define COUNT_OF(array) (sizeof(array) / sizeof(array)[0])

#endif
