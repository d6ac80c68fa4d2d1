/* SPDX-License-Identifier: MIT */
/* Planting: the kinds of points, their order by sorting codes, and the clusters from the leaves up. */
#include "tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"

enum {
    MOST_KINDS = 16, /* more are not looked for: their points are summed */
    LEAF = 8,
    CELL_BITS = 16, /* of a code for each axis */
    DIGIT = 12,     /* bits that are sorted by at once */
    DIGITS = 3 * CELL_BITS / DIGIT,
    BETWEEN_CHECKS = 4096
};

static bool same_kind(const struct lx_emitter *a, const struct lx_emitter *b)
{
    const struct lx_profile *p = &a->profile, *q = &b->profile;
    return a->type == LX_POINT && b->type == LX_POINT && a->is_part == b->is_part && a->attenuation == b->attenuation &&
           (a->attenuation != LX_PRACTICAL || a->k_mm == b->k_mm) && p->falloff == q->falloff &&
           p->exponent == q->exponent &&
           (p->falloff == LX_NO_CONE ||
            (p->inner_rad.value == q->inner_rad.value && p->outer_rad.value == q->outer_rad.value));
}

static bool goes_on(struct lx_control *control, size_t i)
{
    return i % BETWEEN_CHECKS != 0 || lx_control_goes_on(control, true);
}

/* ---- kinds ---- */

struct kinds {
    const struct lx_emitter *models[MOST_KINDS];
    size_t points[MOST_KINDS], count;
};

static void count_points(struct kinds *kinds, const struct lx_emitter *emitter, size_t points)
{
    size_t kind = 0;
    if (emitter->type != LX_POINT)
        return;
    while (kind < kinds->count && !same_kind(kinds->models[kind], emitter))
        kind++;
    if (kind == MOST_KINDS)
        return;
    kinds->models[kind] = emitter;
    kinds->points[kind] += points;
    kinds->count += kind == kinds->count;
}

static void find_kinds(const struct lx_emitters *emitters, struct kinds *kinds)
{
    for (struct lx_emitter_span span = {0}; lx_emitters_next(emitters, &span);) {
        if (span.swarm)
            count_points(kinds, &span.swarm->model, span.end - span.first);
        for (size_t i = span.first; span.items && i < span.end; i++)
            count_points(kinds, &span.items[i - span.first], 1);
    }
}

/* ---- order ---- */

/* A point with its code. */
struct coded {
    uint64_t code;
    uint32_t point;
};

/* What a tree is made from. */
struct planting {
    const struct lx_emitters *emitters;
    struct lx_control *control;
    struct lx_tree *tree;
    struct coded *order, *other;
    size_t cluster_capacity, turn_capacity;
};

/* Lists the points of the kind that shine at all. */
static luxel_status list_points(struct planting *planting)
{
    const struct lx_tree *tree = planting->tree;
    size_t count = 0;
    double row[4];
    for (struct lx_emitter_span span = {0}; lx_emitters_next(planting->emitters, &span);) {
        bool is_swarm = span.swarm && same_kind(&span.swarm->model, &tree->model);
        for (size_t i = span.first; i < span.end && (is_swarm || span.items); i++) {
            if (span.items && !same_kind(&span.items[i - span.first], &tree->model))
                continue;
            lx_emitter_row(planting->emitters, i, row);
            if (row[3] > 0)
                planting->order[count++].point = (uint32_t)i;
            if (!goes_on(planting->control, i))
                return LUXEL_CANCELLED;
        }
    }
    planting->tree->point_count = count;
    return LUXEL_OK;
}

/* Puts the bits of a number of CELL_BITS bits three apart. */
static uint64_t spread_bits(uint64_t cell)
{
    cell = (cell | cell << 32) & UINT64_C(0x001F00000000FFFF);
    cell = (cell | cell << 16) & UINT64_C(0x001F0000FF0000FF);
    cell = (cell | cell << 8) & UINT64_C(0x100F00F00F00F00F);
    cell = (cell | cell << 4) & UINT64_C(0x10C30C30C30C30C3);
    return (cell | cell << 2) & UINT64_C(0x1249249249249249);
}

