/* SPDX-License-Identifier: MIT */
/* What the tool tells people on standard error: its own errors, hints and notes, and the library's diagnostics. */
#ifndef LUXEL_CLI_MESSAGE_H
#define LUXEL_CLI_MESSAGE_H

#include <stdbool.h>
#include <stdio.h>

#include <luxel/luxel.h>

/* "luxel: error: ...", and its second line "  hint: ..." */
void message_error(const char *format, ...) __attribute__((format(printf, 1, 2)));
void message_hint(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Some results, which are printed all the same, are not as exact as was asked for. */
void message_tolerance(size_t missed, size_t count);
/* Whether the reflected light of a picture is as exact as was asked for; if not, says so once: it is forgotten. */
bool message_reflected(luxel_diagnostics *diagnostics);
/* "  hint: did you mean X?" unless `nearest` is NULL. */
void message_did_you_mean(const char *nearest);
/* "luxel: ..." */
void message_note(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Prints the entries of one severity, under the word of `shown_as`, to a stream; says how many were not kept. */
void message_diagnostics(FILE *stream, const luxel_diagnostics *diagnostics, luxel_severity severity,
                         luxel_severity shown_as);

/* Prints what a file holds that is passed over, unless -q was given: all advice that there is, which is forgotten. */
void message_passed_over(luxel_diagnostics *diagnostics, bool quiet);

/*
 * Reports why a call of the library failed, from its diagnostics.  Returns the exit code that the status ends
 * the tool with.
 */
int message_failure(luxel_status status, luxel_diagnostics *diagnostics);
/* The failure of a table: where its file was read, the hint says what form it has to have. */
int message_table_failure(luxel_status status, luxel_diagnostics *diagnostics, const char *form);

/* A new object for diagnostics; without memory for it the tool ends. */
luxel_diagnostics *message_new_diagnostics(void);

/* Memory for count zeroed items; without it the tool says so and ends, since it cannot go on. */
void *message_allocate(size_t count, size_t size);

#endif
