/* SPDX-License-Identifier: MIT */
/*
 * The space view: the scene in its own light, looked at from outside, with what stands in it drawn over its bodies:
 * lamps with their glow, panels and cones, aims, the observer and the screen.  A drag turns it, the right or the middle
 * button moves it, the wheel zooms; lamps, aims and the observer are taken by the hand and move in the plane of the
 * view.
 *
 * Signals: those of sights; "pointed" (x_mm, y_mm, is_inside) when the pointer is on a body, at the point of the
 * observer's screen where that place is seen, or leaves it; "pressed" (x_mm, y_mm) when such a place was clicked.
 */
#ifndef LUXEL_APP_SPACE_VIEW_H
#define LUXEL_APP_SPACE_VIEW_H

#include "sight.h"

#define APP_TYPE_SPACE_VIEW (app_space_view_get_type())
G_DECLARE_FINAL_TYPE(AppSpaceView, app_space_view, APP, SPACE_VIEW, GtkWidget)

GtkWidget *app_space_view_new(AppDocument *document);

/* Shows the scene of the observer's picture, in its colours and range; NULL: none, as another scene is opened. */
void app_space_view_set_picture(AppSpaceView *self, AppPicture *picture);
/* Its sight: lamps that are chosen or lit up, the place that was read. */
AppSight *app_space_view_sight(AppSpaceView *self);

/* Takes all of the scene into view; looks from the front; zooms around the middle. */
void app_space_view_fit(AppSpaceView *self);
void app_space_view_front(AppSpaceView *self);
void app_space_view_zoom(AppSpaceView *self, double factor);

#endif
