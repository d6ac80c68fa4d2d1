/* SPDX-License-Identifier: MIT */
/*
 * The observer: either at the height z above the middle of the screen, which then lies in the plane z = 0 of the scene,
 * or at a position, looking at a target, with the screen's frame carried there as a whole.
 */
#ifndef LX_SCENE_OBSERVER_H
#define LX_SCENE_OBSERVER_H

#include "../base/frame.h"
#include "scene.h"

struct lx_text;

extern const struct lx_table lx_observer_table;

/* Whether it was given a position. */
bool lx_observer_is_placed(const struct lx_observer *observer);

/* Whether what was given of it makes a frame and a height. */
bool lx_observer_is_sound(const struct lx_observer *observer);

/* The frame of the screen: its origin is the target, its z axis points to the position. */
struct lx_frame lx_observer_frame(const struct lx_observer *observer);

/* How high the observer stands above the screen, along that z axis. */
double lx_observer_height(const struct lx_observer *observer);

/* The direction that is up for those who stand in the scene: the axis that a room names, which an observer who looks at
 * its plan does not change, else the observer's `up`; NULL: neither is given. */
const double *lx_scene_up(const struct lx_scene_parameters *scene);

/* Where the eye of somebody who is asked about glare is at one of its places, row by row, and which way it looks. */
void lx_observer_sight(const struct lx_scene_parameters *scene, const struct lx_glare_observer *observer, size_t place,
                       size_t view, double eye_mm[3], double direction[3]);

/* Adds the sides of the screen ("left, top") beyond which a surface reaches; none of one that surrounds the observer or
 * fills the whole screen behind others. */
void lx_add_sides_beyond(const struct lx_scene_parameters *scene, size_t surface, struct lx_text *sides);

#endif
