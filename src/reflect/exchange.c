/* SPDX-License-Identifier: MIT */
/* Form factors by the links of tiles, and the tiles that are cut for them. */
#include "exchange.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/memory.h"
#include "../surface/mesh.h"
#include "between.h"
#include "box.h"
#include "group.h"
#include "links.h"
#include "overlap.h"
#include "reflected.h"
#include "solution.h"
#include "within.h"

enum { MOST_ROUNDS = 6 };
/* The share of the effort that is left which rows may take; with more than the last share of it, or of tiles, gone no
 * other round is begun. */
static const double ROWS_SHARE = 0.9, WORTH_A_ROUND = 0.9;

struct exchanging {
    struct lx_radiosity *reflected;
    const struct lx_reflected_request *request;
    struct lx_exchange *exchange;
    size_t *side_of;                 /* each face */
    struct lx_occluder_cones *cones; /* of each worker */
    lx_bounded *sums;                /* count x count: A_i F_ij in mm^2, by side i alone */
    double *seen;                    /* of one tile: side by side, at the nodes and between them */
    double *scores;                  /* of tiles: the errors that they bring */
};

/* ---- sides ---- */

static size_t authored_of(const struct lx_radiosity *reflected, const struct lx_matte_face *face)
{
    return reflected->prepared->surfaces[face->surface].authored;
}

/* Whether a face looks to the middle of the parts of its surface, which is one of parts: 1, or -1: away from it; 0: it
 * is none. */
static int inwards(const struct lx_radiosity *reflected, const struct lx_matte_face *face)
{
    const struct lx_prepared *prepared = reflected->prepared;
    const size_t authored = authored_of(reflected, face);
    const struct lx_surface_kind *kind =
        (const struct lx_surface_kind *)prepared->scene->surfaces.items[authored].variant;
    double way = 0;
    for (size_t s = 0; s < prepared->surface_count && kind->part_count > 0; s++)
        for (int i = 0; i < 3 && prepared->surfaces[s].authored == authored; i++)
            way += face->sheet.turn * face->sheet.axis[i] *
                   (prepared->surfaces[s].shape.anchor_mm[i] - face->sheet.center_mm[i]);
    return (way > 0) - (way < 0);
}

/* Whether a face is of the inner side of a closed body. */
static bool is_enclosed(const struct lx_radiosity *reflected, const struct lx_matte_face *face)
{
    const struct lx_mesh_body *body = reflected->prepared->surfaces[face->surface].shape.body;
    if (face->is_facet)
        return body->encloses && (face->sheet.turn > 0) == body->looks_inwards;
    return face->sheet.turn < 0 && inwards(reflected, face) > 0;
}

/* Whether it is of the outer side of what looks inwards: a room, or a hollow ball, whose inner faces come first. */
static bool is_outer(const struct lx_radiosity *reflected, size_t f)
{
    const struct lx_matte_face *face = &reflected->faces[f];
    if (face->sheet.type->exchange)
        return face->sheet.turn > 0 && f > 0 && face[-1].surface == face->surface &&
               (face[-1].sheet.turn < 0 || is_outer(reflected, f - 1));
    return !face->is_facet && face->sheet.turn < 0 && inwards(reflected, face) < 0;
}

static int drop_faces(struct lx_radiosity *reflected)
{
    bool *stays = lx_new_array(reflected->face_count, sizeof *stays);
    for (size_t f = 0; stays && f < reflected->face_count; f++)
        stays[f] = !is_enclosed(reflected, &reflected->faces[f]);
    for (size_t f = 0; stays && f < reflected->face_count; f++) {
        const size_t authored = authored_of(reflected, &reflected->faces[f]);
        bool is_met = !stays[f] || !is_outer(reflected, f);
        for (size_t g = 0; g < reflected->face_count && !is_met; g++)
            is_met = stays[g] && authored_of(reflected, &reflected->faces[g]) != authored &&
                     lx_faces_meet(&reflected->faces[f], &reflected->faces[g]);
        stays[f] = stays[f] && is_met;
    }
    const int failed = stays ? lx_groups_drop(reflected, stays) : -1;
    free(stays);
    return failed;
}

