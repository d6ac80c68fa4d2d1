/* SPDX-License-Identifier: MIT */
/*
 * Trees over boxes: sorted along a curve through all of their middles (Morton's), the list is cut into quarters again
 * and again.  A node holds the boxes of its quarters side by side, so that a line is held against all four at once.
 */
#include "boxes.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/larger.h"
#include "../base/memory.h"

/* What roundings may do to shares of a way. */
static const double SLACK = 1e-9;

enum { WIDE = 4, MOST_DEPTH = 64, BITS = 21 };

struct lx_box_node {
    double low[3][WIDE], high[3][WIDE];
    uint32_t below[WIDE]; /* of each quarter the node, or of one box alone its number */
    uint32_t inner, used; /* bits: which quarters are nodes, and which there are */
};

/* A box on the curve. */
struct stop {
    uint64_t code;
    uint32_t box;
};

static int compare_stops(const void *first, const void *second)
{
    const struct stop *a = first, *b = second;
    if (a->code != b->code)
        return a->code < b->code ? -1 : 1;
    return a->box < b->box ? -1 : a->box > b->box;
}

/* Every third bit. */
static uint64_t spread(uint64_t bits)
{
    uint64_t result = 0;
    for (int i = 0; i < BITS; i++)
        result |= (bits >> i & 1) << (3 * i);
    return result;
}

static void add(struct lx_box *box, const struct lx_box *other)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = lx_smaller(box->low[k], other->low[k]);
        box->high[k] = lx_larger(box->high[k], other->high[k]);
    }
}

static uint64_t code_of(const struct lx_box *box, const struct lx_box *all)
{
    uint64_t code = 0;
    for (int k = 0; k < 3; k++) {
        const double share = (box->low[k] / 2 + box->high[k] / 2 - all->low[k]) / (all->high[k] - all->low[k]);
        const double cell = share > 0 ? fmin(share, 1) * ((1 << BITS) - 1) : 0; /* 0 of no number, too */
        code |= spread((uint64_t)cell) << k;
    }
    return code;
}

/* Puts a box into a quarter of a node. */
static void put(struct lx_box_node *node, int quarter, const struct lx_box *box)
{
    for (int k = 0; k < 3; k++) {
        node->low[k][quarter] = box->low[k];
        node->high[k][quarter] = box->high[k];
    }
    node->used |= 1U << quarter;
}

/* Makes the node of some stops, and those below; sets the box around them. */
static void make_node(struct lx_boxes *tree, const struct lx_box *boxes, const struct stop *stops, uint32_t count,
                      struct lx_box *around)
{
    const uint32_t at = tree->node_count++;
    struct lx_box_node *node = &tree->nodes[at];
    *node = (struct lx_box_node){.used = 0};
    for (uint32_t quarter = 0, first = 0, next; quarter < WIDE; quarter++, first = next) {
        next = (uint32_t)((uint64_t)count * (quarter + 1) / WIDE);
        if (next == first)
            continue;
        struct lx_box box = boxes[stops[first].box];
        node->below[quarter] = stops[first].box;
        if (next - first > 1) {
            node->inner |= 1U << quarter;
            node->below[quarter] = tree->node_count;
            make_node(tree, boxes, stops + first, next - first, &box);
        }
        put(node, (int)quarter, &box);
        if (first == 0)
            *around = box;
        add(around, &box);
    }
}

int lx_boxes_make(const struct lx_box *boxes, size_t count, struct lx_boxes *tree)
{
    *tree = (struct lx_boxes){.count = count};
    if (count == 0 || count > UINT32_MAX / 2) {
        tree->count = 0;
        return 0;
    }
    if (count <= LX_FEW_BOXES) {
        tree->boxes = lx_new_array(count, sizeof *tree->boxes);
        if (tree->boxes)
            memcpy(tree->boxes, boxes, count * sizeof *boxes);
        return tree->boxes ? 0 : -1;
    }
    struct stop *stops = lx_new_array(count, sizeof *stops);
    tree->nodes = lx_new_array(count, sizeof *tree->nodes); /* each has two quarters or more */
    const bool has_room = stops && tree->nodes;
    struct lx_box all = boxes[0];
    for (size_t i = 1; i < count; i++)
        add(&all, &boxes[i]);
    for (size_t i = 0; has_room && i < count; i++)
        stops[i] = (struct stop){code_of(&boxes[i], &all), (uint32_t)i};
    if (has_room) {
        qsort(stops, count, sizeof *stops, compare_stops);
        make_node(tree, boxes, stops, (uint32_t)count, &all);
    } else {
        lx_boxes_clear(tree);
    }
    free(stops);
    return has_room ? 0 : -1;
}

void lx_boxes_clear(struct lx_boxes *tree)
{
    free(tree->nodes);
    free(tree->boxes);
    *tree = (struct lx_boxes){.count = 0};
}

static int compare_items(const void *first, const void *second)
{
    const uint32_t a = *(const uint32_t *)first, b = *(const uint32_t *)second;
    return a < b ? -1 : a > b;
}

