/* SPDX-License-Identifier: MIT */
/*
 * The stage: plan and elevation of the scene above each other, to one scale and on one x, always with all of it in
 * view.  Lamps, aims, axes, surfaces and the observer are taken by the hand, in each projection along what it shows;
 * of lamps that are chosen together, one that is dragged takes the others with it.
 *
 * Signals: "selected" and "hovered" (kind of AppThing, index) when a thing was taken, or the pointer comes to it; 0:
 * it has left.  "toggled" (index) when a lamp is to be chosen beside the others, or no longer.
 */
#ifndef LUXEL_APP_STAGE_H
#define LUXEL_APP_STAGE_H

#include <gtk/gtk.h>

#include "../picture/measures.h"
#include "space.h"

#define APP_TYPE_STAGE (app_stage_get_type())
G_DECLARE_FINAL_TYPE(AppStage, app_stage, APP, STAGE, GtkWidget)

GtkWidget *app_stage_new(AppDocument *document);

/* Shows the scene of a moment, to which a reference is taken; NULL: none. */
void app_stage_set_moment(AppStage *self, AppMoment *moment);
/* Which lamps are chosen together (gsize), and which of them is the one that the form shows. */
void app_stage_choose(AppStage *self, const GArray *lights, gsize selected);
/* Which lamp is lit up; -1: none. */
void app_stage_hover(AppStage *self, gssize light);
/* Shows the vectors of the formula at the place that was read; NULL: none. */
void app_stage_set_reading(AppStage *self, const AppReading *reading);
/* Dims it: it is of an earlier scene. */
void app_stage_set_stale(AppStage *self, gboolean stale);

#endif
