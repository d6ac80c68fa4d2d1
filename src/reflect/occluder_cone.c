/* SPDX-License-Identifier: MIT */
/* Making cones of the scene's surfaces. */
#include "occluder_cone.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../base/vector.h"
#include "box.h"
#include "region.h"
#include "round.h"

/* The effort of a question to a mesh, and of a surface that may be in the way. */
enum { MESH_EFFORT = 30, SURFACE_EFFORT = 3 };

static void sub(const double a[3], const double b[3], double difference[3])
{
    for (int i = 0; i < 3; i++)
        difference[i] = a[i] - b[i];
}

/* ---- planes ---- */

void lx_occluder_cones_begin(struct lx_occluder_cones *cones)
{
    if (lx_reserve(&cones->items, &cones->capacity, cones->count + 1, sizeof *cones->items)) {
        cones->failed = true;
        return;
    }
    cones->items[cones->count++] = (struct lx_occluder_cone){.first = cones->plane_count};
}

void lx_occluder_cones_plane(struct lx_occluder_cones *cones, const double normal[3], const double through_mm[3])
{
    const double length = sqrt(lx_dot(normal, normal));
    if (cones->failed || !(length > 0))
        return;
    if (lx_reserve(&cones->planes, &cones->plane_capacity, cones->plane_count + 1, sizeof *cones->planes)) {
        cones->failed = true;
        return;
    }
    double *plane = cones->planes[cones->plane_count++];
    for (int i = 0; i < 3; i++)
        plane[i] = normal[i] / length;
    plane[3] = -lx_dot(plane, through_mm);
    cones->items[cones->count - 1].count++;
}

/* False: memory ran out. */
static bool add_half_space(struct lx_occluder_cones *cones, const double normal[3], const double through_mm[3])
{
    lx_occluder_cones_begin(cones);
    lx_occluder_cones_plane(cones, normal, through_mm);
    if (!cones->failed)
        cones->items[cones->count - 1].is_horizon = true;
    return !cones->failed;
}

void lx_occluder_cones_polygon(struct lx_occluder_cones *cones, const double (*corners)[3], int count,
                               const double axis[3], const double center_mm[3], double height_mm)
{
    double from[3], to[3], middle[3], edge[3], beyond[3];
    sub(center_mm, cones->place_mm, middle);
    lx_occluder_cones_begin(cones);
    for (int i = 0; i < 3; i++)
        beyond[i] = height_mm > 0 ? -axis[i] : axis[i];
    lx_occluder_cones_plane(cones, beyond, center_mm);
    for (int k = 0; k < count; k++) {
        sub(corners[k], cones->place_mm, from);
        sub(corners[(k + 1) % count], cones->place_mm, to);
        lx_cross(from, to, edge);
        if (lx_dot(edge, middle) < 0)
            for (int i = 0; i < 3; i++)
                edge[i] = -edge[i];
        lx_occluder_cones_plane(cones, edge, cones->place_mm);
    }
}

double lx_occluder_cones_height(const struct lx_occluder_cones *cones, const double axis[3], const double center_mm[3])
{
    double from[3];
    sub(cones->place_mm, center_mm, from);
    return lx_dot(axis, from);
}

void lx_occluder_cones_shape(struct lx_occluder_cones *cones, const struct lx_shape *shape)
{
    lx_occluder_cones_begin(cones);
    if (cones->failed)
        return;
    struct lx_occluder_cone *cone = &cones->items[cones->count - 1];
    cone->shape = shape;
    memcpy(cone->center_mm, shape->anchor_mm, sizeof cone->center_mm);
    cone->radius_mm = shape->radius_mm;
}

static void add_plate(struct lx_occluder_cones *cones, const struct lx_smooth_sheet *plate)
{
    const double height = lx_occluder_cones_height(cones, plate->axis, plate->center_mm);
    double corners[4][3];
    if (fabs(height) <= cones->touch_mm)
        return;
    const int count = lx_sheet_corners(plate, corners);
    lx_occluder_cones_polygon(cones, (const double(*)[3])corners, count, plate->axis, plate->center_mm, height);
}

