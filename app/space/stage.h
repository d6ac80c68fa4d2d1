/* SPDX-License-Identifier: MIT */
/*
 * The stage: plan and elevation of the scene above each other, to one scale and on one x, always with all of it in
 * view.  Lamps, aims, axes, surfaces and the observer are taken by the hand, in each projection along what it shows;
 * of lamps that are chosen together, one that is dragged takes the others with it.
 * The signals are those of sights.
 */
#ifndef LUXEL_APP_STAGE_H
#define LUXEL_APP_STAGE_H

#include "sight.h"

#define APP_TYPE_STAGE (app_stage_get_type())
G_DECLARE_FINAL_TYPE(AppStage, app_stage, APP, STAGE, GtkWidget)

GtkWidget *app_stage_new(AppDocument *document);

/* Shows the scene of a moment, to which a reference is taken; NULL: none. */
void app_stage_set_moment(AppStage *self, AppMoment *moment);
/* Its sight: lamps that are chosen or lit up, the place that was read. */
AppSight *app_stage_sight(AppStage *self);

#endif
