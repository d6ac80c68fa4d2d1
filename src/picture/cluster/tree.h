/* SPDX-License-Identifier: MIT */
/*
 * Trees of clusters over many points, as in lightcuts (Walter et al. 2005): one for each set of points that differ in
 * nothing but place, intensity and axis, or for each large cloud of them.  A cluster shines like one point in its
 * middle, with an error that bound.h knows; the cut (cut.h) takes the largest clusters that are exact enough.
 *
 * The points are put in the order of Morton's curve (1966) and split where their codes differ first, so that a cluster
 * is what stands in one cell of an octree, or in half of one.
 */
#ifndef LX_PICTURE_TREE_H
#define LX_PICTURE_TREE_H

#include <stdint.h>

#include <luxel/status.h>

#include "../../base/rows.h"
#include "../../format/kept.h"
#include "../../light/emitter.h"
#include "jet.h"

/* Fewer points of a kind are not clustered. */
enum { LX_LEAST_CLUSTERED = 256 };

struct lx_cluster {
    double center_mm[3]; /* weighted by intensity */
    double strength;     /* of all its points */
    double radius_mm;    /* of a ball around the centre that holds them */
    double second;       /* sum of intensity times the square of the distance from the centre, mm^2 */
    uint32_t child;      /* two are there, one behind the other; 0: it is a leaf */
    uint32_t first, count;
};

/* Where the points of a cluster are turned to. */
struct lx_cluster_turn {
    double axis[3]; /* unit, in their middle */
    double spread;  /* the largest angle between it and the axis of a point */
    double sum;     /* of intensity times that angle */
};

/* The part of a tree that depends on the places, intensities and axes alone; it does not change once built. */
struct lx_built_tree {
    struct lx_kept kept;
    struct lx_cluster *clusters;
    struct lx_cluster_turn *turns; /* one for each, where they have axes */
    size_t cluster_count, leaf_count;
    uint32_t *points; /* which they are, cluster by cluster */
    size_t point_count;
    struct lx_point_set set; /* with the axes that it was built for, where it is of a point set */
};

struct lx_tree {
    struct lx_emitter model;     /* one of the points */
    bool has_axis;               /* their intensity depends on the direction */
    struct lx_power pattern;     /* of the cosine from the axis */
    struct lx_built_tree *built; /* shared by all that are built of one cloud */
    size_t first;                /* emitter that point 0 is */
    /* of it: */
    const struct lx_cluster *clusters;
    const struct lx_cluster_turn *turns;
    const uint32_t *points;
    size_t leaf_count;
};

struct lx_light_trees {
    struct lx_tree *trees;
    size_t tree_count;
};

/* A cloud of so many points gets a tree of its own, which is kept with it as long as only other things change. */
enum { LX_LEAST_KEPT = 4096 };

/*
 * Makes the trees of all points of which there are many of a kind.  LUXEL_OK, LUXEL_ERROR_MEMORY or LUXEL_CANCELLED;
 * release with lx_light_trees_clear() in any case.
 */
luxel_status lx_light_trees_build(const struct lx_emitters *emitters, struct lx_control *control,
                                  struct lx_light_trees *trees);
void lx_light_trees_clear(struct lx_light_trees *trees);

/* The emitter that a point of a tree is. */
static inline size_t lx_tree_emitter(const struct lx_tree *tree, size_t point)
{
    return tree->first + tree->points[point];
}

/* Whether an emitter is in a tree. */
bool lx_is_clustered(const struct lx_light_trees *trees, const struct lx_emitter *emitter);

#endif
