/* SPDX-License-Identifier: MIT */
/*
 * The control of a choice: a list of labels, and where numbers may stand instead of a word, a field for each.  Values
 * come and go as YAML; what is no number, or no range, is marked and not told.
 *
 * Signals: "chosen" (value as YAML) when the user chose; "refused" (reason) when what was typed is wrong, "" when it
 * no longer is.
 */
#ifndef LUXEL_APP_CHOICE_H
#define LUXEL_APP_CHOICE_H

#include <gtk/gtk.h>

#define APP_TYPE_CHOICE (app_choice_get_type())
G_DECLARE_FINAL_TYPE(AppChoice, app_choice, APP, CHOICE, GtkBox)

/* `choices`: "a, b, c"; `numbers`: 0, 1 for a whole number from 1, or 2 for a range [low, high]. */
GtkWidget *app_choice_new(const char *choices, guint numbers);

void app_choice_set(AppChoice *self, const char *yaml);
/* The list and the fields by the name of the value, for those who do not see it. */
void app_choice_name(AppChoice *self, const char *name, const char *meaning);
/* The range that is in force, which one of its own begins with. */
void app_choice_suggest(AppChoice *self, double low, double high);
/* Shows what holds again in place of what was typed; FALSE: there was nothing else. */
gboolean app_choice_restore(AppChoice *self);

#endif
