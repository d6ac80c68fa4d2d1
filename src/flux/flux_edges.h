/* SPDX-License-Identifier: MIT */
/*
 * Edges of the light of one emitter on a plane: where a cone ends, a source sets, or a surface begins to hide it.  On a
 * plane each is a conic, q(u, v) = 0 with a polynomial of the second degree in the coordinates along its sides; so the
 * places where a line crosses it are known, and an integral can begin and end there.
 *
 * Along a line each surface is asked by itself between its own edges whether it hides the light there; what none of
 * them hides is lit.  As v grows the lit ranges change smoothly but at turns: where two edges meet that both are the
 * border of light, where one has its top or bottom, or leaves the plane.
 */
#ifndef LX_FLUX_FLUX_EDGES_H
#define LX_FLUX_FLUX_EDGES_H

#include "../world/cells.h"

enum { LX_MOST_OWN_EDGES = 96 };

/* q(u, v) = c[0] + c[1] u + c[2] v + c[3] u^2 + c[4] u v + c[5] v^2, u and v from -1/2 to 1/2 on the plane. */
struct lx_conic {
    double c[6];
    size_t caster; /* whose shadow begins here; LX_NO_CASTER: it is an edge of the light itself */
};

#define LX_NO_CASTER SIZE_MAX

/* A surface whose shadow has edges; those stand one after the other. */
struct lx_caster {
    const struct lx_prepared_surface *surface;
    size_t first, count;
};

/* A line across the plane: the place (u, v) = middle + x slope. */
struct lx_plane_line {
    double middle[2], slope[2];
};

/* A range of a line's x, and which edges bound it: their number in the list, or LX_LINE_END. */
struct lx_line_part {
    double from, to;
    size_t bounds[2];
};

#define LX_LINE_END SIZE_MAX

/* A place on a line. */
struct lx_crossing {
    double at;
    size_t edge;
};

struct lx_edges {
    const struct lx_cells *plane;
    const struct lx_emitter *emitter;
    lx_bounded3 across, upward; /* the plane's sides in mm: a place is center + u across + v upward */
    struct lx_conic *items;     /* those of the light first, no more than LX_MOST_OWN_EDGES of them */
    size_t count, capacity;
    struct lx_caster *casters;
    size_t caster_count, caster_capacity;
    bool knows_shadows; /* all that may stand in the way are casters */
    /* room for what one line has: places on it, and dark ranges */
    struct lx_crossing *places;
    struct lx_line_part *dark;
};

/*
 * The edges of an emitter on a plane, which has to stay where it is; where it `casts`, those of the shadows of all
 * surfaces but the ones that are `aside`, a flag for each.  0, or -1 when memory ran out; clear them anyway.
 */
int lx_edges_make(const struct lx_prepared *prepared, const struct lx_cells *plane, const struct lx_emitter *emitter,
                  const bool *aside, bool casts, struct lx_edges *edges);
void lx_edges_clear(struct lx_edges *edges);

/* The emitter, if it has no size, as where ways to it begin. */
struct lx_origin lx_edges_light(const struct lx_edges *edges);

/* The place (u, v) of the plane. */
lx_bounded3 lx_edges_place(const struct lx_edges *edges, double u, double v);

/* Whether a caster hides the emitter from a place of the plane. */
bool lx_caster_hides(const struct lx_edges *edges, size_t caster, double u, double v);

/* The most ranges that a line may have. */
size_t lx_edges_most(const struct lx_edges *edges);

/* The ranges of a line, x from -1/2 to 1/2, in which no caster hides the emitter, cut where edges of the light cross
 * them, in order; returns how many there are. */
size_t lx_edges_lit(const struct lx_edges *edges, const struct lx_plane_line *line, struct lx_line_part *lit);

/* A place (u, v) of the plane. */
struct lx_plane_place {
    double u, v;
};

/* Places in no order. */
struct lx_plane_places {
    struct lx_plane_place *items;
    size_t count, capacity;
};

/* Appends the places of all turns; 0, or -1 when memory ran out. */
int lx_edges_turns(const struct lx_edges *edges, struct lx_plane_places *turns);

/* ---- of one edge ---- */

/* Its value at a place. */
static inline double lx_conic_at(const struct lx_conic *edge, double u, double v)
{
    const double *c = edge->c;
    return c[0] + u * (c[1] + u * c[3] + v * c[4]) + v * (c[2] + v * c[5]);
}

/* The roots of a + b x + c x^2, by the form that does not cancel; returns how many, at most 2. */
int lx_edge_roots(double a, double b, double c, double roots[2]);

#endif
