/* SPDX-License-Identifier: MIT */
/* The inside of the space view, for the files that make it up. */
#ifndef LUXEL_APP_SPACE_VIEW_PRIVATE_H
#define LUXEL_APP_SPACE_VIEW_PRIVATE_H

#include "../picture/turn.h"
#include "lit.h"
#include "space_view.h"

typedef enum AppSpaceDoing { APP_SPACE_RESTS, APP_SPACE_MOVES, APP_SPACE_TURNS, APP_SPACE_PANS } AppSpaceDoing;

struct _AppSpaceView {
    GtkWidget parent;
    AppDocument *document;
    AppPicture *picture; /* the observer's; NULL: none yet */
    AppSpace *space;     /* of its scene; NULL: not read off yet */
    AppOrbit orbit;      /* that is wanted */
    gboolean is_own;     /* somebody has turned, moved or zoomed it: it is not fitted anew */
    AppLighter *lighter; /* NULL: nothing was shown yet */
    AppLit *lit;         /* the picture of the bodies, which may be of an orbit of before; NULL: none */
    GdkTexture *texture; /* of it */
    gboolean is_stale;
    gssize selected, hovered; /* lights */
    GArray *chosen;           /* gsize: the lights that are chosen together, the selected one among them */
    gboolean was_chosen;      /* what was pressed, with others */
    AppTurn *turn;            /* of light from far away that is chosen with it, while it is held; NULL: none */
    AppSpaceDoing doing;
    double pointer[2];    /* in the widget */
    gboolean is_toggling; /* pressed to be chosen beside the others, or no longer */
    gboolean has_moved;   /* since it was pressed */
    AppThing thing;       /* that is held, or that the pointer is on */
    double start_mm[3];   /* where it was taken */
    double pixel_mm;      /* of the view, there */
    double last[2];       /* where the hand was, from where it pressed */
    double pinch;         /* the scale that was zoomed by so far */
    gboolean was_inside;  /* the pointer was on a body */
    gboolean has_place;   /* the vectors are shown */
    double place_mm[3], normal[3];
};

/* The orbit by which all is drawn: that of the picture of the bodies, as long as it fits. */
const AppOrbit *app_space_view_orbit(const AppSpaceView *self);
/* Where the mark of a lamp stands: where it is seen, or at the edge, with the `angle` to it.  TRUE: at the edge. */
gboolean app_space_view_mark(const AppSpaceView *self, const AppThing *thing, double at[3], double *angle);
gboolean app_space_view_is_chosen(const AppSpaceView *self, gsize light);

/* space_view_draw.c: what is drawn over the bodies. */
void app_space_view_draw(AppSpaceView *self, cairo_t *cairo);

#endif
