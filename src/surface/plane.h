/* SPDX-License-Identifier: MIT */
/*
 * What flat surfaces share: how their plane lies, where lines of sight and ways of light cross it, and coordinates in
 * it.  The rectangle, the disk, and whatever else is a part of a plane add where they end.
 */
#ifndef LX_SURFACE_PLANE_H
#define LX_SURFACE_PLANE_H

#include "surface.h"

/* A part of a plane around a centre, no place of which is farther from that than the radius; `up` lies in the plane
 * once it is made perpendicular to the axis. */
struct lx_shape lx_plane_lay(const double center_mm[3], const double axis[3], const double up[3], double radius_mm);

/* Unit directions of a shape with their bounds. */
lx_bounded3 lx_shape_axis(const struct lx_shape *shape);
lx_bounded3 lx_shape_across(const struct lx_shape *shape);
lx_bounded3 lx_shape_upward(const struct lx_shape *shape);

/* The axis at a length near 1, without rounding. */
void lx_scaled_axis(const double axis[3], double scaled[3]);

/* The hit of a ray on the front of the plane, and where that is from the centre. */
struct lx_hit lx_plane_meet(const struct lx_shape *plane, const struct lx_ray *ray, double offset_mm[3]);

/* Sets coordinates that a ray along an axis keeps to what they are, without an error. */
void lx_keep_coordinates(const struct lx_ray *ray, lx_bounded3 *place_mm);

/* Whether a way crosses the plane, as `blocks` tells, from so high above it, changing its height by so much. */
struct lx_plane_crossing {
    lx_bounded crosses, start, change;
    lx_bounded3 from; /* its start, from the centre */
};
struct lx_plane_crossing lx_plane_cross(const struct lx_shape *plane, lx_bounded3 place_mm, lx_bounded3 towards,
                                        bool endless);

/*
 * Whether a way that crosses the plane `room` within an edge meets the surface.  The edge itself does.  What lies
 * beyond it by no more than `beyond` does, too, so that edges that meet leave no gap: but that is in doubt, as is what
 * rounding cannot tell from the edge; a place whose offset from the anchor has no rounding may be told to lead to the
 * very edge.
 */
lx_bounded lx_plane_is_within(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded room, double beyond);

/*
 * How far the way from a place passes above the plane: what `beside` answers of a way that leads away from it, or ends
 * before it; or else less than 0, and where the way crosses it, from the centre.
 */
double lx_plane_beside(const struct lx_shape *plane, const double place_mm[3], const double way[3], bool endless,
                       double crossing_mm[3]);

/* Whether an opening lies in the plane, to 1e-9 of its size and the plane's, and where its middle is. */
bool lx_plane_holds_opening(const struct lx_shape *plane, const struct lx_shape_opening *opening, double middle_mm[3]);

/* Members of kinds, charts and bounds: coordinates are the offsets across and upward in mm. */
enum lx_standing lx_plane_standing(const struct lx_shape *plane, double highest_mm, double observer_z_mm,
                                   bool perspective);
bool lx_plane_is_dark(const struct lx_shape *plane, const double place_mm[3]);
bool lx_plane_faces(const struct lx_shape *plane, const struct lx_origin *eye);
void lx_plane_normal(const struct lx_shape *plane, const double offset_mm[3], double normal[3]);
void lx_plane_locate(const struct lx_shape *plane, const double offset_mm[3], const double normal[3], double at[3]);
void lx_plane_place(const struct lx_shape *plane, const double at[3], double place_mm[3], double normal[3]);
void lx_plane_element(const struct lx_shape *plane, const double at[3], lx_bounded3 *place_mm, lx_bounded3 *normal);
void lx_plane_directions(const struct lx_shape *plane, const double at[3], double first[3], double second[3]);
void lx_plane_move(const struct lx_shape *plane, const double at[3], const double first[3], const double second[3],
                   const double step_mm[2], double moved[3]);
void lx_plane_middle(const struct lx_shape *plane, const struct lx_origin *eye, double at[3]);
int lx_plane_guess(const struct lx_shape *plane, const struct lx_origin *light, const struct lx_origin *viewer,
                   bool for_least, double at[LX_MOST_GUESSES][3]);
double lx_plane_least_cosine(const struct lx_shape *plane, const double towards[3], double away);
double lx_plane_curvature(const struct lx_shape *plane);

/* 0 on the cone of the ways from a light past a circle, a quadratic function of the place; on the circle's plane, a
 * linear one, where the light lies in it. */
double lx_circle_edge(const double center_mm[3], const double axis[3], double radius_mm, const struct lx_origin *light,
                      const double place_mm[3]);

#endif
