/* SPDX-License-Identifier: MIT */
/* Planting: the kinds of points, their order by sorting codes, and the clusters from the leaves up. */
#include "tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../base/memory.h"
#include "../../format/cloud.h"

enum {
    MOST_KINDS = 16, /* more are not looked for: their points are summed */
    LEAF = 8,
    CELL_BITS = 16, /* of a code for each axis */
    DIGIT = 12,     /* bits that are sorted by at once */
    DIGITS = 3 * CELL_BITS / DIGIT,
    BETWEEN_CHECKS = 256, /* points, whose memory may be touched for the first time */
    LEAVES_BETWEEN_CHECKS = 16
};

static bool same_law(const struct lx_emitter *a, const struct lx_emitter *b)
{
    return a->attenuation == b->attenuation && (a->attenuation != LX_PRACTICAL || a->k_mm == b->k_mm) &&
           (a->attenuation != LX_POLYNOMIAL ||
            memcmp(a->coefficients, b->coefficients, sizeof a->coefficients) == 0); /* 0 and -0 may stay apart */
}

static bool same_kind(const struct lx_emitter *a, const struct lx_emitter *b)
{
    return lx_is_point(a) && lx_is_point(b) && a->is_part == b->is_part && same_law(a, b) &&
           lx_profile_is_alike(&a->profile, &b->profile);
}

static bool goes_on(struct lx_control *control, size_t i)
{
    return i % BETWEEN_CHECKS != 0 || lx_control_goes_on(control, true);
}

/* ---- kinds ---- */

struct kinds {
    const struct lx_emitter *models[MOST_KINDS];
    size_t points[MOST_KINDS], together[MOST_KINDS]; /* together: in no cloud that has a tree of its own */
    size_t count;
};

/* Whether a span is the points of a cloud that is large enough for a tree of its own. */
static bool has_own_tree(const struct lx_emitter_span *span)
{
    return span->set && span->end - span->first >= LX_LEAST_KEPT;
}

static void count_points(struct kinds *kinds, const struct lx_emitter *emitter, size_t points, bool has_own)
{
    size_t kind = 0;
    if (!lx_is_point(emitter) || !lx_profile_is_alike(&emitter->profile, &emitter->profile))
        return;
    while (kind < kinds->count && !same_kind(kinds->models[kind], emitter))
        kind++;
    if (kind == MOST_KINDS)
        return;
    kinds->models[kind] = emitter;
    kinds->points[kind] += points;
    kinds->together[kind] += has_own ? 0 : points;
    kinds->count += kind == kinds->count;
}

static luxel_status find_kinds(const struct lx_emitters *emitters, struct lx_control *control, struct kinds *kinds)
{
    for (struct lx_emitter_span span = {0}; lx_emitters_next(emitters, &span);) {
        if (span.set)
            count_points(kinds, &span.set->model, span.end - span.first, has_own_tree(&span));
        for (size_t i = span.first; span.items && i < span.end; i++) {
            count_points(kinds, &span.items[i - span.first], 1, false);
            if (!goes_on(control, i))
                return LUXEL_CANCELLED;
        }
    }
    return LUXEL_OK;
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
    const struct lx_tree *tree;
    /* whose points alone are planted; NULL: all of the kind that have no tree of their own */
    const struct lx_point_set *set;
    struct lx_built_tree *built;
    struct coded *order, *other;
};

/* Point i of those that are planted: its place and strength. */
static void point_row(const struct planting *planting, size_t i, double row[4])
{
    lx_emitter_row(planting->emitters, planting->tree->first + planting->order[i].point, row);
}

/* Lists the points of a span that are of the kind and shine at all. */
static luxel_status list_span(struct planting *planting, const struct lx_emitter_span *span)
{
    const struct lx_tree *tree = planting->tree;
    double row[4];
    for (size_t i = span->first; i < span->end; i++) {
        if (!goes_on(planting->control, i))
            return LUXEL_CANCELLED;
        if (span->items && !same_kind(&span->items[i - span->first], &tree->model))
            continue;
        lx_emitter_row(planting->emitters, i, row);
        if (row[3] > 0)
            planting->order[planting->built->point_count++].point = (uint32_t)(i - tree->first);
    }
    return LUXEL_OK;
}

