/* SPDX-License-Identifier: MIT */
/*
 * Tiles: faces of the scene, one side of a sheet each, cut into windows, on each of which the reflected irradiance is
 * a polynomial by its values at the nodes; and cells, windows of any size with the places of their nodes.
 */
#ifndef LX_REFLECT_TILE_H
#define LX_REFLECT_TILE_H

#include <stddef.h>

#include "../surface/sheet.h"
#include "../world/prepared.h"
#include "rule.h"

/* A window of a face in space.  Where edges are straight it is part of a parallelogram, center + x first + y second, x
 * and y from -1 to 1: where |x| <= w(y), lx_cell_width().  Of what is round both vectors are 0. */
struct lx_tile_cell {
    double center_mm[3], radius_mm; /* a ball around it */
    double first_mm[3], second_mm[3];
    double narrow;        /* w(-1); w(1) is 1 */
    double lengths_mm[2]; /* about half its sides */
    double place_mm[LX_RULE_NODES][3], normal[LX_RULE_NODES][3], area[LX_RULE_NODES];
};

/* A face reflects, on one side of a surface. */
struct lx_matte_face {
    struct lx_smooth_sheet sheet;
    size_t surface; /* among the prepared ones */
    double reflectance;
    double center_mm[3], radius_mm; /* a ball around it */
    double size_mm[2];              /* about how long it is along s and t */
    struct lx_tile_cell cell;       /* bounds of all of it */
    uint32_t group;                 /* all of it */
    bool is_flat;
    bool is_overlaid;  /* another one lies on it (overlap.h) */
    bool is_facet;     /* one of many of its surface, a mesh, which may see and hide each other: */
    uint32_t triangle; /* which one it is, */
    bool is_small;     /* and whether they are so many that reflected light is linear on it unless it is cut */
};

/* What samples of the direct light of a window are not sure of (doubt.h): fluxes in mm^2 times irradiance. */
struct lx_doubt {
    double off;      /* beside its polynomials, without signs, which cancel from afar, */
    double reach;    /* times the radii of the windows that it is in, in mm */
    double left;     /* of outlines, of folds that bend and of the samples themselves */
    double squares;  /* of what the last samples differ by, window by window */
    double greatest; /* irradiance that may be wrong anywhere on it */
};

/* Direct light on a window: coefficients at the nodes that have the true integrals with all polynomials of the rule's
 * degree; children, quarters, where that is not all of it. */
struct lx_direct {
    double nodes[LX_RULE_NODES];
    struct lx_doubt doubt;
    struct lx_direct *quarters; /* four of them; NULL: none */
};

struct lx_tile {
    uint32_t face, group;
    struct lx_window window;
    struct lx_tile_cell cell;
    struct lx_direct direct;
    bool has_light;
    bool is_overlaid;                       /* another face lies on it (overlap.h) */
    bool is_sampled;                        /* its direct light was, at its nodes at least; */
    bool is_guessed;                        /* there was no effort left for all that it takes, */
    double most_direct;                     /* and so much would arrive at a place if nothing hid the sources; */
    bool is_blind;                          /* or for what it receives (within.h), of which stays what is known: */
    bool has_past;                          /* solutions before told it */
    double past[LX_RULE_NODES], past_error; /* reflected irradiance, and a bound on all of it */
    double direct_error;                    /* of the mean of the direct light that was sampled, */
    double local_error[LX_RULE_NODES];      /* and the part of it that is around each node, as a flux */
    double seen_error; /* of the share of all ways from the tile that end on faces (lx_radiosity.seen), in the mean */
    double residual[2][2]; /* changes of the solution's: along s and t, towards the low and the high edge */
    double own_error;      /* what the polynomial of the solution may be off by itself, anywhere on the tile, */
    double error;          /* and with the errors of what it receives: a bound */
    unsigned worst;        /* the node that receives the most of these */
    struct lx_rows *rows;  /* what its places receive, while the solution is made; NULL: not known */
};

double lx_cell_area(const struct lx_tile_cell *cell);
double lx_tile_area(const struct lx_tile *tile);

/* The error of the direct light that a tile sends on, in the mean, and around a node. */
double lx_tile_unsure(const struct lx_tile *tile);
double lx_tile_unsure_at(const struct lx_tile *tile, int q);

/* The bounds and nodes of a window. */
void lx_cell_make(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell);
/* The bounds alone, and the nodes of a cell that has bounds. */
void lx_cell_bound(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell);
void lx_cell_nodes(const struct lx_matte_face *face, const struct lx_window *window, struct lx_tile_cell *cell);

static inline double lx_cell_width(const struct lx_tile_cell *cell, double y)
{
    return ((1 + y) + (1 - y) * cell->narrow) / 2;
}

/* Whether a face has straight edges. */
static inline bool lx_is_polygon(const struct lx_matte_face *face)
{
    return face->sheet.type->corner_count > 0;
}

/* Whether it is a rectangle. */
static inline bool lx_is_rectangle(const struct lx_matte_face *face)
{
    return face->sheet.type->corner_count == 4;
}

/* Whether light on a window of a face is a linear function. */
static inline bool lx_is_linear(const struct lx_matte_face *face, const struct lx_window *window)
{
    return face->is_small && window->half[0] == 1 && window->half[1] == 1;
}

/* How far beyond a place anything of the face is along a unit vector, at most. */
double lx_face_reach(const struct lx_matte_face *face, const double axis[3], const double from_mm[3]);

/* A face of a sheet. */
void lx_face_make(const struct lx_smooth_sheet *sheet, size_t surface, double reflectance, struct lx_matte_face *face);

#endif
