/* SPDX-License-Identifier: MIT */
/* Steps of one number of a key, each half of the one before, and the scenes that they lead to. */
#ifndef LX_INVERSE_STEPS_H
#define LX_INVERSE_STEPS_H

#include "keys.h"

enum { LX_MOST_STEPS = 40 };

struct lx_stepping {
    const luxel_scene *scene;
    const struct lx_key *key;
    size_t target, number; /* which of its values, and which number of it */
    double at, first;      /* what it is; the first step, so far as it is legal */
    bool is_one_sided;     /* steps beyond are not legal */
};

/* Finds the first step: that of the key, halved until it is legal, and whether it goes both ways.  LUXEL_ERROR_SCENE,
 * reported: no step is. */
luxel_status lx_steps_find(const luxel_scene *scene, const struct lx_key *key, size_t target, size_t number,
                           luxel_diagnostics *diagnostics, struct lx_stepping *stepping);

/* A step as it is taken: what was stepped to has no rounding of its own.  0: it is too small to tell anything. */
double lx_step_of(const struct lx_stepping *stepping, unsigned row);

/* The scene that is changed by so much; LUXEL_ERROR_SCENE: there is none, which is told where diagnostics are given. */
luxel_status lx_step_scene(const struct lx_stepping *stepping, double change, luxel_diagnostics *diagnostics,
                           luxel_scene **changed);

#endif
