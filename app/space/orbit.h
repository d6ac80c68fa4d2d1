/* SPDX-License-Identifier: MIT */
/*
 * An orbit: how a scene is looked at in space, from outside and in perspective.  It is turned about what is upwards in
 * the scene, tilted, moved and zoomed, and tells where places are seen.
 */
#ifndef LUXEL_APP_ORBIT_H
#define LUXEL_APP_ORBIT_H

#include "../../front/camera.h"
#include "space.h"

typedef struct AppOrbit {
    gboolean is_upright;             /* y is upwards in the scene, as in rooms; else z */
    double turn, tilt;               /* about the axis that is upwards, and away from it, radians */
    double center_mm[3];             /* the target of the camera */
    double distance_mm;              /* from it */
    double scale;                    /* pixels of the widget for a millimetre at the target; 0: not fitted yet */
    double width, height;            /* of the widget, pixels */
    double right[3], up[3], back[3]; /* unit vectors of the camera, the last one towards it */
} AppOrbit;

/* As it begins in a scene: turned and tilted so that fronts of plates are seen, all of the scene in view. */
void app_orbit_begin(AppOrbit *self, const luxel_scene *scene, const AppSpace *space);
/* Takes all of a scene into view, from where it is looked at. */
void app_orbit_fit(AppOrbit *self, const luxel_scene *scene, const AppSpace *space);
/* Looks from the front, a little from above. */
void app_orbit_front(AppOrbit *self);
/* By pixels of a hand's way. */
void app_orbit_turn(AppOrbit *self, double dx, double dy);
void app_orbit_pan(AppOrbit *self, double dx, double dy);
/* What is at a place of the widget stays there. */
void app_orbit_zoom(AppOrbit *self, const double at[2], double factor);

/* Where a place is seen, in pixels of the widget, and how far it is along the line of sight; FALSE: it is behind. */
gboolean app_orbit_see(const AppOrbit *self, const double place_mm[3], double seen[3]);
/* The way back. */
void app_orbit_place(const AppOrbit *self, const double seen[3], double place_mm[3]);
/* Millimetres across the line of sight for a pixel, so far away. */
double app_orbit_pixel(const AppOrbit *self, double depth_mm);

/* The camera that sees it, `dots` of its pixels for one of the widget. */
camera app_orbit_camera(const AppOrbit *self, double dots);

#endif
