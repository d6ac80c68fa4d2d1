/* SPDX-License-Identifier: MIT */
/*
 * How wrong a cluster of points may be that shines like one: bounds that hold for every element of a region, by the
 * derivatives of what a point gives with respect to its place (docs/MATHS.md, "Many sources").
 */
#ifndef LX_PICTURE_BOUND_H
#define LX_PICTURE_BOUND_H

#include "../../world/blocking.h"
#include "../precision.h"
#include "jet.h"
#include "tree.h"

/* Directions within an angle of an axis, which its cosine and sine tell; cosine -1: all of them. */
struct lx_cone {
    double axis[3], cosine, sine;
};

/* Some elements of one surface: where they are, and which ways they face and are seen. */
struct lx_receiver_region {
    struct lx_ball places;
    struct lx_cone normals, views;
    struct lx_cone mirrored; /* V mirrored at N, of Phong's lobe */
    size_t count;
};

/* A lobe with what is known of its power. */
struct lx_lobe_limits {
    struct lx_lobe_double lobe;
    struct lx_power power;
};

struct lx_lobe_limits lx_lobe_limits_of(const struct lx_lobe_double *lobe);

/* The share that a cluster gives to an element of a region. */
struct lx_share_bound {
    double error; /* how far what its point in the middle gives may be off; infinite where there is no bound */
    double most;  /* no more than this */
    double least; /* no less */
};

/* `turn`: of the cluster where the tree has axes; `is_hidden`: other surfaces may stand in its way. */
struct lx_share_bound lx_bound_cluster(const struct lx_receiver_region *region, const double anchor_mm[3],
                                       const struct lx_lobe_limits *limits, const struct lx_tree *tree,
                                       const struct lx_cluster *cluster, const struct lx_cluster_turn *turn,
                                       bool is_hidden);

/* How a point, from the anchor, stands to a region. */
struct lx_stand lx_stand_of(const struct lx_receiver_region *region, const double place[3], bool has_half);

#endif
