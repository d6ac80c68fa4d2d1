/* SPDX-License-Identifier: MIT */
/* Planes around the ways from a place to a face or a cell. */
#include "region.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

/* The effort of a question to a mesh. */
enum { MESH_EFFORT = 30 };

/* A plane, on which, but for rounding, nothing is inside. */
static void add_plane(struct lx_region *region, const double normal[3], const double through_mm[3], double touch_mm)
{
    const double length = sqrt(lx_dot(normal, normal));
    if (!(length > 0))
        return;
    double *plane = region->planes[region->count++];
    for (int i = 0; i < 3; i++)
        plane[i] = normal[i] / length;
    plane[3] = -lx_dot(plane, through_mm) - touch_mm;
}

/* Through the place and each edge of a polygon around `middle`. */
static void add_pyramid(struct lx_region *region, const struct lx_occluder_cones *cones, const double (*corners)[3],
                        int count, const double middle_mm[3])
{
    double from[3], to[3], inwards[3], edge[3];
    for (int k = 0; k < count; k++) {
        for (int i = 0; i < 3; i++) {
            from[i] = corners[k][i] - cones->place_mm[i];
            to[i] = corners[(k + 1) % count][i] - cones->place_mm[i];
            inwards[i] = middle_mm[i] - cones->place_mm[i];
        }
        lx_cross(from, to, edge);
        if (lx_dot(edge, inwards) < 0)
            for (int i = 0; i < 3; i++)
                edge[i] = -edge[i];
        add_plane(region, edge, cones->place_mm, cones->touch_mm);
    }
}

/* The corners of the parallelogram that a cell with straight edges is a part of. */
static void corners_of(const struct lx_tile_cell *cell, double corners[4][3])
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners[k][i] = cell->center_mm[i] + (k == 0 || k == 3 ? -1 : 1) * cell->first_mm[i] +
                            (k < 2 ? -1 : 1) * cell->second_mm[i];
}

/* Four planes around a ball, and one behind it; inside of it there is no pyramid. */
static void add_cone(struct lx_region *region, const struct lx_occluder_cones *cones, const double center_mm[3],
                     double radius_mm)
{
    double way[3], sides[2][3], beyond[3], back[3];
    for (int i = 0; i < 3; i++)
        way[i] = center_mm[i] - cones->place_mm[i];
    const double away = lx_normalize(way), sine = radius_mm / away;
    if (!(sine < 1))
        return;
    const double other[3] = {fabs(way[0]) < 0.6, fabs(way[0]) >= 0.6, 0}, cosine = sqrt(1 - sine * sine);
    lx_cross(way, other, sides[0]);
    lx_normalize(sides[0]);
    lx_cross(way, sides[0], sides[1]);
    for (int k = 0; k < 4; k++) {
        double inwards[3];
        for (int i = 0; i < 3; i++)
            inwards[i] = sine * way[i] + (k & 1 ? cosine : -cosine) * sides[k >> 1][i];
        add_plane(region, inwards, cones->place_mm, -cones->touch_mm);
    }
    for (int i = 0; i < 3; i++) {
        beyond[i] = center_mm[i] + radius_mm * way[i];
        back[i] = -way[i];
    }
    add_plane(region, back, beyond, -cones->touch_mm);
}

static void begin(const struct lx_occluder_cones *cones, struct lx_region *region)
{
    region->count = 0;
    add_plane(region, cones->normal, cones->place_mm, cones->touch_mm);
}

void lx_region_before_face(const struct lx_occluder_cones *cones, const struct lx_matte_face *face,
                           struct lx_region *region)
{
    const struct lx_smooth_sheet *sheet = &face->sheet;
    double corners[4][3], normal[3];
    begin(cones, region);
    for (int i = 0; i < 3; i++)
        normal[i] = sheet->turn * sheet->axis[i];
    if (face->is_flat)
        add_plane(region, normal, sheet->center_mm, cones->touch_mm);
    if (lx_is_polygon(face)) {
        const int count = lx_sheet_corners(&face->sheet, corners);
        add_pyramid(region, cones, (const double(*)[3])corners, count, face->center_mm);
    } else {
        add_cone(region, cones, face->center_mm, face->radius_mm);
    }
}