/* Faces of one side follow each other. */
static int find_sides(struct exchanging *exchanging)
{
    const struct lx_radiosity *reflected = exchanging->reflected;
    struct lx_exchange *exchange = exchanging->exchange;
    exchange->sides = lx_new_array(reflected->face_count + 1, sizeof *exchange->sides);
    exchanging->side_of = lx_new_array(reflected->face_count + 1, sizeof *exchanging->side_of);
    if (!exchange->sides || !exchanging->side_of)
        return -1;
    for (size_t f = 0; f < reflected->face_count; f++) {
        const struct lx_matte_face *face = &reflected->faces[f];
        const struct lx_exchange_side *last = &exchange->sides[exchange->count - (exchange->count > 0)];
        const bool is_back = face->sheet.turn < 0;
        if (exchange->count == 0 || last->surface != face->surface || last->is_back != is_back)
            exchange->sides[exchange->count++] = (struct lx_exchange_side){face->surface, face->is_flat, is_back, 0};
        exchanging->side_of[f] = exchange->count - 1;
    }
    const size_t sides = exchange->count;
    for (size_t t = 0; t < reflected->tile_count; t++)
        exchange->sides[exchanging->side_of[reflected->tiles[t].face]].area_m2 +=
            1e-6 * lx_tile_area(&reflected->tiles[t]);
    exchange->factors = lx_new_array(sides * sides, sizeof *exchange->factors);
    exchanging->sums = lx_new_array(sides * sides, sizeof *exchanging->sums);
    exchanging->seen = lx_new_array(sides * LX_ROWS, sizeof *exchanging->seen);
    return exchange->factors && exchanging->sums && exchanging->seen ? 0 : -1;
}

/* ---- sums over tiles ---- */

/* Links of the places of tiles. */
static void find_rows(void *data, unsigned worker, bool is_caller, unsigned first, unsigned last)
{
    const struct exchanging *exchanging = data;
    struct lx_radiosity *reflected = exchanging->reflected;
    for (size_t i = first; i < last && lx_control_goes_on(reflected->control, is_caller); i++) {
        struct lx_tile *tile = &reflected->tiles[reflected->order[i]];
        tile->is_blind = !lx_within_rows(reflected, &reflected->efforts[i], tile->face, &tile->window, &tile->cell,
                                         &exchanging->cones[worker], &tile->rows);
        tile->is_overlaid = lx_overlap_on(reflected, tile) != NULL;
        if (tile->is_blind) {
            lx_rows_free(tile->rows);
            tile->rows = NULL;
        }
    }
}

/* Adds what a place sees of each side, as number `row` of each; of sides on which another surface lies it is not known
 * which is seen. */
static void add_seen(const struct exchanging *exchanging, const struct lx_links *links, int row)
{
    const struct lx_radiosity *reflected = exchanging->reflected;
    size_t w = 0;
    for (size_t i = 0; i < links->count; i++) {
        if (links->items[i].kind == LX_LINK_NONE)
            continue;
        const struct lx_weights *weights = &links->weights[w++];
        double sum = 0;
        for (int q = 0; q < LX_RULE_NODES; q++)
            sum += (double)weights->of[q];
        exchanging->seen[exchanging->side_of[reflected->groups[weights->group].face] * LX_ROWS + (size_t)row] += sum;
    }
}

/* What a tile sends to a side, by the rule, with what it may be off, in mm^2. */
static lx_bounded sum_tile(const struct exchanging *exchanging, const struct lx_tile *tile, double *nodes,
                           double between[LX_BETWEEN])
{
    const double area = lx_tile_area(tile);
    lx_bounded sum = {0, 0};
    lx_rows_spread(tile->rows, nodes);
    for (int q = 0; q < LX_RULE_NODES; q++)
        sum.value += tile->cell.area[q] * nodes[q];
    for (int p = 0; p < LX_BETWEEN; p++) {
        double at[2];
        lx_between_place(p, at);
        between[p] -= lx_rule_value(nodes, at[0], at[1]);
    }
    sum.error = area * LX_BETWEEN_FACTOR * lx_between_mean(between) + exchanging->reflected->rule * fabs(sum.value) +
                (tile->is_overlaid ? fabs(sum.value) : 0);
    return sum;
}

/* Adds a tile to the sums of its side, and scores it. */
static void add_tile(const struct exchanging *exchanging, size_t t)
{
    struct lx_radiosity *reflected = exchanging->reflected;
    struct lx_tile *tile = &reflected->tiles[t];
    const size_t sides = exchanging->exchange->count, own = exchanging->side_of[tile->face];
    const double area = lx_tile_area(tile);
    memset(tile->residual, 0, sizeof tile->residual);
    memset(exchanging->seen, 0, sides * LX_ROWS * sizeof *exchanging->seen);
    for (int q = 0; !tile->is_blind && q < lx_rows_nodes(tile->rows); q++)
        add_seen(exchanging, &tile->rows->of[q], q);
    for (int p = 0; !tile->is_blind && p < LX_BETWEEN; p++)
        add_seen(exchanging, lx_rows_between(tile->rows, p), LX_RULE_NODES + p);
    exchanging->scores[t] = tile->is_blind ? area : 0;
    for (size_t j = 0; j < sides; j++) {
        double *seen = exchanging->seen + j * LX_ROWS;
        const lx_bounded sum =
            tile->is_blind ? (lx_bounded){area / 2, area / 2} : sum_tile(exchanging, tile, seen, seen + LX_RULE_NODES);
        lx_bounded *all = &exchanging->sums[own * sides + j];
        *all = lx_add(*all, sum);
        if (sum.error > exchanging->scores[t] && !tile->is_blind) {
            exchanging->scores[t] = sum.error;
            memset(tile->residual, 0, sizeof tile->residual);
            lx_between_changes(seen + LX_RULE_NODES, tile->residual);
        }
    }
}

