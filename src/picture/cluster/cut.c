/* SPDX-License-Identifier: MIT */
/* Opening clusters by a heap of their errors, and shading what is left of them. */
#include "cut.h"

#include <math.h>
#include <stdlib.h>

#include "../../base/memory.h"
#include "../../world/among.h"

/* Clusters, or lights, between two questions whether to go on. */
enum { STEPS_BETWEEN_CHECKS = 16 };

int lx_cut_init(const struct lx_plan *plan, struct lx_cut *cut)
{
    *cut = (struct lx_cut){.surface = NULL};
    for (size_t t = 0; t < plan->trees.tree_count; t++)
        cut->capacity += plan->trees.trees[t].leaf_count + 1;
    if (cut->capacity == 0)
        return 0;
    cut->items = lx_new_aligned(cut->capacity, sizeof *cut->items);
    cut->bounds = lx_new_aligned(cut->capacity, sizeof *cut->bounds);
    return cut->items && cut->bounds ? 0 : -1;
}

void lx_cut_clear(struct lx_cut *cut)
{
    free(cut->items);
    free(cut->bounds);
    *cut = (struct lx_cut){.surface = NULL};
}

/* ---- making ---- */

/* A cut in the making, with the sums over its items. */
struct making {
    const struct lx_plan *plan;
    struct lx_cut *cut;
    double error, least;
    size_t unbounded; /* items whose error is infinite */
};

/* Whether other surfaces may stand between the cut's region and what is in a ball. */
static bool is_hidden(const struct lx_plan *plan, const struct lx_cut *cut, const struct lx_ball *ball)
{
    if (!plan->prepared->shadows)
        return false;
    struct lx_found found;
    const double *anchor = cut->surface->shape.anchor_mm;
    const bool is_found = lx_among_balls(plan->prepared, anchor, &cut->region.places, ball, false, &found);
    const size_t count = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t i = 0; i < count; i++) {
        const struct lx_planned_surface *other = &plan->surfaces[lx_found_at(&found, is_found, i)];
        if (!lx_may_hide(&other->shape, other == cut->surface))
            continue;
        const struct lx_ball blocker = lx_ball_from(&plan->balls[other - plan->surfaces], anchor);
        if (lx_may_block(&blocker, &cut->region.places, ball, false))
            return true;
    }
    return false;
}

static struct lx_ball ball_of(const struct lx_cluster *cluster, const double anchor_mm[3])
{
    struct lx_ball ball = {.radius = cluster->radius_mm};
    for (int k = 0; k < 3; k++)
        ball.center[k] = cluster->center_mm[k] - anchor_mm[k];
    return ball;
}

static void count_in(struct making *making, const struct lx_cut_item *item)
{
    making->least += item->least;
    if (item->error < HUGE_VAL)
        making->error += item->error;
    else
        making->unbounded++;
}

/* The sums anew, without what their roundings have added up to. */
static void sum_anew(struct making *making)
{
    const struct lx_cut *cut = making->cut;
    making->error = making->least = 0;
    making->unbounded = 0;
    for (size_t i = 0; i < cut->whole_count; i++)
        count_in(making, &cut->items[i]);
    for (size_t i = cut->capacity - cut->opened_count; i < cut->capacity; i++)
        making->least += cut->items[i].least;
}

/* Puts a cluster among those that are taken whole, unless it gives nothing. */
static void add_cluster(struct making *making, uint32_t t, uint32_t c)
{
    struct lx_cut *cut = making->cut;
    const struct lx_planned_surface *surface = cut->surface;
    const struct lx_tree *tree = &making->plan->trees.trees[t];
    const struct lx_cluster *cluster = &tree->clusters[c];
    const struct lx_ball ball = ball_of(cluster, surface->shape.anchor_mm);
    const struct lx_share_bound bound =
        lx_bound_cluster(&cut->region, surface->shape.anchor_mm, &surface->limits, tree, cluster,
                         tree->has_axis ? &tree->turns[c] : NULL, is_hidden(making->plan, cut, &ball));
    if (bound.most == 0)
        return;
    struct lx_cut_item item = {.error = bound.error, .least = bound.least, .tree = t, .cluster = c};
    count_in(making, &item);
    size_t at = cut->whole_count++;
    for (; at > 0 && cut->items[(at - 1) / 2].error < item.error; at = (at - 1) / 2)
        cut->items[at] = cut->items[(at - 1) / 2];
    cut->items[at] = item;
}

