/* SPDX-License-Identifier: MIT */
/*
 * Collocation on the tiles as they are: the matrix of transfers, what is reflected, the residual between the nodes, and
 * the slack, which bounds the errors.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "between.h"
#include "group.h"
#include "linear.h"
#include "links.h"
#include "refine.h"
#include "reflected.h"
#include "within.h"

/* Rests that solutions of the linear system may leave: of the light, where it counts as residual, beside the bound that
 * is wanted; of the slack, where it is added. */
static const double LIGHT_REST = 1e-3, SLACK_REST = 1e-6;
/* No more, whatever is wanted, and no less than numbers hold. */
static const double MOST_REST = 1e-5, LEAST_REST = 1e-12;

/* The share of the effort that is left which rows may take. */
static const double ROWS_SHARE = 0.9;
/* A share of which nothing is known: it is within as much of this. */
static const double ANY_SHARE = 0.5;

/* A solution under way. */
struct solving {
    struct lx_radiosity *reflected;
    double *reflectance, *direct, *residual; /* at the nodes */
    struct lx_occluder_cones *cones;         /* of each worker */
    double *sampled;                         /* residuals at the places of each tile */
    double *sights;                          /* and what the share that ends on faces is beside the polynomial's */
    const double *before, *after;            /* one bounce lies between them; the first at the nodes of groups */
};

/* The rows of a tile; false: memory ran out, or there was no effort left for them. */
static bool find_rows(const struct lx_radiosity *reflected, struct lx_effort *effort, struct lx_occluder_cones *cones,
                      struct lx_tile *tile)
{
    if (!tile->is_blind &&
        lx_within_rows(reflected, effort, tile->face, &tile->window, &tile->cell, cones, &tile->rows))
        return true;
    tile->is_blind = true;
    lx_rows_free(tile->rows);
    tile->rows = NULL;
    return false;
}

/* Rows of the matrix and for the residual, tile by tile, and the first bounce. */
static void make_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct solving *solving = data;
    struct lx_radiosity *reflected = solving->reflected;
    struct lx_occluder_cones *cones = &solving->cones[worker];
    for (size_t i = first; i < last && lx_control_goes_on(reflected->control, is_caller); i++) {
        const size_t t = reflected->order[i];
        struct lx_tile *tile = &reflected->tiles[t];
        if (!find_rows(reflected, &reflected->efforts[i], cones, tile))
            continue;
        double *direct = solving->direct + t * LX_RULE_NODES, *seen = reflected->seen + t * LX_RULE_NODES;
        for (int q = 0; q < lx_rows_nodes(tile->rows); q++) {
            const struct lx_arrival sent = lx_links_sum(reflected, &tile->rows->of[q], &(struct lx_light){0});
            direct[q] = sent.value;
            seen[q] = sent.seen;
        }
        lx_rows_spread(tile->rows, direct);
        lx_rows_spread(tile->rows, seen);
    }
}

static void find_residuals(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    struct solving *solving = data;
    const struct lx_radiosity *reflected = solving->reflected;
    (void)worker;
    for (size_t t = first; t < last && lx_control_goes_on(reflected->control, is_caller); t++)
        for (int p = 0; p < LX_BETWEEN && !reflected->tiles[t].is_blind; p++) {
            const struct lx_links *links = lx_rows_between(reflected->tiles[t].rows, p);
            const struct lx_arrival sent = lx_links_sum(reflected, links, &(struct lx_light){solving->before, NULL});
            const size_t nodes = t * LX_RULE_NODES, i = t * LX_BETWEEN + (size_t)p;
            double at[2];
            lx_between_place(p, at);
            solving->sampled[i] = sent.value - lx_rule_value(solving->after + nodes, at[0], at[1]);
            solving->sights[i] = sent.seen - lx_rule_value(reflected->seen + nodes, at[0], at[1]);
        }
}

