/* SPDX-License-Identifier: MIT */
/* Failures of the library as exceptions, and its messages in the user's language. */
#ifndef LUXEL_PYTHON_FAILURE_H
#define LUXEL_PYTHON_FAILURE_H

#include "module.h"

/* A luxel_translate whose data is the struct language; it may be called with or without the interpreter's lock. */
const char *language_translate(const char *english, void *data);

/* The language as the library wants it. */
luxel_language language_of(struct language *language);

/* Sets the language from (code, function or None). */
PyObject *language_set(struct language *language, PyObject *arguments);
void language_clear(struct language *language);

/* The entries as a list of tuples, see luxel._errors. */
PyObject *diagnostics_list(struct language *language, const luxel_diagnostics *diagnostics);

/* An empty list of diagnostics; NULL: an exception is set. */
luxel_diagnostics *diagnostics_begin(void);

/*
 * Raises what a status other than LUXEL_OK tells, with its diagnostics, unless an exception is set already; frees the
 * diagnostics whatever the status is.  True: the status is LUXEL_OK and no exception is set.
 */
bool diagnostics_end(struct language *language, luxel_status status, luxel_diagnostics *diagnostics);

#endif
