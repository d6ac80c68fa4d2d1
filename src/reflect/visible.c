/* SPDX-License-Identifier: MIT */
/*
 * The part of a cell with straight edges that is seen: integrals of the rule's polynomials over it, where no cone of
 * planes hides it.  Occluder cones are convex, so what several of them hide of a convex polygon is told by polygons
 * alone, by inclusion and exclusion; the integral over a polygon goes along its edges, by Green's theorem.
 */
#include <string.h>

#include "../base/vector.h"
#include "occluder_cone.h"

enum { MOST_CORNERS = 48, MOST_CONES = 10 };
enum { POLYGON_EFFORT = 5 };

/* A convex polygon in coordinates of the cell, from -1 to 1. */
struct polygon {
    unsigned count;
    double at[MOST_CORNERS][2];
};

/* A cell and what stands before it. */
struct view {
    const struct lx_occluder_cones *cones;
    const struct lx_tile_cell *cell;
    const struct lx_occluder_cone *before[MOST_CONES];
    unsigned count;
    double *shares;
};

/* ---- integrals ---- */

/* Integrals from 0 to x of the rule's four polynomials. */
static void integrate_basis(double x, double integrals[LX_ORDER])
{
    const double outer = LX_RULE_OUTER, inner = LX_RULE_INNER, apart = outer * outer - inner * inner;
    const double square = x * x, cube = x * (square / 3 - outer * outer),
                 cube_within = x * (square / 3 - inner * inner);
    const double even = square * (square / 4 - outer * outer / 2),
                 even_within = square * (square / 4 - inner * inner / 2);
    integrals[0] = (outer * cube_within - even_within) / (apart * 2 * outer);
    integrals[1] = (even - inner * cube) / (apart * 2 * inner);
    integrals[2] = (inner * cube + even) / (-apart * 2 * inner);
    integrals[3] = (outer * cube_within + even_within) / (apart * 2 * outer);
}

/* Adds the integrals over a polygon, whose corners go counterclockwise; coordinates of the polynomials are shares of
 * the cell's width. */
static void add_polygon(const struct view *view, const struct polygon *polygon, double sign)
{
    double *const shares = view->shares;
    for (unsigned k = 0; k < polygon->count; k++) {
        const double *from = polygon->at[k], *to = polygon->at[k + 1 < polygon->count ? k + 1 : 0];
        const double rise = sign * (to[1] - from[1]) / 2;
        if (rise == 0)
            continue;
        for (int p = 0; p < LX_ORDER; p++) {
            const double share = (1 + lx_rule_places[p]) / 2;
            const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
            const double width = lx_cell_width(view->cell, y), weight = rise * lx_rule_weights[p] * width;
            double across[LX_ORDER], upward[LX_ORDER];
            if (!(width > 0)) /* at the tip */
                continue;
            integrate_basis(x / width, across);
            lx_rule_basis(y, upward);
            for (int i = 0; i < LX_ORDER; i++)
                for (int j = 0; j < LX_ORDER; j++)
                    shares[LX_ORDER * i + j] += weight * across[i] * upward[j];
        }
    }
}

/* ---- polygons ---- */

static void copy(const struct polygon *from, struct polygon *to)
{
    to->count = from->count;
    memcpy(to->at, from->at, from->count * sizeof *from->at);
}

/* The part of a polygon that is on the hidden side of a plane; false: too many corners. */
static bool clip(const struct lx_tile_cell *cell, const double plane[4], struct polygon *polygon)
{
    const double middle = lx_dot(plane, cell->center_mm) + plane[3];
    const double x = lx_dot(plane, cell->first_mm), y = lx_dot(plane, cell->second_mm);
    double over[MOST_CORNERS];
    unsigned above = 0;
    for (unsigned k = 0; k < polygon->count; k++) {
        over[k] = middle + x * polygon->at[k][0] + y * polygon->at[k][1];
        above += over[k] > 0;
    }
    if (above == polygon->count)
        return true;
    if (above == 0) {
        polygon->count = 0;
        return true;
    }
    struct polygon whole;
    copy(polygon, &whole);
    polygon->count = 0;
    for (unsigned k = 0; k < whole.count; k++) {
        const unsigned next = k + 1 < whole.count ? k + 1 : 0;
        if (polygon->count + 2 > MOST_CORNERS)
            return false;
        if (over[k] > 0)
            memcpy(polygon->at[polygon->count++], whole.at[k], sizeof *polygon->at);
        if ((over[k] > 0) != (over[next] > 0)) {
            const double share = over[k] / (over[k] - over[next]);
            for (int i = 0; i < 2; i++)
                polygon->at[polygon->count][i] = whole.at[k][i] + share * (whole.at[next][i] - whole.at[k][i]);
            polygon->count++;
        }
    }
    return true;
}

static bool hide(const struct view *view, const struct lx_occluder_cone *cone, struct polygon *polygon)
{
    for (size_t k = cone->first; k < cone->first + cone->count && polygon->count > 0; k++)
        if (!clip(view->cell, view->cones->planes[k], polygon))
            return false;
    return true;
}

/* Adds what is left of a polygon by the cones from `first` on: the polygon, without what each of them hides of it that
 * none of the next ones hides.  False: there are too many corners. */
static bool add_visible(const struct view *view, const struct polygon *polygon, unsigned first, double sign)
{
    if (!lx_effort_take(view->cones->effort, POLYGON_EFFORT))
        return true;
    add_polygon(view, polygon, sign);
    for (unsigned v = first; v < view->count; v++) {
        struct polygon hidden;
        copy(polygon, &hidden);
        if (!hide(view, view->before[v], &hidden))
            return false;
        if (hidden.count > 2 && !add_visible(view, &hidden, v + 1, -sign))
            return false;
    }
    return true;
}

bool lx_occluder_cones_visible(const struct lx_occluder_cones *cones, const struct lx_tile_cell *cell,
                               double shares[LX_RULE_NODES])
{
    const struct polygon whole = {4, {{-cell->narrow, -1}, {cell->narrow, -1}, {1, 1}, {-1, 1}}};
    struct view view = {.cones = cones, .cell = cell, .shares = shares};
    memset(shares, 0, LX_RULE_NODES * sizeof *shares);
    for (size_t i = 0; i < cones->count; i++) {
        if (cones->items[i].shape || lx_occluder_cone_look(cones, &cones->items[i], cell) == LX_ALL_SEEN)
            continue;
        if (view.count == MOST_CONES)
            return false;
        view.before[view.count++] = &cones->items[i];
    }
    return add_visible(&view, &whole, 0, 1);
}
