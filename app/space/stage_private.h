/* SPDX-License-Identifier: MIT */
/* The inside of the stage, for the files that make it up. */
#ifndef LUXEL_APP_STAGE_PRIVATE_H
#define LUXEL_APP_STAGE_PRIVATE_H

#include "outlines.h"
#include "stage.h"

/* From millimetres to the widget: the horizontal is x in both projections. */
typedef struct AppStageMap {
    double scale;                     /* pixels for a millimetre */
    double left;                      /* where x = 0 is */
    double floors[APP_PROJECTIONS];   /* where y = 0, or z = 0, is */
    double tops[APP_PROJECTIONS + 1]; /* where each projection begins; the last one: where they end */
} AppStageMap;

struct _AppStage {
    GtkWidget parent;
    AppSight sight;
    AppMoment *moment; /* NULL: none yet */
    AppSpace *space;   /* of it; NULL: not read off yet */
    AppOutlines *outlines;
    AppStageMap map;
    gboolean is_held;         /* something is dragged: the map stays */
    AppProjection projection; /* in which the thing is that is held, or that the pointer is on */
};

/* stage.c */
void app_stage_place(const AppStageMap *map, AppProjection projection, const double place_mm[3], double at[2]);
/* stage_draw.c */
void app_stage_draw(AppStage *self, cairo_t *cairo, double width, double height);

#endif
