/* SPDX-License-Identifier: MIT */
/*
 * Sheets: the sides of a surface cut into pieces, each with smooth coordinates s, t from -1 to 1, for whoever
 * integrates over surfaces.  A plate is one sheet on either side, a disk and the side of a cylinder four sectors, a
 * ball the six faces of a cube that is blown up, which leaves no pole; a mesh has a sheet on either side of each
 * triangle (mesh_faces.h).
 */
#ifndef LX_SURFACE_SHEET_H
#define LX_SURFACE_SHEET_H

#include <stdbool.h>

#include "surface.h"

enum lx_sheet_type { LX_SHEET_PLATE, LX_SHEET_TRIANGLE, LX_SHEET_DISK, LX_SHEET_TUBE, LX_SHEET_BALL };

struct lx_smooth_sheet {
    enum lx_sheet_type type;
    double turn;         /* 1: the normal is along the axis, or away from the middle; -1: the other way */
    double center_mm[3]; /* of a triangle the corner at t = -1 */
    double across[3], upward[3], axis[3]; /* unit, at right angles */
    double half_mm[2]; /* of a plate; of a triangle the side at t = 1, and the height over it; of what is round the
                        * radius, and of a tube half its height, of a disk the hole's radius */
    double middle;     /* the angle in the middle of a sector; how far the middle of a triangle's side is across */
};

enum { LX_MOST_SHEETS = 12 };

/* The sheets of a shape, as its kind has them; returns how many, 0: it has none, or is a mesh. */
int lx_shape_sheets(const struct lx_shape *shape, struct lx_smooth_sheet sheets[LX_MOST_SHEETS]);

/* For kinds: the sheets on both sides of a plate, of the sectors of a disk or a tube, with their half_mm, and of a
 * ball, which has no inside unless it is hollow; how many. */
int lx_sheets_of_plate(const struct lx_shape *shape, struct lx_smooth_sheet *sheets);
int lx_sheets_of_sectors(const struct lx_shape *shape, enum lx_sheet_type type, double radius_mm, double half_mm,
                         struct lx_smooth_sheet *sheets);
int lx_sheets_of_ball(const struct lx_shape *shape, bool is_hollow, struct lx_smooth_sheet *sheets);

/* The place, the unit normal and the area for each unit of s and t, in mm^2. */
double lx_sheet_place(const struct lx_smooth_sheet *sheet, double s, double t, double place_mm[3], double normal[3]);

/* The numbers that depend on one coordinate alone, for those who ask of many places that have it in common. */
struct lx_sheet_line {
    double at, first, second; /* of a ball its tangent; of other round sheets, along s, cosine and sine */
};
struct lx_sheet_line lx_sheet_line(const struct lx_smooth_sheet *sheet, int way, double at);
double lx_sheet_cross(const struct lx_smooth_sheet *sheet, const struct lx_sheet_line *s, const struct lx_sheet_line *t,
                      double place_mm[3], double normal[3]);

/* The area of a part of a ball between coordinates, in closed form, mm^2. */
double lx_sheet_ball_area(const struct lx_smooth_sheet *ball, const double low[2], const double high[2]);

/* The coordinates of a place on the surface; they are beyond 1 or -1 where it is on another sheet. */
void lx_sheet_locate(const struct lx_smooth_sheet *sheet, const double place_mm[3], double at[2]);

/* A triangle, whose corners run counter-clockwise as seen from its front; false: it has no area. */
bool lx_sheet_of_triangle(const double corners_mm[3][3], struct lx_smooth_sheet *sheet);

#endif
