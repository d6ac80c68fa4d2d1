/* SPDX-License-Identifier: MIT */
/*
 * The outline of what meshes hide of a source, as an element sees it.
 *
 * A direction is hidden where it passes at least one sheet (surface/obstacle.h) before the source.  How many it passes
 * changes only where it crosses an edge that the sheets on its sides do not go on behind: by two where a closed mesh
 * folds over, by one where an open one ends.  Where the plane of a flat source cuts a sheet there is such an edge, too.
 *
 * A sweep (sweep.h) is laid out in slabs of longitudes, between which such edges, and the borders of the source and the
 * horizon, begin, end or cross each other.  In a slab they lie above each other in one order, and one ray, or a gap
 * that the slab before has as well, tells how many sheets there are in each of the gaps between them.  Slabs that have
 * the same hidden parts are joined.
 */
#ifndef LX_WORLD_OUTLINE_H
#define LX_WORLD_OUTLINE_H

#include <stdint.h>

#include "../../base/rows.h"
#include "../integral/sweep.h"
#include "occlusion.h"

/* An edge in the frame of a sweep, or a border of what is looked at. */
enum lx_outline_kind { LX_OUTLINE_EDGE, LX_OUTLINE_BORDER, LX_OUTLINE_HORIZON, LX_OUTLINE_BOX };
struct lx_outline_line {
    enum lx_outline_kind kind;
    double from[3], to[3];
    double rise, start; /* on it v = start + rise u, u and v the tangents of longitude and latitude: y/x and z/x */
    double low, high;   /* of u */
    int change;         /* of the number of sheets, towards higher v; of a horizon, which one it is */
};

/* Hidden between two lines. */
struct lx_outline_part {
    uint32_t lower, upper;
};

struct lx_outline_slab {
    double low, high;        /* of u */
    uint32_t floor, ceiling; /* the lines between which it was looked */
    uint32_t first, count;   /* of the parts, upwards */
};

/* One sweep. */
struct lx_trapezoid_map {
    struct lx_outline_line *lines;
    size_t line_count, line_capacity;
    struct lx_outline_part *parts;
    size_t part_count, part_capacity;
    struct lx_outline_slab *slabs;
    size_t slab_count, slab_capacity;
    double unsure;  /* the width in u, times the height in v, of where rays and edges disagree */
    double area;    /* the same of all that was looked at */
    double skipped; /* and of slabs that are too narrow to be told from their neighbours */
};

struct lx_sheet_outline {
    const struct lx_sweeps *sweeps; /* that it was laid out for */
    struct lx_trapezoid_map *lays;
    size_t lay_count;
    bool is_doubtful; /* too many sheets reach into a round source: what of it they hide is not known */
    bool is_broken;   /* there is too much of it */
};

struct lx_sheet_outline *lx_outline_new(void);
void lx_outline_free(struct lx_sheet_outline *outline);

/* How many sheets a way passes. */
unsigned lx_outline_layers(const struct lx_occlusion *occlusion, const double way_mm[3]);

/* Whether the plane of a flat source cuts sheets, or they reach into a round one. */
bool lx_outline_may_cut(const struct lx_occlusion *occlusion, const struct lx_emitter *emitter);

/* Lays sweeps out, which have to stay; 0, or -1 when memory ran out. */
int lx_trapezoid_map(const struct lx_occlusion *occlusion, const struct lx_sweeps *sweeps,
                     const struct lx_asking *asking);

/* The most that it hides on an arc. */
size_t lx_outline_most(const struct lx_sheet_outline *outline);

/* What it hides of an arc of one of these sweeps, appended from hidden[count] on; returns the new count. */
size_t lx_outline_hide(const struct lx_occlusion *occlusion, const struct lx_sweep *sweep, const struct lx_arc *arc,
                       struct lx_hidden *hidden, size_t count);

/* What part of the light may be wrong because rays and edges disagree: at most this solid angle; and because slabs are
 * too narrow. */
double lx_outline_unsure(const struct lx_sheet_outline *outline);
double lx_outline_skipped(const struct lx_sheet_outline *outline);

/* A solid angle so small beside all that was looked at that no rounding tells it from nothing: what is no larger with
 * its error counts as hidden. */
double lx_outline_nothing(const struct lx_sheet_outline *outline);

/* Whether nothing but the outline, and a plane that it knows, is in the way. */
bool lx_outline_is_alone(const struct lx_occlusion *occlusion);

/* Adds the horizon of the element's normal, unless it is among those that are known.  False: they are too many. */
bool lx_outline_add_horizon(struct lx_occlusion *occlusion, const double normal[3]);

/*
 * The integral of N.L over what is seen of a source of facets, in closed form.  False: something else is in the way,
 * or memory ran out.
 */
bool lx_outline_sum(const struct lx_occlusion *known, const struct lx_emitter *emitter, const double normal[3],
                    double normal_error, const struct lx_asking *asking, double *sum, double *error);

#endif
