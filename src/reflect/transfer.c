/* SPDX-License-Identifier: MIT */
/* The recursion over the cells of a tile. */
#include "transfer.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

enum { MOST_LEVELS = 60 };

/* One tile and one receiver. */
struct sending {
    const struct lx_fineness *fineness;
    const struct lx_receiver *receiver;
    const struct lx_veils *veils;
    const struct lx_matte_face *face;
    const struct lx_tile *tile;
    bool is_rough;   /* its direct light is known in more detail than by its polynomial */
    double constant; /* the kernel inside of a sphere; 0: by its formula */
    double least_mm; /* cells are not cut below this */
    struct lx_sent *sent;
};

/* Direct light where the cell is: of a node of the tile's tree. */
struct light_at {
    const struct lx_direct *direct;
    struct lx_window window; /* of that node */
    bool is_own;             /* the cell is that window */
};

static double kernel(const struct sending *sending, const double place_mm[3], const double normal[3])
{
    const struct lx_receiver *receiver = sending->receiver;
    double way[3];
    if (sending->constant > 0)
        return sending->constant;
    for (int i = 0; i < 3; i++)
        way[i] = place_mm[i] - receiver->place_mm[i];
    const double square = lx_dot(way, way), here = lx_dot(receiver->normal, way), there = -lx_dot(normal, way);
    return here > 0 && there > 0 ? here * there / (M_PI * square * square) : 0;
}

/* Coordinates of a place of the face in a window, from -1 to 1. */
static double within(const struct lx_window *window, int way, double at)
{
    return (at - window->middle[way]) / window->half[way];
}

/* ---- cells that are wholly seen ---- */

/* Adds the nodes of a cell, as values of the tile's polynomials. */
static void add_weights(const struct lx_window *whole, const struct lx_window *window,
                        const double values[LX_RULE_NODES], double weights[LX_RULE_NODES])
{
    double across[LX_ORDER][LX_ORDER], upward[LX_ORDER][LX_ORDER];
    for (int k = 0; k < LX_ORDER; k++) {
        lx_rule_basis(within(whole, 0, window->middle[0] + window->half[0] * lx_rule_places[k]), across[k]);
        lx_rule_basis(within(whole, 1, window->middle[1] + window->half[1] * lx_rule_places[k]), upward[k]);
    }
    for (int k = 0; k < LX_ORDER; k++) {
        double row[LX_ORDER] = {0};
        for (int l = 0; l < LX_ORDER; l++)
            for (int j = 0; j < LX_ORDER; j++)
                row[j] += values[LX_ORDER * k + l] * upward[l][j];
        for (int i = 0; i < LX_ORDER; i++)
            for (int j = 0; j < LX_ORDER; j++)
                weights[LX_ORDER * i + j] += across[k][i] * row[j];
    }
}

static void add_seen(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                     const struct light_at *light)
{
    struct lx_sent *sent = sending->sent;
    double values[LX_RULE_NODES];
    for (int q = 0; q < LX_RULE_NODES; q++)
        values[q] = kernel(sending, cell->place_mm[q], cell->normal[q]) * cell->area[q];
    if (cell == &sending->tile->cell)
        for (int q = 0; q < LX_RULE_NODES; q++)
            sent->weights[q] += values[q];
    else
        add_weights(&sending->tile->window, window, values, sent->weights);
    if (!sending->is_rough)
        return;
    if (light->is_own) {
        for (int q = 0; q < LX_RULE_NODES; q++)
            sent->direct += values[q] * light->direct->nodes[q];
        return;
    }
    double weights[LX_RULE_NODES] = {0};
    add_weights(&light->window, window, values, weights);
    for (int q = 0; q < LX_RULE_NODES; q++)
        sent->direct += weights[q] * light->direct->nodes[q];
}

/* ---- cells that are seen in part ---- */