/* What the places of a tile tell. */
static void judge_tile(const struct solving *solving, size_t t)
{
    const double *sampled = solving->sampled + t * LX_BETWEEN;
    struct lx_tile *tile = &solving->reflected->tiles[t];
    const double mean = lx_between_mean(sampled);
    const size_t first = t * LX_RULE_NODES;
    const double rule = solving->reflected->rule;
    double received = 0;
    for (size_t i = first; i < first + LX_RULE_NODES; i++) {
        received = fmax(received, fabs(solving->after[i]));
        solving->residual[i] = fmax(solving->residual[i], LX_BETWEEN_FACTOR * mean + rule * fabs(solving->after[i]));
    }
    lx_between_changes(sampled, tile->residual);
    tile->own_error = fmax(tile->own_error, LX_BETWEEN_FACTOR * lx_between_greatest(sampled) + rule * received);
    tile->seen_error = LX_BETWEEN_FACTOR * lx_between_mean(solving->sights + t * LX_BETWEEN) + rule;
}

/* A blind tile receives what was known of it before. */
static void keep_past(const struct solving *solving, size_t t)
{
    struct lx_tile *tile = &solving->reflected->tiles[t];
    for (size_t i = t * LX_RULE_NODES; i < (t + 1) * LX_RULE_NODES; i++)
        solving->residual[i] = tile->past_error;
    tile->own_error = tile->past_error;
    tile->seen_error = ANY_SHARE;
}

static bool run(const struct solving *solving, size_t count, lx_rows_work *work)
{
    const struct lx_rows_part part = {
        .last = (unsigned)count, .tile_rows = 1, .counts_itself = true, .work = work, .data = (void *)solving};
    return lx_rows_run_part(solving->reflected->control, solving->reflected->threads, &part);
}

/* The residual of one bounce, from *before, at the nodes of groups, to *after. */
static bool look_between(struct solving *solving, const double *before, const double *after)
{
    const size_t tiles = solving->reflected->tile_count;
    solving->before = before;
    solving->after = after;
    if (!run(solving, tiles, find_residuals))
        return false;
    for (size_t t = 0; t < tiles; t++)
        if (solving->reflected->tiles[t].is_blind)
            keep_past(solving, t);
        else
            judge_tile(solving, t);
    return true;
}

/* x = sum of the first N bounces of `right`; *before that of one less.  False: the work is to stop. */
static bool bounce(const struct lx_linear *linear, unsigned bounces, const double *right, double *before, double *x)
{
    memset(before, 0, linear->count * sizeof *before);
    memcpy(x, right, linear->count * sizeof *x);
    for (unsigned n = 1; n < bounces; n++) {
        double change = 0, greatest = 0;
        memcpy(before, x, linear->count * sizeof *x);
        if (!lx_linear_bounce(linear, right, before, x))
            return false;
        for (size_t i = 0; i < linear->count; i++) {
            change = fmax(change, fabs(x[i] - before[i]));
            greatest = fmax(greatest, fabs(x[i]));
        }
        if (change <= 1e-14 * greatest)
            break;
    }
    return true;
}

static bool solve(const struct solving *solving, const double *right, double rest, double *before, double *x)
{
    const struct lx_radiosity *reflected = solving->reflected;
    const struct lx_linear linear = {.count = reflected->tile_count * LX_RULE_NODES,
                                     .reflected = reflected,
                                     .reflectance = solving->reflectance,
                                     .rest = rest,
                                     .control = reflected->control,
                                     .threads = reflected->threads};
    if (reflected->bounces > 0)
        return bounce(&linear, reflected->bounces, right, before, x);
    if (lx_linear_solve(&linear, right, x))
        return false;
    memcpy(before, x, linear.count * sizeof *x);
    return true;
}

/* The solution for the slack leaves a rest of its equation, no place of which is greater than its length: that adds no
 * more than the sum of all bounces of it, wherever anything arrives. */
