/* SPDX-License-Identifier: MIT */
/*
 * A row of the list of sources: number in its colour, name, on or off, what it gives, and its share under the pointer.
 *
 * Signals: "enabled" and "solo" (is_active) when the user pressed them; "hovered" (is_inside) when the pointer comes
 * or goes.
 */
#ifndef LUXEL_APP_SOURCE_ROW_H
#define LUXEL_APP_SOURCE_ROW_H

#include <gtk/gtk.h>

#include "../picture/measures.h"

#define APP_TYPE_SOURCE_ROW (app_source_row_get_type())
G_DECLARE_FINAL_TYPE(AppSourceRow, app_source_row, APP, SOURCE_ROW, GtkBox)

GtkWidget *app_source_row_new(gsize light);
gsize app_source_row_light(const AppSourceRow *self);

/* Shows what the document has; no signal is emitted. */
void app_source_row_show(AppSourceRow *self, const char *title, gboolean enabled, gboolean solo);
/* Shows flux and irradiance, in these units, the second one untranslated; NULL: they are not known. */
void app_source_row_set_gives(AppSourceRow *self, const AppSource *source, const char *flux_unit, const char *unit);
/* Shows the share of the value under the pointer; NaN: there is none. */
void app_source_row_set_share(AppSourceRow *self, double share, double whole);
/* Dims what it gives: it is of an earlier scene. */
void app_source_row_set_stale(AppSourceRow *self, gboolean stale);

#endif
