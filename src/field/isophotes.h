/* SPDX-License-Identifier: MIT */
/*
 * How isophotes are found: what the files of this search share.
 *
 * The grid has a corner at each sample of the picture and, with an evaluator, at the edges of the screen.  Four passes
 * run over its lines, each line on its own, so that the result is the same for any number of threads:
 *
 * surfaces   which surface each corner shows
 * corners    exact values where the picture's do not do: near a level, and beside the edge of a surface
 * edges      where the levels cross the edges between corners
 * cells      which crossings belong together: directed segments, the greater values to their left
 *
 * A piece is a part of a grid edge that lies on one surface and that a level crosses once at most.  A line of the grid
 * owns its horizontal edges and the vertical ones below it.
 */
#ifndef LX_FIELD_ISOPHOTES_H
#define LX_FIELD_ISOPHOTES_H

#include <luxel/isophotes.h>

#include "../base/rows.h"
#include "../world/evaluate.h"
#include "field.h"

/* No surface is seen. */
enum { LX_ISO_NOTHING = -1 };

/* From this column on a line shows this surface. */
struct lx_iso_run {
    unsigned column;
    int surface;
};

/* A corner whose exact value is known. */
struct lx_iso_exact {
    unsigned column;
    int surface;
    double value; /* NaN where there is none */
};

/*
 * A place within an edge where a piece ends: where the surface of one of its corners is left, or, both on the same, an
 * extremum between them that a level would pass unseen.
 */
struct lx_iso_node {
    size_t edge;        /* 2 x column, + 1 for the vertical one */
    unsigned char side; /* whose surface is left: 0 of the first corner (left or upper), 1 of the second */
    double at;          /* x_mm or y_mm */
    double value;
};

struct lx_iso_crossing {
    size_t edge;
    unsigned char piece; /* 0 from the first corner, 1 to the second; 0 if it is the only one */
    size_t level;        /* index into the sorted ones */
    double at;           /* x_mm or y_mm */
};

/* The end of a line on the edge of a surface. */
struct lx_iso_end {
    size_t level;
    double xy_mm[2];
};

/* A vertex: a crossing of this line or of the next, or an end of this one. */
enum lx_iso_owner { LX_ISO_CROSSING_HERE, LX_ISO_CROSSING_NEXT, LX_ISO_END };

struct lx_iso_vertex {
    enum lx_iso_owner owner;
    size_t index;
};

struct lx_iso_segment {
    struct lx_iso_vertex from, to;
};

struct lx_iso_list {
    void *items;
    size_t count, capacity;
};

/* What is found on a line of the grid, each list in the order of columns and edges. */
struct lx_iso_line {
    struct lx_iso_list runs, exact, nodes, crossings, ends, segments;
};

struct lx_iso_search {
    const struct luxel_field *field;
    const struct luxel_evaluator *evaluator; /* NULL: the picture alone */
    const double *levels;                    /* rising, each once */
    size_t level_count;
    double *x_mm, *y_mm; /* of the grid */
    unsigned columns, rows, left, top;
    struct lx_iso_line *lines;
    double near;         /* how near to a level the picture's values do not tell on which side they are */
    double goal, accept; /* how near to its level a vertex must come, relative: striven for, and at least */
    double pull_mm;      /* how far inside the rim of a sphere lines end */
    double (*boxes)[4];  /* of each surface on the screen: lowest x, highest x, lowest y, highest y */
    struct lx_iso_worker *workers;
    unsigned worker_count;
    struct lx_control control;
    double done, share; /* of all passes together: what came before this one, and what this one is */
    atomic_bool short_of_memory;
};

/* The corners of one line. */
struct lx_iso_corners {
    int *surface;
    double *value;
};

struct lx_iso_worker {
    void *memory;
    struct lx_iso_corners around[4]; /* the line above, the line, the two below */
    unsigned char *marked[2];        /* which edges of the line, and of the one below, have nodes */
    long long line;                  /* that `around` was filled for, -1: none */
};

/* Makes room in a list for one more item and returns it; NULL: memory is short, which the search then knows. */
void *lx_iso_append(struct lx_iso_search *search, struct lx_iso_list *list, size_t size);

/* The first of the sorted levels above a value. */
size_t lx_iso_first_level(const struct lx_iso_search *search, double value);

/* -- the grid (isophotes_grid.c) -- */

/* Places, lines and workers for so many threads; 0, or -1 when memory is short. */
int lx_iso_grid_new(struct lx_iso_search *search, unsigned threads);
void lx_iso_grid_clear(struct lx_iso_search *search);

/* Fills worker->around for a line with what the picture knows, and with the exact values when they are found. */
void lx_iso_load(const struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line, bool with_exact);

/* The passes, over one line each. */
void lx_iso_surfaces(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line);
void lx_iso_corners(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line);
void lx_iso_edges(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line, bool is_caller);
void lx_iso_cells(struct lx_iso_search *search, struct lx_iso_worker *worker, unsigned line);

/* -- along ways (isophotes_way.c) -- */

/* What was found on a way. */
struct lx_iso_sample {
    double at, value;
};

enum { LX_ISO_SAMPLES = 64 };

/* Where the line from an inner place through a share of the chord meets the rim: a multiple of the way to the chord. */
struct lx_iso_rim {
    double share, reach;
};

/* A way across the screen on which the function is followed: along x or y, or along the rim of a surface. */
struct lx_iso_way {
    const struct lx_iso_search *search;
    int surface;
    bool along_rim;
    unsigned axis;      /* along which it runs: 0 x, 1 y */
    double across_mm;   /* the other coordinate */
    double inner_mm[2]; /* of a rim: a place well on the surface */
    double ends_mm[2][2];
    /* of a rim: where it was found last, the newest first, which tells about where it is near by */
    unsigned rim_count;
    struct lx_iso_rim rims[3];
    /* what was found, in rising order of `at` */
    size_t count;
    struct lx_iso_sample samples[LX_ISO_SAMPLES];
};

/* The surface seen through a place. */
int lx_iso_seen(const struct lx_iso_search *search, const double xy_mm[2]);
/* The value there, on this surface; NaN: another is seen, or it has none. */
double lx_iso_value(const struct lx_iso_search *search, int surface, const double xy_mm[2]);
/* Where a way is. */
void lx_iso_way_place(struct lx_iso_way *way, double at, double xy_mm[2]);
/*
 * Finds where the way is on a level, between places where it is on either side of it, roughly; false: nowhere, as
 * the function jumps.
 */
bool lx_iso_way_cross(struct lx_iso_way *way, double level, struct lx_iso_sample from, struct lx_iso_sample to,
                      double *at);
/* Where the way, from a place on its surface towards one that is not, leaves it: the last place found on it. */
double lx_iso_way_leave(struct lx_iso_way *way, double on, double off);
/* The extremum on a piece of the way within which it is known to be, the greatest (sign 1) or the least (-1). */
struct lx_iso_sample lx_iso_way_extremum(struct lx_iso_way *way, double from, double to, double sign);

/* -- chaining (isophotes_chain.c) -- */

/* Makes lines of the segments, in the order of the levels as given; NULL: memory is short. */
struct luxel_isophotes *lx_iso_chain(const struct lx_iso_search *search, const double *levels, size_t count);

#endif
