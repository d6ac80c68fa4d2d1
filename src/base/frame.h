/* SPDX-License-Identifier: MIT */
/*
 * Frames: right-handed systems of axes that stand anywhere in the frame of the scene, as the screen of an observer
 * does.  What is carried into one moves rigidly with it; its axes are wide numbers, so that nothing is rounded more
 * than once.
 */
#ifndef LX_BASE_FRAME_H
#define LX_BASE_FRAME_H

#include "wide.h"

struct lx_frame {
    bool is_own;            /* it is the scene's own frame: what is carried into it stays as it is, to the last bit */
    double origin_mm[3];    /* where its origin lies in the scene */
    lx_wide3 axes[3];       /* x, y and z: unit, at right angles */
    lx_bounded3 rounded[3]; /* the same as float64 numbers, with their rounding as the bound */
};

/* The scene's own frame. */
struct lx_frame lx_frame_own(void);

/* The frame at `origin` whose z axis points to another place, and y along `up` made perpendicular to that, to which it
 * must not be parallel. */
struct lx_frame lx_frame_towards(const double origin_mm[3], const double towards_mm[3], const double up[3]);

/* Places and directions of the scene as the frame has them, and back.  `carried` and `brought` may be the same as what
 * they are made of. */
void lx_frame_carry(const struct lx_frame *frame, const double place_mm[3], double carried_mm[3]);
void lx_frame_bring(const struct lx_frame *frame, const double carried_mm[3], double place_mm[3]);
void lx_frame_turn(const struct lx_frame *frame, const double direction[3], double turned[3]);
void lx_frame_turn_back(const struct lx_frame *frame, const double turned[3], double direction[3]);

/* Directions with their bounds, and wide places and directions. */
lx_bounded3 lx_frame_turn_bounded(const struct lx_frame *frame, lx_bounded3 direction);
lx_wide3 lx_frame_carry_wide(const struct lx_frame *frame, lx_wide3 place_mm);
lx_wide3 lx_frame_turn_wide(const struct lx_frame *frame, lx_wide3 direction);

/* The distance of two places; infinite where it is beyond the numbers. */
double lx_distance(const double a[3], const double b[3]);

#endif
