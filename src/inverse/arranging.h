/* SPDX-License-Identifier: MIT */
/* A search for layouts in the making, and what is computed of those that come near. */
#ifndef LX_INVERSE_ARRANGING_H
#define LX_INVERSE_ARRANGING_H

#include "layouts.h"

/* A layout whose scene was computed. */
struct lx_computed {
    luxel_layout layout;
    luxel_scene *scene;
    bool grids_pass; /* the limits of grids are kept, whatever observers say */
};

/* What is told, and what it is made of. */
struct lx_own_arrangement {
    luxel_arrangement arrangement; /* first, so that its address is that of the whole */
    luxel_scene *goals;
    struct lx_computed *computed; /* as they were found */
    luxel_layout *found, *missed; /* copies of these layouts */
    char **names;                 /* of the numbers of keys */
    const char **units;
};

/* A search in the making. */
struct lx_arranging {
    const luxel_arranging *wanted;
    luxel_settings settings;
    luxel_diagnostics *diagnostics;
    luxel_progress progress;
    void *progress_data;
    double done;
    struct lx_own_arrangement *made;
    struct lx_superposition superposition;
    size_t capacity, found;       /* how many computed ones reach the goals */
    struct lx_lamp_layout *tried; /* the best spacings of each array */
    size_t tried_capacity;
    bool reflects;
    double near; /* arrays whose sums come to so much of the goals are computed */
    double *values, *room;
};

/* The error of reflected light that decides most tries, and that which does for a first idea of it. */
#define LX_COARSE 0.01
#define LX_ROUGH 0.1

void lx_computed_clear(struct lx_computed *computed);

/* Another part of the work is done, of which nobody knows how much there is. */
void lx_end_part(struct lx_arranging *arranging);

/*
 * Judges the goals of a computed layout's scene, with that error of reflected light and then, where it is LX_COARSE or
 * less, as well as it takes to decide.  The values of all cells are in arranging->values.
 */
luxel_status lx_judge_layout(struct lx_arranging *arranging, double reflected_error, struct lx_computed *computed);

#endif