/* Takes the cluster away whose error is the largest. */
static struct lx_cut_item take_worst(struct making *making)
{
    struct lx_cut *cut = making->cut;
    const struct lx_cut_item worst = cut->items[0], last = cut->items[--cut->whole_count];
    size_t at = 0;
    for (size_t child = 1; child < cut->whole_count; child = 2 * at + 1) {
        if (child + 1 < cut->whole_count && cut->items[child + 1].error > cut->items[child].error)
            child++;
        if (!(cut->items[child].error > last.error))
            break;
        cut->items[at] = cut->items[child];
        at = child;
    }
    cut->items[at] = last;
    making->least -= worst.least;
    if (worst.error < HUGE_VAL)
        making->error -= worst.error;
    else
        making->unbounded--;
    return worst;
}

/* Opens a cluster: its two parts come in its place, or, of a leaf, its points. */
static void open_cluster(struct making *making, const struct lx_cut_item *item)
{
    struct lx_cut *cut = making->cut;
    const struct lx_cluster *cluster = &making->plan->trees.trees[item->tree].clusters[item->cluster];
    if (cluster->child > 0) {
        add_cluster(making, item->tree, cluster->child);
        add_cluster(making, item->tree, cluster->child + 1);
        return;
    }
    cut->items[cut->capacity - ++cut->opened_count] = *item;
    making->least += item->least;
}

static bool is_good(const struct making *making)
{
    const struct lx_plan *plan = making->plan;
    double value = fmax(making->cut->surface->uniform + making->least, plan->least_value);
    return making->unbounded == 0 && making->error <= plan->light_error * value;
}

/* Opens clusters until the rest is exact enough; false: the work was stopped. */
static bool refine(struct making *making, const struct lx_asking *asking)
{
    size_t step = 0, next_sum = 64;
    for (;;) {
        if (is_good(making)) {
            sum_anew(making);
            if (is_good(making))
                return true;
        }
        if (making->cut->whole_count == 0)
            return true;
        const struct lx_cut_item worst = take_worst(making);
        open_cluster(making, &worst);
        if (++step == next_sum) {
            sum_anew(making);
            next_sum *= 2;
        }
        if (!lx_asking_at_step(asking, step, STEPS_BETWEEN_CHECKS))
            return false;
    }
}

/* A bound of the rounding error in float32 of a point with a strength, seen from the cut's region. */
static double bound_point(const struct lx_cut *cut, const struct lx_tree *tree, const double place_mm[3],
                          double strength)
{
    const struct lx_planned_surface *surface = cut->surface;
    double place[3];
    for (int k = 0; k < 3; k++)
        place[k] = place_mm[k] - surface->shape.anchor_mm[k];
    const struct lx_stand stand = lx_stand_of(&cut->region, place, LX_IS_BY_HALF(surface->limits.lobe.model));
    return lx_bound_stand(&surface->shape, &surface->lobe, &tree->model, strength, &stand);
}

static double bound_item(const struct lx_plan *plan, const struct lx_cut *cut, const struct lx_cut_item *item,
                         bool is_opened)
{
    const struct lx_tree *tree = &plan->trees.trees[item->tree];
    const struct lx_cluster *cluster = &tree->clusters[item->cluster];
    double sum = 0, row[4];
    if (!is_opened)
        return bound_point(cut, tree, cluster->center_mm, cluster->strength);
    for (size_t i = 0; i < cluster->count; i++) {
        lx_emitter_row(&plan->prepared->emitters, lx_tree_emitter(tree, cluster->first + i), row);
        sum += bound_point(cut, tree, row, row[3]);
    }
    return sum;
}

