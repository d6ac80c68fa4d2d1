/* SPDX-License-Identifier: MIT */
/*
 * A sight of the scene in space: what plan and elevation have in common with the space view.  Which lamps are chosen
 * and lit up, the place that was read, whether all that is of an earlier scene; and the hand on a thing, from press to
 * release, which lets the lamps that are chosen together follow the one that is dragged.
 *
 * The widgets that show one have these signals: "selected" and "hovered" (kind of AppThing, index) when a thing was
 * taken, or the pointer comes to it; 0: it has left.  "toggled" (index) when a lamp is to be chosen beside the others,
 * or no longer.
 */
#ifndef LUXEL_APP_SIGHT_H
#define LUXEL_APP_SIGHT_H

#include <gtk/gtk.h>

#include "../picture/lighting.h"
#include "../picture/measures.h"
#include "../picture/turn.h"
#include "space.h"

typedef struct AppSight {
    GtkWidget *widget; /* that shows it, and has the signals */
    AppDocument *document;
    gboolean is_stale;
    gssize selected, hovered; /* lights; -1: none */
    GArray *chosen;           /* gsize: the lights that are chosen together, the selected one among them */
    gboolean has_place;       /* the vectors of the formula are shown, of the place that was read: */
    double place_mm[3], normal[3];
    AppGrids *grids;      /* that were measured last; NULL: none, as below */
    AppEyes *eyes;        /* observers that were rated last */
    gint64 grids_seen;    /* when they were last of the scene that is shown, monotonic time; 0: never */
    AppThing thing;       /* that is held, or that the pointer is on */
    double start_mm[3];   /* where it was taken */
    gboolean was_chosen;  /* what was pressed, with others */
    gboolean is_toggling; /* pressed to be chosen beside the others, or no longer */
    gboolean has_moved;   /* since it was pressed */
    AppTurn *turn;        /* of light from far away that is chosen with it, while it is held; NULL: none */
} AppSight;

/* The signals of a type whose widgets show one. */
void app_sight_add_signals(GType type);
void app_sight_init(AppSight *self, GtkWidget *widget);
void app_sight_clear(AppSight *self);

/* Which lamps are chosen together (gsize), and which of them is the one that the form shows. */
void app_sight_choose(AppSight *self, const GArray *lights, gsize selected);
gboolean app_sight_is_chosen(const AppSight *self, gsize light);
/* Which lamp is lit up; -1: none. */
void app_sight_hover(AppSight *self, gssize light);
/* Shows the vectors of the formula at the place that was read; NULL: none. */
void app_sight_set_reading(AppSight *self, const AppReading *reading);
/* Dims it: it is of an earlier scene. */
void app_sight_set_stale(AppSight *self, gboolean stale);

/* Shows grids and observers, to which references are taken; NULL: none. */
void app_sight_set_lighting(AppSight *self, AppGrids *grids, AppEyes *eyes);
/* How strongly grids are drawn in the sight of a moment: faintly where they have not followed it for a blink. */
double app_sight_grid_opacity(AppSight *self, const AppMoment *moment);

/* The pointer is on a thing, or with one of no kind on none. */
void app_sight_point(AppSight *self, const AppThing *thing);
/* Its tooltip. */
gboolean app_sight_tell(const AppThing *thing, GtkTooltip *tooltip);

/* A thing is pressed, with these keys; moved to a place, as app_hold_move() does, where a dot is so many millimetres;
 * let go, which where it was not moved was a click. */
void app_sight_take(AppSight *self, const AppThing *thing, GdkModifierType state);
void app_sight_move(AppSight *self, const AppProjection *projection, const double to_mm[3], double pixel_mm,
                    GdkModifierType state);
void app_sight_let_go(AppSight *self);
void app_sight_click(AppSight *self);

#endif
