/* SPDX-License-Identifier: MIT */
/*
 * A measuring grid as it lies in a sight of the scene: its cells in the colours of their values, with the values where
 * there is room for them, its areas around it, and an edge that says whether its limits are kept.
 */
#ifndef LUXEL_APP_GRID_DRAW_H
#define LUXEL_APP_GRID_DRAW_H

#include <gtk/gtk.h>

#include "../picture/lighting.h"

/* How it is seen. */
typedef struct AppGridSight {
    cairo_t *cairo;
    GtkWidget *widget;
    /* From places in space to the widget; FALSE: that one is not seen. */
    gboolean (*see)(gconstpointer from, const double place_mm[3], double at[2]);
    gconstpointer from;
    double opacity; /* of the cells */
} AppGridSight;

/* The colour of a verdict, by the theme. */
void app_verdict_color(luxel_verdict verdict, double color[3]);

/* The corners of a grid's plane. */
void app_grid_corners(const luxel_grid *grid, double corners_mm[4][3]);

/* Draws one grid with its areas; `most`: the value of the last colour. */
void app_grid_draw(const AppGridSight *sight, const AppGrid *grid, double most);

/* Draws where an observer sits and looks, in the colour of its verdict where it is judged; so long is the line. */
void app_eye_draw(const AppGridSight *sight, const AppEye *eye, gboolean is_judged, double reach_mm);

#endif