/* Cells with straight edges are parts of their parallelograms. */
bool lx_region_is_free(const struct lx_occluder_cones *cones, const struct lx_shape *shape,
                       const struct lx_tile_cell *cell)
{
    struct lx_region region;
    uint32_t found;
    double corners[4][3], normal[3], from[3];
    if (lx_mesh_count(shape) == 0)
        return false;
    lx_effort_take(cones->effort, MESH_EFFORT);
    begin(cones, &region);
    lx_cross(cell->first_mm, cell->second_mm, normal);
    if (lx_dot(normal, normal) > 0) {
        for (int i = 0; i < 3; i++)
            from[i] = cones->place_mm[i] - cell->center_mm[i];
        if (lx_dot(normal, from) < 0)
            for (int i = 0; i < 3; i++)
                normal[i] = -normal[i];
        corners_of(cell, corners);
        add_plane(&region, normal, cell->center_mm, cones->touch_mm);
        add_pyramid(&region, cones, (const double(*)[3])corners, 4, cell->center_mm);
    } else {
        add_cone(&region, cones, cell->center_mm, cell->radius_mm);
    }
    return lx_mesh_within(shape, (const double(*)[4])region.planes, region.count, 0, &found) == 0;
}

/* ---- hulls ---- */

/* A convex polygon in space. */
struct outline {
    double corners[4][3], normal[3], middle[3];
    int count;
};

static struct outline outline_of_cell(const struct lx_tile_cell *cell)
{
    struct outline made = {.count = 4};
    corners_of(cell, made.corners);
    memcpy(made.normal, cell->normal[0], sizeof made.normal);
    memcpy(made.middle, cell->center_mm, sizeof made.middle);
    return made;
}

static struct outline outline_of_face(const struct lx_matte_face *face)
{
    struct outline made;
    made.count = lx_sheet_corners(&face->sheet, made.corners);
    for (int i = 0; i < 3; i++)
        made.normal[i] = face->sheet.turn * face->sheet.axis[i];
    memcpy(made.middle, face->center_mm, sizeof made.middle);
    return made;
}

/* Whether all corners are on one side of a plane. */
static bool is_beyond(const struct outline *outline, const double normal[3], const double through_mm[3], double side,
                      double touch_mm)
{
    const double least = side * lx_dot(normal, through_mm);
    for (int c = 0; c < outline->count; c++)
        if (side * lx_dot(normal, outline->corners[c]) < least - touch_mm)
            return false;
    return true;
}

bool lx_cell_meets_face(const struct lx_tile_cell *cell, const struct lx_matte_face *face, double touch_mm)
{
    const struct outline from = outline_of_cell(cell), to = outline_of_face(face);
    return !is_beyond(&to, from.normal, from.middle, -1, touch_mm) &&
           !is_beyond(&from, to.normal, to.middle, -1, touch_mm);
}

/* Planes through edges of one polygon and corners of the other that have both on one side. */
static void add_supporting(struct lx_region *region, const struct outline *edges, const struct outline *tips,
                           double touch_mm)
{
    for (int e = 0; e < edges->count; e++) {
        const double *from = edges->corners[e], *to = edges->corners[(e + 1) % edges->count];
        bool is_found = false;
        for (int c = 0; c < tips->count && !is_found; c++) {
            double along[3], across[3], normal[3];
            for (int i = 0; i < 3; i++) {
                along[i] = to[i] - from[i];
                across[i] = tips->corners[c][i] - from[i];
            }
            lx_cross(along, across, normal);
            if (!(lx_normalize(normal) > 0))
                continue;
            for (int side = -1; side <= 1 && !is_found; side += 2)
                if (is_beyond(edges, normal, from, side, touch_mm) && is_beyond(tips, normal, from, side, touch_mm)) {
                    const double inwards[3] = {side * normal[0], side * normal[1], side * normal[2]};
                    add_plane(region, inwards, from, touch_mm);
                    is_found = true;
                }
        }
    }
}

bool lx_hull_is_free(const struct lx_shape *mesh, const struct lx_tile_cell *cell, const struct lx_matte_face *face,
                     double touch_mm)
{
    const struct outline from = outline_of_cell(cell), to = outline_of_face(face);
    struct lx_region region = {.count = 0};
    uint32_t found;
    add_plane(&region, from.normal, from.middle, touch_mm);
    add_plane(&region, to.normal, to.middle, touch_mm);
    add_supporting(&region, &from, &to, touch_mm);
    add_supporting(&region, &to, &from, touch_mm);
    return lx_mesh_within(mesh, (const double(*)[4])region.planes, region.count, 0, &found) == 0;
}