static bool choose_precision(const struct lx_plan *plan, const struct lx_asking *asking, struct lx_cut *cut)
{
    struct lx_rounding_sum rounding = cut->surface->rounding;
    const size_t count = cut->whole_count + cut->opened_count;
    for (size_t i = 0; i < count; i++) {
        bool is_opened = i >= cut->whole_count;
        if (!lx_asking_at_step(asking, i, STEPS_BETWEEN_CHECKS))
            return false;
        size_t at = is_opened ? cut->capacity - cut->opened_count + (i - cut->whole_count) : i;
        cut->bounds[i] = plan->precision == LUXEL_DOUBLE ? HUGE_VAL : bound_item(plan, cut, &cut->items[at], is_opened);
    }
    if (plan->precision == LUXEL_SINGLE)
        lx_choose_precision(cut->bounds, count, plan->least_maximum, asking, &rounding);
    return lx_asking_goes_on(asking);
}

bool lx_cut_make(const struct lx_plan *plan, const struct lx_planned_surface *surface,
                 const struct lx_receiver_region *region, const struct lx_asking *asking, struct lx_cut *cut)
{
    struct making making = {.plan = plan, .cut = cut};
    cut->surface = surface;
    cut->region = *region;
    cut->whole_count = cut->opened_count = 0;
    for (uint32_t t = 0; t < plan->trees.tree_count; t++)
        if (plan->trees.trees[t].leaf_count > 0)
            add_cluster(&making, t, 0);
    if (!refine(&making, asking) || !choose_precision(plan, asking, cut)) {
        cut->surface = NULL;
        return false;
    }
    cut->error = making.error;
    return true;
}

/* ---- shading ---- */

/* Elements and what lights them: the lights of a tree, some at once. */
struct shading {
    const struct lx_plan *plan;
    const struct lx_cut *cut;
    const struct lx_tree *tree;
    const struct lx_block_double *block;
    const struct lx_block_single *copy;
    size_t count;
    float *open;
    double *sum;
    bool in_double;
    struct lx_light_double model;
    struct lx_light_single singles[LX_MOST_IN_RUN];
    struct lx_light_double exacts[LX_MOST_IN_RUN];
    size_t waiting;
};

static void shade_waiting(struct shading *shading, const float *open)
{
    const struct lx_planned_surface *surface = shading->cut->surface;
    const struct lx_kernels *kernels = shading->plan->kernels;
    if (shading->waiting > 0 && shading->in_double)
        kernels->shade_double(shading->exacts, NULL, shading->waiting, &surface->lobe_exact, shading->block, NULL, open,
                              shading->count, shading->sum);
    else if (shading->waiting > 0)
        kernels->shade_single(shading->singles, shading->exacts, shading->waiting, &surface->lobe_single, shading->copy,
                              shading->block, open, shading->count, shading->sum);
    shading->waiting = 0;
}

/* Sets open[i] to whether the way to a light is free; false: it is free everywhere. */
static bool find_open(struct shading *shading, const struct lx_light_double *light)
{
    const struct lx_plan *plan = shading->plan;
    const struct lx_cut *cut = shading->cut;
    const double *anchor = cut->surface->shape.anchor_mm;
    const struct lx_ball place = {.center = {light->x, light->y, light->z}};
    bool any = false;
    struct lx_found found;
    const bool is_found = lx_among_balls(plan->prepared, anchor, &cut->region.places, &place, false, &found);
    const size_t count = lx_found_count(&found, is_found, plan->surface_count);
    for (size_t s = 0; plan->prepared->shadows && s < count; s++) {
        const struct lx_planned_surface *other = &plan->surfaces[lx_found_at(&found, is_found, s)];
        const struct lx_ball blocker = lx_ball_from(&plan->balls[other - plan->surfaces], anchor);
        if (!lx_may_hide(&other->shape, other == cut->surface) ||
            !lx_may_block(&blocker, &cut->region.places, &place, false))
            continue;
        for (size_t i = 0; !any && i < lx_padded(shading->count); i++)
            shading->open[i] = 1;
        any = true;
        lx_block_one(plan->kernels, &other->shape, other == cut->surface, anchor, light, shading->block, shading->count,
                     shading->open);
    }
    return any;
}

