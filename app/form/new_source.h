/* SPDX-License-Identifier: MIT */
/* New sources: what is added to a scene fits in with it, as luxel_new_light() makes it. */
#ifndef LUXEL_APP_NEW_SOURCE_H
#define LUXEL_APP_NEW_SOURCE_H

#include "../files/document.h"
#include "rules.h"

/*
 * A source of a kind, made like the source `chosen` of the document (beyond the last: like the example of the kind),
 * as YAML; the caller's.  NULL: there is no such kind, or it has no example, as a source of a file.
 */
char *app_new_source(const AppDocument *document, const char *kind, gsize chosen);

/* A source of another kind in the place of the source `index`, likewise. */
char *app_changed_source(const AppDocument *document, const char *kind, gsize index);

/* A luminaire of a photometry file, named as the scene names it, likewise, with the file's own intensities. */
char *app_new_luminaire(const AppDocument *document, const char *file, gsize chosen);

/* The source `chosen`, moved aside so that both are seen, as YAML; the caller's.  NULL: there is none. */
char *app_doubled_source(const AppDocument *document, gsize chosen);

/* Adds to the edits a point source at each of `count` places, as strong as the source `chosen`, from index `at` on. */
void app_new_points(const AppDocument *document, const double *places_mm, gsize count, gsize chosen, gsize at,
                    AppEdits *edits);

#endif
