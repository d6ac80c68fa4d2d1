/* SPDX-License-Identifier: MIT */
/*
 * The camera: between pixels, places on the screen, and lines of sight.  The screen has a frame of its own, in which it
 * lies in the plane z = 0 and the observer stands at (0, 0, z); that is the scene's, or was carried to where the
 * observer looks.  Places and directions are in the frame of the scene here, heights in the screen's.
 */
#ifndef LX_WORLD_CAMERA_H
#define LX_WORLD_CAMERA_H

#include "../scene/observer.h"
#include "../surface/surface.h"

struct lx_camera {
    struct lx_frame frame; /* of the screen */
    double position_mm[3]; /* of the observer */
    double z_mm;           /* its height above the screen */
    bool is_perspective;
    bool is_parallel; /* the view vector is the screen's z axis everywhere; else it points to the observer */
};

/* The camera of an observer. */
struct lx_camera lx_camera_of(const struct lx_observer *observer);

/* The camera in a scene that was carried into the frame of its screen. */
struct lx_camera lx_camera_carried(const struct lx_camera *camera);

/* Where the samples of a column and a row lie on the screen. */
double lx_column_x_mm(const struct lx_screen *screen, unsigned column);
double lx_row_y_mm(const struct lx_screen *screen, unsigned row);

/* The pixel that a screen point falls in; false off the screen. */
bool lx_pixel_at(const struct lx_screen *screen, double x_mm, double y_mm, unsigned *column, unsigned *row);

/* Where lines of sight start, and where view vectors point to: the observer's place, or the direction of the z axis. */
struct lx_origin lx_eye(const struct lx_camera *camera);
struct lx_origin lx_viewer(const struct lx_camera *camera);

/* The view vector at a place, of unit length. */
lx_bounded3 lx_view_from(const struct lx_camera *camera, lx_bounded3 place_mm);

/* The line of sight through a screen point. */
struct lx_ray lx_line_of_sight(const struct lx_camera *camera, double x_mm, double y_mm);

/* What a length at a height has to be multiplied by to have its length on the screen; 0: it is not seen. */
double lx_scale_at(const struct lx_camera *camera, double height_mm);

/* The screen point at which a place is seen, or would be but for what is not finite; its height. */
double lx_seen_at(const struct lx_camera *camera, const double place_mm[3], double screen_mm[2]);

/* The screen point at which a place is seen, and the place at a height that is seen at a screen point; false where it
 * is not in front of an observer in perspective, or not finite. */
bool lx_project(const struct lx_camera *camera, const double place_mm[3], double screen_mm[2]);
bool lx_unproject(const struct lx_camera *camera, const double screen_mm[2], double height_mm, double place_mm[3]);

#endif
