/* SPDX-License-Identifier: MIT */
/*
 * Links: what a receiver sees of each group, in the order of the trees, and with which weights the values at the nodes
 * of groups count in what it receives.  They stay right when tiles are cut, but for those of the tiles themselves that
 * were near or hidden in part.
 */
#ifndef LX_REFLECT_LINKS_H
#define LX_REFLECT_LINKS_H

#include "between.h"
#include "transfer.h"

/* Nothing of a group is seen, all of it from afar, all of it from nearby, or a part of it. */
enum lx_link_kind { LX_LINK_NONE, LX_LINK_FAR, LX_LINK_NEAR, LX_LINK_PART };

/* Whether a link holds for its tile as it is, and not for those that it is cut into. */
static inline bool lx_link_is_of_tile(enum lx_link_kind kind)
{
    return kind == LX_LINK_NEAR || kind == LX_LINK_PART;
}

struct lx_link {
    uint32_t group : 30;
    uint32_t kind : 2;
};

struct lx_weights {
    uint32_t group;
    float of[LX_RULE_NODES];
    float doubt, squares; /* of a tile, of its direct light (transfer.h), */
    double direct;
};

struct lx_links {
    struct lx_link *items;
    size_t count, capacity;
    struct lx_weights *weights; /* of those that are seen, in their order */
    size_t weight_count, weight_capacity;
    size_t known; /* so many groups there were */
    bool failed;  /* memory ran out */
};

/* Light that is sent beside direct light, and bounds of its error, at the nodes of groups; NULL: nothing. */
struct lx_light {
    const double *indirect, *slack;
};

/* Sums over all faces. */
struct lx_arrival {
    double value, slack;
    double seen; /* of all ways, how many end on faces */
};

struct lx_radiosity;

/* Brings links up to date: all of them, at first, of count 0; where the cones' effort is spent they stay as they
 * are. */
void lx_links_find(const struct lx_radiosity *reflected, const struct lx_prepared *prepared,
                   const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                   struct lx_occluder_cones *cones, struct lx_links *links);
struct lx_arrival lx_links_sum(const struct lx_radiosity *reflected, const struct lx_links *links,
                               const struct lx_light *light);
/* Errors of near tiles' direct light as they arrive. */
double lx_links_unsure_near(const struct lx_radiosity *reflected, const struct lx_links *links);
void lx_links_clear(struct lx_links *links);

/* Links of the places of a window: at the nodes of the rule, and finer ones between them; where light is linear at
 * three places in place of the nodes, and at the corners and in the middle. */
enum { LX_ROWS = LX_RULE_NODES + LX_BETWEEN, LX_LINEAR_NODES = 3 };
struct lx_rows {
    bool is_linear;
    struct lx_links of[LX_ROWS];
};

/* How many rows stand for the nodes. */
static inline int lx_rows_nodes(const struct lx_rows *rows)
{
    return rows->is_linear ? LX_LINEAR_NODES : LX_RULE_NODES;
}
/* Values at the nodes, of which the first lx_rows_nodes() are what arrives by the rows. */
void lx_rows_spread(const struct lx_rows *rows, double nodes[LX_RULE_NODES]);
/* The row of place p between the nodes. */
const struct lx_links *lx_rows_between(const struct lx_rows *rows, int p);

/* Brings the rows of a window of a face up to date, whose cell it is, as long as the cones have effort for it; 0, or
 * -1: memory ran out. */
int lx_rows_find(const struct lx_radiosity *reflected, uint32_t face, const struct lx_window *window,
                 const struct lx_tile_cell *cell, struct lx_occluder_cones *cones, struct lx_rows **rows);
void lx_rows_free(struct lx_rows *rows);

#endif
