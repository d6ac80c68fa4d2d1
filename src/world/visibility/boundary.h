/* SPDX-License-Identifier: MIT */
/*
 * Visible boundaries: what obstacles leave of a source, by its borders, in float64.
 *
 * Bodies are the source, and the obstacles, each a convex cone of directions with the element at its tip: u is in it
 * where g.u > limit for all of its sides, u and g of unit length.  A side is bounded by its curve, a great circle, the
 * edge of a polygon, or a circle around g, the outline of a ball.  What is seen is bounded by pieces of these curves:
 * those that lie on the source and behind no other obstacle.  By the law 1/r^2 the irradiance is a sum over the pieces
 * (light/solid/extended.h).
 */
#ifndef LX_WORLD_BOUNDARY_H
#define LX_WORLD_BOUNDARY_H

#include "occlusion.h"

/* Sides of the source at most; bodies, and the sides of all obstacles together. */
enum { LX_BOUNDARY_SIDES = 12, LX_BOUNDARY_BODIES = 64, LX_BOUNDARY_OBSTACLE_SIDES = 132 };

struct lx_boundary_side {
    double g[3], limit;
    double from[3], to[3];   /* of a great circle's piece, its ends, of any length */
    bool is_circle;          /* or the outline of a disk; */
    double sine, p[3], q[3]; /* it is walked along limit g + sine (cos t p + sin t q), counter-clockwise about what is
                                inside; of a circle the sine of its angle, and two directions across g */
    double longest;          /* how long that is for each radian of t, at most, */
    double nearest_mm;       /* and how near to the element what is round comes there */
    bool is_cone;            /* of a disk: */
    double rows[3][3];       /* inside is what rows[0].u is more than the length of rows[1].u and rows[2].u */
};

struct lx_boundary_body {
    struct lx_boundary_side *sides;
    unsigned count;
    bool is_pipe; /* one that can be seen through */
};

/* Large: what is not needed of it stays as it is.  It stays where it is, as its bodies point to its sides. */
struct lx_boundary {
    struct lx_boundary_body bodies[LX_BOUNDARY_BODIES]; /* the source first, with room for the most sides */
    unsigned count;
    struct lx_boundary_side sides[LX_BOUNDARY_SIDES + LX_BOUNDARY_OBSTACLE_SIDES]; /* body behind body */
    bool has_hole; /* the sides of what is seen through a pipe, */
    struct lx_boundary_side hole[2];
    struct lx_boundary_side ends[2];  /* the outlines of both ends of a pipe that the element is in, */
    unsigned end_count;               /* which are all that it sees: 2, or 0 */
    double cuts[LX_MOST_HORIZONS][3]; /* only what has cut.u > 0 for all of these is seen */
    unsigned cut_count;
    double error_mm; /* how far all of it may be off, */
    double unsure;   /* and for how much of the solid angle it is not known whether it is seen */
};

/* A convex polygon as an element sees it: the directions of its corners, of any length. */
struct lx_boundary_polygon {
    double corners[LX_BOUNDARY_SIDES][3];
    unsigned count;
};

/* Makes the bodies of all obstacles before the source; false: there are other ones, or too many, or one of which it
 * cannot be told whether it is before the source wherever both are to be seen. */
bool lx_boundary_begin(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                       struct lx_boundary *boundary);

/* A convex part of a source as the element sees it: a polygon, or what of it is inside a curve. */
struct lx_boundary_shape {
    struct lx_boundary_polygon polygon;
    bool has_curve;
    struct lx_boundary_side curve;
};

struct lx_boundary_shapes {
    struct lx_boundary_shape items[3];
    unsigned count;
    double unsure; /* the solid angle of what is left out, as it is seen edge-on */
};

/* The shapes that together are all of a source, none where the element sees nothing of it; false: not known. */
bool lx_boundary_shape(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter,
                       struct lx_boundary_shapes *shapes);

/* Makes a shape an obstacle, so that what others share with it does not count twice; false: there are too many. */
bool lx_boundary_put_aside(const struct lx_boundary_shape *shape, struct lx_boundary *boundary);

/* The outline of one face; *away: its normal, away from the element if that sees it. */
bool lx_boundary_face(const struct lx_occlusion *occlusion, const struct lx_facets *facets, size_t face,
                      struct lx_boundary_polygon *outline, double away[3]);

/* Keeps the part of a convex polygon that the cuts leave; the polygon must have room for as many corners more. */
void lx_boundary_cut_all(const struct lx_boundary *boundary, struct lx_boundary_polygon *polygon);

/* Keeps the part of a convex polygon with normal.u > 0, if any; the polygon must have room for a corner more. */
void lx_boundary_cut(struct lx_boundary_polygon *polygon, const double normal[3]);

/*
 * Makes a body, which has room for that, of a polygon, or adds the circle of directions that meet a ball, or any
 * circle, to a body, as one more side.  False: it is seen edge-on, or the element is in the ball.
 */
bool lx_boundary_add_polygon(const struct lx_boundary_polygon *polygon, struct lx_boundary_body *body);
bool lx_boundary_add_ball(const double center[3], double radius, struct lx_boundary_body *body);
void lx_boundary_add_circle(const double axis[3], double cosine, double sine, struct lx_boundary_body *body);

/* The direction at t of a side's curve, of a great circle of any length. */
void lx_boundary_place(const struct lx_boundary_side *side, double t, double u[3]);

/* Takes a piece of a border of what is seen; `sign`: 1 where what is seen is on the inner side of the curve, -1 where
 * it is on the other.  What is unsure is added to.  False: there are too many sides or pieces, or a piece is missing or
 * counts twice, as the ends of all do not meet. */
typedef void lx_take_border(void *data, const struct lx_boundary_side *side, double from, double to, int sign);
bool lx_boundary_walk(struct lx_boundary *boundary, lx_take_border *take, void *data);
/* Walks around what is seen of a source over the element's horizon; *unsure: for how much of the solid angle that is
 * not known. */
bool lx_boundary_walk_source(const struct lx_emitter *emitter, const double normal[3],
                             const struct lx_occlusion *occlusion, lx_take_border *take, void *data, double *unsure);

/* For a radiance of 1, with a bound of its error.  False: it is not known, as there are other laws, sources or
 * obstacles, or too many, or one is not wholly before the source, or borders that touch cannot be told apart. */
bool lx_boundary_irradiance(const struct lx_emitter *emitter, const double normal[3],
                            const struct lx_occlusion *occlusion, lx_bounded *irradiance);

/* The irradiance by a view of a dome (light/sky/dome.h) that has a potential, for a radiance of 1 or, of a sky, in its
 * zenith, to a tolerance relative to the sum with what is known or to a small share of the whole sky, with its bound;
 * adds how many places of borders were looked at to *parts.  False: there are other obstacles, or too many, or that was
 * not reached. */
bool lx_boundary_sky(const struct lx_emitter *emitter, const double normal[3], const struct lx_occlusion *occlusion,
                     double tolerance, double known, lx_bounded *irradiance, size_t *parts);

#endif
