/* SPDX-License-Identifier: MIT */
/*
 * The pane beside the picture: a page each for the scene in space, points, sections, statistics and, where the scene
 * has grids or observers, lighting.
 *
 * Signals: "wanted" when another page was turned to, which may need other numbers; "read" (x_mm, y_mm, is_inside) when
 * a section is read at a place, or no longer.
 */
#ifndef LUXEL_APP_NUMBERS_H
#define LUXEL_APP_NUMBERS_H

#include <gtk/gtk.h>

#include "../files/document.h"
#include "../picture/lighting.h"
#include "../picture/measures.h"

#define APP_TYPE_NUMBERS (app_numbers_get_type())
G_DECLARE_FINAL_TYPE(AppNumbers, app_numbers, APP, NUMBERS, GtkBox)

typedef enum AppPage {
    APP_PAGE_SPACE,
    APP_PAGE_POINTS,
    APP_PAGE_SECTION,
    APP_PAGE_STATISTICS,
    APP_PAGE_LIGHTING
} AppPage;

/* `space` is shown on the first page. */
GtkWidget *app_numbers_new(AppDocument *document, GtkWidget *space);
AppPage app_numbers_page(AppNumbers *self);

/* Shows what the answers have; profiles and histogram are taken out of them. */
void app_numbers_show(AppNumbers *self, AppMeasures *measures);
/* Shows grids, or eyes where these are not NULL; references are taken. */
void app_numbers_show_lighting(AppNumbers *self, AppGrids *grids, AppEyes *eyes, guint64 serial);
/* Whether there is a page for them. */
void app_numbers_offer_lighting(AppNumbers *self, gboolean is_offered);
/* The version that is shown, the live one whatever is compared, and whether that is the document as it is: numbers of
 * another one are dimmed and not copied.  FALSE: those of the page that is open are still on their way. */
gboolean app_numbers_set_version(AppNumbers *self, const AppVersion *version, guint64 live, gboolean is_latest);
/* Says below the page that its numbers are still being computed. */
void app_numbers_set_late(AppNumbers *self, gboolean is_late);
/* Another scene is opened: nothing is left of the one before. */
void app_numbers_forget(AppNumbers *self);
/* The colours of the histogram. */
void app_numbers_set_colors(AppNumbers *self, const char *palette, double low, double high, gboolean logarithmic);

#endif
