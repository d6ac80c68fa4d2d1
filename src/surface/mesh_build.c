/* SPDX-License-Identifier: MIT */
/* Building the tree of a mesh: splits by the surface area heuristic, the cost of each guessed from some bins. */
#include <math.h>
#include <stdlib.h>

#include "../base/larger.h"
#include "../base/memory.h"
#include "mesh_edges.h"

enum {
    BINS = 16,
    LEAF = 4,                    /* no leaf has more triangles, unless they cannot be told apart */
    DEEPEST = LX_TREE_DEPTH - 34 /* from there on ranges are halved, of which there are no more than 32 */
};

/* What a step through a node costs, a triangle costing 1. */
static const float STEP = 0.7F;

struct box {
    float low[3], high[3];
};

/* A triangle while the tree is built. */
struct item {
    struct box box;
    uint32_t number;
};

struct build {
    struct lx_mesh_tree *tree;
    struct item *items;
};

static struct box empty_box(void)
{
    return (struct box){{HUGE_VALF, HUGE_VALF, HUGE_VALF}, {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF}};
}

static inline void extend(struct box *box, const struct box *by)
{
    for (int k = 0; k < 3; k++) {
        box->low[k] = by->low[k] < box->low[k] ? by->low[k] : box->low[k];
        box->high[k] = by->high[k] > box->high[k] ? by->high[k] : box->high[k];
    }
}

/* Half the area of a box. */
static float area(const struct box *box)
{
    const float x = box->high[0] - box->low[0], y = box->high[1] - box->low[1], z = box->high[2] - box->low[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
}

/* Twice the middle of an item along an axis. */
static inline float middle_of(const struct item *item, int axis)
{
    return item->box.low[axis] + item->box.high[axis];
}

/* Where a range of items is to be split: the bins from `bin` on go to the right. */
struct split {
    float cost; /* in areas times triangles; the range's own area times it */
    int axis, bin;
    float low, per; /* the bin of a middle m is (m - low) per */
};

static inline int bin_of(const struct split *split, const struct item *item)
{
    const int bin = (int)((middle_of(item, split->axis) - split->low) * split->per);
    return bin < BINS ? bin : BINS - 1;
}

struct bin {
    struct box box;
    uint32_t count;
};

/* The cheapest split between the bins of an axis. */
static void find_split(const struct bin bins[BINS], struct split *split)
{
    float right_areas[BINS];
    uint32_t right_counts[BINS], count = 0;
    struct box box = empty_box();
    for (int i = BINS - 1; i > 0; i--) {
        extend(&box, &bins[i].box);
        right_counts[i] = count += bins[i].count;
        right_areas[i] = area(&box);
    }
    box = empty_box();
    count = 0;
    split->cost = HUGE_VALF;
    for (int i = 1; i < BINS; i++) {
        extend(&box, &bins[i - 1].box);
        count += bins[i - 1].count;
        const float cost = area(&box) * (float)count + right_areas[i] * (float)right_counts[i];
        if (count > 0 && right_counts[i] > 0 && cost < split->cost) {
            split->cost = cost;
            split->bin = i;
        }
    }
}

static struct split best_split(const struct item *items, size_t count, const float low[3], const float high[3])
{
    struct split best = {.cost = HUGE_VALF};
    for (int axis = 0; axis < 3; axis++) {
        struct split split = {.axis = axis, .low = low[axis], .per = BINS / (high[axis] - low[axis])};
        struct bin bins[BINS];
        if (!(high[axis] > low[axis]) || !isfinite(split.per))
            continue;
        for (int i = 0; i < BINS; i++)
            bins[i] = (struct bin){empty_box(), 0};
        for (size_t i = 0; i < count; i++) {
            struct bin *bin = &bins[bin_of(&split, &items[i])];
            extend(&bin->box, &items[i].box);
            bin->count++;
        }
        find_split(bins, &split);
        if (split.cost < best.cost)
            best = split;
    }
    return best;
}

/* Brings the items of the left side to the front; how many there are. */
static size_t part(struct item *items, size_t count, const struct split *split)
{
    size_t left = 0, right = count;
    while (left < right)
        if (bin_of(split, &items[left]) < split->bin) {
            left++;
        } else {
            const struct item moved = items[left];
            items[left] = items[--right];
            items[right] = moved;
        }
    return left;
}

/* How many items go to the left; 0: they stay together, as a leaf. */
static size_t divide(struct item *items, size_t count, const struct box *box, unsigned depth)
{
    float low[3], high[3];
    if (count <= 1)
        return 0;
    if (depth >= DEEPEST)
        return count <= LEAF ? 0 : count / 2;
    for (int k = 0; k < 3; k++) {
        low[k] = HUGE_VALF, high[k] = -HUGE_VALF;
        for (size_t i = 0; i < count; i++) {
            const float middle = middle_of(&items[i], k);
            low[k] = middle < low[k] ? middle : low[k];
            high[k] = middle > high[k] ? middle : high[k];
        }
    }
    const struct split split = best_split(items, count, low, high);
    const float whole = area(box);
    if (!(split.cost < HUGE_VALF))
        return count <= LEAF ? 0 : count / 2;
    if (count <= LEAF && split.cost + STEP * whole >= whole * (float)count)
        return 0;
    return part(items, count, &split);
}

static struct box box_around(const struct item *items, size_t count)
{
    struct box box = empty_box();
    for (size_t i = 0; i < count; i++)
        extend(&box, &items[i].box);
    return box;
}

static void grow(const struct build *build, size_t first, size_t count, size_t left, unsigned depth);

/* Makes one side of a node: a leaf, or a node of its own. */
static void grow_side(const struct build *build, size_t node, int side, size_t first, size_t count, unsigned depth)
{
    struct lx_mesh_tree *tree = build->tree;
    const struct box box = box_around(build->items + first, count);
    for (int k = 0; k < 3; k++) {
        tree->nodes[node].ends[k][side] = box.low[k] - LX_TREE_ROOM;
        tree->nodes[node].ends[k][side + 2] = box.high[k] + LX_TREE_ROOM;
    }
    const size_t left = divide(build->items + first, count, &box, depth);
    tree->nodes[node].count[side] = left == 0 ? (uint32_t)count : LX_TREE_BRANCH;
    tree->nodes[node].child[side] = left == 0 ? (uint32_t)first : (uint32_t)tree->node_count;
    if (left > 0)
        grow(build, first, count, left, depth + 1);
}

/* Makes the node of a range, so many of which go to the left. */
static void grow(const struct build *build, size_t first, size_t count, size_t left, unsigned depth)
{
    const size_t node = build->tree->node_count++;
    grow_side(build, node, 0, first, left, depth);
    grow_side(build, node, 1, first + left, count - left, depth);
}

/* Finds the tree's frame: the middle of the box, and a power of two near its size. */
static void set_frame(struct lx_mesh_tree *tree, const double (*corners)[3], const unsigned (*triangles)[3],
                      size_t count)
{
    double size = 0;
    for (int k = 0; k < 3; k++) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = 0; i < count; i++)
            for (int c = 0; c < 3; c++) {
                low = lx_smaller(low, corners[triangles[i][c]][k]);
                high = lx_larger(high, corners[triangles[i][c]][k]);
            }
        tree->middle[k] = low / 2 + high / 2;
        size = lx_larger(size, high / 2 - low / 2);
    }
    tree->unit = size > 0 ? ldexp(1, ilogb(size) + 1) : 1;
}

