/* SPDX-License-Identifier: MIT */
/*
 * A vector of a form: label and unit in one line, its numbers side by side in the next one, and
 * below them what is said of the numbers.
 */
#ifndef LUXEL_APP_VECTOR_H
#define LUXEL_APP_VECTOR_H

#include "row.h"

#define APP_TYPE_VECTOR (app_vector_get_type())
G_DECLARE_FINAL_TYPE(AppVector, app_vector, APP, VECTOR, GtkBox)

/* The texts are copied; `meaning` is the tooltip. */
GtkWidget *app_vector_new(const char *label, const char *unit, const char *meaning);
/* One more number: a row with a short name (AppRowSpec.part). */
void app_vector_add(AppVector *self, AppRow *part);
const char *app_vector_label(const AppVector *self);
void app_vector_set_unit(AppVector *self, const char *unit);

#endif
