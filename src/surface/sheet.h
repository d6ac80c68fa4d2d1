/* SPDX-License-Identifier: MIT */
/*
 * Sheets: the sides of a surface cut into pieces, each with smooth coordinates s, t from -1 to 1, for whoever
 * integrates over surfaces.  A plate is one sheet on either side, a disk and the side of a cylinder four sectors, a
 * ball the six faces of a cube that is blown up, which leaves no pole; a mesh has a sheet on either side of each
 * triangle (mesh_faces.h).  What is asked of a sheet its type answers.
 */
#ifndef LX_SURFACE_SHEET_H
#define LX_SURFACE_SHEET_H

#include <stdbool.h>

#include "surface.h"

struct lx_smooth_sheet {
    const struct lx_sheet_type *type;
    double turn;         /* 1: the normal is along the axis, or away from the middle; -1: the other way */
    double center_mm[3]; /* of a triangle the corner at t = -1 */
    double across[3], upward[3], axis[3]; /* unit, at right angles */
    double half_mm[2]; /* of a plate; of a triangle the side at t = 1, and the height over it; of what is round the
                        * radius, and of a tube half its height, of a disk the hole's radius */
    double middle;     /* the angle in the middle of a sector; how far the middle of a triangle's side is across */
};

/* The numbers that depend on one coordinate alone, for those who ask of many places that have it in common. */
struct lx_sheet_line {
    double at, first, second; /* of a ball its tangent; of other round sheets, along s, cosine and sine */
};

/* A part of a sheet with straight edges around its middle, the origin here: the places x first + y second, x and y from
 * -1 to 1, where |x| <= ((1 + y) + (1 - y) narrow) / 2. */
struct lx_sheet_part {
    double first_mm[3], second_mm[3], narrow;
    double lengths_mm[2], radius_mm; /* about half its sides; a ball around it */
};

/* Takes a straight piece of a rim, and a place beside it towards which the surface goes on; false: no more of them. */
typedef bool lx_rim_taker(void *data, const double from_mm[3], const double to_mm[3], const double inside_mm[3]);

/* How a curved sheet is turned to a place: all of it, nothing of it, or what is not beyond a plane. */
enum lx_sheet_facing { LX_FACES_WHOLLY, LX_FACES_NOT, LX_FACES_PARTLY };

/* Here "all of it" is what a sheet is a sector of: the whole disk, tube or ball. */
struct lx_sheet_type {
    unsigned corner_count; /* of what is flat with straight edges: 3 or 4; 0: of what has others */
    unsigned bends; /* in how many directions it is curved: none, as a tube, or as a ball, half_mm[0] the radius */
    bool has_ends;  /* a shell that is open there: light comes to its inner side past them alone */
    enum lx_obstacle_type
        obstacle; /* what all of it is in the way of light; else it is asked by its shape's `blocks` */

    struct lx_sheet_line (*line)(const struct lx_smooth_sheet *sheet, int way, double at); /* NULL: `at` alone */
    double (*cross)(const struct lx_smooth_sheet *sheet, const struct lx_sheet_line *s, const struct lx_sheet_line *t,
                    double place_mm[3], double normal[3]);
    void (*locate)(const struct lx_smooth_sheet *sheet, const double place_mm[3], double at[2]);
    /* How far all of it reaches beyond its centre along a unit vector. */
    double (*reach)(const struct lx_smooth_sheet *sheet, const double direction[3]);
    /* A part between coordinates, where edges are straight. */
    void (*part)(const struct lx_smooth_sheet *sheet, const double middle[2], const double half[2],
                 struct lx_sheet_part *part);
    /* The outline of all of it as a light or an eye sees it: a round one in so many straight pieces. */
    void (*rim)(const struct lx_smooth_sheet *sheet, const struct lx_origin *light, int pieces, lx_rim_taker *take,
                void *data);

    /* -- of what is curved; NULL: not known -- */

    /* The area between coordinates in closed form, mm^2.  NULL: rules know it well enough. */
    double (*area)(const struct lx_smooth_sheet *sheet, const double low[2], const double high[2]);
    /* How far a place is from all of it, at least. */
    double (*distance)(const struct lx_smooth_sheet *sheet, const double place_mm[3]);
    /* The way to a place from the nearest one of its axis, or from its middle. */
    void (*outwards)(const struct lx_smooth_sheet *sheet, const double place_mm[3], double way[3]);
    /* The part of it that is turned to a place; LX_FACES_PARTLY: all but the side of a plane that the normal, of any
     * length, looks to. */
    enum lx_sheet_facing (*facing)(const struct lx_smooth_sheet *sheet, const double place_mm[3], double touch_mm,
                                   double normal[3], double through_mm[3]);
    /* The share of the light from any of its places that any other receives, for each mm^2.  NULL: that differs. */
    double (*exchange)(const struct lx_smooth_sheet *sheet);
};

extern const struct lx_sheet_type lx_plate_sheet, lx_triangle_sheet, lx_disk_sheet, lx_tube_sheet, lx_ball_sheet;

enum { LX_MOST_SHEETS = 12 };

/* The sheets of a shape, as its kind has them; returns how many, 0: it has none, or is a mesh. */
int lx_shape_sheets(const struct lx_shape *shape, struct lx_smooth_sheet sheets[LX_MOST_SHEETS]);

/* For kinds: the sheets on both sides of a plate, of the sectors of a disk or a tube, with their half_mm, and of a
 * ball, which has no inside unless it is hollow; how many. */
int lx_sheets_of_plate(const struct lx_shape *shape, struct lx_smooth_sheet *sheets);
int lx_sheets_of_sectors(const struct lx_shape *shape, const struct lx_sheet_type *type, double radius_mm,
                         double half_mm, struct lx_smooth_sheet *sheets);
int lx_sheets_of_ball(const struct lx_shape *shape, bool is_hollow, struct lx_smooth_sheet *sheets);

/* The place, the unit normal and the area for each unit of s and t, in mm^2. */
double lx_sheet_place(const struct lx_smooth_sheet *sheet, double s, double t, double place_mm[3], double normal[3]);

static inline struct lx_sheet_line lx_sheet_line(const struct lx_smooth_sheet *sheet, int way, double at)
{
    return sheet->type->line ? sheet->type->line(sheet, way, at) : (struct lx_sheet_line){.at = at};
}

static inline double lx_sheet_cross(const struct lx_smooth_sheet *sheet, const struct lx_sheet_line *s,
                                    const struct lx_sheet_line *t, double place_mm[3], double normal[3])
{
    return sheet->type->cross(sheet, s, t, place_mm, normal);
}

/* The coordinates of a place on the surface; they are beyond 1 or -1 where it is on another sheet. */
static inline void lx_sheet_locate(const struct lx_smooth_sheet *sheet, const double place_mm[3], double at[2])
{
    sheet->type->locate(sheet, place_mm, at);
}

/* How far a place is from all of it, or from its plane, at least. */
double lx_sheet_distance(const struct lx_smooth_sheet *sheet, const double place_mm[3]);

/* The corners of a sheet with straight edges, in their order; how many. */
int lx_sheet_corners(const struct lx_smooth_sheet *sheet, double corners_mm[4][3]);

/* A triangle, whose corners run counter-clockwise as seen from its front; false: it has no area. */
bool lx_sheet_of_triangle(const double corners_mm[3][3], struct lx_smooth_sheet *sheet);

#endif