static void set_triangle(struct lx_mesh_tree *tree, const double (*corners)[3], const unsigned triangle[3],
                         struct lx_tree_triangle *made)
{
    for (int c = 0; c < 3; c++) {
        double square = 0;
        for (int k = 0; k < 3; k++) {
            const double at = made->corners[c][k] = (corners[triangle[c]][k] - tree->middle[k]) / tree->unit;
            tree->low[k] = lx_smaller(tree->low[k], at);
            tree->high[k] = lx_larger(tree->high[k], at);
            square += at * at;
        }
        tree->farthest = lx_larger(tree->farthest, square);
        made->names[c] = triangle[c];
    }
}

static void set_item(const struct lx_tree_triangle *triangle, struct item *item)
{
    item->box = empty_box();
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            const float at = (float)triangle->corners[c][k];
            item->box.low[k] = at < item->box.low[k] ? at : item->box.low[k];
            item->box.high[k] = at > item->box.high[k] ? at : item->box.high[k];
        }
}

static void free_tree(struct lx_kept *kept)
{
    struct lx_mesh_tree *tree = (struct lx_mesh_tree *)kept;
    lx_tree_free_edges(tree);
    free(tree->nodes);
    free(tree->triangles);
    free(tree->places);
    free(tree);
}

/* The tree of a single leaf has a node whose other side is empty. */
static void grow_all(const struct build *build, size_t count)
{
    const struct box box = box_around(build->items, count);
    const size_t left = divide(build->items, count, &box, 0);
    if (left > 0) {
        grow(build, 0, count, left, 1);
        return;
    }
    struct lx_tree_node *node = &build->tree->nodes[build->tree->node_count++];
    for (int k = 0; k < 3; k++) {
        node->ends[k][0] = box.low[k] - LX_TREE_ROOM, node->ends[k][2] = box.high[k] + LX_TREE_ROOM;
        node->ends[k][1] = node->ends[k][0], node->ends[k][3] = node->ends[k][2];
    }
    node->count[0] = (uint32_t)count;
    node->child[0] = 0;
    node->count[1] = node->child[1] = 0;
}

struct lx_mesh_tree *lx_mesh_tree_new(const double (*corners)[3], const unsigned (*triangles)[3], size_t count)
{
    struct lx_mesh_tree *tree = lx_new_array(1, sizeof *tree);
    if (!tree)
        return NULL;
    lx_kept_init(&tree->kept, free_tree);
    tree->nodes = lx_new_aligned(count, sizeof *tree->nodes);
    tree->triangles = lx_new_aligned(count, sizeof *tree->triangles);
    tree->places = lx_new_aligned(count, sizeof *tree->places);
    tree->triangle_count = count;
    const struct build build = {tree, lx_new_aligned(count, sizeof *build.items)};
    if (!tree->nodes || !tree->triangles || !tree->places || !build.items) {
        free(build.items);
        lx_kept_release(&tree->kept);
        return NULL;
    }
    set_frame(tree, corners, triangles, count);
    for (int k = 0; k < 3; k++)
        tree->low[k] = HUGE_VAL, tree->high[k] = -HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        struct lx_tree_triangle triangle;
        set_triangle(tree, corners, triangles[i], &triangle);
        set_item(&triangle, &build.items[i]);
        build.items[i].number = (uint32_t)i;
    }
    tree->farthest = sqrt(tree->farthest);
    grow_all(&build, count);
    for (size_t i = 0; i < count; i++) {
        const uint32_t number = build.items[i].number;
        set_triangle(tree, corners, triangles[number], &tree->triangles[i]);
        tree->triangles[i].number = number;
        tree->places[number] = (uint32_t)i;
    }
    free(build.items);
    if (lx_tree_make_edges(tree)) {
        lx_kept_release(&tree->kept);
        return NULL;
    }
    return tree;
}
