/* SPDX-License-Identifier: MIT */
/* The table of unified glare ratings of a luminaire in standard rooms, as catalogues have it, folded to one line. */
#ifndef LUXEL_APP_UGR_TABLE_H
#define LUXEL_APP_UGR_TABLE_H

#include <gtk/gtk.h>
#include <luxel/photometry.h>

/* An expander, which is hidden until a luminaire is shown. */
GtkWidget *app_ugr_table_new(void);
/* Shows that of a luminaire; NULL, or one that has no luminance towards an observer: nothing. */
void app_ugr_table_show(GtkWidget *expander, const luxel_photometry *photometry);

#endif