static void sort_items(struct lx_found *found)
{
    enum { FEW = 24 };
    if (found->count > FEW) {
        qsort(found->items, found->count, sizeof *found->items, compare_items);
        return;
    }
    for (size_t i = 1; i < found->count; i++) {
        const uint32_t moved = found->items[i];
        size_t k = i;
        for (; k > 0 && found->items[k - 1] > moved; k--)
            found->items[k] = found->items[k - 1];
        found->items[k] = moved;
    }
}

/* Tells of each quarter of a node whether something may be met in it, as bits. */
typedef unsigned node_test(const void *data, lx_box_test *may_meet, const struct lx_box_node *node);

static unsigned quarters_met(const void *data, lx_box_test *may_meet, const struct lx_box_node *node)
{
    unsigned met = 0;
    for (int i = 0; i < WIDE; i++) {
        const double low[3] = {node->low[0][i], node->low[1][i], node->low[2][i]};
        const double high[3] = {node->high[0][i], node->high[1][i], node->high[2][i]};
        if (node->used >> i & 1 && may_meet(data, low, high))
            met |= 1U << i;
    }
    return met;
}

/* The walk through a tree, for each test compiled by itself. */
static inline __attribute__((always_inline)) bool walk(const struct lx_boxes *tree, node_test *test,
                                                       lx_box_test *may_meet, const void *data, struct lx_found *found)
{
    uint32_t waiting[MOST_DEPTH];
    size_t depth = 0;
    waiting[depth++] = 0;
    found->count = 0;
    while (depth > 0) {
        const struct lx_box_node *node = &tree->nodes[waiting[--depth]];
        for (unsigned met = test(data, may_meet, node) & node->used; met != 0; met &= met - 1) {
            const unsigned i = (unsigned)__builtin_ctz(met);
            if (node->inner >> i & 1) {
                waiting[depth++] = node->below[i];
                continue;
            }
            if (found->count == LX_MOST_FOUND)
                return false;
            found->items[found->count++] = node->below[i];
        }
    }
    sort_items(found);
    return true;
}

static bool ask_each(const struct lx_boxes *boxes, lx_box_test *may_meet, const void *data, struct lx_found *found)
{
    found->count = 0;
    for (uint32_t i = 0; i < boxes->count; i++)
        if (may_meet(data, boxes->boxes[i].low, boxes->boxes[i].high))
            found->items[found->count++] = i;
    return boxes->count > 0;
}

bool lx_boxes_find(const struct lx_boxes *tree, lx_box_test *may_meet, const void *data, struct lx_found *found)
{
    return tree->nodes ? walk(tree, quarters_met, may_meet, data, found) : ask_each(tree, may_meet, data, found);
}

struct lx_box_way lx_box_way_of(const double from[3], const double way[3], double room, bool endless)
{
    struct lx_box_way made = {.room = room, .end = endless ? HUGE_VAL : 1 + SLACK};
    for (int k = 0; k < 3; k++) {
        made.from[k] = from[k];
        /* along a way of no length a box is met from no end to no end, or from beyond all on */
        made.each[k] = fabs(way[k]) > DBL_MIN ? 1 / way[k] : DBL_MAX;
    }
    return made;
}

/* The shares of a way between which it is in a box, narrowed by one axis. */
static inline void narrow(const struct lx_box_way *way, int axis, double low, double high, double *begin, double *end)
{
    const double a = (low - way->room - way->from[axis]) * way->each[axis];
    const double b = (high + way->room - way->from[axis]) * way->each[axis];
    *begin = lx_larger(*begin, lx_smaller(a, b));
    *end = lx_smaller(*end, lx_larger(a, b));
}

bool lx_box_way_meets(const void *data, const double low[3], const double high[3])
{
    const struct lx_box_way *way = data;
    double begin = -SLACK, end = way->end;
    for (int k = 0; k < 3; k++)
        narrow(way, k, low[k], high[k], &begin, &end);
    return begin - SLACK * fabs(begin) <= end;
}

static unsigned quarters_on_way(const void *data, lx_box_test *may_meet, const struct lx_box_node *node)
{
    const struct lx_box_way *way = data;
    double begin[WIDE], end[WIDE];
    unsigned met = 0;
    (void)may_meet;
    for (int i = 0; i < WIDE; i++)
        begin[i] = -SLACK, end[i] = way->end;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < WIDE; i++)
            narrow(way, k, node->low[k][i], node->high[k][i], &begin[i], &end[i]);
    for (int i = 0; i < WIDE; i++)
        met |= (unsigned)(begin[i] - SLACK * fabs(begin[i]) <= end[i]) << i;
    return met;
}

bool lx_boxes_find_on_way(const struct lx_boxes *tree, const struct lx_box_way *way, struct lx_found *found)
{
    return tree->nodes ? walk(tree, quarters_on_way, NULL, way, found) : ask_each(tree, lx_box_way_meets, way, found);
}

bool lx_is_among(const uint32_t *list, size_t count, uint32_t number)
{
    size_t low = 0, high = count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (list[middle] < number)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && list[low] == number;
}
