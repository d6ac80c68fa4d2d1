/* SPDX-License-Identifier: MIT */
/* Edits of a document that are made together, as one step of undo. */
#ifndef LUXEL_APP_EDITS_H
#define LUXEL_APP_EDITS_H

#include "../files/document.h"

/* Edits with their own texts. */
typedef struct AppEdits {
    GArray *list; /* AppEdit */
    GPtrArray *texts;
} AppEdits;

AppEdits *app_edits_new(void);
void app_edits_free(AppEdits *edits);
/* Copies what it is given. */
void app_edits_add(AppEdits *edits, AppEditKind kind, const char *key, const char *value, gsize index, gsize to);

/* Makes them together, as app_document_edit() does; at least one. */
gboolean app_edits_make(const AppEdits *edits, AppDocument *document, luxel_diagnostics *diagnostics);

#endif
