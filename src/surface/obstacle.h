/* SPDX-License-Identifier: MIT */
/*
 * Obstacles: what a surface may put between an element and an extended source, piece by piece.
 *
 * A shaft is the space that light from a source may take to an element, or to elements that lie near to each other: the
 * hull of a ball around them and one around the source, cut by planes.  A kind of surface gathers its obstacles in a
 * shaft: convex pieces that together take exactly the light that `blocks` (surface.h) does.  One too many costs time
 * alone; one too few would be light where there is none.  A kind of many pieces, as a mesh, leaves out those of
 * which lx_shaft_meets_box() and the others tell that they are outside, a branch of its tree at a time.
 *
 * Obstacles take light from both of their sides, and may overlap.  What is nearer to the place than its `touch_mm`
 * hides nothing from it.
 *
 * A kind of very many triangles, its sheets, gathers their outlines instead, as seen from a single place: the edges
 * that sheets do not go on behind (world/visibility/outline.h), and those sheets that reach beyond the plane behind
 * which the source begins.  How many of them a way passes the kind's `layers` tells.
 */
#ifndef LX_SURFACE_OBSTACLE_H
#define LX_SURFACE_OBSTACLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../base/bounded.h"
#include "shape.h"

enum lx_obstacle_type {
    LX_OBSTACLE_SHAPE,   /* by the shape's `blocks`, for kinds that gather nothing: found by scanning */
    LX_OBSTACLE_POLYGON, /* plane and convex: corners, either way round */
    LX_OBSTACLE_DISK,    /* flat: centre, axis, radius */
    LX_OBSTACLE_BALL,    /* the surface of a ball: centre, radius */
    LX_OBSTACLE_TUBE,    /* the side of a cylinder with open ends: centre, axis, radius, half its height */
    LX_OBSTACLE_SPACE    /* what lies on the other side of a plane through the place; the axis looks to the open side */
};

enum { LX_OBSTACLE_CORNERS = 4 };

struct lx_obstacle {
    enum lx_obstacle_type type;
    bool is_around;        /* a ball or an endless tube that the place is inside of, or on and seen from inside */
    unsigned corner_count; /* 3 or 4 */
    double corners_mm[LX_OBSTACLE_CORNERS][3];
    double center_mm[3], axis[3], radius_mm, half_mm; /* the axis is a unit vector */
    double touch_mm;
    const struct lx_shape *shape; /* of LX_OBSTACLE_SHAPE */
};

/* An edge of sheets, and how many of them there are more on its left than on its right, as the place sees it. */
struct lx_outline_edge {
    double from_mm[3], to_mm[3];
    int change;
};

/* A triangle; corners of one name are at one place. */
struct lx_sheet {
    double corners_mm[3][3];
    uint32_t names[3];
    int turn; /* 1 where the corners run counter-clockwise as the place sees them, else -1 */
};

/* Lists; zero-initialise, and clear.  They may be used again: set the counts to 0. */
struct lx_obstacles {
    struct lx_obstacle *items;
    size_t count, capacity;
    struct lx_outline_edge *edges;
    size_t edge_count, edge_capacity;
    struct lx_sheet *sheets;
    size_t sheet_count, sheet_capacity;
    const struct lx_shape **layered; /* whose sheets may be in the shaft */
    size_t layered_count, layered_capacity;
};

/* 0, or -1 when memory ran out. */
int lx_obstacles_append(struct lx_obstacles *obstacles, const struct lx_obstacle *obstacle);
int lx_obstacles_append_edge(struct lx_obstacles *obstacles, const struct lx_outline_edge *edge);
int lx_obstacles_append_sheet(struct lx_obstacles *obstacles, const struct lx_sheet *sheet);
int lx_obstacles_append_layered(struct lx_obstacles *obstacles, const struct lx_shape *shape);
void lx_obstacles_clear(struct lx_obstacles *obstacles);

/* p.x + p[3] >= 0 for all places x of the shaft, p a unit vector, for each of the planes. */
enum { LX_SHAFT_PLANES = 12 };
struct lx_shaft {
    double from_mm[3], from_radius_mm; /* around the elements: 0 for a single one, which is at that place */
    double to_mm[3], to_radius_mm;     /* around the source */
    double planes[LX_SHAFT_PLANES][4];
    unsigned plane_count;
    double outline_radius_mm; /* around the source, and around the rectangles in which outlines are looked at */
    double before[4];         /* p.x + p[3] < 0 for all places of the source and beyond */
};

/* Whether something may come into the shaft: a ball, a box along the axes, the hull of some places. */
bool lx_shaft_meets_ball(const struct lx_shaft *shaft, const double center_mm[3], double radius_mm);
bool lx_shaft_meets_box(const struct lx_shaft *shaft, const double low_mm[3], const double high_mm[3]);
bool lx_shaft_meets_hull(const struct lx_shaft *shaft, const double (*places_mm)[3], size_t count);

/* Appends what a shape puts into the shaft; 0, or -1 when memory ran out. */
int lx_shape_gather(const struct lx_shape *shape, const struct lx_shaft *shaft, struct lx_obstacles *obstacles);

/* Gathers for a free element that the shape holds, at shaft->from_mm, with that unit normal: as lx_shape_hides(). */
int lx_shape_gather_beside(const struct lx_shape *shape, const double normal[3], const struct lx_shaft *shaft,
                           struct lx_obstacles *obstacles);

#endif