/* Whether a plate has the place and all of a face on one of its sides. */
static bool is_aside(const struct lx_occluder_cones *cones, const struct lx_smooth_sheet *plate,
                     const struct lx_matte_face *face)
{
    const double height = lx_occluder_cones_height(cones, plate->axis, plate->center_mm);
    const double side = height > 0 ? 1 : -1;
    const double back[3] = {-side * plate->axis[0], -side * plate->axis[1], -side * plate->axis[2]};
    return lx_face_reach(face, back, plate->center_mm) <= cones->touch_mm;
}

/* A mesh hides what is behind its triangles: those that come between the place and the face, where these are few. */
static void add_mesh(struct lx_occluder_cones *cones, const struct lx_shape *mesh, const struct lx_matte_face *face)
{
    enum { FEW = 12 };
    uint32_t found[FEW];
    struct lx_region region;
    lx_region_before_face(cones, face, &region);
    lx_effort_take(cones->effort, MESH_EFFORT);
    const size_t count = lx_mesh_within(mesh, (const double(*)[4])region.planes, region.count, FEW, found);
    if (count > FEW) {
        lx_occluder_cones_shape(cones, mesh);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        struct lx_smooth_sheet sheet;
        double corners[3][3], middle[3];
        if (!lx_mesh_sheet(mesh, found[i], &sheet))
            continue;
        const double height = lx_occluder_cones_height(cones, sheet.axis, sheet.center_mm);
        if (fabs(height) <= cones->touch_mm || is_aside(cones, &sheet, face))
            continue;
        lx_mesh_corners(mesh, found[i], corners);
        for (int k = 0; k < 3; k++)
            middle[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
        lx_occluder_cones_polygon(cones, (const double(*)[3])corners, 3, sheet.axis, middle, height);
    }
}

/* One other surface in the way; false: it hides all. */
static bool add_surface(struct lx_occluder_cones *cones, const struct lx_prepared_surface *surface,
                        const struct lx_matte_face *face)
{
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    const struct lx_shape *shape = &surface->shape;
    lx_effort_take(cones->effort, SURFACE_EFFORT);
    if (!lx_may_stand_before(cones, shape->anchor_mm, shape->radius_mm, face->center_mm, face->radius_mm))
        return true;
    if (lx_mesh_count(shape) > 0) {
        add_mesh(cones, shape, face);
        return true;
    }
    const enum lx_obstacle_type is = lx_shape_sheets(shape, sheets) > 0 ? sheets[0].type->obstacle : LX_OBSTACLE_SHAPE;
    switch (is) {
    case LX_OBSTACLE_POLYGON:
        if (!is_aside(cones, &sheets[0], face))
            add_plate(cones, &sheets[0]);
        return true;
    case LX_OBSTACLE_DISK: lx_occluder_cones_disk(cones, shape, &sheets[0]); return true;
    case LX_OBSTACLE_TUBE: return lx_occluder_cones_tube(cones, shape, &sheets[0], face);
    case LX_OBSTACLE_BALL: return lx_occluder_cones_ball(cones, shape, &sheets[0], face);
    default: lx_occluder_cones_shape(cones, shape); return true;
    }
}

/* The part of a round face that is turned away from the place is on one side of a plane. */
static bool add_turned(struct lx_occluder_cones *cones, const struct lx_matte_face *face)
{
    const struct lx_smooth_sheet *sheet = &face->sheet;
    double normal[3], through[3];
    if (face->is_flat) {
        sub(cones->place_mm, sheet->center_mm, through);
        return sheet->turn * lx_dot(sheet->axis, through) > cones->touch_mm;
    }
    const enum lx_sheet_facing facing =
        sheet->type->facing ? sheet->type->facing(sheet, cones->place_mm, cones->touch_mm, normal, through)
                            : LX_FACES_WHOLLY;
    if (facing == LX_FACES_PARTLY)
        add_half_space(cones, normal, through);
    return facing != LX_FACES_NOT;
}

/* The cone that its own surface hides from a receiver that has not its normal; a tube hides one from others, too. */
static void add_own(struct lx_occluder_cones *cones, const struct lx_prepared_surface *own,
                    const struct lx_receiver *receiver)
{
    const double *anchor = own->shape.anchor_mm;
    double normal[3], offset[3];
    sub(receiver->place_mm, anchor, offset);
    if (lx_mesh_count(&own->shape) == 0 || !lx_mesh_face_normal(&own->shape, receiver->place_mm, normal))
        own->kind->normal(&own->shape, offset, normal);
    const double *up = receiver->response ? receiver->response->axis : receiver->normal;
    const double side = lx_dot(normal, up) >= 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
        normal[i] *= side;
    lx_occluder_cones_begin(cones);
    lx_occluder_cones_plane(cones, normal, receiver->place_mm);
}

/* The shell of a tube, seen from outside, hides its inner side but for what the ends leave; a mesh hides anything. */
static bool hides_itself(const struct lx_matte_face *face, const struct lx_receiver *receiver)
{
    return face->is_facet || (face->sheet.type->has_ends && face->sheet.turn < 0 && face->surface != receiver->own);
}

/* Whether the receiver lies on the inner side of a tube or a hollow ball, which is between it and what is outside. */
static bool is_within(const struct lx_shape *shape, const struct lx_receiver *receiver)
{
    struct lx_smooth_sheet sheets[LX_MOST_SHEETS];
    double way[3];
    if (lx_shape_sheets(shape, sheets) == 0 || !sheets[0].type->outwards)
        return false;
    sheets[0].type->outwards(&sheets[0], receiver->place_mm, way);
    return lx_dot(way, receiver->normal) < 0;
}

bool lx_occluder_cones_set(const struct lx_prepared *prepared, const struct lx_receiver *receiver,
                           const struct lx_matte_face *face, size_t f, double size_mm, struct lx_occluder_cones *cones)
{
    cones->count = cones->plane_count = 0;
    cones->touch_mm = 1e-10 * size_mm;
    memcpy(cones->place_mm, receiver->place_mm, sizeof cones->place_mm);
    memcpy(cones->normal, receiver->normal, sizeof cones->normal);
    double below[3], from[3];
    for (int i = 0; i < 3; i++)
        below[i] = -receiver->normal[i];
    sub(face->center_mm, receiver->place_mm, from);
    if (lx_dot(from, receiver->normal) < -face->radius_mm || !add_turned(cones, face))
        return false;
    if (lx_closed_boxes_part(cones->boxes, receiver->place_mm, face))
        return false;
    /* of what is hollow nothing is below a tangent plane of its inner side, and all is behind its outer one */
    const bool is_own = lx_receives_from_own(receiver, face);
    if (is_own && !is_within(&prepared->surfaces[receiver->own].shape, receiver))
        return false;
    if (!is_own && add_half_space(cones, below, receiver->place_mm))
        cones->items[cones->count - 1].is_horizon = !receiver->response;
    if (receiver->is_turned && receiver->own < prepared->surface_count)
        add_own(cones, &prepared->surfaces[receiver->own], receiver);
    const struct lx_shafts *shafts = &cones->shafts;
    const size_t first = shafts->of ? shafts->of[f].first : 0;
    const size_t last = shafts->of ? shafts->of[f].last : prepared->surface_count;
    for (size_t i = first; i < last; i++) {
        const size_t s = shafts->of ? shafts->surfaces[i] : i;
        const struct lx_prepared_surface *surface = &prepared->surfaces[s];
        if (s == face->surface) {
            if (!hides_itself(face, receiver))
                continue;
        } else if (lx_closed_boxes_turn_away(cones->boxes, s, receiver->place_mm)) {
            continue;
        } else if (s == receiver->own && lx_mesh_count(&surface->shape) == 0) {
            if (!is_within(&surface->shape, receiver))
                continue;
        }
        if (!add_surface(cones, surface, face))
            return false;
    }
    return !cones->failed;
}

void lx_occluder_cones_clear(struct lx_occluder_cones *cones)
{
    free(cones->planes);
    free(cones->items);
    lx_shafts_clear(&cones->shafts);
    *cones = (struct lx_occluder_cones){0};
}
