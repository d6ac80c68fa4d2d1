/* SPDX-License-Identifier: MIT */
/*
 * Reporting into the caller's luxel_diagnostics: a message id with arguments and a place.  The one who
 * detects an error reports it; the others only hand its status on.  Every function accepts a NULL object.
 */
#ifndef LX_BASE_DIAGNOSTICS_H
#define LX_BASE_DIAGNOSTICS_H

#include <stdbool.h>

#include <luxel/diagnostics.h>

#include "phrase.h"

/* The messages: messages.def lists LX_MESSAGE(NAME, "stable-id", "English template with {0}, {1}"). */
enum lx_message {
#define LX_MESSAGE(name, id, english) LX_MSG_##name,
#include "messages.def"
#undef LX_MESSAGE
    LX_MSG_COUNT
};

/* A stretch of a source text. */
struct lx_place {
    const char *source;  /* name of the source, or NULL */
    const char *text;    /* the whole text of the source, or NULL */
    size_t length;       /* bytes of text */
    size_t start, end;   /* bytes: the offending stretch; start == end marks a single column */
    const char *key;     /* the scene key that is meant, or NULL */
    size_t lines_before; /* lines of the source before the text, where this is not all of it */
    size_t line;         /* the line without a text, from 1; 0: not known */
};

/*
 * Appends an entry.  `place` may be NULL.  `arguments` are those of {0}, {1} ..., in LX_ARGS (NULL: none): plain
 * texts, or words that the front end translates in LX_TERM or LX_WORDS (phrase.h).  All strings are copied.  Line,
 * column and excerpt are worked out here; control characters in arguments are escaped here.
 */
void lx_report(luxel_diagnostics *diagnostics, luxel_severity severity, const struct lx_place *place,
               enum lx_message message, const char *const *arguments);

/* Whether another entry would be kept, so that it is worth while to work out its words. */
bool lx_keeps(const luxel_diagnostics *diagnostics, luxel_severity severity);

/* The English template of a message, to be a phrase of another one (phrase.h). */
const char *lx_message_words(enum lx_message message);

/* Gives the last entry appended a hint that says how to mend it. */
void lx_hint(luxel_diagnostics *diagnostics, enum lx_message message, const char *const *arguments);

/*
 * Where several pieces of advice have a change of the same key to try, or one of a part of what another sets, the last
 * one, which was looked at with all else, takes the place of the others.
 */
void lx_settle_hints(luxel_diagnostics *diagnostics);

/*
 * Moves the entries of `from`, which is then empty, to the end of `to`; those without a place, and those whose source
 * is `source` (NULL: no other), get this one.
 */
void lx_hand_over(luxel_diagnostics *to, luxel_diagnostics *from, const char *source, const struct lx_place *place);

/* Reports an error that has no place and returns LUXEL_ERROR_ARGUMENT. */
luxel_status lx_refuse(luxel_diagnostics *diagnostics, enum lx_message message, const char *const *arguments);

/* Reports that memory ran out and returns LUXEL_ERROR_MEMORY. */
luxel_status lx_out_of_memory(luxel_diagnostics *diagnostics);

/* Reports a setting that is not as `range` (English, to translate) has it; returns LUXEL_ERROR_ARGUMENT. */
luxel_status lx_setting_out_of_range(luxel_diagnostics *diagnostics, const char *setting, double value,
                                     const char *range);

/* Whether what a structure of the caller's has reserved for later versions is NULL; LUXEL_ERROR_ARGUMENT, reported. */
luxel_status lx_check_reserve(void *const *reserved, size_t count, luxel_diagnostics *diagnostics);
#define LX_CHECK_RESERVE(of, diagnostics)                                                                              \
    lx_check_reserve((of)->reserved, sizeof(of)->reserved / sizeof *(of)->reserved, diagnostics)

#endif
