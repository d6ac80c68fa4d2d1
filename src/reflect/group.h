/* SPDX-License-Identifier: MIT */
/*
 * Groups: the tiles of each face in a tree.  A group is a window that was cut into others, down to the tiles; from afar
 * the light of all of its tiles goes by the nodes of its own rule, with coefficients that have the true integrals with
 * all polynomials of the rule's degree, as long as the whole group is seen.
 */
#ifndef LX_REFLECT_GROUP_H
#define LX_REFLECT_GROUP_H

#include "tile.h"

enum { LX_NO_GROUP = INT32_MAX };

/* A group keeps its number for good; what is in it has greater ones. */
struct lx_group {
    uint32_t face;
    uint32_t parent, child, sibling; /* the group around it, the first one in it, the next one beside it */
    uint32_t first_tile, tile_count; /* without a child it is that tile */
    struct lx_window window;
    struct lx_tile_cell cell;
    double across[LX_ORDER][LX_ORDER], upward[LX_ORDER][LX_ORDER]; /* values at its nodes of its parent's polynomials */
    double direct[LX_RULE_NODES];
    double unsure; /* direct_error of its tiles times their areas */
};

struct lx_radiosity;

/* A group behind the last one of its parent, or a whole face's; its number, or LX_NO_GROUP: memory ran out. */
uint32_t lx_group_add(struct lx_radiosity *reflected, uint32_t face, uint32_t parent, const struct lx_window *window);
/* Frees what a tile holds. */
void lx_tile_clear(struct lx_tile *tile);
/* Numbers tiles as they lie in the trees, with new ones where there are none; 0, or -1. */
int lx_groups_number(struct lx_radiosity *reflected);
/* Cuts the tiles of which that is asked, where their residuals change; 0, or -1. */
int lx_groups_cut(struct lx_radiosity *reflected, const bool *cuts);
/* Faces that stay, before anything has been cut; 0, or -1. */
int lx_groups_drop(struct lx_radiosity *reflected, const bool *stays);

/* Sets values at the nodes of all groups by those at the nodes of the tiles. */
void lx_groups_lift(const struct lx_radiosity *reflected, const double *tiles, double *groups);
/* The direct light of groups, of their tiles'. */
int lx_groups_light(struct lx_radiosity *reflected);

/* The group behind one and all that is in it, within the same face; LX_NO_GROUP: there is none. */
uint32_t lx_group_after(const struct lx_radiosity *reflected, uint32_t group);

#endif