static void add_rest(const struct solving *solving, const double *right)
{
    const struct lx_radiosity *reflected = solving->reflected;
    const size_t count = reflected->tile_count * LX_RULE_NODES;
    double squares = 0, largest = 0;
    for (size_t i = 0; i < count; i++) {
        squares += right[i] * right[i];
        largest = fmax(largest, solving->reflectance[i]);
    }
    const double rest = SLACK_REST * sqrt(squares) / (1 - largest);
    for (size_t i = 0; i < count; i++)
        if (reflected->seen[i] > 0)
            reflected->slack_before[i] = reflected->slack[i] += rest;
}

/* Reflected light at a node that may be too much: all of it where another face lies on the tile. */
static double doubt(const struct lx_radiosity *reflected, size_t i)
{
    return reflected->tiles[i / LX_RULE_NODES].is_overlaid ? fabs(reflected->indirect[i]) : 0;
}

/* The slack begins with the residual and with what is not known of what is sent on, one bounce of it. */
static bool find_slack(struct solving *solving)
{
    struct lx_radiosity *reflected = solving->reflected;
    const size_t count = reflected->tile_count * LX_RULE_NODES;
    double *unsure = lx_new_array(count, sizeof *unsure), *right = lx_new_array(count, sizeof *right);
    const struct lx_linear linear = {.count = count,
                                     .reflected = reflected,
                                     .reflectance = solving->reflectance,
                                     .control = reflected->control,
                                     .threads = reflected->threads};
    for (size_t i = 0; unsure && i < count; i++)
        unsure[i] =
            lx_tile_unsure_at(&reflected->tiles[i / LX_RULE_NODES], (int)(i % LX_RULE_NODES)) + doubt(reflected, i);
    const bool whole = unsure && right && lx_linear_bounce(&linear, solving->residual, unsure, right) &&
                       solve(solving, right, SLACK_REST, reflected->slack_before, reflected->slack);
    if (whole && reflected->bounces == 0)
        add_rest(solving, right);
    free(unsure);
    free(right);
    return whole;
}

/* The slack is the residual's mean and what arrives of other errors, which is smooth: between the nodes no more than a
 * little above the greatest of them. */
static void bound_tiles(const struct solving *solving)
{
    const double beyond = 1.1;
    for (size_t t = 0; t < solving->reflected->tile_count; t++) {
        struct lx_tile *tile = &solving->reflected->tiles[t];
        double arrives = 0;
        for (unsigned q = 0; q < LX_RULE_NODES; q++) {
            const double error =
                solving->reflected->slack[t * LX_RULE_NODES + q] - solving->residual[t * LX_RULE_NODES + q];
            if (error > arrives) {
                arrives = error;
                tile->worst = q;
            }
        }
        tile->error = tile->own_error + beyond * arrives;
    }
}

/* Whether memory ran out. */
static bool has_failed(const struct solving *solving)
{
    bool failed = false;
    for (size_t w = 0; w < solving->reflected->threads; w++)
        failed = failed || solving->cones[w].failed;
    return failed;
}

/* All rows, and what stands for those that are missing. */
static bool make_right(struct solving *solving)
{
    struct lx_radiosity *reflected = solving->reflected;
    const struct lx_within rows = {reflected->tile_count, ROWS_SHARE, make_rows, solving};
    bool is_any_blind = false;
    if (lx_within_order(reflected) || lx_within_run(reflected, &rows) != LUXEL_OK || has_failed(solving))
        return false;
    for (size_t t = 0; t < reflected->tile_count; t++)
        is_any_blind = is_any_blind || reflected->tiles[t].is_blind;
    if (is_any_blind && lx_within_ceilings(reflected))
        return false;
    for (size_t i = 0; i < reflected->tile_count * LX_RULE_NODES; i++) {
        const struct lx_tile *tile = &reflected->tiles[i / LX_RULE_NODES];
        if (!tile->is_blind)
            continue;
        solving->direct[i] = tile->past[i % LX_RULE_NODES];
        reflected->seen[i] = ANY_SHARE;
    }
    return true;
}

