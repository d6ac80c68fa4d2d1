/* SPDX-License-Identifier: MIT */
/* The parts of bodies of visible boundaries that are neither polygons nor balls. */
#ifndef LX_WORLD_BOUNDARY_BODIES_H
#define LX_WORLD_BOUNDARY_BODIES_H

#include "boundary.h"

/* The outline of a disk as a side; false: it is seen edge-on, and no more than *unsure of the solid angle, which is
 * added to. */
bool lx_boundary_disk(const double center[3], const double axis[3], double radius, struct lx_boundary_side *side,
                      double *unsure);

/* A cylinder as an element sees it: of the outline of all of it. */
struct lx_boundary_tube {
    double ends[2][3];           /* their centres */
    double out[3], away, height; /* of the element: from the axis, unit; how far; from the middle, along the axis */
    double axis[3], radius, half;
};

struct lx_boundary_tube lx_boundary_tube_of(const double center[3], const double axis[3], double radius, double half);

/* The rectangle between the two generators that are the outline of the side. */
struct lx_boundary_polygon lx_boundary_side_of_tube(const struct lx_boundary_tube *tube);

/* Where an obstacle stands, as far as can be told, but for what is *beyond_mm: BEYOND, it hides nothing, as rays to the
 * source do not reach it. */
enum lx_boundary_stand { LX_BOUNDARY_BEFORE, LX_BOUNDARY_BEYOND, LX_BOUNDARY_UNKNOWN };
enum lx_boundary_stand lx_boundary_stand(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                                         const struct lx_obstacle *obstacle, double *beyond_mm);

#endif
