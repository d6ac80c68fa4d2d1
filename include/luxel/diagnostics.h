/* SPDX-License-Identifier: MIT */
/*
 * Diagnostics: what went wrong or deserves advice, where, and how to mend it.
 *
 * The caller owns a luxel_diagnostics and hands it to the calls that take one (NULL is allowed: then the
 * details are dropped).  Calls append; nothing is printed.  The first LUXEL_DIAGNOSTICS_KEPT entries of a
 * severity are kept, the rest only counted.  An entry is a message id with arguments, so a front end can
 * put it into words of its language through a gettext-like callback.
 */
#ifndef LUXEL_DIAGNOSTICS_H
#define LUXEL_DIAGNOSTICS_H

#include <stddef.h>

#include <luxel/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    LUXEL_DIAGNOSTICS_KEPT = 20 /* entries of a severity that are kept; further ones are only counted */
};

/* How much an entry weighs. */
typedef enum luxel_severity {
    LUXEL_SEVERITY_ERROR, /* what was asked for cannot be done */
    LUXEL_SEVERITY_ADVICE /* legal, but outside the advised range, unused, or without visible effect */
} luxel_severity;

/* A list of entries, owned by the caller; made by luxel_diagnostics_new(). */
typedef struct luxel_diagnostics luxel_diagnostics;

/* One entry; every pointer belongs to the luxel_diagnostics and lives until it is cleared or freed. */
typedef struct luxel_diagnostic {
    luxel_severity severity; /* an error or advice */
    const char *id;          /* stable name of the message, such as "unknown-key" */
    /* A file's name, "<stdin>", a name that the caller gave, "<text>" where that was NULL, or a built-in scene's name;
     * of what luxel_scene_set() and its like are given "-s", "key" or "value"; NULL where no place applies. */
    const char *source;
    unsigned line;        /* from 1; 0 where no place applies */
    unsigned column;      /* from 1, in characters; 0 where no place applies */
    const char *key;      /* the scene key that is meant, such as "lights[0].intensity", or NULL */
    const char *excerpt;  /* the offending line, control characters escaped, or NULL */
    unsigned mark_offset; /* columns of the excerpt before the offending text */
    unsigned mark_length; /* columns of the excerpt to underline, at least 1 where there is an excerpt */
} luxel_diagnostic;

/*
 * Returns the translation of English words, or the words themselves; like gettext().  It is called with the templates
 * of messages, and with words that stand in them: units, ranges, types, meanings of keys, reasons of the system.
 */
typedef const char *(*luxel_translate)(const char *english, void *data);

/* An empty list; the caller's, free it with luxel_diagnostics_free().  NULL when memory is short. */
LUXEL_API luxel_diagnostics *luxel_diagnostics_new(void);
/* Frees the list with its entries; NULL is harmless. */
LUXEL_API void luxel_diagnostics_free(luxel_diagnostics *diagnostics);
/* Removes all entries and sets the totals to 0. */
LUXEL_API void luxel_diagnostics_clear(luxel_diagnostics *diagnostics);

/* How many entries of a severity were reported, the ones not kept included. */
LUXEL_API size_t luxel_diagnostics_total(const luxel_diagnostics *diagnostics, luxel_severity severity);
/* How many entries are kept, of all severities. */
LUXEL_API size_t luxel_diagnostics_count(const luxel_diagnostics *diagnostics);
/* The i-th kept entry in order of reporting; NULL beyond the last. */
LUXEL_API const luxel_diagnostic *luxel_diagnostics_get(const luxel_diagnostics *diagnostics, size_t i);

/*
 * The message of entry i in words, without its place.  `translate` may be NULL (English).  The text is the
 * caller's: free it with luxel_text_free().  NULL beyond the last entry or when memory is short.
 */
LUXEL_API char *luxel_diagnostics_message(const luxel_diagnostics *diagnostics, size_t i, luxel_translate translate,
                                          void *data);
/* How to mend what entry i reports, "" where there is no hint; else as luxel_diagnostics_message(). */
LUXEL_API char *luxel_diagnostics_hint(const luxel_diagnostics *diagnostics, size_t i, luxel_translate translate,
                                       void *data);

/* Frees a text that a function of this library returned as the caller's; NULL is harmless. */
LUXEL_API void luxel_text_free(char *text);
/* Frees the bytes of a file that a function of this library made in memory; NULL is harmless. */
LUXEL_API void luxel_bytes_free(unsigned char *bytes);

#ifdef __cplusplus
}
#endif
#endif