/* The solution stands where there is no effort for the next one; that of some bounces is another one for each. */
static void remember(struct lx_radiosity *reflected)
{
    for (size_t t = 0; t < reflected->tile_count && reflected->bounces == 0; t++) {
        struct lx_tile *tile = &reflected->tiles[t];
        memcpy(tile->past, reflected->indirect + t * LX_RULE_NODES, sizeof tile->past);
        tile->past_error = tile->error;
        tile->has_past = true;
    }
}

static bool work(struct solving *solving)
{
    struct lx_radiosity *reflected = solving->reflected;
    const size_t count = reflected->tile_count * LX_RULE_NODES;
    for (size_t i = 0; i < count; i++)
        solving->reflectance[i] = reflected->faces[reflected->tiles[i / LX_RULE_NODES].face].reflectance;
    for (size_t t = 0; t < reflected->tile_count; t++) {
        memset(reflected->tiles[t].residual, 0, sizeof reflected->tiles[t].residual);
        reflected->tiles[t].own_error = 0;
    }
    const double rest = fmin(fmax(LIGHT_REST * reflected->error, LEAST_REST), MOST_REST);
    if (!make_right(solving) || !solve(solving, solving->direct, rest, reflected->before, reflected->indirect))
        return false;
    lx_groups_lift(reflected, reflected->before, reflected->sent);
    if (!look_between(solving, reflected->sent, reflected->indirect))
        return false;
    if (reflected->bounces > 1 && !look_between(solving, NULL, solving->direct))
        return false;
    if (!find_slack(solving))
        return false;
    bound_tiles(solving);
    for (size_t i = 0; i < count; i++) {
        reflected->slack[i] += doubt(reflected, i);
        reflected->slack_before[i] += doubt(reflected, i);
    }
    lx_groups_lift(reflected, reflected->slack_before, reflected->sent_slack);
    remember(reflected);
    return true;
}

static int renew(double **numbers, size_t count)
{
    free(*numbers);
    *numbers = lx_new_array(count, sizeof **numbers);
    return *numbers ? 0 : -1;
}

luxel_status lx_reflected_solve(struct lx_radiosity *reflected)
{
    const size_t count = reflected->tile_count * LX_RULE_NODES, workers = reflected->threads;
    struct solving solving = {.reflected = reflected,
                              .reflectance = lx_new_array(count, sizeof(double)),
                              .direct = lx_new_array(count, sizeof(double)),
                              .residual = lx_new_array(count, sizeof(double)),
                              .cones = lx_new_array(workers, sizeof(struct lx_occluder_cones)),
                              .sampled = lx_new_array(reflected->tile_count * LX_BETWEEN, sizeof(double)),
                              .sights = lx_new_array(reflected->tile_count * LX_BETWEEN, sizeof(double))};
    bool has_room = solving.reflectance && solving.direct && solving.residual && solving.cones && solving.sampled &&
                    solving.sights && !renew(&reflected->seen, count) && !renew(&reflected->indirect, count) &&
                    !renew(&reflected->before, count) && !renew(&reflected->slack, count) &&
                    !renew(&reflected->slack_before, count) &&
                    !renew(&reflected->sent, reflected->group_count * LX_RULE_NODES) &&
                    !renew(&reflected->sent_slack, reflected->group_count * LX_RULE_NODES);
    bool whole = has_room && work(&solving);
    for (size_t w = 0; solving.cones && w < workers; w++) {
        has_room = has_room && !solving.cones[w].failed;
        lx_occluder_cones_clear(&solving.cones[w]);
    }
    free(solving.reflectance);
    free(solving.direct);
    free(solving.residual);
    free(solving.cones);
    free(solving.sampled);
    free(solving.sights);
    if (whole && has_room)
        return LUXEL_OK;
    return lx_control_goes_on(reflected->control, false) ? LUXEL_ERROR_MEMORY : LUXEL_CANCELLED;
}
