/* SPDX-License-Identifier: MIT */
/* The recursion over the cells of a tile. */
#include "transfer.h"

#include <math.h>
#include <string.h>

#include "../base/vector.h"

enum { MOST_LEVELS = 60, CELL_EFFORT = 8 };

/* One tile and one receiver. */
struct sending {
    const struct lx_transfer *of;
    const struct lx_tile *tile;
    bool is_rough; /* its direct light is known in more detail than by its polynomial */
    struct lx_sent *sent;
};

/* Direct light where the cell is: of a node of the tile's tree. */
struct light_at {
    const struct lx_direct *direct;
    struct lx_window window; /* of that node */
    bool is_own;             /* the cell is that window */
};

/* Without regard to which sides see each other: below 0 where one does not. */
static double signed_kernel(const struct lx_transfer *transfer, const double place_mm[3], const double normal[3],
                            bool *sees)
{
    const struct lx_receiver *receiver = transfer->receiver;
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = place_mm[i] - receiver->place_mm[i];
    const double square = lx_dot(way, way), here = lx_receiver_takes(receiver, way, sees), there = -lx_dot(normal, way);
    *sees = *sees && there > 0;
    return here * there / (M_PI * square * square);
}

static double kernel(const struct lx_transfer *transfer, const double place_mm[3], const double normal[3])
{
    bool sees;
    if (transfer->constant > 0)
        return transfer->constant;
    const double value = signed_kernel(transfer, place_mm, normal, &sees);
    return sees ? value : 0;
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

/* Adds what the light at the nodes of a cell weighs. */
static void add_values(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                       const struct light_at *light, const double values[LX_RULE_NODES])
{
    struct lx_sent *sent = sending->sent;
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

static void weigh_seen(const struct sending *sending, const struct lx_tile_cell *cell, double values[LX_RULE_NODES])
{
    for (int q = 0; q < LX_RULE_NODES; q++)
        values[q] = kernel(sending->of, cell->place_mm[q], cell->normal[q]) * cell->area[q];
}

/* The kernel, as a polynomial on all of the cell, over what is seen.  False: that is too complicated. */
static bool weigh_flat_part(const struct sending *sending, const struct lx_tile_cell *cell,
                            const struct lx_partly *partly, double values[LX_RULE_NODES])
{
    double across[3];
    bool sees;
    if (!lx_occluder_cones_visible(sending->of->cones, cell, partly, values))
        return false;
    lx_cross(cell->first_mm, cell->second_mm, across);
    const double area = sqrt(lx_dot(across, across));
    for (int q = 0; q < LX_RULE_NODES; q++)
        values[q] *= area * signed_kernel(sending->of, cell->place_mm[q], cell->normal[q], &sees);
    return true;
}

static void weigh_nodes_in_part(const struct sending *sending, const struct lx_tile_cell *cell,
                                double values[LX_RULE_NODES])
{
    weigh_seen(sending, cell, values);
    for (int q = 0; q < LX_RULE_NODES; q++)
        if (values[q] > 0 && !lx_occluder_cones_leave(sending->of->cones, cell->place_mm[q]))
            values[q] = 0;
}

/* ---- the recursion ---- */

/* How far it is to where the kernel is another one. */
static double scale_of(const struct lx_transfer *transfer, const struct lx_tile_cell *cell)
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = cell->center_mm[i] - transfer->receiver->place_mm[i];
    return fmin(sqrt(lx_dot(way, way)), transfer->turns_mm);
}

/* Whether a cell is small enough to be taken as it is. */
static bool is_small(const struct sending *sending, const struct lx_tile_cell *cell, double share)
{
    return cell->radius_mm <= sending->of->least_mm || cell->radius_mm <= share * scale_of(sending->of, cell);
}

/* How a cell is seen, and what hides it in part. */
struct view_of {
    enum lx_outlook sight;
    const struct lx_partly *partly;
};

static void send_cell(const struct sending *sending, const struct lx_window *window, struct lx_tile_cell *cell,
                      const struct light_at *light, struct view_of view, int level);

/* A piece of a cell, of which it is known what hides that. */
static void send_piece(const struct sending *sending, const struct lx_window *window, const struct light_at *light,
                       const struct lx_partly *around, int level)
{
    struct lx_tile_cell cell;
    struct lx_partly partly = {0};
    lx_cell_bound(sending->of->face, window, &cell);
    const enum lx_outlook sight = lx_occluder_cones_look(sending->of->cones, &cell, around, &partly);
    send_cell(sending, window, &cell, light, (struct view_of){sight, &partly}, level);
}

static void cut_cell(const struct sending *sending, const struct lx_window *window, const struct lx_tile_cell *cell,
                     const struct light_at *light, const struct lx_partly *partly, int level)
{
    if (light->is_own && light->direct->quarters) {
        for (int i = 0; i < 4; i++) {
            const struct lx_window quarter = lx_window_quarter(window, i);
            send_piece(sending, &quarter, &(struct light_at){&light->direct->quarters[i], quarter, true}, partly,
                       level + 1);
        }
        return;
    }
    const int way = cell->lengths_mm[1] > cell->lengths_mm[0];
    for (int i = 0; i < 2; i++) {
        const struct lx_window half = lx_window_half(window, way, i);
        send_piece(sending, &half, &(struct light_at){light->direct, light->window, false}, partly, level + 1);
    }
}

/* Where nothing but horizons hide it the integrand has no jump, only a kink. */
static double part_share(const struct sending *sending, const struct lx_partly *partly)
{
    const double smoother = 2.5;
    return sending->of->fineness->round_part * (lx_partly_are_horizons(partly) ? smoother : 1);
}

/* Whether most of the light of a window falls on a small part of it: its polynomial goes up and down then, and errors
 * of the kernel's do not cancel. */
static bool is_narrow(const struct lx_direct *direct)
{
    const double beyond = 4;
    double sum = 0, greatest = 0;
    for (int q = 0; q < LX_RULE_NODES; q++) {
        sum += direct->nodes[q];
        greatest = fmax(greatest, fabs(direct->nodes[q]));
    }
    return greatest * LX_RULE_NODES > beyond * fabs(sum);
}

/* Whether the light of a window is known in more detail than by its polynomial. */
static bool has_detail(const struct light_at *light)
{
    return light->is_own && light->direct->quarters;
}

static double seen_share(const struct lx_fineness *fineness, const struct light_at *light)
{
    if (!has_detail(light))
        return fineness->seen;
    return is_narrow(light->direct) ? fineness->narrow : fineness->rough;
}

/* Whether the polynomial of a window will do for what is seen of it: it has the light of all of it, not of a part.  By
 * nodes coarse integrals take it, so that they differ from fine ones by what a horizon leaves in doubt. */
static bool tells_part(const struct lx_fineness *fineness, const struct light_at *light, enum lx_outlook sight,
                       bool by_nodes)
{
    return sight != LX_PART_SEEN || !has_detail(light) || (by_nodes && !fineness->has_details);
}

/* False: the quarters of its direct light are asked in its place. */
static bool take_cell(const struct sending *sending, const struct lx_window *window, struct lx_tile_cell *cell,
                      const struct light_at *light, struct view_of view, int level)
{
    const enum lx_outlook sight = view.sight;
    const struct lx_fineness *fineness = sending->of->fineness;
    const bool by_nodes =
        sight == LX_PART_SEEN && (!lx_is_polygon(sending->of->face) || lx_partly_have_shapes(view.partly));
    const double share = sight == LX_ALL_SEEN ? seen_share(fineness, light)
                         : by_nodes           ? part_share(sending, view.partly)
                                              : fineness->flat_part;
    const bool has_levels = level < MOST_LEVELS;
    double values[LX_RULE_NODES];
    if (sight == LX_NONE_SEEN || !lx_effort_take(sending->of->cones->effort, CELL_EFFORT))
        return true;
    if (has_levels && !(sight == LX_ALL_SEEN && sending->of->constant > 0) &&
        !(is_small(sending, cell, share) && tells_part(fineness, light, sight, by_nodes))) {
        cut_cell(sending, window, cell, light, view.partly, level);
        return !has_detail(light);
    }
    if (cell != &sending->tile->cell)
        lx_cell_nodes(sending->of->face, window, cell);
    if (sight == LX_ALL_SEEN) {
        weigh_seen(sending, cell, values);
    } else if (by_nodes) {
        weigh_nodes_in_part(sending, cell, values);
    } else if (!weigh_flat_part(sending, cell, view.partly, values)) {
        if (has_levels)
            cut_cell(sending, window, cell, light, view.partly, level);
        return !has_levels || !has_detail(light);
    }
    add_values(sending, window, cell, light, values);
    return true;
}

/* The share of the view that is known of a tile by now. */
static double seen_of(const struct lx_sent *sent)
{
    double seen = 0;
    for (int q = 0; q < LX_RULE_NODES; q++)
        seen += sent->weights[q];
    return seen;
}

static void send_cell(const struct sending *sending, const struct lx_window *window, struct lx_tile_cell *cell,
                      const struct light_at *light, struct view_of view, int level)
{
    const double before = light->is_own ? seen_of(sending->sent) : 0;
    if (!take_cell(sending, window, cell, light, view, level) || !light->is_own || view.sight == LX_NONE_SEEN)
        return;
    const struct lx_doubt *doubt = &light->direct->doubt;
    if (cell != &sending->tile->cell)
        lx_cell_nodes(sending->of->face, window, cell);
    const double seen = fabs(seen_of(sending->sent) - before);
    const double kernel = sending->of->constant > 0 ? sending->of->constant
                          : sending->of->fineness->is_of_nodes
                              ? lx_kernel_of_nodes(sending->of->receiver, cell)
                              : lx_greatest_kernel(sending->of->receiver, sending->of->face, cell);
    if (cell->radius_mm <= sending->of->receiver->smooth_mm)
        return;
    const double differs = lx_doubt_differs(doubt, kernel, seen);
    sending->sent->doubt += lx_doubt_at(doubt, kernel, seen);
    sending->sent->squares += differs * differs;
}

struct lx_transfer lx_transfer_of(const struct lx_fineness *fineness, const struct lx_receiver *receiver,
                                  const struct lx_occluder_cones *cones, const struct lx_matte_face *face)
{
    const double turns = 2; /* radii */
    const bool is_own = lx_receives_from_own(receiver, face);
    return (struct lx_transfer){
        .fineness = fineness,
        .receiver = receiver,
        .cones = cones,
        .face = face,
        .constant =
            is_own && !receiver->response && face->sheet.type->exchange ? face->sheet.type->exchange(&face->sheet) : 0,
        .turns_mm = face->is_flat ? HUGE_VAL : turns * face->sheet.half_mm[0],
        .least_mm = is_own ? 1e-3 * face->radius_mm : 10 * cones->touch_mm,
    };
}

void lx_transfer(const struct lx_transfer *transfer, const struct lx_tile *tile, enum lx_outlook sight,
                 const struct lx_partly *partly, struct lx_sent *sent)
{
    const struct sending sending = {.of = transfer, .tile = tile, .is_rough = tile->direct.quarters, .sent = sent};
    memset(sent, 0, sizeof *sent);
    send_cell(&sending, &tile->window, (struct lx_tile_cell *)&tile->cell,
              &(struct light_at){&tile->direct, tile->window, true}, (struct view_of){sight, partly}, 0);
    for (int q = 0; q < LX_RULE_NODES && !sending.is_rough; q++)
        sent->direct += sent->weights[q] * tile->direct.nodes[q];
}

bool lx_transfer_group(const struct lx_transfer *transfer, const struct lx_group *group, struct lx_sent *sent)
{
    const struct lx_tile_cell *cell = &group->cell;
    if (transfer->constant == 0 && cell->radius_mm > transfer->fineness->group * scale_of(transfer, cell))
        return false;
    sent->direct = sent->doubt = sent->squares = 0;
    for (int q = 0; q < LX_RULE_NODES; q++) {
        sent->weights[q] = kernel(transfer, cell->place_mm[q], cell->normal[q]) * cell->area[q];
        sent->direct += sent->weights[q] * group->direct[q];
    }
    return true;
}
