/* SPDX-License-Identifier: MIT */
/* Veils of what is round, and what they are made of: planes, beyond each of which a veil goes on. */
#ifndef LX_REFLECT_ROUND_H
#define LX_REFLECT_ROUND_H

#include "veil.h"

/* A veil without planes, and one more plane of the last veil: through a place, hidden where the normal, of any length
 * but 0, points to. */
void lx_veils_begin(struct lx_veils *veils);
void lx_veils_plane(struct lx_veils *veils, const double normal[3], const double through_mm[3]);
/* A veil of what lies behind a convex polygon in a plane that has the receiver's place `height_mm` above itself. */
void lx_veils_polygon(struct lx_veils *veils, const double (*corners)[3], int count, const double axis[3],
                      const double center_mm[3], double height_mm);
/* A surface that is asked way by way. */
void lx_veils_shape(struct lx_veils *veils, const struct lx_shape *shape);
/* How high the receiver's place is over a plane. */
double lx_veils_height(const struct lx_veils *veils, const double axis[3], const double center_mm[3]);

/* The veils of a surface by one of its sheets, before a face; false: it hides all of that. */
void lx_veils_disk(struct lx_veils *veils, const struct lx_shape *shape, const struct lx_smooth_sheet *disk);
bool lx_veils_ball(struct lx_veils *veils, const struct lx_shape *shape, const struct lx_smooth_sheet *ball,
                   const struct lx_matte_face *face);
bool lx_veils_tube(struct lx_veils *veils, const struct lx_shape *shape, const struct lx_smooth_sheet *tube,
                   const struct lx_matte_face *face);

#endif
