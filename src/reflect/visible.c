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
    double moments[LX_RULE_NODES];
};

/* Factors of the integrals of the powers of x from 0 on. */
static const double factors[LX_ORDER] = {1, 1.0 / 2, 1.0 / 3, 1.0 / 4};

/* Integrals of x^i y^j, at place 4 i + j, over all of the square from -1 to 1. */
static const double square_moments[LX_RULE_NODES] = {
    4, 0, 4.0 / 3, 0, 0, 0, 0, 0, 4.0 / 3, 0, 4.0 / 9, 0, 0, 0, 0, 0,
};

/* The rule's polynomials (rule.h) by powers. */
#define APART (LX_RULE_OUTER * LX_RULE_OUTER - LX_RULE_INNER * LX_RULE_INNER)
#define AT_OUTER (1 / (APART * 2 * LX_RULE_OUTER))
#define AT_INNER (1 / (APART * 2 * LX_RULE_INNER))
static const double powers[LX_ORDER][LX_ORDER] = {
    {-LX_RULE_INNER * LX_RULE_INNER * LX_RULE_OUTER * AT_OUTER, LX_RULE_INNER *LX_RULE_INNER *AT_OUTER,
     LX_RULE_OUTER *AT_OUTER, -AT_OUTER},
    {LX_RULE_OUTER * LX_RULE_OUTER * LX_RULE_INNER * AT_INNER, -LX_RULE_OUTER *LX_RULE_OUTER *AT_INNER,
     -LX_RULE_INNER *AT_INNER, AT_INNER},
    {LX_RULE_OUTER * LX_RULE_OUTER * LX_RULE_INNER * AT_INNER, LX_RULE_OUTER *LX_RULE_OUTER *AT_INNER,
     -LX_RULE_INNER *AT_INNER, -AT_INNER},
    {-LX_RULE_INNER * LX_RULE_INNER * LX_RULE_OUTER * AT_OUTER, -LX_RULE_INNER *LX_RULE_INNER *AT_OUTER,
     LX_RULE_OUTER *AT_OUTER, AT_OUTER},
};

/* ---- integrals ---- */

/* Adds integrals over a polygon, whose corners go counterclockwise, of x^i y^j at place 4 i + j; x is a share of the
 * cell's width. */
static void add_polygon(struct view *view, const struct polygon *polygon, double sign)
{
    double *const moments = view->moments;
    for (unsigned k = 0; k < polygon->count; k++) {
        const double *from = polygon->at[k], *to = polygon->at[k + 1 < polygon->count ? k + 1 : 0];
        const double rise = sign * (to[1] - from[1]) / 2;
        if (rise == 0)
            continue;
        for (int p = 0; p < LX_ORDER; p++) {
            const double share = (1 + lx_rule_places[p]) / 2;
            const double y = from[1] + share * (to[1] - from[1]);
            const double width = view->cell->narrow == 1 ? 1 : lx_cell_width(view->cell, y);
            if (!(width > 0)) /* at the tip */
                continue;
            const double x = (from[0] + share * (to[0] - from[0])) / width;
            const double square = y * y, cube = square * y;
            double power = rise * lx_rule_weights[p] * width * x;
            for (int i = 0; i < LX_ORDER; i++) {
                double *row = moments + LX_ORDER * i;
                const double moment = power * factors[i];
                row[0] += moment;
                row[1] += moment * y;
                row[2] += moment * square;
                row[3] += moment * cube;
                power *= x;
            }
        }
    }
}

/* The integrals of the rule's polynomials, by those of powers. */
static void set_shares(const struct view *view, double shares[LX_RULE_NODES])
{
    for (int i = 0; i < LX_ORDER; i++) {
        double row[LX_ORDER] = {0};
        for (int k = 0; k < LX_ORDER; k++)
            for (int l = 0; l < LX_ORDER; l++)
                row[l] += powers[i][k] * view->moments[LX_ORDER * k + l];
        for (int j = 0; j < LX_ORDER; j++) {
            double sum = 0;
            for (int l = 0; l < LX_ORDER; l++)
                sum += powers[j][l] * row[l];
            shares[LX_ORDER * i + j] = sum;
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

static bool add_hidden(struct view *view, const struct polygon *polygon, unsigned first, double sign);

/* Adds what is left of a polygon by the cones from `first` on.  False: there are too many corners. */
static bool add_visible(struct view *view, const struct polygon *polygon, unsigned first, double sign)
{
    if (!lx_effort_take(view->cones->effort, POLYGON_EFFORT))
        return true;
    add_polygon(view, polygon, sign);
    return add_hidden(view, polygon, first, sign);
}

/* Takes off what each of the cones hides of a polygon that none of the next ones hides. */
static bool add_hidden(struct view *view, const struct polygon *polygon, unsigned first, double sign)
{
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
                               const struct lx_partly *partly, double shares[LX_RULE_NODES])
{
    const struct polygon whole = {4, {{-cell->narrow, -1}, {cell->narrow, -1}, {1, 1}, {-1, 1}}};
    struct view view = {.cones = cones, .cell = cell};
    if (partly->is_all)
        return false;
    for (unsigned i = 0; i < partly->count; i++) {
        if (partly->cones[i]->shape)
            continue;
        if (view.count == MOST_CONES)
            return false;
        view.before[view.count++] = partly->cones[i];
    }
    const bool is_square = cell->narrow == 1;
    if (is_square)
        memcpy(view.moments, square_moments, sizeof view.moments);
    if (!(is_square ? add_hidden(&view, &whole, 0, 1) : add_visible(&view, &whole, 0, 1)))
        return false;
    set_shares(&view, shares);
    return true;
}