/* The cube that the points stand in, by its lowest corner and its size. */
static luxel_status find_cube(const struct planting *planting, double low[3], double *size)
{
    double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, row[4];
    for (int k = 0; k < 3; k++)
        low[k] = HUGE_VAL;
    for (size_t i = 0; i < planting->tree->point_count; i++) {
        lx_emitter_row(planting->emitters, planting->order[i].point, row);
        for (int k = 0; k < 3; k++) {
            low[k] = row[k] < low[k] ? row[k] : low[k];
            high[k] = row[k] > high[k] ? row[k] : high[k];
        }
        if (!goes_on(planting->control, i))
            return LUXEL_CANCELLED;
    }
    *size = fmax(fmax(high[0] - low[0], high[1] - low[1]), high[2] - low[2]);
    return LUXEL_OK;
}

static luxel_status code_points(struct planting *planting)
{
    const double cells = 1 << CELL_BITS;
    double low[3], row[4], size;
    luxel_status status = find_cube(planting, low, &size);
    for (size_t i = 0; i < planting->tree->point_count && status == LUXEL_OK; i++) {
        uint64_t code = 0;
        lx_emitter_row(planting->emitters, planting->order[i].point, row);
        for (int k = 0; k < 3; k++) {
            double cell = (row[k] - low[k]) / size * cells; /* no number where all stand at one place */
            code |= spread_bits((uint64_t)(cell > 0 ? fmin(cell, cells - 1) : 0)) << k;
        }
        planting->order[i].code = code;
        if (!goes_on(planting->control, i))
            status = LUXEL_CANCELLED;
    }
    return status;
}

/* Sorts by one digit of the codes, stably; the order is in the other list then. */
static luxel_status sort_by_digit(struct planting *planting, unsigned shift)
{
    size_t begin[1 << DIGIT] = {0}, sum = 0;
    const size_t count = planting->tree->point_count;
    const uint64_t mask = (1 << DIGIT) - 1;
    struct coded *order = planting->order, *other = planting->other;
    for (size_t i = 0; i < count; i++)
        begin[order[i].code >> shift & mask]++;
    for (size_t digit = 0; digit <= mask; digit++) {
        size_t here = begin[digit];
        begin[digit] = sum;
        sum += here;
    }
    for (size_t i = 0; i < count; i++) {
        other[begin[order[i].code >> shift & mask]++] = order[i];
        if (!goes_on(planting->control, i))
            return LUXEL_CANCELLED;
    }
    planting->order = other;
    planting->other = order;
    return LUXEL_OK;
}

static luxel_status sort_points(struct planting *planting)
{
    luxel_status status = LUXEL_OK;
    planting->other = lx_new_array(planting->tree->point_count, sizeof *planting->other);
    if (!planting->other)
        return LUXEL_ERROR_MEMORY;
    for (unsigned digit = 0; digit < DIGITS && status == LUXEL_OK; digit++)
        status = sort_by_digit(planting, digit * DIGIT);
    free(planting->other);
    planting->other = NULL;
    return status;
}

/* ---- clusters ---- */

/* The box around some points. */
struct box {
    double low[3], high[3];
};

