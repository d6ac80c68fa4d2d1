/* SPDX-License-Identifier: MIT */
/* Where the levels cross the edges of the grid. */
#include <math.h>

#include "isophotes.h"

/* One edge, from its first (left or upper) corner to the second, with the corners that lie before and behind it. */
struct edge {
    size_t index;
    unsigned line;
    unsigned axis;    /* along which it runs */
    double across_mm; /* its other coordinate */
    double at[2];     /* of its corners */
    int surface[4];   /* of the corners before, first, second, behind */
    double value[4];
};

static struct lx_iso_way way_along(const struct lx_iso_search *search, const struct edge *edge, int surface)
{
    struct lx_iso_way way;
    way.search = search;
    way.surface = surface;
    way.along_rim = false;
    way.axis = edge->axis;
    way.across_mm = edge->across_mm;
    way.count = 0; /* the samples need no clearing */
    return way;
}

/* Where a level meets a piece by a straight line between the values at its ends. */
static double cross_straight(double level, struct lx_iso_sample from, struct lx_iso_sample to)
{
    double share = (level - from.value) / (to.value - from.value);
    return from.at + fmin(fmax(share, 0), 1) * (to.at - from.at);
}

/* Lists the crossings of all levels with a piece. */
static void cross_piece(struct lx_iso_search *search, const struct edge *edge, unsigned char piece, int surface,
                        struct lx_iso_sample from, struct lx_iso_sample to)
{
    double low = fmin(from.value, to.value), high = fmax(from.value, to.value);
    if (!(low < high) || !isfinite(from.value) || !isfinite(to.value))
        return;
    size_t k = lx_iso_first_level(search, low);
    if (k == search->level_count || search->levels[k] > high)
        return;
    struct lx_iso_way way = way_along(search, edge, surface);
    for (; k < search->level_count && search->levels[k] <= high; k++) {
        double at = 0;
        if (!search->evaluator)
            at = cross_straight(search->levels[k], from, to);
        else if (!lx_iso_way_cross(&way, search->levels[k], from, to, &at))
            continue;
        struct lx_iso_crossing *crossing =
            lx_iso_append(search, &search->lines[edge->line].crossings, sizeof *crossing);
        if (!crossing)
            return;
        *crossing = (struct lx_iso_crossing){.edge = edge->index, .piece = piece, .level = k, .at = at};
    }
}

static bool add_node(struct lx_iso_search *search, const struct edge *edge, unsigned char side,
                     struct lx_iso_sample sample)
{
    struct lx_iso_node *node = lx_iso_append(search, &search->lines[edge->line].nodes, sizeof *node);
    if (node)
        *node = (struct lx_iso_node){.edge = edge->index, .side = side, .at = sample.at, .value = sample.value};
    return node;
}

/* An edge between different surfaces: what of it belongs to the surface of each corner. */
static void clip_edge(struct lx_iso_search *search, const struct edge *edge)
{
    for (unsigned char side = 0; side < 2; side++) {
        int surface = edge->surface[1 + side];
        if (surface == LX_ISO_NOTHING)
            continue;
        struct lx_iso_way way = way_along(search, edge, surface);
        struct lx_iso_sample corner = {edge->at[side], edge->value[1 + side]}, cut = corner;
        double xy_mm[2];
        cut.at = lx_iso_way_leave(&way, corner.at, edge->at[1 - side]);
        lx_iso_way_place(&way, cut.at, xy_mm);
        cut.value = cut.at == corner.at ? corner.value : lx_iso_value(search, surface, xy_mm);
        if (isnan(cut.value))
            cut = corner;
        if (!add_node(search, edge, side, cut))
            return;
        cross_piece(search, edge, side, surface, side == 0 ? corner : cut, side == 0 ? cut : corner);
    }
}

/* Whether no level comes near an edge, as is the rule. */
static bool is_far_from_levels(const struct lx_iso_search *search, const struct edge *edge)
{
    double low = edge->value[1], high = low;
    for (int i = 0; i < 4; i++) {
        double value = edge->value[i];
        if (edge->surface[i] != edge->surface[1] && i % 3 == 0)
            continue;
        low = value < low ? value : low;
        high = value > high ? value : high;
    }
    /* an extremum between the corners may rise as far again as the corners around it differ */
    double reach = high - low;
    size_t k = lx_iso_first_level(search, low - reach);
    return k == search->level_count || search->levels[k] > high + reach;
}

