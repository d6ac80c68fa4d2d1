/* SPDX-License-Identifier: MIT */
/*
 * What stands beside the picture: a page each for the scene in space, points, sections and statistics.
 *
 * Signals: "wanted" when another page was turned to, which may need other numbers; "read" (x_mm, y_mm, is_inside) when
 * a section is read at a place, or no longer.
 */
#ifndef LUXEL_APP_NUMBERS_H
#define LUXEL_APP_NUMBERS_H

#include <gtk/gtk.h>

#include "document.h"
#include "measures.h"

#define APP_TYPE_NUMBERS (app_numbers_get_type())
G_DECLARE_FINAL_TYPE(AppNumbers, app_numbers, APP, NUMBERS, GtkBox)

typedef enum AppPage { APP_PAGE_SPACE, APP_PAGE_POINTS, APP_PAGE_SECTION, APP_PAGE_STATISTICS } AppPage;

/* `space` is shown on the first page. */
GtkWidget *app_numbers_new(AppDocument *document, GtkWidget *space);
AppPage app_numbers_page(AppNumbers *self);
void app_numbers_turn_to(AppNumbers *self, AppPage page);

/* Shows what the answers have; profiles and histogram are taken out of them. */
void app_numbers_show(AppNumbers *self, AppMeasures *measures);
/* Dims all but the first page, and copies nothing: the numbers of the present scene are still on their way. */
void app_numbers_set_waiting(AppNumbers *self, gboolean waiting);
/* The colours of the histogram. */
void app_numbers_set_colors(AppNumbers *self, const char *palette, double low, double high, gboolean logarithmic);

#endif
