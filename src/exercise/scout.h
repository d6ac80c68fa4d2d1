/* SPDX-License-Identifier: MIT */
/*
 * Scouting: a quick look at what a scene shows, and at what it would show after some changes, for advice.  The picture
 * is coarse; the peak is looked for between its pixels where that is quick.
 */
#ifndef LX_EXERCISE_SCOUT_H
#define LX_EXERCISE_SCOUT_H

#include <luxel/extrema.h>
#include <luxel/scene.h>

#include "../scene/scene.h"

/* How much all looks of one adviser may cost, about in ns. */
#define LX_SCOUT_EFFORT 1e9

enum { LX_SCOUT_SOURCES = 4096 }; /* the most that advice looks at one by one */

struct lx_scout {
    bool too_large; /* more sources than a quick look can take, or no effort is left: nothing else is known */
    bool is_seen;   /* whether any surface is */
    bool is_coarse; /* whether the peak was read off the picture, because some source has no quick exact value */
    double maximum; /* the greatest brightness on the screen */
    size_t surface; /* where it is seen */
    unsigned part;  /* of that surface */
    luxel_peak_place place;
    size_t strongest; /* the light that gives most of it */
    double white;     /* share of what is seen that is brighter than the picture's range reaches */
    double sample_mm; /* between the picture's pixels */
};

/*
 * Looks at a copy of the scene with the assignments (NULL-terminated) made, and takes what that costs off the effort
 * that is left; it is estimated, so that advice does not depend on the machine.  Any status that luxel_scene_set(),
 * luxel_scene_commit() or luxel_render() may have: such assignments do not go.
 */
luxel_status lx_scout(const luxel_scene *scene, const char *const *assignments, double *effort, struct lx_scout *scout);

#endif
