/* SPDX-License-Identifier: MIT */
/* The camera: between pixels, places on the screen, and lines of sight. */
#ifndef LX_SHADE_CAMERA_H
#define LX_SHADE_CAMERA_H

#include "../scene/scene.h"
#include "../surface/surface.h"

/* Where the samples of a column and a row lie on the screen. */
double lx_column_x_mm(const struct lx_screen *screen, unsigned column);
double lx_row_y_mm(const struct lx_screen *screen, unsigned row);

/* The pixel that a screen point falls in; false off the screen. */
bool lx_pixel_at(const struct lx_screen *screen, double x_mm, double y_mm, unsigned *column, unsigned *row);

/* Whether the view vector is (0, 0, 1) everywhere; else it points to the observer. */
bool lx_views_along_z(const struct lx_observer *observer);

/* Where lines of sight start, and where view vectors point to: the observer's place, or the direction (0, 0, 1). */
struct lx_origin lx_eye(const struct lx_observer *observer);
struct lx_origin lx_viewer(const struct lx_observer *observer);

/* The line of sight through a screen point. */
struct lx_ray lx_line_of_sight(const struct lx_observer *observer, double x_mm, double y_mm);

/* What a length at the height z has to be multiplied by to have its length on the screen; 0: it is not seen. */
double lx_scale_at(const struct lx_observer *observer, double z_mm);

/* The screen point at which a place is seen, and the place at a height that is seen at a screen point; false where it
 * is not in front of an observer in perspective, or not finite. */
bool lx_project(const struct lx_observer *observer, const double place_mm[3], double screen_mm[2]);
bool lx_unproject(const struct lx_observer *observer, const double screen_mm[2], double z_mm, double place_mm[3]);

#endif
