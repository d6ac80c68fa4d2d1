/* SPDX-License-Identifier: MIT */
/*
 * Sweeps: an extended source, as an element sees it, covered by arcs of great circles.  An arc runs in latitude tau
 * about a pole d at the longitude beta; its directions are L = e(beta) cos(tau) + d sin(tau), and
 *
 *     integral over the source of f dw = sum over the sweeps of integral_0^1 dx measure(x) integral dtau cos(tau) f.
 *
 * The straight lines of a flat source that are parallel to d are such arcs, and so are a cylinder's generators.
 * Each sweep is smooth in x; where it would not be, the source is cut into several.
 */
#ifndef LX_WORLD_SWEEP_H
#define LX_WORLD_SWEEP_H

#include <stdbool.h>
#include <stddef.h>

#include "../../light/solid/extended.h"

/* Right-handed: e(beta) = x cos(beta) + y sin(beta), the pole z. */
struct lx_sweep_frame {
    double x[3], y[3], z[3];
};

enum lx_sweep_kind {
    LX_SWEEP_STRIP,
    LX_SWEEP_DISK,
    LX_SWEEP_BALL,
    LX_SWEEP_DOME,      /* a round end, of the ball that it is half of: its axis is the pole */
    LX_SWEEP_ELLIPSOID, /* an opening */
    LX_SWEEP_SIDE,
    LX_SWEEP_TUBE /* all of a cylinder's side, as an opening; its incidence is told so that areas come out right */
};

/* Sides of a ball or an ellipsoid as an opening, which is seen through: what stands within hides the far one alone. */
enum lx_sweep_wall { LX_BOTH_WALLS, LX_NEAR_WALL, LX_FAR_WALL };

struct lx_sweep {
    enum lx_sweep_kind kind;
    enum lx_sweep_wall wall;
    struct lx_sweep_frame frame;
    double height_mm; /* of a flat source's plane over the element; from the axis of a cylinder, from a ball's centre */
    double radius_mm; /* of the round ones; of an ellipse half of what it measures across the arcs */
    double y_mm, s_mm; /* the centre in the source's plane, from the element's foot: across and along the arcs; for
                          a side s is its lower end */
    double length_mm;  /* of a cylinder's side */
    /* of a strip, offsets from the centre: from y1 to y2, there from s1 to s1 + width1, here to s2 + width2; of a
     * disk y1 and y2 from the foot */
    double y1_mm, y2_mm, s1_mm, s2_mm, width1_mm, width2_mm;
    double half_mm, slope; /* of a disk: half the chord through its middle, and how the middles of others move */
    double angle1, angle;  /* the range of the parameter of bodies: first, width */
    /* of a tube, in x and y of the frame: from the element to its nearest place, whose angle that is, and half axes */
    double near_mm[2], nearest, first_mm[2], second_mm[2];
    /* of an ellipsoid, as a unit sphere: directions over half axes, the way to its centre, which is so long, and at
     * right angles to that the pole and the third direction; the square of the length, less 1; the sine and the cosine
     * of the angle between the middle and the sides; latitudes as tangents in the middle; the pole's length */
    double ways[3][3], center[3], away, pole[3], third[3], beyond, sine, cosine, spread, pole_length;
};

struct lx_arc {
    double direction[3]; /* at tau = 0 */
    double measure;      /* d beta/d x */
    double from, width;  /* in tau */
    bool round;          /* its ends are tangent to the source: integrands may go like square roots there */
    double distance_mm;  /* to the place at tau = 0 */
    double slant;        /* cosine of incidence at tau = 0, of a side; what lx_sweep_far() needs, of an ellipsoid */
};

/* What is nearer to the plane of an opening than this share of its distance is so far from it. */
#define LX_FLATTEST 1e-13

/* A list; zero-initialise, free `items` with free(). */
struct lx_sweeps {
    struct lx_sweep *items;
    size_t count, capacity;
};

/*
 * The sweeps of what an element at a place sees of a source, horizon apart.  Arcs of flat sources and balls run
 * perpendicularly to `across`, so that its angle from L is easy along them.  Where something is in the way, sweeps of
 * tubes are cut so that each has a longitude once, and those of balls have one side.  0, or -1 when memory ran out.
 */
int lx_sweeps_make(const struct lx_emitter *emitter, const double place_mm[3], const double across[3], bool is_occluded,
                   struct lx_sweeps *sweeps);

struct lx_arc lx_sweep_arc(const struct lx_sweep *sweep, double x);

/* Whether it is a part of a ball or an ellipsoid, so that arcs meet it on a circle or an ellipse, else on a line. */
static inline bool lx_sweep_bulges(const struct lx_sweep *sweep)
{
    return sweep->kind == LX_SWEEP_BALL || sweep->kind == LX_SWEEP_DOME || sweep->kind == LX_SWEEP_ELLIPSOID;
}

/* How far the source is along the direction at tau, and the cosine of its incidence there (>= 0). */
double lx_sweep_distance(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau,
                         double *incidence);

/*
 * Where the arc leaves a ball or an ellipsoid, whose far side belongs to an opening, too; and the incidences on the
 * near and on the far side with all the digits that they have at tau, towards the ends of the arc.
 */
double lx_sweep_far(const struct lx_sweep *sweep, const struct lx_arc *arc, double tau, double incidences[2]);

/* The part of the rectangle x = 1 of their frame that tubes and ellipsoids take, and the x between which they are. */
struct lx_sweep_bounds {
    double u[2], v[2]; /* y/x, z/x */
    double x_mm[2];
};
struct lx_sweep_bounds lx_sweep_bound(const struct lx_sweep *sweep);

/*
 * Changes its sign at the x whose arc comes nearest to the element, of a sweep whose arcs pass by it so quickly that
 * the integral across them has a peak there; 1 where they do not.  A needle of a face is one, aslant to its arcs.
 */
double lx_sweep_approach(const struct lx_sweep *sweep, double x);

/* Arcs nearer to each other in x are the same one, as far as rounding tells. */
#define LX_SAME_ARC 1e-13

/* The x of the arc at whose longitude a direction (of any length) lies, that of an end where rounding cannot tell it
 * from there; false: the sweep has none. */
bool lx_sweep_find(const struct lx_sweep *sweep, const double towards[3], double *x);

#endif
