/* SPDX-License-Identifier: MIT */
/*
 * A form: rows for the keys of a group, a surface or a light, all of them by the parameter table.  It shows the keys
 * that have a say and hides those that the other values make idle; what a change makes necessary it adds.
 */
#ifndef LUXEL_APP_FORM_H
#define LUXEL_APP_FORM_H

#include <gtk/gtk.h>

#include "../files/document.h"

#define APP_TYPE_FORM (app_form_get_type())
G_DECLARE_FINAL_TYPE(AppForm, app_form, APP, FORM, GtkBox)

/*
 * A form of those keys of the parameter table whose paths begin with one of `prefixes` (NULL-terminated; "lights[]."
 * are the keys of a light) and not with `except` (NULL: none).  Everything lives as long as the form.
 */
GtkWidget *app_form_new(AppDocument *document, const luxel_parameters *parameters, const char *const *prefixes,
                        const char *except);

/* Shows the element `index` of the list that the paths go through, of this type; NULL: there is none. */
void app_form_set_element(AppForm *self, gsize index, const char *type);

/* Which other elements of the list take every change, too, as far as they have its key; names are each one's own. */
void app_form_set_others(AppForm *self, const gsize *others, gsize count);

/* Shows the document's present values, as soon as the form is seen. */
void app_form_refresh(AppForm *self);
/* The rows are there with their values although nobody sees them, as for a search. */
void app_form_fill(AppForm *self);

/* Tells a row that takes a range which one is in force; the key is a literal. */
void app_form_suggest(AppForm *self, const char *key, double low, double high);

/* Marks the row of a key as wrong; key NULL: none is.  TRUE where the form has that row. */
gboolean app_form_set_fault(AppForm *self, const char *key, const char *reason);

#endif