static double length_of(const double a[3])
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* The angle between unit vectors. */
static double angle_between(const double a[3], const double b[3])
{
    double off[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return 2 * asin(fmin(length_of(off) / 2, 1));
}

/* Makes the sum of axes one of length 1; of axes that make nothing any one. */
static void make_unit(double axis[3])
{
    double length = length_of(axis);
    bool is_lost = !(length > 0);
    for (int k = 0; k < 3; k++)
        axis[k] = is_lost ? (k == 2) : axis[k] / length;
}

/* The farthest that a place of the box can be from the centre. */
static double farthest(const struct box *box, const double center[3])
{
    double far[3];
    for (int k = 0; k < 3; k++)
        far[k] = fmax(center[k] - box->low[k], box->high[k] - center[k]);
    return length_of(far);
}

static struct box make_leaf(const struct planting *planting, struct lx_cluster *leaf)
{
    struct box box = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    double rows[LEAF][4], greatest = 0, sum[3] = {0}, weights = 0;
    for (size_t i = 0; i < leaf->count; i++) {
        lx_emitter_row(planting->emitters, planting->order[leaf->first + i].point, rows[i]);
        leaf->strength += rows[i][3];
        greatest = fmax(greatest, rows[i][3]);
    }
    for (size_t i = 0; i < leaf->count; i++) {
        double weight = rows[i][3] / greatest; /* sums of these are no more than LEAF times the largest place */
        weights += weight;
        for (int k = 0; k < 3; k++) {
            sum[k] += weight * rows[i][k];
            box.low[k] = fmin(box.low[k], rows[i][k]);
            box.high[k] = fmax(box.high[k], rows[i][k]);
        }
    }
    for (int k = 0; k < 3; k++)
        leaf->center_mm[k] = sum[k] / weights;
    for (size_t i = 0; i < leaf->count; i++) {
        double off[3];
        for (int k = 0; k < 3; k++)
            off[k] = rows[i][k] - leaf->center_mm[k];
        double away = length_of(off);
        leaf->radius_mm = fmax(leaf->radius_mm, away);
        leaf->second += rows[i][3] * away * away;
    }
    return box;
}

static void turn_leaf(const struct planting *planting, const struct lx_cluster *leaf, struct lx_cluster_turn *turn)
{
    double axes[LEAF][3], strengths[LEAF];
    for (size_t i = 0; i < leaf->count; i++) {
        struct lx_emitter room;
        const struct lx_emitter *point =
            lx_emitter_at(planting->emitters, planting->order[leaf->first + i].point, &room);
        const lx_bounded3 *axis = &point->profile.axis;
        strengths[i] = point->strength;
        axes[i][0] = axis->x.value, axes[i][1] = axis->y.value, axes[i][2] = axis->z.value;
        for (int k = 0; k < 3; k++)
            turn->axis[k] += strengths[i] / leaf->strength * axes[i][k];
    }
    make_unit(turn->axis);
    for (size_t i = 0; i < leaf->count; i++) {
        double angle = angle_between(turn->axis, axes[i]);
        turn->spread = fmax(turn->spread, angle);
        turn->sum += strengths[i] * angle;
    }
}

static void join(const struct lx_cluster parts[2], const struct box *box, struct lx_cluster *whole)
{
    whole->strength = parts[0].strength + parts[1].strength;
    const double share = parts[1].strength / whole->strength;
    for (int k = 0; k < 3; k++)
        whole->center_mm[k] = parts[0].center_mm[k] + share * (parts[1].center_mm[k] - parts[0].center_mm[k]);
    for (int p = 0; p < 2; p++) {
        double off[3];
        for (int k = 0; k < 3; k++)
            off[k] = parts[p].center_mm[k] - whole->center_mm[k];
        double away = length_of(off);
        whole->radius_mm = fmax(whole->radius_mm, away + parts[p].radius_mm);
        whole->second += parts[p].second + parts[p].strength * away * away;
    }
    whole->radius_mm = fmin(whole->radius_mm, farthest(box, whole->center_mm));
}

static void join_turns(const struct lx_cluster parts[2], const struct lx_cluster_turn turns[2],
                       struct lx_cluster_turn *whole)
{
    for (int p = 0; p < 2; p++)
        for (int k = 0; k < 3; k++)
            whole->axis[k] += parts[p].strength / (parts[0].strength + parts[1].strength) * turns[p].axis[k];
    make_unit(whole->axis);
    for (int p = 0; p < 2; p++) {
        double angle = angle_between(whole->axis, turns[p].axis);
        whole->spread = fmin(fmax(whole->spread, angle + turns[p].spread), M_PI);
        whole->sum += turns[p].sum + parts[p].strength * angle;
    }
}

/* Where to split the points first ... end - 1: where their codes differ first, or in the middle of equal ones. */
static size_t split(const struct coded *order, size_t first, size_t end)
{
    const uint64_t different = order[first].code ^ order[end - 1].code;
    size_t low = first, high = end - 1;
    if (different == 0)
        return first + (end - first) / 2;
    const uint64_t bit = UINT64_C(1) << (63 - __builtin_clzll(different));
    while (high - low > 1) { /* low has not the bit, high has it */
        size_t middle = low + (high - low) / 2;
        if (order[middle].code & bit)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* Room for two more clusters; 0, which is the root's place, when memory ran out. */
static size_t add_children(struct planting *planting)
{
    struct lx_tree *tree = planting->tree;
    const size_t at = tree->cluster_count, needed = at + 2;
    if (lx_reserve(&tree->clusters, &planting->cluster_capacity, needed, sizeof *tree->clusters) ||
        (tree->has_axis && lx_reserve(&tree->turns, &planting->turn_capacity, needed, sizeof *tree->turns)))
        return 0;
    tree->cluster_count = needed;
    return at;
}

/* Makes cluster `at` of the points first ... end - 1, and all below it. */
static luxel_status grow(struct planting *planting, size_t at, size_t first, size_t end, struct box *box)
{
    struct lx_tree *tree = planting->tree;
    struct lx_cluster made = {.first = (uint32_t)first, .count = (uint32_t)(end - first)};
    struct lx_cluster_turn turn = {0};
    if (end - first <= LEAF) {
        if (!goes_on(planting->control, tree->leaf_count++))
            return LUXEL_CANCELLED;
        *box = make_leaf(planting, &made);
        if (tree->has_axis)
            turn_leaf(planting, &made, &turn);
    } else {
        struct box other;
        size_t middle = split(planting->order, first, end), child = add_children(planting);
        luxel_status status = child > 0 ? grow(planting, child, first, middle, box) : LUXEL_ERROR_MEMORY;
        if (status == LUXEL_OK)
            status = grow(planting, child + 1, middle, end, &other);
        if (status != LUXEL_OK)
            return status;
        for (int k = 0; k < 3; k++) {
            box->low[k] = fmin(box->low[k], other.low[k]);
            box->high[k] = fmax(box->high[k], other.high[k]);
        }
        made.child = (uint32_t)child;
        join(&tree->clusters[child], box, &made);
        if (tree->has_axis)
            join_turns(&tree->clusters[child], &tree->turns[child], &turn);
    }
    tree->clusters[at] = made;
    if (tree->has_axis)
        tree->turns[at] = turn;
    return LUXEL_OK;
}

static luxel_status grow_all(struct planting *planting)
{
    struct lx_tree *tree = planting->tree;
    struct box box;
    /* The root has no neighbour; one cluster stays unused. */
    add_children(planting);
    if (tree->cluster_count == 0)
        return LUXEL_ERROR_MEMORY;
    luxel_status status = grow(planting, 0, 0, tree->point_count, &box);
    if (status != LUXEL_OK)
        return status;
    void *fitting = realloc(tree->clusters, tree->cluster_count * sizeof *tree->clusters);
    tree->clusters = fitting ? fitting : tree->clusters;
    tree->points = lx_new_array(tree->point_count, sizeof *tree->points);
    for (size_t i = 0; tree->points && i < tree->point_count; i++)
        tree->points[i] = planting->order[i].point;
    return tree->points ? LUXEL_OK : LUXEL_ERROR_MEMORY;
}

static luxel_status plant(const struct lx_emitters *emitters, struct lx_control *control, size_t points,
                          struct lx_tree *tree)
{
    struct planting planting = {
        .emitters = emitters,
        .control = control,
        .tree = tree,
        .order = lx_new_array(points, sizeof *planting.order),
    };
    luxel_status status = planting.order ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        status = list_points(&planting);
    if (status == LUXEL_OK && tree->point_count > 0)
        status = code_points(&planting);
    if (status == LUXEL_OK && tree->point_count > 0)
        status = sort_points(&planting);
    if (status == LUXEL_OK && tree->point_count > 0)
        status = grow_all(&planting);
    free(planting.order);
    free(planting.other);
    return status;
}

luxel_status lx_forest_plant(const struct lx_emitters *emitters, struct lx_control *control, struct lx_forest *forest)
{
    struct kinds kinds = {.count = 0};
    luxel_status status = LUXEL_OK;
    find_kinds(emitters, &kinds);
    if (emitters->count > UINT32_MAX) /* their numbers have 32 bits */
        return LUXEL_OK;
    for (size_t kind = 0; kind < kinds.count && status == LUXEL_OK; kind++) {
        if (kinds.points[kind] < LX_LEAST_CLUSTERED)
            continue;
        forest->trees = forest->trees ? forest->trees : lx_new_array(kinds.count, sizeof *forest->trees);
        if (!forest->trees)
            return LUXEL_ERROR_MEMORY;
        struct lx_tree *tree = &forest->trees[forest->tree_count++];
        tree->model = *kinds.models[kind];
        tree->has_axis = tree->model.profile.falloff != LX_NO_CONE || tree->model.profile.exponent > 0;
        tree->pattern = lx_power_of(tree->model.profile.exponent);
        status = plant(emitters, control, kinds.points[kind], tree);
    }
    return status;
}

void lx_forest_clear(struct lx_forest *forest)
{
    for (size_t i = 0; i < forest->tree_count; i++) {
        free(forest->trees[i].clusters);
        free(forest->trees[i].turns);
        free(forest->trees[i].points);
    }
    free(forest->trees);
    *forest = (struct lx_forest){0};
}

bool lx_is_clustered(const struct lx_forest *forest, const struct lx_emitter *emitter)
{
    for (size_t i = 0; i < forest->tree_count; i++)
        if (same_kind(&forest->trees[i].model, emitter))
            return true;
    return false;
}
