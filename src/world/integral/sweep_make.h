/* SPDX-License-Identifier: MIT */
/* Making sweeps: what flat sources (sweep.c) and bodies (sweep_body.c) share. */
#ifndef LX_WORLD_SWEEP_MAKE_H
#define LX_WORLD_SWEEP_MAKE_H

#include "../../light/solid/elliptic.h"
#include "sweep.h"

/* Makes a vector of unit length, and returns the one that it had. */
double lx_sweep_normalize(double a[3]);

/* A frame with this x and, as far as that leaves the choice, its pole perpendicular to `across`. */
struct lx_sweep_frame lx_sweep_frame_about(const double x[3], const double across[3]);

/* 0, or -1 when memory ran out; and so say those that follow. */
int lx_sweeps_append(struct lx_sweeps *sweeps, const struct lx_sweep *sweep);

int lx_sweep_disk(const struct lx_emitter *emitter, const double center_mm[3], const double axis[3],
                  const double place_mm[3], const double across[3], struct lx_sweeps *sweeps);
int lx_sweep_ball(const struct lx_emitter *ball, const double place_mm[3], const double across[3],
                  struct lx_sweeps *sweeps);
/* The round ends of a capsule, whose centres and distance from the element, along the axis and from it, these are. */
int lx_sweep_round_ends(const struct lx_emitter *capsule, const double caps[2][3], const double axis[3], double along,
                        double away, const double place_mm[3], const double across[3], struct lx_sweeps *sweeps);
/* The share of an arc of the ball that is on the end. */
struct lx_arc lx_dome_arc(const struct lx_sweep *dome, struct lx_arc arc);
int lx_sweep_ellipsoid(const struct lx_emitter *ellipsoid, const double place_mm[3], const double across[3],
                       struct lx_sweeps *sweeps);
int lx_sweep_cylinder(const struct lx_emitter *cylinder, const double place_mm[3], const double across[3],
                      bool is_occluded, struct lx_sweeps *sweeps);

/* As lx_sweep_arc(), _distance() and _find() for them; a direction in x and y of the frame, x > 0. */
struct lx_arc lx_body_arc(const struct lx_sweep *sweep, double x);
double lx_body_distance(const struct lx_sweep *sweep, const struct lx_arc *arc, double cos_tau, double sin_tau,
                        double *incidence);
bool lx_body_find(const struct lx_sweep *sweep, double ahead, double aside, double *x);

#endif
