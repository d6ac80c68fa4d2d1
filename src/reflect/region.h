/* SPDX-License-Identifier: MIT */
/* Regions: the convex parts of space in which a mesh may stand between a receiver and what it looks at. */
#ifndef LX_REFLECT_REGION_H
#define LX_REFLECT_REGION_H

#include "../surface/mesh_faces.h"
#include "occluder_cone.h"

/* x.p + p[3] > 0 inside, p of unit length. */
struct lx_region {
    double planes[LX_REGION_PLANES][4];
    unsigned count;
};

/* Over the receiver's tangent plane, before the face, and within the pyramid that the face, or the ball around it,
 * makes with the place. */
void lx_region_before_face(const struct lx_occluder_cones *cones, const struct lx_matte_face *face,
                           struct lx_region *region);

/* Whether no triangle of a mesh comes between the place and a cell, but for what `lx_region_before_face` leaves out. */
bool lx_region_is_free(const struct lx_occluder_cones *cones, const struct lx_shape *shape,
                       const struct lx_tile_cell *cell);

/* Whether a cell with straight edges and a face of that kind see something of each other; and whether a mesh is not
 * between any place of the one and any of the other, as far as that is told by the hull of both. */
bool lx_cell_meets_face(const struct lx_tile_cell *cell, const struct lx_matte_face *face, double touch_mm);
bool lx_hull_is_free(const struct lx_shape *mesh, const struct lx_tile_cell *cell, const struct lx_matte_face *face,
                     double touch_mm);

#endif
