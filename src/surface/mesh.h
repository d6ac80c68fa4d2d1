/* SPDX-License-Identifier: MIT */
/*
 * The shape of a mesh: its tree and normals stay in a frame of their own, and the shape holds how that lies in space.
 * A place q of the tree is at anchor + size (q_x across + q_y upward + q_z axis).
 */
#ifndef LX_SURFACE_MESH_H
#define LX_SURFACE_MESH_H

#include "solid.h"
#include "surface.h"

/* What a shape points to. */
struct lx_mesh_body {
    const struct lx_mesh_tree *tree;
    const struct lx_mesh_normals *normals;
    bool fronts_only;   /* the backs of its faces are not seen */
    bool encloses;      /* it is closed */
    bool looks_inwards; /* closed, and its faces look inwards */
};

/* own[0]: mm for each unit of the tree; own[1]: what rounding may have done to the anchor, in mm. */
static inline double lx_mesh_size_of(const struct lx_shape *shape)
{
    return shape->own[0];
}

/* A place, an offset from the anchor, and a direction in the frame of the tree; a direction back. */
void lx_mesh_enter(const struct lx_shape *shape, const double offset_mm[3], double place[3]);
void lx_mesh_leave(const struct lx_shape *shape, const double direction[3], double turned[3]);
/* A place of the tree in space. */
void lx_mesh_leave_place(const struct lx_shape *shape, const double place[3], double place_mm[3]);

/* The unit normal of the face at a place, as its corners run; false: there is none. */
bool lx_mesh_face_normal(const struct lx_shape *shape, const double place_mm[3], double normal[3]);

/* Members of the kind: mesh_shape.c, mesh_blocks.c. */
struct lx_hit lx_mesh_hit(const struct lx_shape *shape, const struct lx_ray *ray);
void lx_mesh_normal(const struct lx_shape *shape, const double offset_mm[3], double normal[3]);
void lx_mesh_normal_seen(const struct lx_shape *shape, const double offset_mm[3], const double sight[3],
                         double normal[3]);
bool lx_mesh_holds(const struct lx_shape *shape, const double place_mm[3]);
bool lx_mesh_meets(const struct lx_shape *shape, const double from_mm[3], const double direction[3], double *t,
                   double offset_mm[3]);
bool lx_mesh_takes(const struct lx_shape *shape, const double from_mm[3], const double way[3], bool endless);
lx_bounded lx_mesh_blocks(const struct lx_shape *shape, lx_bounded3 place_mm, lx_bounded3 towards, bool endless);
int lx_mesh_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles);
lx_bounded lx_mesh_hides(const struct lx_shape *shape, lx_bounded3 place_mm, double facing, lx_bounded3 towards,
                         bool endless);
unsigned lx_mesh_layers(const struct lx_shape *shape, const double from_mm[3], const double way[3]);
int lx_mesh_gather_beside(const struct lx_shape *shape, double facing, const struct lx_obstacle *beyond,
                          const struct lx_shaft *shaft, struct lx_obstacles *obstacles);
bool lx_mesh_is_behind(const struct lx_shape *shape, const double offset_mm[3], const double normal[3],
                       const double way[3]);
bool lx_mesh_encloses(const struct lx_shape *shape, const double place_mm[3]);
double lx_mesh_distance(const struct lx_shape *shape, const double offset_mm[3], double direction[3]);

#endif