static void put_light(struct shading *shading, const double row[4], const double axis[3])
{
    struct lx_light_double light = shading->model;
    lx_light_move(shading->cut->surface->shape.anchor_mm, row, &light);
    if (axis)
        light.axis_x = axis[0], light.axis_y = axis[1], light.axis_z = axis[2];
    bool is_alone = find_open(shading, &light);
    if (is_alone)
        shade_waiting(shading, NULL);
    shading->exacts[shading->waiting] = light;
    if (!shading->in_double)
        shading->singles[shading->waiting] = lx_light_single_of(&light);
    shading->waiting++;
    if (is_alone || shading->waiting == LX_MOST_IN_RUN)
        shade_waiting(shading, is_alone ? shading->open : NULL);
}

/* Puts what a cluster shines like, or each of its points. */
static void put_cluster(struct shading *shading, const struct lx_cut_item *item, bool is_opened)
{
    const struct lx_tree *tree = shading->tree;
    const struct lx_cluster *cluster = &tree->clusters[item->cluster];
    const struct lx_emitters *emitters = &shading->plan->prepared->emitters;
    double row[4] = {cluster->center_mm[0], cluster->center_mm[1], cluster->center_mm[2], cluster->strength};
    if (!is_opened)
        put_light(shading, row, tree->has_axis ? tree->turns[item->cluster].axis : NULL);
    for (size_t i = 0; is_opened && i < cluster->count; i++) {
        const size_t point = lx_tree_emitter(tree, cluster->first + i);
        struct lx_emitter room;
        double axis[3];
        lx_emitter_row(emitters, point, row);
        if (tree->has_axis) {
            const lx_bounded3 *exact = &lx_emitter_at(emitters, point, &room)->profile.axis;
            axis[0] = exact->x.value, axis[1] = exact->y.value, axis[2] = exact->z.value;
        }
        put_light(shading, row, tree->has_axis ? axis : NULL);
    }
}

void lx_cut_shade(const struct lx_plan *plan, const struct lx_cut *cut, const struct lx_block_double *block,
                  const struct lx_block_single *copy, size_t count, const struct lx_asking *asking,
                  float open[LX_BLOCK], double *sum)
{
    const size_t items = cut->whole_count + cut->opened_count, opened = cut->capacity - cut->opened_count;
    struct shading shading = {
        .plan = plan, .cut = cut, .block = block, .copy = copy, .count = count, .open = open, .sum = sum};
    for (size_t t = 0; t < plan->trees.tree_count; t++) {
        shading.tree = &plan->trees.trees[t];
        lx_light_set(&shading.tree->model, cut->surface->shape.anchor_mm, &shading.model);
        for (int in_double = 0; in_double < 2; in_double++) {
            shading.in_double = in_double;
            for (size_t i = 0; i < items; i++) {
                bool is_opened = i >= cut->whole_count;
                const struct lx_cut_item *item = &cut->items[is_opened ? opened + (i - cut->whole_count) : i];
                if (item->tree != t || (cut->bounds[i] < 0) == shading.in_double)
                    continue;
                put_cluster(&shading, item, is_opened);
                if (!lx_asking_at_step(asking, i + 1, STEPS_BETWEEN_CHECKS))
                    return;
            }
            shade_waiting(&shading, NULL);
        }
    }
}
