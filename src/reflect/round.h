/* SPDX-License-Identifier: MIT */
/* Occluder cones of what is round, and what they are made of: planes, beyond each of which a cone goes on. */
#ifndef LX_REFLECT_ROUND_H
#define LX_REFLECT_ROUND_H

#include "occluder_cone.h"

/* A cone without planes, and one more plane of the last cone: through a place, hidden where the normal, of any length
 * but 0, points to. */
void lx_occluder_cones_begin(struct lx_occluder_cones *cones);
void lx_occluder_cones_plane(struct lx_occluder_cones *cones, const double normal[3], const double through_mm[3]);
/* A cone of what lies behind a convex polygon in a plane that has the receiver's place `height_mm` above itself. */
void lx_occluder_cones_polygon(struct lx_occluder_cones *cones, const double (*corners)[3], int count,
                               const double axis[3], const double center_mm[3], double height_mm);
/* A surface that is asked way by way. */
void lx_occluder_cones_shape(struct lx_occluder_cones *cones, const struct lx_shape *shape);
/* How high the receiver's place is over a plane. */
double lx_occluder_cones_height(const struct lx_occluder_cones *cones, const double axis[3], const double center_mm[3]);

/* The cones of a surface by one of its sheets, before a face; false: it hides all of that. */
void lx_occluder_cones_disk(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *disk);
bool lx_occluder_cones_ball(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *ball, const struct lx_matte_face *face);
bool lx_occluder_cones_tube(struct lx_occluder_cones *cones, const struct lx_shape *shape,
                            const struct lx_smooth_sheet *tube, const struct lx_matte_face *face);

#endif