/*
 * Whether a level may pass through an edge twice, so that its corners do not show it: there is an extremum between
 * them, as a curve through the four corners has it, and a level between it and them.  *sign is that of the extremum.
 */
static bool may_hide_level(const struct lx_iso_search *search, const struct edge *edge, double *sign)
{
    const double *v = edge->value;
    for (int i = 0; i < 4; i++)
        if (edge->surface[i] != edge->surface[1] || !isfinite(v[i]))
            return false;
    /* the slopes at the two corners, with some room for what the curve does not tell */
    double first = (6 * v[2] - 2 * v[0] - 3 * v[1] - v[3]) / 6, second = (v[0] - 6 * v[1] + 3 * v[2] + 2 * v[3]) / 6;
    double most = fmax(fabs(first), fabs(second)), room = 0.1 * most;
    if (first > -room && second < room)
        *sign = 1;
    else if (first < room && second > -room)
        *sign = -1;
    else
        return false;
    /* a parabola rises a quarter of its slope: twice that is safe */
    double reach = 0.5 * most, high = fmax(v[1], v[2]), low = fmin(v[1], v[2]);
    size_t k = lx_iso_first_level(search, *sign > 0 ? high : low - reach);
    return k < search->level_count && search->levels[k] <= (*sign > 0 ? high + reach : low);
}

/* An edge between corners of one surface: one piece, or two that meet at an extremum. */
static void cross_edge(struct lx_iso_search *search, const struct edge *edge)
{
    if (is_far_from_levels(search, edge))
        return;
    int surface = edge->surface[1];
    struct lx_iso_sample first = {edge->at[0], edge->value[1]}, second = {edge->at[1], edge->value[2]};
    double sign;
    if (search->evaluator && may_hide_level(search, edge, &sign)) {
        struct lx_iso_way way = way_along(search, edge, surface);
        struct lx_iso_sample peak = lx_iso_way_extremum(&way, first.at, second.at, sign);
        if (sign * peak.value > fmax(sign * first.value, sign * second.value)) {
            if (!add_node(search, edge, 0, peak))
                return;
            cross_piece(search, edge, 0, surface, first, peak);
            cross_piece(search, edge, 1, surface, peak, second);
            return;
        }
    }
    cross_piece(search, edge, 0, surface, first, second);
}

static void look_at(struct lx_iso_search *search, const struct edge *edge)
{
    if (edge->surface[1] == edge->surface[2]) {
        if (edge->surface[1] != LX_ISO_NOTHING)
            cross_edge(search, edge);
    } else if (search->evaluator) {
        clip_edge(search, edge);
    }
}

void lx_iso_edges(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line, bool is_caller)
{
    lx_iso_load(search, worker, line, true);
    const struct lx_iso_corners *around = worker->around, *own = &around[1];
    for (unsigned i = 0; i < search->columns; i++) {
        if (i + 1 < search->columns) {
            struct edge edge = {.index = 2 * (size_t)i, .line = line, .axis = 0, .across_mm = search->y_mm[line]};
            for (int k = 0; k < 4; k++) {
                bool exists = i + (unsigned)k >= 1 && i + (unsigned)k - 1 < search->columns;
                edge.surface[k] = exists ? own->surface[i + (unsigned)k - 1] : LX_ISO_NOTHING;
                edge.value[k] = exists ? own->value[i + (unsigned)k - 1] : 0;
            }
            edge.at[0] = search->x_mm[i], edge.at[1] = search->x_mm[i + 1];
            look_at(search, &edge);
        }
        if (line + 1 < search->rows) {
            struct edge edge = {.index = 2 * (size_t)i + 1, .line = line, .axis = 1, .across_mm = search->x_mm[i]};
            for (int k = 0; k < 4; k++) {
                edge.surface[k] = around[k].surface[i];
                edge.value[k] = around[k].value[i];
            }
            edge.at[0] = search->y_mm[line], edge.at[1] = search->y_mm[line + 1];
            look_at(search, &edge);
        }
        if (i % 16 == 0 && !lx_control_goes_on(&search->control, is_caller))
            return;
    }
}
