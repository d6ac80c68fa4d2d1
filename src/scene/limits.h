/* SPDX-License-Identifier: MIT */
/*
 * Limits: what a measuring grid and an observer's glare are to keep, number by number or by the name of a row of a
 * standard, whose numbers those that are written replace.
 */
#ifndef LX_SCENE_LIMITS_H
#define LX_SCENE_LIMITS_H

#include "../parameter/table.h"

/* In the order in which they are judged. */
enum lx_grid_limit {
    LX_LIMIT_AVERAGE,
    LX_LIMIT_MINIMUM,
    LX_LIMIT_MAXIMUM,
    LX_LIMIT_UNIFORMITY,
    LX_LIMIT_RATIO,
    LX_LIMIT_SHARE
};
enum { LX_GRID_LIMITS = LX_LIMIT_SHARE + 1 };

/* A share of the cells, in percent, that are to have at least so much. */
struct lx_share_limit {
    uint64_t given;
    double above, percent;
};

struct lx_grid_limits {
    uint64_t given;
    int preset;
    double wanted[LX_LIMIT_SHARE];
    struct lx_share_limit share;
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
    double size_mm[2];
    unsigned n[2]; /* of places */
    struct lx_glare_limits limits;
};

enum { LX_LEVEL_VIEWS = 4 }; /* of an observer without a view */

extern const struct lx_table lx_grid_limits_table, lx_glare_observer_table;

/* The limit of a grid, NaN where there is none, of a share its percents; its key is *name. */
double lx_grid_limit(const struct lx_grid_limits *limits, enum lx_grid_limit which, const char **name);

/* The greatest UGR, NaN where there is none. */
double lx_glare_limit(const struct lx_glare_limits *limits);

bool lx_observer_has_view(const struct lx_glare_observer *observer);

#endif
