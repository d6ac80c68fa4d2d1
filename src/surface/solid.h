/* SPDX-License-Identifier: MIT */
/*
 * What surfaces make of a mesh: triangles of its faces with a tree over them, normals to shade them by, and what can be
 * said of it as a body.  Triangles and normals are kept with the mesh, for all scenes that share it.
 */
#ifndef LX_SURFACE_SOLID_H
#define LX_SURFACE_SOLID_H

#include "../format/mesh/mesh_survey.h"
#include "mesh_tree.h"

struct lx_solid {
    struct lx_kept kept;
    struct lx_mesh_tree *tree;
    unsigned (*places)[3]; /* of the corners of each triangle in the mesh's loop */
    size_t count;
    struct lx_mesh_note flat; /* triangles without area, which are left out */
    unsigned flat_face;       /* the number of the first one's face */
    struct lx_mesh_survey survey;
};

/* The solid of a mesh that has one, as one more user of it; NULL: memory ran out, or no triangle has an area, and then
 * *is_empty. */
struct lx_solid *lx_solid_of(const struct lx_mesh *mesh, bool *is_empty);

enum lx_solid_normals { LX_NORMALS_AUTO, LX_NORMALS_FILE, LX_NORMALS_SMOOTH, LX_NORMALS_FLAT };

/* Normals of the corners of triangles, turned to where these look to. */
struct lx_mesh_normals {
    struct lx_kept kept;
    enum lx_solid_normals way;
    double crease;
    double (*normals)[3]; /* unit */
    unsigned (*of)[3];    /* of each triangle; LX_NO_NORMAL three times: its own */
    size_t count;
};

/* Makes its normals; within a crease of so many degrees faces are shaded as one.  NULL: memory ran out. */
struct lx_mesh_normals *lx_normals_of(const struct lx_mesh *mesh, const struct lx_solid *solid,
                                      enum lx_solid_normals way, double crease);

/* Cuts a polygon, which may be concave and need not be quite flat, into count - 2 triangles of its corners, by ear
 * clipping; `room` for 3 count numbers. */
void lx_cut_polygon(const double (*corners)[3], const unsigned *loop, unsigned count, unsigned *room,
                    unsigned (*triangles)[3]);
enum { LX_LARGEST_POLYGON = 4096 };

#endif
