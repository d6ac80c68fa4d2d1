/* SPDX-License-Identifier: MIT */
/* The inside of the space view, for the files that make it up. */
#ifndef LUXEL_APP_SPACE_VIEW_PRIVATE_H
#define LUXEL_APP_SPACE_VIEW_PRIVATE_H

#include "lit.h"
#include "space_view.h"

typedef enum AppSpaceDoing { APP_SPACE_RESTS, APP_SPACE_MOVES, APP_SPACE_TURNS, APP_SPACE_PANS } AppSpaceDoing;

struct _AppSpaceView {
    GtkWidget parent;
    AppSight sight;
    AppPicture *picture; /* the observer's; NULL: none yet */
    AppSpace *space;     /* of its scene; NULL: not read off yet */
    AppOrbit orbit;      /* that is wanted */
    gboolean is_own;     /* somebody has turned, moved or zoomed it: it is not fitted anew */
    AppLighter *lighter; /* NULL: nothing was shown yet */
    AppLit *lit;         /* the picture of the bodies, which may be of an orbit of before; NULL: none */
    GdkTexture *texture; /* of it */
    AppSpaceDoing doing;
    double pointer[2];   /* in the widget */
    double pixel_mm;     /* of the view, where the hand pressed */
    double last[2];      /* where the hand was, from where it pressed */
    double pinch;        /* the scale that was zoomed by so far */
    gboolean was_inside; /* the pointer was on a body */
};

/* The orbit by which all is drawn: that of the picture of the bodies, as long as it fits. */
const AppOrbit *app_space_view_orbit(const AppSpaceView *self);
/* Where the mark of a lamp stands: where it is seen, or at the edge, with the `angle` to it.  TRUE: at the edge. */
gboolean app_space_view_mark(const AppSpaceView *self, const AppThing *thing, double at[3], double *angle);

/* space_view_areas.c */
/* Fills an outline that lies in a plane of three places with the source that is set, but where bodies hide it. */
void app_space_view_fill(const AppSpaceView *self, cairo_t *cairo, const double (*outline)[3], gsize count,
                         const double (*plane)[3]);
/* The measuring grids of the scene. */
void app_space_view_draw_grids(AppSpaceView *self, cairo_t *cairo);

/* space_view_draw.c: what is drawn over the bodies. */
void app_space_view_draw(AppSpaceView *self, cairo_t *cairo);

#endif
