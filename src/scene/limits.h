/* SPDX-License-Identifier: MIT */
/*
 * Limits: what a measuring grid and an observer's glare are to keep, number by number or by the name of a row of a
 * standard, whose numbers those that are written replace.
 */
#ifndef LX_SCENE_LIMITS_H
#define LX_SCENE_LIMITS_H

#include "../parameter/table.h"

/* In the order in which they are judged. */
enum lx_grid_limit { LX_LIMIT_AVERAGE, LX_LIMIT_MINIMUM, LX_LIMIT_MAXIMUM, LX_LIMIT_UNIFORMITY, LX_LIMIT_RATIO };
enum { LX_GRID_LIMITS = LX_LIMIT_RATIO + 1 };

struct lx_grid_limits {
    uint64_t given;
    int preset;
    double wanted[LX_GRID_LIMITS];
};

struct lx_glare_limits {
    uint64_t given;
    int preset;
    double ugr;
};

/* Who is asked how much the lights dazzle; the observer of the picture is another one. */
struct lx_glare_observer {
    uint64_t given;
    const char *name; /* NULL: none */
    double eye_mm[3], view[3];
    struct lx_glare_limits limits;
};

extern const struct lx_table lx_grid_limits_table, lx_glare_observer_table;

/* The limit of a grid, NaN where there is none; its key is *name. */
double lx_grid_limit(const struct lx_grid_limits *limits, enum lx_grid_limit which, const char **name);

/* The greatest UGR, NaN where there is none. */
double lx_glare_limit(const struct lx_glare_limits *limits);

#endif
