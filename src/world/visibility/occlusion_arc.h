/* SPDX-License-Identifier: MIT */
/* What the files of obstacles on arcs (occlusion_arc.c, occlusion_tube.c) share. */
#ifndef LX_WORLD_OCCLUSION_ARC_H
#define LX_WORLD_OCCLUSION_ARC_H

#include "occlusion.h"

/* The names of an obstacle's bounds, beside its number. */
enum bound {
    EDGE,
    OTHER_EDGE = 3,
    ON_THE_SOURCE,
    TANGENT,
    OTHER_TANGENT,
    RIM,
    OTHER_RIM = RIM + 3,
    SCANNED,
    BOUNDS = 16
};

/* A half plane and the source in it. */
struct half_plane {
    const struct lx_sweep *sweep;
    const struct lx_arc *arc;
    const double *x, *y; /* unit directions */
    double n[3];         /* at right angles to both */
    double error_mm;
    /* the source: a line at so much x, a circle around (centre, 0), or an ellipse, of which nothing is nearer than a
     * distance */
    bool is_line, is_ellipse;
    double line_mm, center_mm, square, nearest_mm;
    unsigned name; /* of the obstacle's first bound */
};

struct point {
    double x, y;
};

/* Before which distance a ray has to meet an obstacle to be hidden. */
double lx_reach_of(const struct half_plane *half, double cos_tau, double sin_tau);

/* Latitudes between which an obstacle hides all or nothing, in their order. */
enum { MOST_CANDIDATES = 16 };

struct candidate {
    double tau, slack;
    enum bound bound;
};

struct candidates {
    struct candidate items[MOST_CANDIDATES];
    size_t count;
};

void lx_propose(struct candidates *candidates, double tau, double slack, enum bound bound);

/* Whether an obstacle hides what is seen at tau. */
typedef bool (*hides_test)(const struct half_plane *half, const struct lx_obstacle *obstacle, double tau);

/* Appends the parts of the arc between candidates, and its ends, whose middles are hidden. */
size_t lx_hide_between(const struct half_plane *half, const struct lx_obstacle *obstacle, hides_test hides,
                       const struct candidates *candidates, struct lx_hidden *hidden, size_t count);

/* Proposes where an obstacle begins and ceases to hide, of those that may reach into an ellipse. */
void lx_propose_by_scan(const struct half_plane *half, const struct lx_obstacle *obstacle, hides_test hides,
                        struct candidates *candidates);

/* What the side of a cylinder hides. */
size_t lx_hide_by_tube(const struct half_plane *half, const struct lx_obstacle *tube, struct lx_hidden *hidden,
                       size_t count);

#endif
