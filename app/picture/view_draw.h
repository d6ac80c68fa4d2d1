/* SPDX-License-Identifier: MIT */
/* Drawing what lies over the picture: values, marks, sections, isophotes. */
#ifndef LUXEL_APP_VIEW_DRAW_H
#define LUXEL_APP_VIEW_DRAW_H

#include <gtk/gtk.h>

#include "marks.h"

/* From the screen's millimetres to a widget's pixels: at = origin + mm * scale, y upwards. */
typedef struct AppMap {
    double origin[2];
    double scale; /* pixels for a millimetre */
} AppMap;

void app_map_to_widget(const AppMap *map, const double place_mm[2], double at[2]);
void app_map_from_widget(const AppMap *map, const double at[2], double place_mm[2]);

/* Where a mark is shown in a widget of this size; *angle, where it is an arrow at the edge, its direction. */
gboolean app_mark_shown(const AppMap *map, const AppMark *mark, double width, double height, double at[2],
                        double *angle);

/* The mark with its label; `hovered`: with a ring around it, as the pointer is on it or on its line of a list. */
void app_draw_mark(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppMark *mark, gboolean selected,
                   gboolean hovered);
/* Writes the values of the pixels into them, where they are large enough on the screen for that. */
void app_draw_values(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppPicture *picture);
/* A text around its middle, readable on every ground. */
void app_draw_text(GtkSnapshot *snapshot, GtkWidget *widget, const double middle[2], const char *text);
/* A sentence beside a mark. */
void app_draw_hint(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const AppMark *mark, const char *hint);
void app_draw_section(GtkSnapshot *snapshot, const AppMap *map, const double section_mm[2], double width,
                      double height);
void app_draw_read(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const double place_mm[2]);
void app_draw_isophotes(GtkSnapshot *snapshot, const AppMap *map, const luxel_isophotes *isophotes,
                        const graphene_rect_t *area);
void app_draw_maximum(GtkSnapshot *snapshot, GtkWidget *widget, const AppMap *map, const luxel_extremum *maximum);

#endif
