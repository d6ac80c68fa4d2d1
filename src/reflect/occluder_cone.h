/* SPDX-License-Identifier: MIT */
/*
 * Occluder cones: what of a face is hidden from a place.  A cone is the part of space where some linear functions are
 * all positive: behind the horizon of the place, turned away from it, or behind a surface that is convex as seen from
 * there; round outlines are polygons of as much area.  Triangles of a mesh are cones where few of them come between the
 * place and the face; what is not convex, or of too many pieces, is asked way by way.
 */
#ifndef LX_REFLECT_OCCLUDER_CONE_H
#define LX_REFLECT_OCCLUDER_CONE_H

#include "../base/effort.h"
#include "receiver.h"
#include "shaft.h"
#include "tile.h"

struct lx_closed_boxes;

/* Whether a face is of the receiver's own smooth surface: faces of a mesh may see each other. */
static inline bool lx_receives_from_own(const struct lx_receiver *receiver, const struct lx_matte_face *face)
{
    return face->surface == receiver->own && !receiver->is_turned && !face->is_facet;
}

struct lx_occluder_cone {
    size_t first, count;            /* planes */
    const struct lx_shape *shape;   /* instead of planes: by its own answer; */
    bool is_ball;                   /* or the ball below, with what is behind it */
    bool is_horizon;                /* at its border nothing arrives anyway: the kernel is 0 there */
    double center_mm[3], radius_mm; /* a ball around that */
};

/* x.p + p[3] > 0 is on the hidden side; p of unit length. */
struct lx_occluder_cones {
    double (*planes)[4];
    size_t plane_count, plane_capacity;
    struct lx_occluder_cone *items;
    size_t count, capacity;
    double place_mm[3], normal[3], touch_mm; /* of the receiver; what is below rounding */
    struct lx_shafts shafts;                 /* from what the receivers lie on */
    const struct lx_closed_boxes *boxes;
    struct lx_effort *effort; /* that the work counts as; NULL: it is not counted */
    bool failed;              /* memory ran out */
};

/* How a cell is seen. */
enum lx_outlook { LX_ALL_SEEN, LX_NONE_SEEN, LX_PART_SEEN };

/* Sets the cones before face f; false: nothing of it can be seen.  `size_mm`: of the scene. */
bool lx_occluder_cones_set(const struct lx_prepared *prepared, const struct lx_receiver *receiver,
                           const struct lx_matte_face *face, size_t f, double size_mm, struct lx_occluder_cones *cones);
void lx_occluder_cones_clear(struct lx_occluder_cones *cones);

/* Whether one ball may stand before another as the place sees them: their cones overlap. */
bool lx_may_stand_before(const struct lx_occluder_cones *cones, const double center_mm[3], double radius_mm,
                         const double behind_mm[3], double behind_radius_mm);
enum lx_outlook lx_occluder_cone_look(const struct lx_occluder_cones *cones, const struct lx_occluder_cone *cone,
                                      const struct lx_tile_cell *cell);

/* Occluder cones that hide a part of a cell: alone those can hide anything of what is in it. */
enum { LX_MOST_PARTLY = 24 };
struct lx_partly {
    unsigned count;
    bool is_all; /* there are too many: all cones are to be asked */
    const struct lx_occluder_cone *cones[LX_MOST_PARTLY];
};

/* How a cell is seen, which lies in one that `around` is of, if that is not NULL; sets what hides it in part. */
enum lx_outlook lx_occluder_cones_look(const struct lx_occluder_cones *cones, const struct lx_tile_cell *cell,
                                       const struct lx_partly *around, struct lx_partly *partly);

/* Whether anything of what hides a cell in part is asked way by way; whether all of it are horizons. */
bool lx_partly_have_shapes(const struct lx_partly *partly);
bool lx_partly_are_horizons(const struct lx_partly *partly);

/* Whether a single place of the face is seen. */
bool lx_occluder_cones_leave(const struct lx_occluder_cones *cones, const double place_mm[3]);

/* Sets the integrals of the rule's polynomials, in coordinates from -1 to 1, over what the cones that hide a cell in
 * part leave of a parallelogram; false: there are too many. */
bool lx_occluder_cones_visible(const struct lx_occluder_cones *cones, const struct lx_tile_cell *cell,
                               const struct lx_partly *partly, double shares[LX_RULE_NODES]);

#endif