/* Both numbers of a pair bound the same: the truth is in both intervals, and the part that they share is told.  Where
 * they share nothing a bound was broken, and both are told. */
static lx_bounded join(lx_bounded a, lx_bounded b)
{
    double low = fmax(a.value - a.error, b.value - b.error), high = fmin(a.value + a.error, b.value + b.error);
    if (low > high) {
        low = fmin(a.value - a.error, b.value - b.error);
        high = fmax(a.value + a.error, b.value + b.error);
    }
    const double value = fmax(low, fmin(a.error <= b.error ? a.value : b.value, high));
    return (lx_bounded){value, fmax(high - value, value - low) * LX_BOUND_SLACK};
}

static void set_factors(const struct exchanging *exchanging)
{
    struct lx_exchange *exchange = exchanging->exchange;
    const size_t sides = exchange->count;
    exchange->reached = true;
    for (size_t i = 0; i < sides; i++)
        for (size_t j = 0; j < sides; j++) {
            const double area = 1e6 * exchange->sides[i].area_m2;
            const lx_bounded sum = join(exchanging->sums[i * sides + j], exchanging->sums[j * sides + i]);
            const lx_bounded factor = {sum.value / area, sum.error / area};
            exchange->factors[i * sides + j] = factor;
            exchange->reached = exchange->reached && factor.error <= exchanging->request->error;
        }
}

/* ---- the whole ---- */

static luxel_status look(struct exchanging *exchanging)
{
    struct lx_radiosity *reflected = exchanging->reflected;
    const size_t sides = exchanging->exchange->count;
    const struct lx_within rows = {reflected->tile_count, ROWS_SHARE, find_rows, exchanging};
    free(exchanging->scores);
    exchanging->scores = lx_new_array(reflected->tile_count, sizeof *exchanging->scores);
    if (!exchanging->scores || lx_within_order(reflected))
        return LUXEL_ERROR_MEMORY;
    const luxel_status status = lx_within_run(reflected, &rows);
    memset(exchanging->sums, 0, sides * sides * sizeof *exchanging->sums);
    for (size_t t = 0; t < reflected->tile_count && status == LUXEL_OK; t++)
        add_tile(exchanging, t);
    if (status == LUXEL_OK)
        set_factors(exchanging);
    return status;
}

/* Cuts the tiles that matter; 1: some, 0: none, or it is not worth it, -1: memory ran out. */
static int refine(struct exchanging *exchanging)
{
    struct lx_radiosity *reflected = exchanging->reflected;
    const size_t count = reflected->tile_count;
    if ((double)count >= WORTH_A_ROUND * (double)reflected->most_tiles ||
        (double)reflected->effort.done > WORTH_A_ROUND * (double)reflected->effort.most)
        return 0;
    bool *cuts = lx_new_array(count, sizeof *cuts);
    int any =
        cuts ? lx_cut_greatest(reflected, exchanging->scores, (reflected->most_tiles - count) * 2 / 3 + 1, cuts) : -1;
    any = any > 0 && lx_groups_cut(reflected, cuts) ? -1 : any;
    free(cuts);
    return any;
}

static luxel_status work(struct exchanging *exchanging)
{
    struct lx_radiosity *reflected = exchanging->reflected;
    exchanging->cones = lx_new_array(reflected->threads, sizeof *exchanging->cones);
    if (!exchanging->cones || drop_faces(reflected) || find_sides(exchanging))
        return LUXEL_ERROR_MEMORY;
    for (int round = 0;; round++) {
        const luxel_status status = look(exchanging);
        if (status != LUXEL_OK || exchanging->exchange->reached || round == MOST_ROUNDS)
            return status;
        const int any = refine(exchanging);
        if (any <= 0)
            return any < 0 ? LUXEL_ERROR_MEMORY : LUXEL_OK;
    }
}

luxel_status lx_exchange_make(const struct lx_reflected_request *request, struct lx_exchange *exchange)
{
    struct exchanging exchanging = {.request = request, .exchange = exchange};
    luxel_status status = lx_reflected_begin(request, &exchanging.reflected);
    if (status == LUXEL_OK)
        status = work(&exchanging);
    for (size_t w = 0; exchanging.cones && w < exchanging.reflected->threads; w++) {
        status = status == LUXEL_OK && exchanging.cones[w].failed ? LUXEL_ERROR_MEMORY : status;
        lx_occluder_cones_clear(&exchanging.cones[w]);
    }
    lx_reflected_free(exchanging.reflected);
    free(exchanging.cones);
    free(exchanging.side_of);
    free(exchanging.sums);
    free(exchanging.seen);
    free(exchanging.scores);
    return status;
}

void lx_exchange_clear(struct lx_exchange *exchange)
{
    free(exchange->sides);
    free(exchange->factors);
    *exchange = (struct lx_exchange){0};
}
