/* SPDX-License-Identifier: MIT */
/*
 * The triangles of a mesh as flat sheets, for whoever integrates over surfaces, and which of them come into a convex
 * part of space.  Their numbers are those of the tree.
 */
#ifndef LX_SURFACE_MESH_FACES_H
#define LX_SURFACE_MESH_FACES_H

#include <stdint.h>

#include "mesh.h"
#include "sheet.h"

/* The most triangles that reflected light is calculated of, of all meshes together. */
enum { LX_MOST_REFLECTING = 2000 };

/* How many triangles a shape has; 0: it is no mesh. */
size_t lx_mesh_count(const struct lx_shape *shape);

/* The front of a triangle; false: it has no area. */
bool lx_mesh_sheet(const struct lx_shape *shape, size_t i, struct lx_smooth_sheet *sheet);
void lx_mesh_corners(const struct lx_shape *shape, size_t i, double corners_mm[3][3]);

/* Which triangles are there once more, either way round, with a lower number in the file: an array to free, or NULL
 * when memory ran out. */
bool *lx_mesh_repeated(const struct lx_shape *shape);

/*
 * Calls `take` for each edge, from one end to the other, along which faces do not go on behind it as a place sees it,
 * with the number of faces that there are more on the left of that way than on its right; until it returns false.
 */
void lx_mesh_outline(const struct lx_shape *shape, const double place_mm[3],
                     bool (*take)(void *data, const double from_mm[3], const double to_mm[3], int change), void *data);

/* The triangle that a place lies on, or the nearest one. */
size_t lx_mesh_triangle_at(const struct lx_shape *shape, const double place_mm[3]);

/* Sets the triangles that may come to where p.x + p[3] > 0 for all planes p, a unit vector and a number; how many of
 * them, but no more than most + 1: there are too many. */
enum { LX_REGION_PLANES = 10 };
size_t lx_mesh_within(const struct lx_shape *shape, const double (*planes)[4], unsigned count, size_t most,
                      uint32_t *found);

#endif