/* Adds one place, whose coordinates in the face are s, t, with a weight. */
static void add_place(const struct sending *sending, const struct light_at *light, double s, double t, double weight)
{
    const struct lx_window *whole = &sending->tile->window;
    struct lx_sent *sent = sending->sent;
    double across[LX_ORDER], upward[LX_ORDER];
    lx_rule_basis(within(whole, 0, s), across);
    lx_rule_basis(within(whole, 1, t), upward);
    for (int i = 0; i < LX_ORDER; i++)
        for (int j = 0; j < LX_ORDER; j++)
            sent->weights[LX_ORDER * i + j] += weight * across[i] * upward[j];
    if (sending->is_rough)
        sent->direct +=
            weight * lx_rule_value(light->direct->nodes, within(&light->window, 0, s), within(&light->window, 1, t));
}

/* A place of a piece, by the coordinates of its cell. */
static void add_sample(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                       const struct light_at *light, const double at[2], double area)
{
    double place[3];
    for (int i = 0; i < 3; i++)
        place[i] = cell->center_mm[i] + at[0] * cell->first_mm[i] + at[1] * cell->second_mm[i];
    for (size_t v = 0; v < sending->veils->count; v++)
        if (sending->veils->items[v].shape && !lx_veils_leave(sending->veils, place))
            return;
    const double weight = area * kernel(sending, place, cell->normal[0]);
    add_place(sending, light, window->middle[0] + at[0] * window->half[0], window->middle[1] + at[1] * window->half[1],
              weight);
}

/* A triangle of a piece, by Radon's rule of seven places, which is exact to the fifth degree: the middle, and two
 * triples, each near to the corners or to the sides. */
static void add_triangle(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                         const struct light_at *light, const double *const corners[3])
{
    const double *a = corners[0], *b = corners[1], *c = corners[2];
    const double half = fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    const double area = half * cell->lengths_mm[0] * cell->lengths_mm[1];
    static const double shares[2] = {0.10128650732345633, 0.47014206410511505}; /* (6 -+ sqrt 15)/21 */
    static const double weights[2] = {0.12593918054482717, 0.13239415278850619}; /* (155 -+ sqrt 15)/1200 */
    const double sum[2] = {a[0] + b[0] + c[0], a[1] + b[1] + c[1]};
    add_sample(sending, window, cell, light, (const double[]){sum[0] / 3, sum[1] / 3}, area * 9 / 40);
    for (int k = 0; k < 6; k++) {
        const double share = shares[k / 3];
        double at[2];
        for (int i = 0; i < 2; i++)
            at[i] = share * sum[i] + (1 - 3 * share) * corners[k % 3][i];
        add_sample(sending, window, cell, light, at, area * weights[k / 3]);
    }
}

static bool add_flat_part(const struct sending *sending, const struct lx_window *window,
                          const struct lx_tile_cell *cell, const struct light_at *light)
{
    struct lx_clipped pieces[LX_MOST_PIECES];
    const int count = lx_veils_cut(sending->veils, cell, pieces);
    for (int p = 0; p < count; p++)
        for (unsigned k = 2; k < pieces[p].count; k++)
            add_triangle(sending, window, cell, light,
                         (const double *const[]){pieces[p].at[0], pieces[p].at[k - 1], pieces[p].at[k]});
    return count >= 0;
}

static void add_nodes_in_part(const struct sending *sending, const struct lx_window *window,
                              const struct lx_tile_cell *cell, const struct light_at *light)
{
    for (int q = 0; q < LX_RULE_NODES; q++) {
        const double weight = kernel(sending, cell->place_mm[q], cell->normal[q]) * cell->area[q];
        if (weight > 0 && lx_veils_leave(sending->veils, cell->place_mm[q]))
            add_place(sending, light, window->middle[0] + window->half[0] * lx_rule_places[q / LX_ORDER],
                      window->middle[1] + window->half[1] * lx_rule_places[q % LX_ORDER], weight);
    }
}

/* ---- the recursion ---- */

static double distance_to(const struct sending *sending, const struct lx_tile_cell *cell)
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = cell->center_mm[i] - sending->receiver->place_mm[i];
    return sqrt(lx_dot(way, way));
}

