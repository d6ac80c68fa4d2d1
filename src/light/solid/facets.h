/* SPDX-License-Identifier: MIT */
/* Facets: making them of outlines, boxes, meshes; their irradiance in closed form; cutting them into parts. */
#ifndef LX_LIGHT_FACETS_H
#define LX_LIGHT_FACETS_H

#include "../../base/pose.h"
#include "../emitter.h"
#include "area_light_facets.h"

/* What is wrong with an outline or a mesh, and where. */
enum lx_shape_fault {
    LX_SHAPE_GOOD,
    LX_SHAPE_TOO_SMALL,  /* no area, or fewer than 3 corners, or a doubled corner (`first`) */
    LX_SHAPE_NOT_FLAT,   /* corner `first` lies out of the plane of the others */
    LX_SHAPE_CROSSES,    /* edge `first` (from corner first to the next) meets edge `second` */
    LX_SHAPE_NOT_CLOSED, /* the edge from corner `second` to the next in face `first` has not just one partner */
    LX_SHAPE_NOT_CONVEX, /* corner `second` lies outside the plane of face `first` */
    LX_SHAPE_INWARD,     /* the faces' corners run clockwise as seen from outside: turn them round */
    LX_SHAPE_OUT_OF_MEMORY
};

struct lx_shape_report {
    enum lx_shape_fault fault;
    size_t first, second;
};

/*
 * A simple polygon in one plane (to 1e-6 of its size; faces take the plane of best fit), counter-clockwise as seen
 * from the lit side.  A convex one gives one lx_facets; another is cut into convex ones that share no area.  The
 * array is allocated; the caller frees each and the array.
 */
struct lx_shape_report lx_facets_of_outline(const double (*vertices_mm)[3], size_t count, struct lx_facets ***facets,
                                            size_t *facet_count);

/* A rectangle: axis is its normal, h runs along up made perpendicular to the axis, w along up x axis (SPEC 3). */
struct lx_facets *lx_facets_of_rectangle(const double center_mm[3], const double size_mm[2], const double axis[3],
                                         const double up[3]);

/* The same, however its axis was given. */
struct lx_facets *lx_facets_of_pose(const double center_mm[3], const double size_mm[2], const struct lx_pose *pose);

/* The other side of facets of one face that are open. */
struct lx_facets *lx_facets_turned(const struct lx_facets *sheet);

/* An axis-parallel box. */
struct lx_facets *lx_facets_of_box(const double center_mm[3], const double size_mm[3]);

/* How far corners may be off where they ought to be, and how far one is that is too far. */
struct lx_shape_rounding {
    double corner_mm;          /* to be set: each may be off so much along each axis, because its digits end */
    double off_mm, allowed_mm; /* of NOT_FLAT and NOT_CONVEX */
};

/* Any polyhedron: corners, then for each face the number of its corners and their indexes, counter-clockwise from
 * outside.  Must be closed, and flat and convex to 1e-6 of its size or to what the rounding of its corners (NULL: none)
 * makes of flat faces and convex bodies; bent faces become triangles.  Coplanar neighbours are allowed. */
struct lx_shape_report lx_facets_of_mesh(const double (*corners_mm)[3], size_t corner_count, const unsigned *loop,
                                         const unsigned *counts, size_t face_count, struct lx_shape_rounding *rounding,
                                         struct lx_facets **facets);

/* The polyhedron inscribed in a sphere: `meridians` (>= 3) half circles from pole to pole along z, the first at +x,
 * and meridians/2 (at least 2) bands of equal angle between the poles; NULL when memory ran out, or where the work
 * is to stop. */
struct lx_facets *lx_facets_make_sphere(const double center_mm[3], double radius_mm, unsigned meridians,
                                        const struct lx_asking *asking);

/* The prism of `sides` (>= 3) inscribed in a cylinder. */
struct lx_facets *lx_facets_make_cylinder(const double center_mm[3], double radius_mm, double height_mm,
                                          const double axis[3], unsigned sides, const struct lx_asking *asking);

/* The same, not to be stopped. */
static inline struct lx_facets *lx_facets_of_sphere(const double center_mm[3], double radius_mm, unsigned meridians)
{
    return lx_facets_make_sphere(center_mm, radius_mm, meridians, NULL);
}

static inline struct lx_facets *lx_facets_of_cylinder(const double center_mm[3], double radius_mm, double height_mm,
                                                      const double axis[3], unsigned sides)
{
    return lx_facets_make_cylinder(center_mm, radius_mm, height_mm, axis, sides, NULL);
}

/* As lx_extended_touches(), _irradiance(), _cut() for LX_FACETS. */
bool lx_facets_touch(const struct lx_facets *facets, lx_bounded3 place_mm);
/* for a radiance of 1 */
lx_bounded lx_facets_irradiance(const struct lx_facets *facets, lx_bounded3 place_mm, lx_bounded3 normal);
int lx_facets_cut(const struct lx_emitter *emitter, unsigned parts, struct lx_emitters *emitters);

#endif