static luxel_status list_points(struct planting *planting)
{
    luxel_status status = LUXEL_OK;
    for (struct lx_emitter_span span = {0}; status == LUXEL_OK && lx_emitters_next(planting->emitters, &span);) {
        const bool is_together = !planting->set && !has_own_tree(&span) &&
                                 (span.items || same_kind(&span.set->model, &planting->tree->model));
        if (is_together || (planting->set && span.set == planting->set))
            status = list_span(planting, &span);
    }
    return status;
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
    for (size_t i = 0; i < planting->built->point_count; i++) {
        point_row(planting, i, row);
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
    for (size_t i = 0; i < planting->built->point_count && status == LUXEL_OK; i++) {
        uint64_t code = 0;
        point_row(planting, i, row);
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
    const size_t count = planting->built->point_count;
    const uint64_t mask = (1 << DIGIT) - 1;
    struct coded *order = planting->order, *other = planting->other;
    for (size_t i = 0; i < count; i++) {
        begin[order[i].code >> shift & mask]++;
        if (!goes_on(planting->control, i))
            return LUXEL_CANCELLED;
    }
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
    planting->other = lx_new_aligned(planting->built->point_count, sizeof *planting->other);
    if (!planting->other)
        return LUXEL_ERROR_MEMORY;
    /* Sorting writes all over it: no page of it is to be had for the first time there. */
    for (size_t i = 0; i < planting->built->point_count; i++) {
        planting->other[i].point = 0;
        if (!goes_on(planting->control, i))
            return LUXEL_CANCELLED;
    }
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
        point_row(planting, leaf->first + i, rows[i]);
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
            lx_emitter_at(planting->emitters, planting->tree->first + planting->order[leaf->first + i].point, &room);
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

/* Counts the leaves of the points first ... end - 1; false: the work is to stop. */
static bool count_leaves(const struct planting *planting, size_t first, size_t end, size_t *leaves)
{
    if (end - first <= LEAF)
        return (*leaves)++ % LEAVES_BETWEEN_CHECKS != 0 || lx_control_goes_on(planting->control, true);
    const size_t middle = split(planting->order, first, end);
    return count_leaves(planting, first, middle, leaves) && count_leaves(planting, middle, end, leaves);
}

/* Makes cluster `at` of the points first ... end - 1, and all below it. */
static luxel_status grow(struct planting *planting, size_t at, size_t first, size_t end, struct box *box)
{
    struct lx_built_tree *tree = planting->built;
    const bool has_axis = planting->tree->has_axis;
    struct lx_cluster made = {.first = (uint32_t)first, .count = (uint32_t)(end - first)};
    struct lx_cluster_turn turn = {0};
    if (end - first <= LEAF) {
        if (tree->leaf_count++ % LEAVES_BETWEEN_CHECKS == 0 && !lx_control_goes_on(planting->control, true))
            return LUXEL_CANCELLED;
        *box = make_leaf(planting, &made);
        if (has_axis)
            turn_leaf(planting, &made, &turn);
    } else {
        struct box other;
        const size_t middle = split(planting->order, first, end), child = tree->cluster_count;
        tree->cluster_count += 2;
        luxel_status status = grow(planting, child, first, middle, box);
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
        if (has_axis)
            join_turns(&tree->clusters[child], &tree->turns[child], &turn);
    }
    tree->clusters[at] = made;
    if (has_axis)
        tree->turns[at] = turn;
    return LUXEL_OK;
}

static luxel_status grow_all(struct planting *planting)
{
    struct lx_built_tree *built = planting->built;
    const size_t count = built->point_count;
    struct box box;
    size_t leaves = 0;
    if (!count_leaves(planting, 0, count, &leaves))
        return LUXEL_CANCELLED;
    built->clusters = lx_new_aligned(2 * leaves, sizeof *built->clusters);
    built->points = lx_new_aligned(count, sizeof *built->points);
    if (planting->tree->has_axis)
        built->turns = lx_new_aligned(2 * leaves, sizeof *built->turns);
    if (!built->clusters || !built->points || (planting->tree->has_axis && !built->turns))
        return LUXEL_ERROR_MEMORY;
    /* The root has no neighbour; one cluster stays unused. */
    built->cluster_count = 2;
    luxel_status status = grow(planting, 0, 0, count, &box);
    for (size_t i = 0; i < count && status == LUXEL_OK; i++) {
        built->points[i] = planting->order[i].point;
        if (!goes_on(planting->control, i))
            status = LUXEL_CANCELLED;
    }
    return status;
}

/* ---- trees ---- */

static void free_built(struct lx_kept *kept)
{
    struct lx_built_tree *built = (struct lx_built_tree *)kept;
    free(built->clusters);
    free(built->turns);
    free(built->points);
    free(built);
}

/* Makes the tree have what was built, as one more user. */
static void take(struct lx_built_tree *built, struct lx_tree *tree)
{
    tree->built = built;
    tree->clusters = built->clusters;
    tree->turns = built->turns;
    tree->points = built->points;
    tree->leaf_count = built->leaf_count;
}

static luxel_status plant(const struct lx_emitters *emitters, struct lx_control *control,
                          const struct lx_point_set *set, size_t points, struct lx_tree *tree)
{
    struct planting planting = {
        .emitters = emitters,
        .control = control,
        .tree = tree,
        .set = set,
        .built = lx_new_array(1, sizeof *planting.built),
    };
    if (!planting.built)
        return LUXEL_ERROR_MEMORY;
    lx_kept_init(&planting.built->kept, free_built);
    if (set)
        planting.built->set = *set;
    planting.order = lx_new_aligned(points, sizeof *planting.order);
    luxel_status status = planting.order ? LUXEL_OK : LUXEL_ERROR_MEMORY;
    if (status == LUXEL_OK)
        status = list_points(&planting);
    if (status == LUXEL_OK && planting.built->point_count > 0)
        status = code_points(&planting);
    if (status == LUXEL_OK && planting.built->point_count > 0)
        status = sort_points(&planting);
    if (status == LUXEL_OK && planting.built->point_count > 0)
        status = grow_all(&planting);
    free(planting.order);
    free(planting.other);
    take(planting.built, tree);
    return status;
}

static bool same_values(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Whether a tree can have what was built of the same cloud. */
static bool fits(const struct lx_built_tree *built, const struct lx_tree *tree, const struct lx_point_set *set)
{
    const lx_bounded3 *axis = &set->model.profile.axis, *other = &built->set.model.profile.axis;
    if (!tree->has_axis)
        return true;
    if (!built->turns || set->is_aimed != built->set.is_aimed)
        return false;
    if (set->is_aimed)
        return same_values(set->aim_mm, built->set.aim_mm);
    return axis->x.value == other->x.value && axis->y.value == other->y.value && axis->z.value == other->z.value;
}

/* Plants the points of a large cloud, or takes what was planted of it before. */
static luxel_status plant_cloud(const struct lx_emitters *emitters, struct lx_control *control,
                                const struct lx_point_set *set, struct lx_tree *tree)
{
    struct lx_kept_slot *slot = set->cloud->tree;
    struct lx_built_tree *built = slot ? (struct lx_built_tree *)lx_kept_slot_look(slot) : NULL;
    tree->first = set->first;
    if (built && fits(built, tree, set)) {
        take(built, tree);
        return LUXEL_OK;
    }
    lx_kept_release((struct lx_kept *)built);
    luxel_status status = plant(emitters, control, set, set->end - set->first, tree);
    if (status == LUXEL_OK && slot)
        lx_kept_slot_put(slot, &tree->built->kept);
    return status;
}

static struct lx_tree *add_tree(struct lx_light_trees *trees, const struct lx_emitter *model)
{
    struct lx_tree *tree = &trees->trees[trees->tree_count++];
    tree->model = *model;
    tree->has_axis = !lx_profile_is_isotropic(&model->profile);
    tree->pattern = lx_power_of(model->profile.exponent);
    return tree;
}

/* The trees of one kind of points: of each large cloud, and of all other points together. */
static luxel_status plant_kind(const struct lx_emitters *emitters, struct lx_control *control,
                               const struct lx_emitter *model, size_t together, struct lx_light_trees *trees)
{
    luxel_status status = LUXEL_OK;
    if (together > 0)
        status = plant(emitters, control, NULL, together, add_tree(trees, model));
    for (struct lx_emitter_span span = {0}; status == LUXEL_OK && lx_emitters_next(emitters, &span);)
        if (has_own_tree(&span) && same_kind(&span.set->model, model))
            status = plant_cloud(emitters, control, span.set, add_tree(trees, &span.set->model));
    return status;
}

luxel_status lx_light_trees_build(const struct lx_emitters *emitters, struct lx_control *control,
                                  struct lx_light_trees *trees)
{
    struct kinds kinds = {.count = 0};
    if (emitters->count > UINT32_MAX) /* their numbers have 32 bits */
        return LUXEL_OK;
    luxel_status status = find_kinds(emitters, control, &kinds);
    for (size_t kind = 0; kind < kinds.count && status == LUXEL_OK; kind++) {
        if (kinds.points[kind] < LX_LEAST_CLUSTERED)
            continue;
        const size_t most = kinds.count + emitters->point_set_count;
        trees->trees = trees->trees ? trees->trees : lx_new_array(most, sizeof *trees->trees);
        status = trees->trees ? plant_kind(emitters, control, kinds.models[kind], kinds.together[kind], trees)
                              : LUXEL_ERROR_MEMORY;
    }
    return status;
}

void lx_light_trees_clear(struct lx_light_trees *trees)
{
    for (size_t i = 0; i < trees->tree_count; i++)
        lx_kept_release((struct lx_kept *)trees->trees[i].built);
    free(trees->trees);
    *trees = (struct lx_light_trees){0};
}

bool lx_is_clustered(const struct lx_light_trees *trees, const struct lx_emitter *emitter)
{
    for (size_t i = 0; i < trees->tree_count; i++)
        if (same_kind(&trees->trees[i].model, emitter))
            return true;
    return false;
}
