/* SPDX-License-Identifier: MIT */
/* Edits that belong together, and the texts that they point to. */
#include "edits.h"

AppEdits *app_edits_new(void)
{
    AppEdits *edits = g_new(AppEdits, 1);
    *edits = (AppEdits){g_array_new(FALSE, FALSE, sizeof(AppEdit)), g_ptr_array_new_with_free_func(g_free)};
    return edits;
}

void app_edits_free(AppEdits *edits)
{
    g_array_unref(edits->list);
    g_ptr_array_unref(edits->texts);
    g_free(edits);
}

static const char *keep_text(AppEdits *edits, const char *text)
{
    char *copy = g_strdup(text);
    if (copy)
        g_ptr_array_add(edits->texts, copy);
    return copy;
}

void app_edits_add(AppEdits *edits, AppEditKind kind, const char *key, const char *value, gsize index, gsize to)
{
    const AppEdit edit = {kind, keep_text(edits, key), keep_text(edits, value), index, to};
    g_array_append_val(edits->list, edit);
}

gboolean app_edits_make(const AppEdits *edits, AppDocument *document, luxel_diagnostics *diagnostics)
{
    const AppEdit *list = (const AppEdit *)(void *)edits->list->data;
    return app_document_edit(document, list, edits->list->len, NULL, diagnostics);
}
