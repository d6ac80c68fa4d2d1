/* SPDX-License-Identifier: MIT */
/*
 * Repairs: a change of one or a few values with which a scene that was refused can be computed, tried before it is
 * offered.
 */
#ifndef LUXEL_APP_REPAIR_H
#define LUXEL_APP_REPAIR_H

#include "../files/document.h"

/* Assignments as luxel_scene_set() takes them. */
typedef GPtrArray AppRepair;

/* The assignments that a hint names, each behind -s and in single quotes; the caller's, g_ptr_array_unref(). */
AppRepair *app_repair_of_hint(const char *hint);

/*
 * What mends a document with these faults: what their hints say, or else another number for the key that is at fault,
 * or the value that the key, or else the one that was changed last, had in `good`, the last scene that could be
 * computed (NULL: none), or when it was opened.  The caller's, g_ptr_array_unref(); NULL where nothing of that does.
 */
AppRepair *app_repair_find(const AppDocument *document, const luxel_diagnostics *faults, const luxel_scene *good);

/* Makes it, as one step of undo.  FALSE: it is no longer possible. */
gboolean app_repair_make(const AppRepair *repair, AppDocument *document);

/* What it does in the words of a table, such as "Height z 3000 mm, …"; the caller's. */
char *app_repair_words(const AppRepair *repair, const luxel_parameters *parameters);

#endif