/* Whether a cell is small enough to be taken as it is. */
static bool is_small(const struct sending *sending, const struct lx_tile_cell *cell, enum lx_outlook sight,
                     bool is_rough)
{
    const struct lx_fineness *fineness = sending->fineness;
    const bool is_plate = sending->face->sheet.type == LX_SHEET_PLATE;
    if (cell->radius_mm <= sending->least_mm || (sight == LX_ALL_SEEN && sending->constant > 0))
        return true;
    const double share = sight == LX_ALL_SEEN ? (is_rough ? fineness->rough : fineness->seen)
                         : is_plate           ? fineness->flat_part
                                              : fineness->round_part;
    return cell->radius_mm <= share * distance_to(sending, cell);
}

static void send_cell(const struct sending *sending, const struct lx_window *window, struct lx_tile_cell *cell,
                      const struct light_at *light, int level);

static void send_piece(const struct sending *sending, const struct lx_window *window, const struct light_at *light,
                       int level)
{
    struct lx_tile_cell cell;
    lx_cell_bound(sending->face, window, &cell);
    send_cell(sending, window, &cell, light, level);
}

static void cut_cell(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                     const struct light_at *light, int level)
{
    if (light->is_own && light->direct->quarters) {
        for (int i = 0; i < 4; i++) {
            const struct lx_window quarter = lx_window_quarter(window, i);
            send_piece(sending, &quarter, &(struct light_at){&light->direct->quarters[i], quarter, true}, level + 1);
        }
        return;
    }
    const int way = cell->lengths_mm[1] > cell->lengths_mm[0];
    for (int i = 0; i < 2; i++) {
        const struct lx_window half = lx_window_half(window, way, i);
        send_piece(sending, &half, &(struct light_at){light->direct, light->window, false}, level + 1);
    }
}

static void send_cell(const struct sending *sending, const struct lx_window *window, struct lx_tile_cell *cell,
                      const struct light_at *light, int level)
{
    const enum lx_outlook sight = lx_veils_look(sending->veils, cell);
    const bool is_rough = light->is_own && light->direct->quarters;
    if (sight == LX_NONE_SEEN)
        return;
    if (level < MOST_LEVELS && !is_small(sending, cell, sight, is_rough)) {
        cut_cell(sending, window, cell, light, level);
        return;
    }
    if (cell != &sending->tile->cell)
        lx_cell_nodes(sending->face, window, cell);
    if (sight == LX_ALL_SEEN)
        add_seen(sending, window, cell, light);
    else if (sending->face->sheet.type != LX_SHEET_PLATE)
        add_nodes_in_part(sending, window, cell, light);
    else if (!add_flat_part(sending, window, cell, light)) {
        if (level < MOST_LEVELS)
            cut_cell(sending, window, cell, light, level);
    }
}

void lx_transfer(const struct lx_fineness *fineness, const struct lx_receiver *receiver, const struct lx_veils *veils,
                 const struct lx_matte_face *face, const struct lx_tile *tile, struct lx_sent *sent)
{
    const double radius = face->sheet.half_mm[0];
    const bool is_own = receiver->own == face->surface && !receiver->is_turned;
    const bool is_hollow = face->sheet.type == LX_SHEET_BALL && face->sheet.turn < 0;
    const struct sending sending = {
        .fineness = fineness,
        .receiver = receiver,
        .veils = veils,
        .face = face,
        .tile = tile,
        .is_rough = tile->direct.quarters,
        .constant = is_own && is_hollow ? 1 / (4 * M_PI * radius * radius) : 0,
        .least_mm = is_own ? 1e-3 * face->radius_mm : 10 * veils->touch_mm,
        .sent = sent,
    };
    memset(sent, 0, sizeof *sent);
    send_cell(&sending, &tile->window, (struct lx_tile_cell *)&tile->cell,
              &(struct light_at){&tile->direct, tile->window, true}, 0);
    for (int q = 0; q < LX_RULE_NODES && !sending.is_rough; q++)
        sent->direct += sent->weights[q] * tile->direct.nodes[q];
}
