/* SPDX-License-Identifier: MIT */
/*
 * A tree over boxes along the axes, by which those of a scene's many surfaces are found that a line or a shaft may
 * meet, without asking each.  What it finds may be too much, never too little, and comes in the order of the surfaces,
 * so that whoever asks a few of them computes what asking all would give.
 */
#ifndef LX_WORLD_BOXES_H
#define LX_WORLD_BOXES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct lx_box {
    double low[3], high[3];
};

/* Zero-initialise, and clear. */
struct lx_boxes {
    struct lx_box_node *nodes; /* of many; NULL: there are few, and each is asked: */
    struct lx_box *boxes;
    size_t count;
    uint32_t node_count;
};

/* Boxes that are too few for a tree. */
enum { LX_FEW_BOXES = 48 };

/* More than so many are not listed: then each has to be asked. */
enum { LX_MOST_FOUND = 512 };

struct lx_found {
    uint32_t items[LX_MOST_FOUND]; /* ascending */
    size_t count;
};

/* Makes the tree; 0, or -1 when memory ran out. */
int lx_boxes_make(const struct lx_box *boxes, size_t count, struct lx_boxes *tree);
void lx_boxes_clear(struct lx_boxes *tree);

/* Whether something may be met that lies in a box. */
typedef bool lx_box_test(const void *data, const double low[3], const double high[3]);

/* Finds the boxes that a test, which answers for boxes around others as well, does not rule out.  False: there is
 * nothing to find them by, or they are too many. */
bool lx_boxes_find(const struct lx_boxes *tree, lx_box_test *may_meet, const void *data, struct lx_found *found);

/* The places `from` + t `way`, t from 0 to 1 or without end, with that much room around. */
struct lx_box_way {
    double from[3], each[3]; /* t for each mm */
    double room, end;
};
struct lx_box_way lx_box_way_of(const double from[3], const double way[3], double room, bool endless);
bool lx_box_way_meets(const void *way, const double low[3], const double high[3]);
bool lx_boxes_find_on_way(const struct lx_boxes *tree, const struct lx_box_way *way, struct lx_found *found);

/* The place of item i of those that are to be asked, which are all of `count` where nothing was found. */
static inline size_t lx_found_count(const struct lx_found *found, bool is_found, size_t count)
{
    return is_found ? found->count : count;
}
static inline size_t lx_found_at(const struct lx_found *found, bool is_found, size_t i)
{
    return is_found ? found->items[i] : i;
}

/* Whether a number is in an ascending list. */
bool lx_is_among(const uint32_t *list, size_t count, uint32_t number);

#endif
