/* SPDX-License-Identifier: MIT */
/*
 * Trees over boxes: sorted along a curve through all of their middles (Morton's), the list is halved again and again;
 * an inner node's first half is the node behind it.
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

enum { LEAF = 4, MOST_DEPTH = 64, BITS = 21 };

struct lx_box_node {
    struct lx_box box;
    uint32_t first, count; /* of the boxes below; */
    uint32_t second;       /* the node of the second half; 0: a leaf */
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
        box->low[k] = fmin(box->low[k], other->low[k]);
        box->high[k] = fmax(box->high[k], other->high[k]);
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

/* Makes the node of a range of the order, and those below; returns the number behind the last. */
static uint32_t make_node(struct lx_boxes *tree, uint32_t at, uint32_t first, uint32_t count)
{
    struct lx_box_node *node = &tree->nodes[at];
    *node = (struct lx_box_node){.box = tree->boxes[first], .first = first, .count = count};
    for (uint32_t i = 1; i < count; i++)
        add(&node->box, &tree->boxes[first + i]);
    if (count <= LEAF)
        return at + 1;
    node->second = make_node(tree, at + 1, first, count / 2);
    return make_node(tree, node->second, first + count / 2, count - count / 2);
}

int lx_boxes_make(const struct lx_box *boxes, size_t count, struct lx_boxes *tree)
{
    *tree = (struct lx_boxes){NULL, NULL, NULL, 0};
    if (count == 0 || count > UINT32_MAX / 2)
        return 0;
    if (count <= LX_FEW_BOXES) {
        tree->boxes = lx_new_array(count, sizeof *tree->boxes);
        if (tree->boxes)
            memcpy(tree->boxes, boxes, count * sizeof *boxes);
        tree->count = count;
        return tree->boxes ? 0 : -1;
    }
    struct stop *stops = lx_new_array(count, sizeof *stops);
    tree->nodes = lx_new_array(2 * count, sizeof *tree->nodes);
    tree->order = lx_new_array(count, sizeof *tree->order);
    tree->boxes = lx_new_array(count, sizeof *tree->boxes);
    const bool has_room = stops && tree->nodes && tree->order && tree->boxes;
    struct lx_box all = boxes[0];
    for (size_t i = 1; i < count; i++)
        add(&all, &boxes[i]);
    for (size_t i = 0; has_room && i < count; i++)
        stops[i] = (struct stop){code_of(&boxes[i], &all), (uint32_t)i};
    if (has_room) {
        qsort(stops, count, sizeof *stops, compare_stops);
        for (size_t i = 0; i < count; i++)
            tree->order[i] = stops[i].box, tree->boxes[i] = boxes[stops[i].box];
        make_node(tree, 0, 0, (uint32_t)count);
        tree->count = count;
    } else {
        lx_boxes_clear(tree);
    }
    free(stops);
    return has_room ? 0 : -1;
}

void lx_boxes_clear(struct lx_boxes *tree)
{
    free(tree->nodes);
    free(tree->order);
    free(tree->boxes);
    *tree = (struct lx_boxes){NULL, NULL, NULL, 0};
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

static void ask_each(const struct lx_boxes *boxes, lx_box_test *may_meet, const void *data, struct lx_found *found)
{
    for (uint32_t i = 0; i < boxes->count; i++)
        if (may_meet(data, boxes->boxes[i].low, boxes->boxes[i].high))
            found->items[found->count++] = i;
}

bool lx_boxes_find(const struct lx_boxes *tree, lx_box_test *may_meet, const void *data, struct lx_found *found)
{
    uint32_t waiting[MOST_DEPTH];
    size_t depth = 0;
    found->count = 0;
    if (!tree->nodes) {
        ask_each(tree, may_meet, data, found);
        return tree->count > 0;
    }
    waiting[depth++] = 0;
    while (depth > 0) {
        const uint32_t at = waiting[--depth];
        const struct lx_box_node *node = &tree->nodes[at];
        if (!may_meet(data, node->box.low, node->box.high))
            continue;
        if (node->second > 0) {
            waiting[depth++] = node->second;
            waiting[depth++] = at + 1;
            continue;
        }
        for (uint32_t i = node->first; i < node->first + node->count; i++) {
            if (!may_meet(data, tree->boxes[i].low, tree->boxes[i].high))
                continue;
            if (found->count == LX_MOST_FOUND)
                return false;
            found->items[found->count++] = tree->order[i];
        }
    }
    sort_items(found);
    return true;
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

bool lx_box_way_meets(const void *data, const double low[3], const double high[3])
{
    const struct lx_box_way *way = data;
    double begin = -SLACK, end = way->end;
    for (int k = 0; k < 3; k++) {
        const double a = (low[k] - way->room - way->from[k]) * way->each[k];
        const double b = (high[k] + way->room - way->from[k]) * way->each[k];
        const double first = lx_smaller(a, b), last = lx_larger(a, b);
        begin = lx_larger(begin, first);
        end = lx_smaller(end, last);
    }
    return begin - SLACK * fabs(begin) <= end;
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
