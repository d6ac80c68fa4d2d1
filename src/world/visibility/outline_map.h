/* SPDX-License-Identifier: MIT */
/* The trapezoidal map of one sweep of an outline: what its lines (outline_lines.c) and slabs (outline_map.c) share. */
#ifndef LX_WORLD_OUTLINE_MAP_H
#define LX_WORLD_OUTLINE_MAP_H

#include "outline.h"

/* A rectangle of u and v in which a sweep lies, how far before it things may be, and the lines so far. */
struct map_build {
    const struct lx_occlusion *occlusion;
    const struct lx_sweep *sweep;
    struct lx_trapezoid_map *map;
    double u[2], v[2];
    double limit_mm, farthest_mm;         /* along x: up to where things hide surely, from where on they do not */
    double horizons[LX_MOST_HORIZONS][3]; /* in the frame of the sweep: seen is what is above all of them */
    unsigned horizon_count;
    double *events;
    size_t event_count, event_capacity;
    double *walls; /* events at which an edge stands upright, beyond which counts do not go on */
    size_t wall_count, wall_capacity;
    struct gap *gaps; /* between the lines of a slab */
    size_t gap_count, gap_capacity, row_capacity;
    uint32_t *row; /* lines of a slab, upwards */
    size_t row_count;
    int *places;          /* of lines in the row before, less than 0: they were not in it */
    int *counts, *inside; /* of the gaps of the row before above each of its lines */
    size_t count_capacity, inside_capacity, place_capacity;
};

struct gap {
    double low, high; /* of what is looked at in it; high <= low: nothing */
    int count;
};

static inline double lx_outline_height(const struct lx_outline_line *line, double u)
{
    return line->start + line->rise * u;
}

/* The rectangle, the lines in the order of where they begin, and all events and walls in theirs; 0, or -1 when memory
 * ran out. */
int lx_outline_draw(struct map_build *build);

#endif
