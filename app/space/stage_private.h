/* SPDX-License-Identifier: MIT */
/* The inside of the stage, for the files that make it up. */
#ifndef LUXEL_APP_STAGE_PRIVATE_H
#define LUXEL_APP_STAGE_PRIVATE_H

#include "../picture/turn.h"
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
    AppDocument *document;
    AppMoment *moment; /* NULL: none yet */
    AppSpace *space;   /* of it; NULL: not read off yet */
    AppOutlines *outlines;
    AppStageMap map;
    gboolean is_held; /* something is dragged: the map stays */
    gboolean is_stale;
    gssize selected, hovered; /* lights */
    GArray *chosen;           /* gsize: the lights that are chosen together, the selected one among them */
    gboolean was_chosen;      /* what was pressed, with others */
    AppTurn *turn;            /* of light from far away that is chosen with it, while it is held; NULL: none */
    gboolean is_toggling;     /* pressed to be chosen beside the others, or no longer */
    gboolean has_moved;       /* since it was pressed */
    AppThing thing;           /* that is held, or that the pointer is on */
    AppProjection projection; /* in which it is */
    double start_mm[3];       /* where it was taken */
    gboolean has_place;       /* the vectors are shown */
    double place_mm[3], normal[3];
};

/* stage.c */
gboolean app_stage_is_chosen(const AppStage *self, gsize light);
void app_stage_place(const AppStageMap *map, AppProjection projection, const double place_mm[3], double at[2]);
/* stage_draw.c */
void app_stage_draw(AppStage *self, cairo_t *cairo, double width, double height);

#endif
